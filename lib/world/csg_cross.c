/* The first crossings of several rays with trees, where outlines have told which ones they are: members of one class are asked side by
 * side. */
#include "world/csg_outline.h"
#include "world/internal.h"

/* Rays whose members are entered there, or crossed once, by the caller's number: the nearest crossing is that. */
typedef struct entries {
    const csg_member *member[WORLD_MANY];
    const pov_ray *ray[WORLD_MANY];
    pov_hits found[WORLD_MANY];
    pov_crossing at[WORLD_MANY];
    pov_ray own[WORLD_MANY];
} entries;

static csg_first first_of_note(uint32_t note)
{
    const csg_first first = { .column = note & CSG_NOTE_COLUMN, .enters = note & CSG_NOTE_ENTERS, .inward = note & CSG_NOTE_INWARD };

    return first;
}

/* The crossing of one ray. */
static void cross(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const csg_first first = first_of_note(((const csg_user *)hits->user)->note);
    csg_traversal w;

    csg_traversal_init(&w, ((const csg_root *)self)->tree, ray, hits);
    if (!csg_chords_report(&w, &first, hits))
        csg_intersect(self, ray, hits);
}

static void begin(entries *e, uint32_t i, const csg_member *m, const pov_ray *ray, const pov_hits *hits)
{
    const pov_hits found = { .tmax = HUGE_VAL, .want = POV_WANT_NEAREST, .at = &e->at[i], .capacity = 1,
                             .owner = ((const csg_user *)hits->user)->scratch->names + m->leaf, .user = hits->user, .scratch = hits->scratch };

    e->member[i] = m;
    e->ray[i] = ray;
    e->found[i] = found;
}

/* Rays of instanced members go to their own spaces. */
static void to_own_spaces(entries *e, uint64_t which)
{
    xform_batch instanced;

    instanced.count = 0;
    for (; which; which &= which - 1) {
        const uint32_t i = first_of64(which);

        if (!e->member[i]->xform)
            continue;
        xform_batch_add(&instanced, e->member[i]->xform, e->ray[i], &e->own[i]);
        e->ray[i] = &e->own[i];
    }
    xform_batch_apply(&instanced);
}

/* Ask the members of one class; returns the others. */
static uint64_t ask_class(entries *e, uint64_t which, class_counts *classes)
{
    const csg_member *const first = e->member[first_of64(which)];
    const shape_class *shape = first->shape;
    const void *selves[WORLD_MANY];
    const pov_ray *rays[WORLD_MANY];
    pov_hits *hits[WORLD_MANY];
    uint64_t others = 0;
    uint32_t n = 0;

    for (; which; which &= which - 1) {
        const uint32_t i = first_of64(which);

        if (e->member[i]->shape != shape) {
            others |= (uint64_t)1 << i;
            continue;
        }
        selves[n] = e->member[i]->instance;
        rays[n] = e->ray[i];
        hits[n++] = &e->found[i];
    }
    if (shape->cross_many)
        shape->cross_many(selves, rays, hits, n);
    else if (shape->intersect_many)
        shape->intersect_many(selves, rays, hits, n);
    else
        for (uint32_t i = 0; i < n; i++)
            shape->intersect(selves[i], rays[i], hits[i]);
    if (classes) {
        classes->of[first->class_number].asked += n;
        for (uint32_t i = 0; i < n; i++)
            classes->of[first->class_number].escalated += hits[i]->escalated;
    }
    return others;
}

/* Report the crossing; false: it is too near the start for doubles, or not there. */
static bool report(const csg_tree *t, const pov_ray *ray, const pov_hits *found, pov_hits *hits)
{
    const double behind = CSG_SEPARATION * (pov_largest(ray->org) + t->size);

    if (found->count == 0 || found->at->t * pov_largest(ray->dir) <= behind)
        return false;
    hits->escalated += found->escalated;
    csg_report(found->at, ((const csg_user *)hits->user)->note & CSG_NOTE_INWARD, hits);
    return true;
}

void csg_cross_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    uint64_t nearest = 0;
    entries e;

    for (uint32_t i = 0; i < n; i++) {
        const csg_tree *t = ((const csg_root *)selves[i])->tree;
        const csg_first first = first_of_note(((const csg_user *)hits[i]->user)->note);

        if (!first.enters && !(t->outline->halves >> first.column & 1)) {
            cross(selves[i], rays[i], hits[i]);
            continue;
        }
        begin(&e, i, &t->members[t->outline->member[first.column]], rays[i], hits[i]);
        nearest |= (uint64_t)1 << i;
    }
    to_own_spaces(&e, nearest);
    for (uint64_t left = nearest; left; )
        left = ask_class(&e, left, ((const csg_user *)hits[0]->user)->scratch->classes);
    for (; nearest; nearest &= nearest - 1) {
        const uint32_t i = first_of64(nearest);

        if (!report(((const csg_root *)selves[i])->tree, rays[i], &e.found[i], hits[i]))
            csg_intersect(selves[i], rays[i], hits[i]);
    }
}

#include "api/explain.h"

#include "base/err.h"
#include "base/vec.h"
#include "plug/shape_class.h"

#include <stdio.h>
#include <string.h>

/* ---- rows ---- */

void explain_init(explanation *e, const env *from)
{
    memset(e, 0, sizeof *e);
    arena_init(&e->memory, from);
}

void explain_free(explanation *e)
{
    env_free(e->memory.env, e->rows.items);
    arena_free(&e->memory);
}

/* state is static text; the subject is copied, the reason is formatted and copied. */
static pov_status POV_PRINTF(6, 7) add(explanation *e, pov_error *err, bool used, const char *subject, const char *state,
                                       const char *reason, ...)
{
    explain_row row = { used, NULL, state, NULL };
    char text[512];
    va_list args;

    va_start(args, reason);
    vsnprintf(text, sizeof text, reason, args);
    va_end(args);
    row.subject = arena_text(&e->memory, subject, strlen(subject));
    row.reason = arena_text(&e->memory, text, strlen(text));
    if (!row.subject || !row.reason || !VEC_PUSH(e->memory.env, &e->rows, row))
        return err_memory(err);
    return POV_OK;
}

/* ---- the plan ---- */

static const char *no_light(const plan_counts *s)
{
    return s->emitting == 0 ? "no light emits" : "no surface has a diffuse colour or a highlight";
}

static const char *no_photons(const plan *p) { return p->lighting ? "no light sends any" : no_light(&p->counts); }

static pov_status explain_light(explanation *e, const plan *p, pov_error *err)
{
    const plan_counts *s = &p->counts;
    pov_status status;

    if (p->lighting)
        status = add(e, err, true, "lighting", "computed", "lights that emit: %zu; objects with diffuse or highlights: %zu",
                          s->emitting, s->lit);
    else
        status = add(e, err, false, "lighting", "left out", "%s", no_light(s));
    if (status == POV_OK && p->shadows)
        status = add(e, err, true, "shadow rays", "sent", "objects that throw a shadow: %zu", s->casting);
    else if (status == POV_OK)
        status = add(e, err, false, "shadow rays", "left out", "%s",
                          p->lighting ? "every object is no_shadow" : no_light(s));
    if (status == POV_OK && p->coloured_shadows)
        status = add(e, err, true, "coloured shadows", "collected", "transparent objects that throw a shadow: %zu",
                          s->filtering);
    else if (status == POV_OK)
        status = add(e, err, false, "coloured shadows", "left out", "%s",
                          p->shadows ? "nothing that throws a shadow is transparent: the first object hit ends it"
                                     : "no shadow rays are sent");
    if (status == POV_OK && p->photons)
        status = add(e, err, true, "photons", "sent", "targets: %zu; lights that send photons: %zu", s->targets, s->photon_lights);
    else if (status == POV_OK)
        status = add(e, err, false, "photons", "left out", "%s",
                     s->targets == 0 ? "nothing is a target of photons" : no_photons(p));
    return status;
}

/* A row on a part that objects of some kind need. */
static pov_status explain_kind(explanation *e, bool used, const char *subject, const char *state, const char *kind,
                               size_t count, const char *why_not, pov_error *err)
{
    if (used)
        return add(e, err, true, subject, state, "objects %s: %zu", kind, count);
    return add(e, err, false, subject, "left out", "%s", why_not);
}

static pov_status explain_surfaces(explanation *e, const model *m, const plan *p, pov_error *err)
{
    const plan_counts *s = &p->counts;
    pov_status status = explain_kind(e, p->highlights, "highlights", "computed", "with phong or specular", s->glossy,
                                     s->glossy > 0 ? no_light(s) : "no surface has phong or specular", err);

    if (status == POV_OK)
        status = explain_kind(e, p->metallic, "metallic", "computed", "with metallic highlights", s->metallic,
                              s->metallic > 0 ? no_light(s) : "no surface has a metallic highlight", err);
    if (status == POV_OK)
        status = explain_kind(e, p->textures, "textures", "evaluated", "whose texture varies", s->varying,
                              "every texture is constant", err);
    if (status == POV_OK)
        status = explain_kind(e, p->reflection, "reflection", "followed", "with reflection", s->reflective,
                              "no surface has reflection", err);
    if (status == POV_OK)
        status = explain_kind(e, p->transmission, "transparency", "followed", "that let light through", s->transparent,
                              "no surface lets light through", err);
    if (status == POV_OK)
        status = explain_kind(e, p->refraction, "refraction", "computed", "that refract light", s->refracting,
                              p->transmission ? "no transparent surface has an interior of ior other than 1"
                                              : "no surface lets light through", err);
    if (status == POV_OK && p->media)
        status = add(e, err, true, "media", p->scattering ? "sampled" : "looked through",
                     "objects with media: %zu; the scene around them: %s; light is %sscattered", s->filled,
                     m->atmosphere ? "filled" : "empty", p->scattering ? "" : "not ");
    else if (status == POV_OK)
        status = add(e, err, false, "media", "left out", "no object has media, nor has the scene");
    if (status == POV_OK && p->radiosity)
        status = add(e, err, true, "radiosity", "sampled", "objects with a diffuse colour: %zu; bounces: %u; rays from a surface: %u",
                     s->diffuse, m->radiosity.recursion_limit, m->radiosity.draws);
    else if (status == POV_OK)
        status = add(e, err, false, "radiosity", "left out", "%s",
                     m->radiosity.given ? "no surface has a diffuse colour" : "the scene does not ask for it");
    if (status == POV_OK)
        status = explain_kind(e, p->dielectrics_at_start, "dielectrics at the camera", "looked up", "that may hold it",
                              s->dielectrics, "nothing refracts light", err);
    return status;
}

/* ---- the world ---- */

static pov_status explain_objects(explanation *e, const world_facts *f, size_t objects, pov_error *err)
{
    pov_status status;

    if (f->absorbed + f->composed == 0)
        status = add(e, err, false, "transformations", "left out", "no object has one");
    else if (f->composed == 0)
        status = add(e, err, true, "transformations", "absorbed", "applied to the shapes themselves: %zu",
                          f->absorbed);
    else
        status = add(e, err, true, "transformations", f->absorbed ? "some absorbed" : "composed",
                          "applied to the shapes themselves: %zu; rays transformed to object space: %zu",
                          f->absorbed, f->composed);
    if (status == POV_OK && f->packed > 0)
        status = add(e, err, true, "blocks", "packed", "shapes filtered up to eight at once: %zu of %zu",
                          f->packed, objects);
    else if (status == POV_OK)
        status = add(e, err, false, "blocks", "left out", "no shape takes part in them");
    if (status == POV_OK && f->infinite > 0)
        status = add(e, err, true, "infinite objects", "tested separately",
                          "without a finite box, tested for every ray: %zu", f->infinite);
    else if (status == POV_OK)
        status = add(e, err, false, "infinite objects", "left out", "every object has a finite box");
    return status;
}

static pov_status explain_tree(explanation *e, const world_facts *f, pov_error *err)
{
    if (f->kernels)
        return add(e, err, true, "tree", "built", "%zu objects: nodes %zu, leaves %zu, depth %d, frames %zu, %.1f kB; %s",
                   f->finite, f->nodes, f->leaves, f->depth, f->frames, (double)f->tree_bytes / 1000.0, f->kernels);
    return add(e, err, false, "tree", "left out", "%s",
               f->finite > 0 ? "asked for none: every ray tests every object" : "no object has a finite box");
}

/* Solids made of others are in the model: a tree for each, whose members are leaves. */
static pov_status explain_solids(explanation *e, const model *m, pov_error *err)
{
    size_t members = 0;

    for (size_t i = 0; i < m->trees.count; i++)
        members += m->groups.items[m->trees.items[i] & ~NODE_GROUP].leaf_count;
    if (members > 0)
        return add(e, err, true, "solids made of others", "traversed", "trees: %zu; members: %zu", m->trees.count, members);
    return add(e, err, false, "solids made of others", "left out", "nothing is merged, intersected, cut or clipped");
}

static pov_status explain_copies(explanation *e, const model *m, pov_error *err)
{
    size_t leaves = 0;

    for (size_t i = 0; i < m->parts.count; i++)
        leaves += m->parts.items[i]->leaves.count;
    if (m->copies.count > 0)
        return add(e, err, true, "copies", "stored once", "copies: %zu; of %zu declared solids, of shapes: %zu", m->copies.count,
                   m->parts.count, leaves);
    return add(e, err, false, "copies", "left out", "no declared solid is large and used often");
}

pov_status explain_world(explanation *e, const model *m, const world *w, pov_error *err)
{
    const world_facts facts = world_get_facts(w);
    const plan *p = world_plan(w);
    pov_status status = add(e, err, true, "dialect", m->dialect == POV_DIALECT_COURSE ? "course" : "povray", "%s",
                            m->dialect_reason ? m->dialect_reason : "asked for");

    if (status == POV_OK)
        status = explain_light(e, p, err);
    if (status == POV_OK)
        status = explain_surfaces(e, m, p, err);
    if (status == POV_OK)
        status = explain_objects(e, &facts, m->leaves.count, err);
    if (status == POV_OK)
        status = explain_solids(e, m, err);
    if (status == POV_OK)
        status = explain_copies(e, m, err);
    return status == POV_OK ? explain_tree(e, &facts, err) : status;
}

/* ---- plugins ---- */

typedef struct plugin_rows {
    explanation *to;
    size_t first;                /* of the rows of plugins, which are the last */
    pov_status status;
    pov_error *err;
} plugin_rows;

static pov_status add_plugin(plugin_rows *r, const char *keyword, bool used, const char *reason)
{
    char subject[96];

    snprintf(subject, sizeof subject, "plugin %s", keyword);
    return add(r->to, r->err, used, subject, used ? "loaded" : "not loaded", "%s", reason);
}

static pov_status add_class(plugin_rows *r, const shape_class *shape, size_t objects)
{
    const bool certified = shape->flags & POV_SHAPE_CERTIFIED;
    char reason[96];

    snprintf(reason, sizeof reason, "objects: %zu%s", objects,
             certified ? "" : "; its distances are not certified: as right as its own arithmetic");
    return add_plugin(r, shape->keyword, true, reason);
}

static bool has_row(const plugin_rows *r, const char *keyword)
{
    size_t i;

    for (i = r->first; i < r->to->rows.count; i++)
        if (strcmp(r->to->rows.items[i].subject + strlen("plugin "), keyword) == 0)
            return true;
    return false;
}

static void visit_keyword(void *user, const char *keyword)
{
    plugin_rows *r = user;

    if (r->status == POV_OK && !has_row(r, keyword))
        r->status = add_plugin(r, keyword, false, "the scene does not name it");
}

/* A folder lists its files in any order. */
static void sort_rows(explain_row *rows, size_t count)
{
    size_t i, j;

    for (i = 1; i < count; i++) {
        explain_row row = rows[i];
        for (j = i; j > 0 && strcmp(rows[j - 1].subject, row.subject) > 0; j--)
            rows[j] = rows[j - 1];
        rows[j] = row;
    }
}

/* The number of objects of each class, in the order in which the scene first names them. */
typedef struct class_tally { const shape_class *shape; size_t objects; } class_tally;
typedef struct tally { class_tally *items; size_t count, capacity; } tally;

static bool count_classes(const model *m, tally *t)
{
    size_t i, k;

    for (i = 0; i < m->parts.count; i++)
        if (!count_classes(m->parts.items[i], t))
            return false;
    for (i = 0; i < m->leaves.count; i++) {
        const class_tally one = { m->leaves.items[i].shape, 1 };
        for (k = 0; k < t->count && t->items[k].shape != one.shape; k++)
            continue;
        if (k < t->count)
            t->items[k].objects++;
        else if (!VEC_PUSH(m->env, t, one))
            return false;
    }
    return true;
}

pov_status explain_plugins(explanation *e, const model *m, const registry *plugins, pov_error *err)
{
    plugin_rows r = { e, e->rows.count, POV_OK, err };
    tally t = { NULL, 0, 0 };
    size_t i, n;

    if (!count_classes(m, &t))
        r.status = err_memory(err);
    for (i = 0; r.status == POV_OK && i < t.count; i++)
        r.status = add_class(&r, t.items[i].shape, t.items[i].objects);
    env_free(m->env, t.items);
    n = e->rows.count;
    if (r.status == POV_OK && plugins)
        registry_each_keyword(plugins, "primitives", visit_keyword, &r);
    if (e->rows.count > n)
        sort_rows(e->rows.items + n, e->rows.count - n);
    return r.status;
}

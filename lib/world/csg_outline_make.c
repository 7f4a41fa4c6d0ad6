/* The outline of a tree: its members' slabs and quadrics side by side, in doubles about the tree's middle, in units of its size, and
 * what their crossings do to the tree's value. docs/numerics.md ("Outlines") derives the constants. */
#include "world/csg_outline.h"

#include <string.h>

enum { SLAB_NUMBERS = CSG_SLAB_NUMBERS, QUADRIC_NUMBERS = CSG_QUADRIC_NUMBERS, FOUR = CSG_FOUR };

/* Numbers stand side by side by four slabs, or four quadrics; here is the first of one. */
static double *numbers_of(double *numbers, uint32_t each, uint32_t i) { return numbers + csg_number(each, i); }

static const double farthest = CSG_FARTHEST;
static const double most_cancelled = 0x1p12, most_turned = 0x1p-46;

/* ---- making one ---- */

/* Points of the tree's units to what the member's slabs and quadric are of: w = column q + from. */
typedef struct own_map { pov_vec3 column[3], from; } own_map;

static pov_vec3 linear_part(const own_map *m, pov_vec3 q)
{
    return pov_add(pov_add(pov_scale(m->column[0], q.x), pov_scale(m->column[1], q.y)), pov_scale(m->column[2], q.z));
}

/* False: it is too far away. */
static bool find_map(const csg_member *m, const pov_outline *c, const csg_outline *of, own_map *out)
{
    const double size = of->size;
    double least = 0.0, from;

    memset(out, 0, sizeof *out);
    if (m->xform) {
        const own_map linear = { { m->xform->column[0], m->xform->column[1], m->xform->column[2] }, { 0.0, 0.0, 0.0 } };
        const pov_vec3 middle = linear_part(&linear, pov_sub(of->centre, m->xform->anchor));

        for (int i = 0; i < 3; i++)
            out->column[i] = pov_scale(linear.column[i], size);
        out->from = pov_sub(pov_add(middle, m->xform->own_anchor), c->centre);
        from = pov_max(pov_largest(middle), pov_max(pov_largest(m->xform->own_anchor), pov_largest(c->centre)));
    } else {
        out->column[0].x = out->column[1].y = out->column[2].z = size;
        out->from = pov_sub(of->centre, c->centre);
        from = pov_max(pov_largest(of->centre), pov_largest(c->centre));
    }
    for (int i = 0; i < 3; i++)
        least = i == 0 ? pov_largest(out->column[0]) : pov_min(least, pov_largest(out->column[i]));
    return from < farthest * least && pov_largest(of->centre) < farthest * size;
}

static double dot_square(const double s[6], pov_vec3 a, pov_vec3 b)
{
    return s[0] * a.x * b.x + s[1] * a.y * b.y + s[2] * a.z * b.z + s[3] * (a.x * b.y + a.y * b.x) +
           s[4] * (a.x * b.z + a.z * b.x) + s[5] * (a.y * b.z + a.z * b.y);
}

/* False: it is as good as flat, or nothing is known. */
static bool add_slab(const pov_outline *c, int which, const own_map *map, double *to)
{
    const pov_vec3 own = c->normal[which];
    const pov_vec3 n = pov_vec3_of(pov_dot(own, map->column[0]), pov_dot(own, map->column[1]), pov_dot(own, map->column[2]));
    const double length = sqrt(pov_dot(n, n)), shift = pov_dot(own, map->from);

    to[0] = n.x / length;
    to[FOUR] = n.y / length;
    to[2 * FOUR] = n.z / length;
    to[3 * FOUR] = (c->lo[which] - shift) / length;
    to[4 * FOUR] = (c->hi[which] - shift) / length;
    return length > 0.0 && to[4 * FOUR] - to[3 * FOUR] > CSG_LEAST_HEIGHT &&
           (fabs(to[3 * FOUR]) < farthest || c->lo[which] == -HUGE_VAL) && fabs(to[4 * FOUR]) < farthest;
}

static bool add_quadric(const pov_outline *c, const own_map *map, double *to)
{
    static const int first[6] = { 0, 1, 2, 0, 0, 1 }, second[6] = { 0, 1, 2, 1, 2, 2 };
    double number[QUADRIC_NUMBERS], largest = 0.0;
    const double terms = fabs(dot_square(c->square, map->from, map->from)) + fabs(2.0 * pov_dot(c->linear, map->from)) + fabs(c->constant);
    bool known;

    for (int i = 0; i < 6; i++)
        number[i] = dot_square(c->square, map->column[first[i]], map->column[second[i]]);
    for (int i = 0; i < 3; i++)
        number[6 + i] = dot_square(c->square, map->column[i], map->from) + pov_dot(c->linear, map->column[i]);
    number[9] = dot_square(c->square, map->from, map->from) + 2.0 * pov_dot(c->linear, map->from) + c->constant;
    for (int i = 0; i < QUADRIC_NUMBERS; i++)
        largest = pov_max(largest, fabs(number[i]));
    known = terms < most_cancelled * largest;
    for (int i = 0; i < QUADRIC_NUMBERS; i++) {
        to[i * FOUR] = number[i] / largest;
        known = known && to[i * FOUR] >= -1.0 && to[i * FOUR] <= 1.0;
    }
    return known;
}

/* Is the square part that of a sphere, or of a quadric about the axis, but for roundings? It may be off by less than the quadric may. */
static csg_turned find_turned(const double *of, pov_vec3 axis)
{
    enum { N = FOUR };
    const double square[6] = { of[0], of[N], of[2 * N], of[3 * N], of[4 * N], of[5 * N] };
    const double products[6] = { axis.x * axis.x, axis.y * axis.y, axis.z * axis.z, axis.x * axis.y, axis.x * axis.z, axis.y * axis.z };
    const double trace = square[0] + square[1] + square[2], along = dot_square(square, axis, axis);
    csg_turned out = { .all = 0.5 * (trace - along), .axis = axis };
    double sphere = 0.0, turned = 0.0;

    out.of_axis = along - out.all;
    for (int i = 0; i < 6; i++) {
        const double rest = square[i] - (i < 3 ? out.all : 0.0);

        sphere = pov_max(sphere, fabs(rest));
        turned = pov_max(turned, fabs(rest - out.of_axis * products[i]));
    }
    out.kind = sphere <= most_turned ? CSG_SPHERE : turned <= most_turned ? CSG_TURNED : CSG_NOT_TURNED;
    return out;
}

/* What fills up a vector: crossed nowhere near, and met never, in a column that nobody asks. */
static void fill_up(const csg_outline *of, double *slabs, double *quadrics, uint32_t slab_count, uint32_t quadric_count)
{
    for (uint32_t i = slab_count; i < of->slabs; i++) {
        double *to = numbers_of(slabs, SLAB_NUMBERS, i);

        to[3 * FOUR] = -1.0;
        to[4 * FOUR] = 1.0;
    }
    for (uint32_t i = quadric_count; i < of->quadrics; i++) {
        double *to = numbers_of(quadrics, QUADRIC_NUMBERS, i);

        to[0] = to[FOUR] = to[2 * FOUR] = to[9 * FOUR] = 1.0;
    }
}

/* The normal of a column's first slab, of those before `end`; without one, any axis. */
static pov_vec3 axis_of(const csg_outline *of, double *slabs, uint32_t column, uint32_t end)
{
    const double *number = numbers_of(slabs, SLAB_NUMBERS, of->first_slab[column]);

    return of->first_slab[column] < end ? pov_vec3_of(number[0], number[FOUR], number[2 * FOUR]) : pov_vec3_of(1.0, 0.0, 0.0);
}

/* The box's slabs in the tree's units, and a little wider: a crossing beyond it does not count. */
static void add_box(const csg_tree *t, csg_outline *of, double *slabs, uint32_t first)
{
    const pov_vec3 lo = pov_scale(pov_sub(t->box.lo, of->centre), of->per_size), hi = pov_scale(pov_sub(t->box.hi, of->centre), of->per_size);
    const double from[3] = { lo.x, lo.y, lo.z }, to[3] = { hi.x, hi.y, hi.z };

    for (uint32_t i = 0; i < 3; i++) {
        double *number = numbers_of(slabs, SLAB_NUMBERS, first + i);

        number[i * FOUR] = 1.0;
        number[3 * FOUR] = from[i] - CSG_LEAST_HEIGHT;
        number[4 * FOUR] = to[i] + CSG_LEAST_HEIGHT;
    }
}

static bool add_all(const csg_tree *t, const pov_outline *all, csg_outline *of)
{
    double *slabs = of->numbers, *quadrics = of->numbers + SLAB_NUMBERS * of->slabs;
    uint32_t s = 0, q = 0;

    for (uint32_t i = 0; i < of->count; i++) {
        own_map map;

        of->first_slab[i] = (uint8_t)s;
        if ((of->asked | of->held) >> i & 1)
            continue;
        if (!find_map(&t->members[of->member[i]], &all[i], of, &map))
            return false;
        for (uint32_t k = 0; k < all[i].slabs; k++, s++)
            if (!add_slab(&all[i], (int)k, &map, numbers_of(slabs, SLAB_NUMBERS, s)))
                return false;
        if (all[i].round) {
            of->round |= 1u << i;
            of->quadric[i] = (uint8_t)q;
            if (!add_quadric(&all[i], &map, numbers_of(quadrics, QUADRIC_NUMBERS, q)))
                return false;
            if (of->turned)
                of->turned[q] = find_turned(numbers_of(quadrics, QUADRIC_NUMBERS, q), axis_of(of, slabs, i, s));
            q++;
        }
    }
    of->first_slab[of->count] = (uint8_t)s;
    if (of->boxed) {
        add_box(t, of, slabs, s);
        of->first_slab[of->count + 1] = (uint8_t)(s += 3);
    }
    fill_up(of, slabs, quadrics, s, q);
    return true;
}

/* The columns: false: there are too many, or members that no outline can tell of. */
static bool find_columns(const csg_tree *t, csg_outline *of)
{
    if (t->chords.all) {
        of->count = t->few.count;
        memcpy(of->member, t->chords.member, sizeof t->chords.member);
        return true;
    }
    for (uint32_t i = 0; i < t->member_count; i++) {
        const csg_member *m = &t->members[i];

        if (m->absent)
            continue;
        if (m->patch || of->count == CSG_COLUMNS)
            return false;
        of->hidden |= (uint32_t)csg_is_unseen(m) << of->count;
        of->member[of->count++] = i;
    }
    return !t->empty;
}

/* Where the surface that is clipped has no outline: the clips alone. */
static bool take_clips(csg_tree *t, csg_outline *of)
{
    const csg_outline clips = { .count = t->clipped.count };

    *of = clips;
    memcpy(of->member, t->clipped.clip, sizeof t->clipped.clip);
    t->clipped.outlined = clips.count > 0;
    return t->clipped.outlined;
}

static const csg_member *member_at(const csg_tree *t, const csg_outline *of, uint32_t column)
{
    return &t->members[of->member[column]];
}

/* What stands behind the numbers: of trees with chords, of clips and of boxed trees with steps what quadrics are turned; of trees without
 * chords a table of the values of all sets of columns, where these are few, or up to `most` and no product, which needs none. */
static bool is_narrowed(const csg_tree *t) { return t->chords.all || t->clipped.outlined; }

static bool has_steps(const csg_tree *t, const csg_outline *of) { return !is_narrowed(t) && of->count <= CSG_TABLE_COLUMNS; }

static size_t table_size(const csg_tree *t, const csg_outline *of, uint32_t most)
{
    return has_steps(t, of) || (!is_narrowed(t) && !of->is_product && of->count <= most) ? (size_t)1 << of->count : 0;
}

static size_t turned_size(const csg_tree *t, const csg_outline *of)
{
    return is_narrowed(t) || of->boxed ? of->quadrics * sizeof *of->turned : 0;
}

bool csg_is_small(const csg_tree *t)
{
    uint32_t count = 0;
    bool held = false, other = false;

    for (uint32_t i = 0; i < t->member_count; i++) {
        if (t->members[i].absent)
            continue;
        if (t->members[i].patch || ++count > CSG_COLUMNS)
            return false;
        other = other || !t->members[i].shape->outline;
        held = held || (t->members[i].needed && t->members[i].shape->outline);
    }
    return !t->empty && (held || (count <= CSG_TABLE_COLUMNS && !other));
}

/* A column without slabs and quadrics. False: its crossings cannot be found apart from those of others. */
static bool add_other(const csg_member *m, uint32_t column, csg_outline *of, pov_outline *out)
{
    memset(out, 0, sizeof *out);
    if (m->open && m->hidden)
        of->held |= 1u << column;
    else
        of->asked |= 1u << column;
    of->walked = of->walked || (m->open && !m->hidden);
    return m->open || m->boxed;
}

/* What the classes know of the columns. any: others will do that have a box, or gaps. */
static bool ask_columns(const csg_tree *t, csg_outline *of, bool any, pov_outline *all)
{
    for (uint32_t i = 0; i < of->count; i++) {
        const csg_member *m = member_at(t, of, i);

        if (m->open || !m->shape->outline || !m->shape->outline(m->instance, &all[i])) {
            if (!any || !add_other(m, i, of, &all[i]))
                return false;
            continue;
        }
        of->within |= (uint32_t)m->needed << i;
        of->convex |= (uint32_t)(m->needed && (!all[i].round || m->shape->flags & POV_SHAPE_CONVEX)) << i;
        of->bare |= (uint32_t)(all[i].round && all[i].slabs == 0) << i;
        of->halves |= (uint32_t)(!all[i].round && all[i].lo[0] == -HUGE_VAL) << i;
        of->slabs += all[i].slabs;
        of->quadrics += all[i].round;
    }
    of->boxed = t->boxed && (has_steps(t, of) || (t->clipped.outlined && t->clipped.loose));
    of->slabs = (of->slabs + (of->boxed ? 3 : 0) + FOUR - 1) / FOUR * FOUR;
    of->quadrics = (of->quadrics + FOUR - 1) / FOUR * FOUR;
    return true;
}

/* A factor that is no column is far from the tree: then that is another one. */
static void find_factors(const csg_tree *t, csg_outline *of)
{
    uint8_t holds[CSG_CHORDS_MAX] = { 0 };
    uint32_t left = 0;

    if (t->clipped.outlined || !csg_is_product(t, holds))
        return;
    for (uint32_t i = 0; i < t->member_count; i++)
        left += holds[i];
    for (uint32_t i = 0; i < of->count; i++) {
        of->factors |= (uint32_t)holds[of->member[i]] << i;
        left -= holds[of->member[i]];
    }
    of->is_product = left == 0;
}

/* Values for all sets of columns, each one that differs from one before it in a single column. False: no memory. */
static bool find_values(const csg_tree *t, const env *e, csg_outline *of, uint32_t count)
{
    csg_state *states = env_alloc(e, t->node_count, sizeof *states);
    uint8_t *inside = env_alloc(e, t->member_count, sizeof *inside);
    const bool done = states && inside;
    uint32_t set = 0;

    if (done)
        memcpy(states, t->outside, t->node_count * sizeof *states);
    for (uint32_t i = 1; done; i++) {
        of->values[set] = (uint8_t)states[0].value;
        if (i == count)
            break;
        csg_flip(t, states, inside, of->member[first_of(i)]);
        set ^= i & (0u - i);
    }
    env_free(e, states);
    env_free(e, inside);
    return done;
}

/* From the table, what crossings of single columns do. */
static void find_steps(csg_outline *of)
{
    for (uint32_t c = 0; c < of->count; c++) {
        for (uint32_t set = 0; set < 1u << of->count; set++) {
            const uint8_t without = of->values[set & ~(1u << c)], with = of->values[set | 1u << c];

            of->shows[c] |= (uint64_t)(with != without && !(of->hidden >> c & 1)) << set;
            of->grows[c] |= (uint64_t)(with > without) << set;
        }
    }
}

/* About how large is what a tree without a box has? As large as a member's box is, or as it is far from the origin. */
static double find_size(const csg_tree *t, const csg_outline *of, const pov_outline *all)
{
    double size = t->size;

    for (uint32_t i = 0; i < of->count; i++) {
        const instance_xform *x = member_at(t, of, i)->xform;

        size = pov_max(size, x ? pov_largest(x->anchor) : all[i].slabs > 0 && !all[i].round ? fabs(all[i].hi[0]) : pov_largest(all[i].centre));
    }
    return size > 0.0 ? size : 1.0;
}

static void find_middle(const csg_tree *t, const pov_outline *all, csg_outline *of)
{
    const pov_vec3 extent = pov_sub(t->box.hi, t->box.lo);

    of->endless = !t->boxed;
    of->size = t->boxed ? 0.5 * pov_largest(extent) : find_size(t, of, all);
    if (t->boxed)
        of->centre = pov_add(t->box.lo, pov_scale(extent, 0.5));
    of->per_size = 1.0 / of->size;
}

/* May csg_clipped.c have the tree? Of surfaces with gaps it has one that clips without gaps cut, none of which show or are hollows. */
static bool has_clips(const csg_tree *t)
{
    const csg_clipped *c = &t->clipped;

    return c->count > 0 && (t->open_count == 0 || (t->open_count == 1 && t->members[c->surface].open && !c->shown && !c->hollows));
}

static void drop_clips(csg_tree *t)
{
    t->clipped.outlined = false;
    t->clipped.count = t->clipped.loose || t->open_count > 0 ? 0 : t->clipped.count;
}

static bool drop_outline(csg_tree *t, const env *e)
{
    env_free(e, t->outline);
    t->outline = NULL;
    drop_clips(t);
    return true;
}

/* Of all members; or of the clips; or of those that have slabs and quadrics. */
static bool take_columns(csg_tree *t, csg_outline *of, pov_outline *all)
{
    static const csg_outline none = { .count = 0 };

    *of = none;
    if (!has_clips(t))
        t->clipped = (csg_clipped){ .count = 0 };
    if ((find_columns(t, of) && ask_columns(t, of, false, all)) || (!t->chords.all && take_clips(t, of) && ask_columns(t, of, false, all)))
        return true;
    drop_clips(t);
    *of = none;
    return !t->chords.all && t->clipped.count == 0 && find_columns(t, of) && ask_columns(t, of, true, all);
}

bool csg_find_outline(csg_tree *t, const env *e, uint32_t most)
{
    pov_outline all[CSG_COLUMNS];
    size_t numbers, table;
    csg_outline of;

    if (!take_columns(t, &of, all))
        return drop_outline(t, e);
    find_middle(t, all, &of);
    find_factors(t, &of);
    if (!(of.per_size > 1e-100 && of.per_size < 1e100))
        return drop_outline(t, e);
    numbers = SLAB_NUMBERS * of.slabs + QUADRIC_NUMBERS * of.quadrics;
    table = table_size(t, &of, most);
    t->outline = env_alloc(e, 1, sizeof of + numbers * sizeof(double) + turned_size(t, &of) + table);
    if (!t->outline)
        return false;
    *t->outline = of;
    t->outline->turned = turned_size(t, &of) ? (csg_turned *)(void *)(t->outline->numbers + numbers) : NULL;
    if (!add_all(t, all, t->outline))
        return drop_outline(t, e);
    if (table == 0)
        return true;
    t->outline->values = (uint8_t *)(t->outline->numbers + numbers) + turned_size(t, &of);
    if (!find_values(t, e, t->outline, (uint32_t)table))
        return false;
    if (has_steps(t, &of))
        find_steps(t->outline);
    return true;
}

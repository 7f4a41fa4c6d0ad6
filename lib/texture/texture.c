#include "texture/blend.h"
#include "texture/normal.h"
#include "texture/points.h"

#include "base/powers.h"

#include <math.h>

/* Lanes of a node, which of the caller's they are, and their shares; the blends that the node is in, or NULL. */
typedef struct part {
    const normal_blend *around;
    uint32_t n;
    uint8_t lane[LANES_MAX];
    float share[LANES_MAX];
} part;

/* Slope and aoi see the normal that the texture bent last at a point, as in POV-Ray: in a layer above, or in a member that is
 * asked before. */
typedef struct terms {
    const model *model;
    texture_term *items;
    uint32_t count;
    bool sees;                   /* some pattern asks for normals where some are bent */
    vec_lanes seen;              /* these, by lane of the whole, if so */
} terms;

static const texture *const *layers_of(const texture *const *of, uint32_t *count)
{
    *count = (*of)->blend == BLEND_LAYERS ? (*of)->count : 1;
    return (*of)->blend == BLEND_LAYERS ? (*of)->textures : of;
}

/* ---- terms ---- */

static void put(const part *p, uint32_t i, const texture *layer, const pigment *value, const vec_lanes *normal,
                texture_term *out)
{
    out->lane = p->lane[i];
    out->share = p->share[i];
    out->pigment = *value;
    out->finish = &layer->finish;
    out->bent = layer->normal != NULL;
    if (out->bent)
        out->normal = lanes_at(normal, i);
}

/* Without a surface there is no normal. */
static void find_normals(const model *m, const texture *layer, const texture_points *points, const part *p, vec_lanes *out)
{
    if (points->has_surface)
        *out = points->normal;
    else
        memset(out, 0, sizeof *out);
    if (layer->normal && points->has_surface)
        normal_eval(m, layer->normal, p->around, points, p->n, out);
}

static bool pigment_asks(const pigment_node *p, unsigned flag);

static bool asks(const pattern *p, unsigned flag)
{
    return p && (p->class->flags & flag || (p->class->inner && pigment_asks(p->class->inner(p->self), flag)));
}

static bool pigment_asks(const pigment_node *p, unsigned flag)
{
    bool found = asks(p->pattern, flag);

    for (uint32_t i = 0; !found && p->pigments && i < p->count; i++)
        found = pigment_asks(p->pigments[i], flag);
    return found;
}

static bool normal_asks(const normal_node *n, unsigned flag)
{
    bool found = asks(n->pattern, flag);

    for (uint32_t i = 0; !found && n->normals && i < n->count; i++)
        found = n->normals[i] && normal_asks(n->normals[i], flag);
    return found;
}

static bool texture_asks(const texture *of, unsigned flag)
{
    bool found = asks(of->pattern, flag) || (of->blend == BLEND_NONE && (pigment_asks(of->pigment, flag) ||
                                                                         (of->normal && normal_asks(of->normal, flag))));

    for (uint32_t i = 0; !found && of->blend != BLEND_NONE && i < of->count; i++)
        found = texture_asks(of->textures[i], flag);
    return found;
}

bool texture_is_of_view(const texture *of) { return texture_asks(of, PATTERN_NEEDS_VIEW); }
bool texture_is_of_world(const texture *of) { return texture_asks(of, PATTERN_NEEDS_WORLD); }

/* Does slope or aoi see a normal that may be bent? */
static bool asks_normals(const texture *of, bool *perturbs)
{
    bool sees = asks(of->pattern, PATTERN_NEEDS_NORMAL);

    if (of->blend == BLEND_NONE) {
        *perturbs |= of->normal != NULL;
        return pigment_asks(of->pigment, PATTERN_NEEDS_NORMAL);
    }
    for (uint32_t i = 0; i < of->count; i++)
        sees |= asks_normals(of->textures[i], perturbs);
    return sees;
}

bool texture_sees_bent(const texture *of)
{
    bool perturbs = false;
    const bool sees = asks_normals(of, &perturbs);

    return sees && perturbs;
}

/* The points with the normals that are seen there. */
static void take_seen(const terms *t, const texture_points *points, const part *p, texture_points *out)
{
    *out = *points;
    for (uint32_t i = 0; i < p->n; i++)
        lanes_put(&out->normal, i, lanes_at(&t->seen, p->lane[i]));
}

static void find_pigments(const terms *t, const texture *layer, const texture_points *points, const part *p, pigment *out)
{
    texture_points seen;

    if (!t->sees || !pigment_asks(layer->pigment, PATTERN_NEEDS_NORMAL)) {
        pigment_eval(t->model, layer->pigment, points, p->n, out);
        return;
    }
    take_seen(t, points, p, &seen);
    pigment_eval(t->model, layer->pigment, &seen, p->n, out);
}

/* Normals that a layer perturbs are seen from then on. */
static void perturb(terms *t, const texture *layer, const texture_points *points, const part *p, vec_lanes *normals)
{
    find_normals(t->model, layer, points, p, normals);
    for (uint32_t i = 0; t->sees && i < p->n; i++)
        lanes_put(&t->seen, p->lane[i], lanes_at(normals, i));
}

/* The terms of each lane follow one another, from the top. */
static void add_stack(terms *t, const texture *of, const texture_points *points, const part *p)
{
    uint32_t count;
    const texture *const *layers = layers_of(&of, &count);
    pigment pigments[LANES_MAX];
    vec_lanes normals;

    for (uint32_t k = 0; k < count; k++) {
        const texture *layer = layers[count - 1 - k];

        if (layer->normal)
            perturb(t, layer, points, p, &normals);
        find_pigments(t, layer, points, p, pigments);
        for (uint32_t i = 0; i < p->n; i++) {
            texture_term *out = &t->items[t->count + i * count + k];

            put(p, i, layer, &pigments[i], &normals, out);
            out->first = k == 0;
        }
    }
    t->count += p->n * count;
}

/* The shares of a node's members, which begin at the points of `inner`. */
static void find(const model *m, const texture *of, const texture_points *points, uint32_t n, texture_points *inner,
                 blending *b)
{
    SIMD_ALIGNED double value[LANES_MAX];
    pattern_input in;

    if (of->blend == BLEND_PARTS) {
        *inner = *points;
        blend_find_parts(b, points->parts, of->count, n);
        return;
    }
    points_enter(m, of->pattern, points, n, inner);
    in = points_input(m, of->pattern, inner, &inner->at, n);
    if (of->blend != BLEND_AVERAGE)
        points_values(&in, value);
    blend_find(b, of->blend, of->values, of->count, value, n);
    blend_mark(b);
}

/* The same by normals that are seen; the members bend those of the surface. */
static void find_seen(const terms *t, const texture *of, const texture_points *points, const part *p, texture_points *inner, blending *b)
{
    texture_points seen;

    if (!t->sees || !asks(of->pattern, PATTERN_NEEDS_NORMAL)) {
        find(t->model, of, points, p->n, inner, b);
        return;
    }
    take_seen(t, points, p, &seen);
    find(t->model, of, &seen, p->n, inner, b);
    inner->normal = points->normal;
}

static void add_terms(terms *t, const texture *of, const texture_points *points, const part *p);

/* around: with the blend that it is a member of. */
static void add_member(terms *t, const texture *member, const blending *b, uint32_t number, const texture_points *points,
                       const part *outer, const normal_blend *around)
{
    texture_points memory;
    const texture_points *picked;
    part own;

    own.around = around;
    own.n = blend_lanes(b, number, own.lane, own.share);
    if (own.n == 0)
        return;
    picked = points_pick(points, b->n, own.lane, own.n, &memory);
    for (uint32_t i = 0; i < own.n; i++) {
        own.share[i] *= outer->share[own.lane[i]];
        own.lane[i] = outer->lane[own.lane[i]];
    }
    add_terms(t, member, picked, &own);
}

static void add_terms(terms *t, const texture *of, const texture_points *points, const part *p)
{
    const normal_blend own = { of->pattern, p->around };
    texture_points inner;
    blending b;

    if (of->blend == BLEND_NONE || of->blend == BLEND_LAYERS) {
        add_stack(t, of, points, p);
        return;
    }
    find_seen(t, of, points, p, &inner, &b);
    for (uint32_t i = 0; i < of->count; i++) {
        /* Of two entries of a map the upper one comes first. */
        const uint32_t k = t->sees && of->blend == BLEND_MAP ? of->count - 1 - i : i;

        add_member(t, of->textures[k], &b, k, &inner, p, of->blend == BLEND_PARTS ? p->around : &own);
    }
}

uint32_t texture_eval(const model *m, const texture *of, const texture_points *points, uint32_t n, texture_term *out)
{
    terms t;
    part all;

    t.model = m;
    t.items = out;
    t.count = 0;
    t.sees = points->has_surface && texture_sees_bent(of);
    if (t.sees)
        t.seen = points->normal;
    all.around = NULL;
    all.n = n;
    for (uint32_t i = 0; i < n; i++) {
        all.lane[i] = (uint8_t)i;
        all.share[i] = 1.0f;
    }
    add_terms(&t, of, points, &all);
    return t.count;
}

uint32_t texture_most_terms(const texture *of)
{
    uint32_t most = 0, sum = 0, before = 0;

    if (of->blend == BLEND_NONE)
        return 1;
    for (uint32_t i = 0; i < of->count; i++) {
        const uint32_t one = texture_most_terms(of->textures[i]);
        const uint32_t both = before + one;

        most = both > most ? both : most;
        sum += one;
        before = one;
    }
    if (of->blend == BLEND_PARTS)
        return sum < TEXTURE_PARTS_MAX * most ? sum : TEXTURE_PARTS_MAX * most;
    return of->blend == BLEND_LIST || of->blend == BLEND_MAP ? most : sum;
}

/* ---- filters of shadow rays ---- */

static colour filter_of(const pigment *p)
{
    return colour_add(colour_scale(p->color, p->filter), colour_of(p->transmit, p->transmit, p->transmit));
}

static void find_stack_filters(const model *m, const texture *of, const texture_points *points, uint32_t n, colour *out)
{
    uint32_t count;
    const texture *const *layers = layers_of(&of, &count);
    pigment pigments[LANES_MAX];

    for (uint32_t k = 0; k < count; k++) {
        pigment_eval(m, layers[count - 1 - k]->pigment, points, n, pigments);
        for (uint32_t i = 0; i < n; i++) {
            const colour by = filter_of(&pigments[i]);

            out[i] = k == 0 ? by : colour_mul(out[i], by);
        }
    }
}

static void add_filters(const model *m, const texture *member, const blending *b, uint32_t number,
                        const texture_points *points, colour *out)
{
    texture_points picked;
    colour filters[LANES_MAX];
    part own;

    own.n = blend_lanes(b, number, own.lane, own.share);
    if (own.n == 0)
        return;
    texture_filters(m, member, points_pick(points, b->n, own.lane, own.n, &picked), own.n, filters);
    for (uint32_t i = 0; i < own.n; i++)
        out[own.lane[i]] = colour_add(out[own.lane[i]], colour_scale(filters[i], own.share[i]));
}

void texture_filters(const model *m, const texture *of, const texture_points *points, uint32_t n, colour *out)
{
    texture_points inner;
    blending b;

    if (of->blend == BLEND_NONE || of->blend == BLEND_LAYERS) {
        find_stack_filters(m, of, points, n, out);
        return;
    }
    find(m, of, points, n, &inner, &b);
    memset(out, 0, n * sizeof *out);
    for (uint32_t k = 0; k < of->count; k++)
        add_filters(m, of->textures[k], &b, k, &inner, out);
}

/* ---- the focus of light that crosses the surface ---- */

SIMD_CLONES static void find_cosines(const vec_lanes *restrict normal, const vec_lanes *restrict view, uint32_t n, double *restrict out)
{
    for (uint32_t i = 0; i < n; i++) {
        const double cosine = fabs(pov_dot(lanes_at(normal, i), lanes_at(view, i)));

        out[i] = cosine < 1.0 ? cosine : 1.0;
    }
}

void texture_focus_of(const vec_lanes *normal, const vec_lanes *view, const double *power, uint32_t n, double *out)
{
    find_cosines(normal, view, n, out);
    powers_raise_each(power, n, out);
    for (uint32_t i = 0; i < n; i++)
        out[i] += 1.0;
}

static void find_stack_focus(const model *m, const texture *of, const texture_points *points, const part *p, const double *power, double *out)
{
    uint32_t count;
    const texture *const *layers = layers_of(&of, &count);
    SIMD_ALIGNED double by[LANES_MAX];
    vec_lanes normal;

    for (uint32_t i = 0; i < p->n; i++)
        out[i] = 1.0;
    for (uint32_t k = 0; k < count; k++) {
        find_normals(m, layers[k], points, p, &normal);
        texture_focus_of(&normal, &points->view, power, p->n, by);
        for (uint32_t i = 0; i < p->n; i++)
            out[i] *= by[i];
    }
}

static void find_focus(const model *m, const texture *of, const texture_points *points, const part *p, const double *power, double *out);

static void add_focus(const model *m, const texture *member, const texture_points *points, uint32_t whole, const part *p,
                      const double *power, double *out)
{
    SIMD_ALIGNED double own[LANES_MAX], by[LANES_MAX];
    texture_points picked;

    for (uint32_t i = 0; i < p->n; i++)
        own[i] = power[p->lane[i]];
    find_focus(m, member, points_pick(points, whole, p->lane, p->n, &picked), p, own, by);
    for (uint32_t i = 0; i < p->n; i++)
        out[p->lane[i]] += (double)p->share[i] * by[i];
}

static void find_focus(const model *m, const texture *of, const texture_points *points, const part *p, const double *power, double *out)
{
    const normal_blend own = { of->pattern, p->around };
    texture_points inner;
    blending b;

    if (of->blend == BLEND_NONE || of->blend == BLEND_LAYERS) {
        find_stack_focus(m, of, points, p, power, out);
        return;
    }
    find(m, of, points, p->n, &inner, &b);
    for (uint32_t i = 0; i < p->n; i++)
        out[i] = 0.0;
    for (uint32_t k = 0; k < of->count; k++) {
        part member;

        member.around = of->blend == BLEND_PARTS ? p->around : &own;
        member.n = blend_lanes(&b, k, member.lane, member.share);
        if (member.n > 0)
            add_focus(m, of->textures[k], &inner, p->n, &member, power, out);
    }
}

void texture_focus(const model *m, const texture *of, const texture_points *points, const double *power, uint32_t n, double *out)
{
    part all;

    all.around = NULL;
    all.n = n;
    find_focus(m, of, points, &all, power, out);
}

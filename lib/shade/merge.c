#include "shade/merge.h"

#include "base/simd.h"
#include "shade/coloured.h"

/* The sum of a surface's terms, each by what those above it leave. */
typedef struct term_sum {
    const shading *scene;
    const appearance *any;       /* of one of the finishes */
    colour diffuse, emitted;     /* by opacity and share */
    colour left;                 /* factor of what lies below */
    uint32_t stacks;
    bool lit, hidden;            /* nothing below is seen */
    bool goes_on;                /* a ray goes through the last stack */
} term_sum;

bool merge_is_possible(const shading *scene)
{
    return !scene->plan->radiosity && !scene->plan->subsurface && !scene->photons;
}

bool merge_takes(const appearance *a)
{
    return a->kinds == 0 && a->phong == 0.0f && !a->reflective && !a->angular;
}

static void begin_stack(term_sum *sum)
{
    sum->left = colour_of(1.0f, 1.0f, 1.0f);
    sum->hidden = sum->goes_on = false;
    sum->stacks++;
}

static void add(term_sum *sum, const texture_term *t, const appearance *of, bool upper)
{
    const model *m = sum->scene->model;
    appearance_light one;
    colour by;

    if (sum->hidden)
        return;
    appearance_light_of(&one, m, of->finish, &t->pigment);
    by = colour_scale(sum->left, t->share);
    sum->diffuse = colour_add(sum->diffuse, colour_mul(by, colour_scale(t->pigment.color, one.opacity * of->finish->diffuse)));
    sum->emitted = colour_add(sum->emitted, colour_mul(by, one.emitted));
    sum->left = colour_mul(sum->left, one.filter);
    sum->any = of;
    sum->lit |= of->lit;
    sum->goes_on = !upper && appearance_transmits(sum->scene->plan, &t->pigment);
    sum->hidden = upper && appearance_is_dark(m, sum->left);
}

/* False: the terms are not as one. */
static bool add_all(term_sum *sum, const painted *p, uint32_t from, uint32_t end)
{
    for (uint32_t k = from; k < end; k++) {
        const texture_term *t = &p->terms[p->order[k]];
        const appearance *of = shading_finish(sum->scene, t->finish);
        const bool upper = k + 1 < end && !p->terms[p->order[k + 1]].first;

        if (t->bent || !merge_takes(of))
            return false;
        if (t->first)
            begin_stack(sum);
        add(sum, t, of, upper);
        if (sum->goes_on && (sum->stacks > 1 || k + 1 < end))
            return false;
    }
    return true;
}

static void set(const term_sum *sum, const material *of, appearance *out)
{
    *out = *sum->any;
    out->pigment = sum->diffuse;
    out->opacity = out->diffuse_weight = 1.0f;
    out->below_weight = 0.0f;
    out->emitted = sum->emitted;
    out->lit = sum->lit;
    out->transmissive = sum->goes_on;
    if (sum->goes_on)
        onward_set_filter(&out->onward, sum->scene->model, sum->left);
    appearance_set_material(out, of);
}

static bool merge(const shading *scene, const painted *p, uint32_t i, surfaces *s)
{
    const material *of = s->at[i].appearance->material;
    term_sum sum = { .scene = scene };

    if (of->double_illuminate || !add_all(&sum, p, p->first[i], p->first[i + 1]))
        return false;
    set(&sum, of, &s->varying[i]);
    s->at[i].appearance = &s->varying[i];
    return true;
}

/* ---- surfaces side by side ---- */

/* Surfaces whose terms are alike but for the pigments: the same number, level by level of one finish, in one stack. */
enum { LEVELS_MOST = 64, ALIKE_LEAST = 4 };
typedef struct alike {
    uint32_t count, levels;
    uint8_t lane[BATCH_MAX];
    const appearance *of[LEVELS_MOST];
    const finish *refused;       /* terms of this one are never as one with others; NULL: of none */
} alike;

/* By lane: a level's pigments. */
typedef struct SIMD_ALIGNED level_lanes {
    float red[BATCH_MAX], green[BATCH_MAX], blue[BATCH_MAX], filter[BATCH_MAX], transmit[BATCH_MAX], share[BATCH_MAX];
    float covered[BATCH_MAX];    /* what filter takes of the opacity */
} level_lanes;

/* Sums as in term_sum; the last level that is seen; whether nothing below it is. */
typedef struct SIMD_ALIGNED sum_lanes {
    float diffuse[3][BATCH_MAX], emitted[3][BATCH_MAX], left[3][BATCH_MAX];
    int32_t last[BATCH_MAX], hidden[BATCH_MAX];
} sum_lanes;

/* What all lanes of a level have in common. */
typedef struct level {
    colour ambient, ambient_light, emission;
    float diffuse, bailout;
    int32_t number, upper;
    float by_luminance;          /* 1 or 0: loops take conditions that are no numbers for branches */
} level;

static level level_of(const model *m, const finish *f, uint32_t number, bool upper)
{
    const level out = { .ambient = f->ambient, .ambient_light = m->ambient_light, .emission = f->emission, .diffuse = f->diffuse,
                        .bailout = (float)m->adc_bailout, .number = (int32_t)number, .upper = upper,
                        .by_luminance = m->opaque_dark_filters ? 1.0f : 0.0f };

    return out;
}

/* One component of a lane: as add() and appearance_light_of() have it. */
typedef struct component { float diffuse, emitted, left; } component;

SIMD_INLINE component add_component(component sum, float by, float value, float opacity, float own, float filter, float ambient,
                                    float ambient_light, float emission)
{
    const float share = sum.left * by, shines = ambient * value * opacity * ambient_light + emission * value * opacity;
    const component out = { sum.diffuse + share * (value * own), sum.emitted + share * shines, sum.left * filter };

    return out;
}

SIMD_INLINE component component_at(const sum_lanes *l, int k, uint32_t i)
{
    const component out = { l->diffuse[k][i], l->emitted[k][i], l->left[k][i] };

    return out;
}

/* What is not seen adds nothing. */
SIMD_INLINE void put_component(sum_lanes *l, int k, uint32_t i, bool seen, component before, component after)
{
    l->diffuse[k][i] = seen ? after.diffuse : before.diffuse;
    l->emitted[k][i] = seen ? after.emitted : before.emitted;
    l->left[k][i] = seen ? after.left : before.left;
}

/* to: other memory, as compilers take what leaves some lanes as they are for branches. Within another function they make no vectors
 * of this loop. */
SIMD_CLONES SIMD_NOINLINE static void add_level(const sum_lanes *restrict from, const level_lanes *restrict l, const level *at, uint32_t n,
                                  sum_lanes *restrict to)
{
    const level of = *at;

    for (uint32_t i = 0; i < n; i++) {
        const float r = l->red[i], g = l->green[i], b = l->blue[i], transmit = l->transmit[i];
        const float opacity = 1.0f - l->covered[i] - transmit, own = opacity * of.diffuse;
        const component red = component_at(from, 0, i), green = component_at(from, 1, i), blue = component_at(from, 2, i);
        const component more_red = add_component(red, l->share[i], r, opacity, own, r * l->filter[i] + transmit,
                                                 of.ambient.r, of.ambient_light.r, of.emission.r);
        const component more_green = add_component(green, l->share[i], g, opacity, own, g * l->filter[i] + transmit,
                                                   of.ambient.g, of.ambient_light.g, of.emission.g);
        const component more_blue = add_component(blue, l->share[i], b, opacity, own, b * l->filter[i] + transmit,
                                                  of.ambient.b, of.ambient_light.b, of.emission.b);
        const colour left = { more_red.left, more_green.left, more_blue.left };
        const float size = of.by_luminance > 0.0f ? fabsf(colour_luminance(left)) : colour_weight(left);
        const bool seen = from->hidden[i] == 0;
        const int32_t ends = size < of.bailout ? of.upper : 0;

        put_component(to, 0, i, seen, red, more_red);
        put_component(to, 1, i, seen, green, more_green);
        put_component(to, 2, i, seen, blue, more_blue);
        to->last[i] = seen ? of.number : from->last[i];
        to->hidden[i] = seen ? ends : 1;
    }
}

static inline const texture_term *term_at(const painted *p, uint32_t i, uint32_t k) { return &p->terms[p->order[p->first[i] + k]]; }

/* Has the surface such terms? */
static bool is_alike(const alike *a, const painted *p, const surfaces *s, uint32_t i)
{
    if (p->first[i + 1] - p->first[i] != a->levels || s->at[i].appearance->material->double_illuminate)
        return false;
    for (uint32_t k = 0; k < a->levels; k++) {
        const texture_term *t = term_at(p, i, k);

        if (t->bent || t->first != (k == 0) || t->finish != a->of[k]->finish)
            return false;
    }
    return true;
}

/* Find the lanes like the first of `lanes`. Their terms may be as one, or there are none. */
static void find_alike(const shading *scene, const surfaces *s, const painted *p, uint64_t lanes, alike *out)
{
    const uint32_t first = first_of64(lanes);

    out->count = 0;
    out->refused = NULL;
    out->levels = p->first[first + 1] - p->first[first];
    if (out->levels > LEVELS_MOST)
        return;
    for (uint32_t k = 0; k < out->levels; k++) {
        out->of[k] = shading_finish(scene, term_at(p, first, k)->finish);
        if (!merge_takes(out->of[k])) {
            out->refused = out->of[k]->finish;
            return;
        }
    }
    for (; lanes; lanes &= lanes - 1)
        if (is_alike(out, p, s, first_of64(lanes)))
            out->lane[out->count++] = (uint8_t)first_of64(lanes);
}

/* Terms and pigments as they stand in memory, four bytes each: these numbers of eight of them go to lanes side by side. Stored one
 * by one, they would stall the loops that follow. */
enum { SHARE = 1, PIGMENT = 2, EIGHT = 8 };
enum { TERMS_AGREE = 1 / (offsetof(texture_term, share) == 4 * SHARE && offsetof(texture_term, pigment) == 4 * PIGMENT &&
                          offsetof(pigment, filter) == 12 && offsetof(pigment, transmit) == 16) };   /* else this does not compile */

#if defined(__AVX__) && defined(__GNUC__)

/* Four numbers of each, from the first on. */
SIMD_INLINE void transpose(const void *const t[EIGHT], int first, __m256 to[4])
{
    __m256 rows[4], low[2], high[2];

    for (int j = 0; j < 4; j++)
        rows[j] = _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps((const float *)t[j] + first)),
                                       _mm_loadu_ps((const float *)t[j + 4] + first), 1);
    for (int j = 0; j < 2; j++) {
        low[j] = _mm256_unpacklo_ps(rows[2 * j], rows[2 * j + 1]);
        high[j] = _mm256_unpackhi_ps(rows[2 * j], rows[2 * j + 1]);
    }
    to[0] = _mm256_shuffle_ps(low[0], low[1], 0x44);
    to[1] = _mm256_shuffle_ps(low[0], low[1], 0xee);
    to[2] = _mm256_shuffle_ps(high[0], high[1], 0x44);
    to[3] = _mm256_shuffle_ps(high[0], high[1], 0xee);
}

static inline void put_terms(level_lanes *l, uint32_t i, const void *const t[EIGHT])
{
    __m256 v[4];

    transpose(t, SHARE, v);
    _mm256_store_ps(l->share + i, v[0]);
    _mm256_store_ps(l->red + i, v[1]);
    _mm256_store_ps(l->green + i, v[2]);
    _mm256_store_ps(l->blue + i, v[3]);
    transpose(t, PIGMENT + 3, v);
    _mm256_store_ps(l->filter + i, v[0]);
    _mm256_store_ps(l->transmit + i, v[1]);
}

static inline void put_pigments(level_lanes *l, uint32_t i, const void *const of[EIGHT])
{
    __m256 v[4];

    transpose(of, 0, v);
    _mm256_store_ps(l->red + i, v[0]);
    transpose(of, 1, v);
    _mm256_store_ps(l->green + i, v[0]);
    _mm256_store_ps(l->blue + i, v[1]);
    _mm256_store_ps(l->filter + i, v[2]);
    _mm256_store_ps(l->transmit + i, v[3]);
}
#else
static inline void put_pigments(level_lanes *l, uint32_t i, const void *const of[EIGHT])
{
    for (uint32_t j = 0; j < EIGHT; j++) {
        const pigment *const from = of[j];

        l->red[i + j] = from->color.r;
        l->green[i + j] = from->color.g;
        l->blue[i + j] = from->color.b;
        l->filter[i + j] = from->filter;
        l->transmit[i + j] = from->transmit;
    }
}

static inline void put_terms(level_lanes *l, uint32_t i, const void *const t[EIGHT])
{
    const void *of[EIGHT];

    for (uint32_t j = 0; j < EIGHT; j++) {
        of[j] = &((const texture_term *)t[j])->pigment;
        l->share[i + j] = ((const texture_term *)t[j])->share;
    }
    put_pigments(l, i, of);
}
#endif

static void find_covered(const model *m, level_lanes *l, uint32_t n)
{
    if (!m->opacity_uses_filter_colour)
        memcpy(l->covered, l->filter, n * sizeof l->covered[0]);
    for (uint32_t i = 0; m->opacity_uses_filter_colour && i < n; i++)
        l->covered[i] = appearance_covered(m, colour_of(l->red[i], l->green[i], l->blue[i]), l->filter[i]);
}

/* Lanes past the end hold the last one again. */
static void take_terms(level_lanes *l, const alike *a, const painted *p, uint32_t k)
{
    for (uint32_t i = 0; i < a->count; i += EIGHT) {
        const void *t[EIGHT];

        for (uint32_t j = 0; j < EIGHT; j++)
            t[j] = term_at(p, a->lane[i + j < a->count ? i + j : a->count - 1], k);
        put_terms(l, i, t);
    }
}

/* Of one layer. */
static void take_pigments(level_lanes *l, uint32_t n, const pigment *of)
{
    for (uint32_t i = 0; i < n; i += EIGHT) {
        const void *at[EIGHT];

        for (uint32_t j = 0; j < EIGHT; j++)
            at[j] = &of[i + j < n ? i + j : n - 1];
        put_pigments(l, i, at);
    }
}

/* Sums of the levels so far, in turn; the present level. */
typedef struct sums {
    sum_lanes of[2];
    level_lanes level;
    uint32_t first_lit;          /* finishes are lit from this level on */
} sums;

static void begin_lanes(sums *out, uint32_t levels, uint32_t n)
{
    sum_lanes *l = &out->of[0];

    out->first_lit = levels;
    for (uint32_t i = 0; i < n; i++) {
        for (int k = 0; k < 3; k++) {
            l->diffuse[k][i] = l->emitted[k][i] = 0.0f;
            l->left[k][i] = 1.0f;
        }
        l->last[i] = l->hidden[i] = 0;
    }
}

/* Level k, whose pigments are there. */
static void add_next_level(const model *m, const alike *a, uint32_t k, uint32_t n, sums *io)
{
    const level of = level_of(m, a->of[k]->finish, k, k + 1 < a->levels);

    find_covered(m, &io->level, n);
    add_level(&io->of[k & 1], &io->level, &of, n, &io->of[~k & 1]);
    if (a->of[k]->lit && io->first_lit > k)
        io->first_lit = k;
}

/* What a lane shows once all levels have been added. */
static term_sum sum_of(const shading *scene, const alike *a, const sums *from, uint32_t i)
{
    const sum_lanes *l = &from->of[a->levels & 1];
    const pigment lowest = { .filter = from->level.filter[i], .transmit = from->level.transmit[i] };
    const uint32_t last = (uint32_t)l->last[i];
    const term_sum sum = { .scene = scene, .any = a->of[last], .lit = last >= from->first_lit,
                           .diffuse = colour_of(l->diffuse[0][i], l->diffuse[1][i], l->diffuse[2][i]),
                           .emitted = colour_of(l->emitted[0][i], l->emitted[1][i], l->emitted[2][i]),
                           .left = colour_of(l->left[0][i], l->left[1][i], l->left[2][i]),
                           .goes_on = last + 1 == a->levels && appearance_transmits(scene->plan, &lowest) };

    return sum;
}

static void set_lane(const shading *scene, const alike *a, const sums *from, uint32_t i, surfaces *s)
{
    const term_sum sum = sum_of(scene, a, from, i);
    const uint32_t lane = a->lane[i];

    set(&sum, s->at[lane].appearance->material, &s->varying[lane]);
    s->at[lane].appearance = &s->varying[lane];
}

static uint32_t whole_eights(uint32_t n) { return (n + EIGHT - 1) & ~(uint32_t)(EIGHT - 1); }

/* Returns the lanes that are done. */
static uint64_t merge_alike(const shading *scene, const alike *a, const painted *p, surfaces *s)
{
    const uint32_t whole = whole_eights(a->count);
    uint64_t done = 0;
    sums of;

    begin_lanes(&of, a->levels, whole);
    for (uint32_t k = 0; k < a->levels; k++) {
        take_terms(&of.level, a, p, k);
        add_next_level(scene->model, a, k, whole, &of);
    }
    for (uint32_t i = 0; i < a->count; i++) {
        set_lane(scene, a, &of, i, s);
        done |= (uint64_t)1 << a->lane[i];
    }
    return done;
}

/* Those of these lanes none of whose terms has the finish. */
static uint64_t leave_finish(const painted *p, uint64_t lanes, const finish *of)
{
    uint64_t left = lanes;

    for (; lanes; lanes &= lanes - 1) {
        const uint32_t i = first_of64(lanes);

        for (uint32_t k = p->first[i]; k < p->first[i + 1]; k++)
            if (p->terms[p->order[k]].finish == of)
                left &= ~((uint64_t)1 << i);
    }
    return left;
}

void merge_terms(const shading *scene, surfaces *s, painted *p)
{
    uint64_t lanes = 0;
    alike a;

    if (!merge_is_possible(scene))
        return;
    for (uint32_t i = 0; i < s->count; i++)
        lanes |= (uint64_t)!paint_is_single(p, i) << i;
    while (lanes) {
        const uint32_t i = first_of64(lanes);

        find_alike(scene, s, p, lanes, &a);
        if (a.refused) {
            lanes = leave_finish(p, lanes, a.refused);
        } else if (a.count >= ALIKE_LEAST) {
            const uint64_t done = merge_alike(scene, &a, p, s);

            p->merged |= done;
            lanes &= ~done;
        } else {
            p->merged |= (uint64_t)merge(scene, p, i, s) << i;
            lanes &= lanes - 1;
        }
    }
}

/* ---- layers of one texture ---- */

/* From the top. */
static const texture *layer_of(const texture *of, uint32_t k) { return of->textures[of->count - 1 - k]; }

/* The levels of all of its lanes. False: they are not as one. */
static bool find_levels(const shading *scene, const texture *of, alike *out)
{
    if (!merge_is_possible(scene) || of->blend != BLEND_LAYERS || of->count < 2 || of->count > LEVELS_MOST)
        return false;
    out->levels = of->count;
    for (uint32_t k = 0; k < of->count; k++) {
        out->of[k] = shading_finish(scene, &layer_of(of, k)->finish);
        if (layer_of(of, k)->normal || !merge_takes(out->of[k]))
            return false;
    }
    return true;
}

bool merge_takes_layers(const shading *scene, const texture *of)
{
    alike a;

    return find_levels(scene, of, &a);
}

/* Does light go through none of the lanes, and is it seen of all or of none? Then they differ by their colours alone. */
static bool differ_by_colours(const shading *scene, const alike *a, const sums *from, uint32_t n)
{
    const sum_lanes *l = &from->of[a->levels & 1];
    const bool transmission = scene->plan->transmission, lit = (uint32_t)l->last[0] >= from->first_lit;
    bool differ = true;

    for (uint32_t i = 0; i < n; i++) {
        const uint32_t last = (uint32_t)l->last[i];
        const bool clear = (from->level.filter[i] != 0.0f) | (from->level.transmit[i] != 0.0f);

        differ &= (last >= from->first_lit) == lit && !(transmission && clear && last + 1 == a->levels);
    }
    return differ;
}

static void set_all(const shading *scene, const alike *a, const sums *from, surfaces *s)
{
    const sum_lanes *l = &from->of[a->levels & 1];
    const term_sum first = sum_of(scene, a, from, 0);

    set(&first, s->at[0].appearance->material, &s->varying[0]);
    memcpy(s->pigment.red, l->diffuse[0], sizeof s->pigment.red);
    memcpy(s->pigment.green, l->diffuse[1], sizeof s->pigment.green);
    memcpy(s->pigment.blue, l->diffuse[2], sizeof s->pigment.blue);
    memcpy(s->emitted.red, l->emitted[0], sizeof s->emitted.red);
    memcpy(s->emitted.green, l->emitted[1], sizeof s->emitted.green);
    memcpy(s->emitted.blue, l->emitted[2], sizeof s->emitted.blue);
    coloured_set(s, &s->varying[0]);
}

void merge_layers(const shading *scene, const texture *of, const texture_points *points, surfaces *s)
{
    const uint32_t whole = whole_eights(s->count);
    pigment pigments[BATCH_MAX];
    sums sum;
    alike a;

    if (!find_levels(scene, of, &a))
        return;
    begin_lanes(&sum, a.levels, whole);
    for (uint32_t i = 0; i < whole; i++)
        sum.level.share[i] = 1.0f;
    for (uint32_t k = 0; k < a.levels; k++) {
        pigment_eval(scene->model, layer_of(of, k)->pigment, points, s->count, pigments);
        take_pigments(&sum.level, s->count, pigments);
        add_next_level(scene->model, &a, k, whole, &sum);
    }
    for (uint32_t i = 0; i < s->count; i++)
        a.lane[i] = (uint8_t)i;
    if (differ_by_colours(scene, &a, &sum, s->count)) {
        set_all(scene, &a, &sum, s);
        return;
    }
    for (uint32_t i = 0; i < s->count; i++)
        set_lane(scene, &a, &sum, i, s);
}

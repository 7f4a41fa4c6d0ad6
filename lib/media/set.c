#include "media/set.h"

#include <string.h>

void media_set_add(media_set *s, const media *m, uint32_t leaf)
{
    for (uint32_t i = 0; i < m->count && s->count < MEDIA_SET_MAX; i++) {
        const medium *one = &m->items[i];

        s->varies |= medium_varies(one);
        s->dims |= medium_dims(one);
        s->shines |= !colour_is_black(one->emission);
        s->scatters |= !colour_is_black(one->scattering);
        s->strata = one->strata > s->strata ? one->strata : s->strata;
        s->of[s->count++] = (media_member){ one, leaf };
    }
}

bool media_set_same(const media_set *a, const media_set *b)
{
    bool same = a->count == b->count;

    for (uint32_t i = 0; same && i < a->count; i++)
        same = a->of[i].medium == b->of[i].medium;
    return same;
}

static bool is_lit(const model *m, const media_member *of, const light *by)
{
    if (!by || m->light_groups.count == 0)
        return true;
    return of->leaf == MEDIA_AIR ? by->group == 0 : model_is_lit_by(m, of->leaf, by);
}

bool media_set_scatters(const model *m, const media_set *s, const light *by)
{
    for (uint32_t i = 0; s->scatters && i < s->count; i++)
        if (!colour_is_black(s->of[i].medium->scattering) && is_lit(m, &s->of[i], by))
            return true;
    return false;
}

/* The densities of one medium, multiplied, by channel and lane. */
typedef struct density { double by[3][LANES_MAX]; } density;

static void multiply(density *d, const pigment *p, uint32_t n, uint32_t step)
{
    for (uint32_t i = 0; i < n; i++) {
        d->by[0][i] *= (double)p[i * step].color.r;
        d->by[1][i] *= (double)p[i * step].color.g;
        d->by[2][i] *= (double)p[i * step].color.b;
    }
}

static void find_density(const model *m, const medium *of, const texture_points *points, uint32_t n, density *out)
{
    pigment p[LANES_MAX];

    for (uint32_t i = 0; i < n; i++)
        out->by[0][i] = out->by[1][i] = out->by[2][i] = 1.0;
    for (uint32_t k = 0; k < of->density_count; k++) {
        if (of->densities[k]->pattern) {
            pigment_eval(m, of->densities[k], points, n, p);
            multiply(out, p, n, 1);
        } else {
            multiply(out, &of->densities[k]->most, n, 0);
        }
    }
}

/* Of one medium of density one. */
static void find_optics(const medium *of, bool lit, media_channel out[3])
{
    const float a[3] = { of->absorption.r, of->absorption.g, of->absorption.b };
    const float e[3] = { of->emission.r, of->emission.g, of->emission.b };
    const float s[3] = { of->scattering.r, of->scattering.g, of->scattering.b };

    for (int c = 0; c < 3; c++) {
        out[c].loss = (double)a[c] + (double)of->extinction * (double)s[c];
        out[c].emitted = (double)e[c];
        out[c].scatter = lit ? (double)s[c] : 0.0;
    }
}

static void add_by(double *restrict sum, const double *restrict by, double one, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++)
        sum[i] += by[i] * one;
}

static void add(const media_set *s, media_optics *o, const media_channel one[3], const density *d, uint32_t n)
{
    for (int c = 0; c < 3; c++) {
        if (s->dims)
            add_by(o->loss[c], d->by[c], one[c].loss, n);
        if (s->shines)
            add_by(o->emitted[c], d->by[c], one[c].emitted, n);
        if (s->scatters)
            add_by(o->scatter[c], d->by[c], one[c].scatter, n);
    }
}

static void place(const media_segment *on, const double *at, uint32_t n, texture_points *out)
{
    out->has_surface = false;
    out->parts = NULL;
    for (uint32_t i = 0; i < lanes_whole(n); i++)
        texture_point(out, i, pov_add(on->from, pov_scale(on->dir, at[i < n ? i : n - 1])), pov_vec3_of(0.0, 0.0, 0.0));
}

static void clear(const media_set *s, media_optics *o, uint32_t n)
{
    for (int c = 0; c < 3; c++) {
        if (s->dims)
            memset(o->loss[c], 0, n * sizeof *o->loss[c]);
        if (s->shines)
            memset(o->emitted[c], 0, n * sizeof *o->emitted[c]);
        if (s->scatters)
            memset(o->scatter[c], 0, n * sizeof *o->scatter[c]);
    }
}

void media_set_even(const model *m, const media_set *s, const light *by, media_channel out[3])
{
    media_channel one[3];

    for (int c = 0; c < 3; c++)
        out[c] = (media_channel){ 0.0, 0.0, 0.0 };
    for (uint32_t i = 0; i < s->count; i++) {
        const medium *of = s->of[i].medium;
        double dense[3] = { 1.0, 1.0, 1.0 };

        find_optics(of, is_lit(m, &s->of[i], by), one);
        for (uint32_t k = 0; k < of->density_count; k++) {
            dense[0] *= (double)of->densities[k]->most.color.r;
            dense[1] *= (double)of->densities[k]->most.color.g;
            dense[2] *= (double)of->densities[k]->most.color.b;
        }
        for (int c = 0; c < 3; c++) {
            out[c].loss += dense[c] * one[c].loss;
            out[c].emitted += dense[c] * one[c].emitted;
            out[c].scatter += dense[c] * one[c].scatter;
        }
    }
}

/* Where no density varies, n lanes are alike. */
static void set_even(const model *m, const media_set *s, const light *by, uint32_t n, media_optics *out)
{
    media_channel sum[3];

    media_set_even(m, s, by, sum);
    for (int c = 0; c < 3; c++)
        for (uint32_t i = 0; i < n; i++) {
            out->loss[c][i] = sum[c].loss;
            out->emitted[c][i] = sum[c].emitted;
            out->scatter[c][i] = sum[c].scatter;
        }
}

void media_set_at_points(const model *m, const media_set *s, const texture_points *points, uint32_t n, const light *by, media_optics *out)
{
    media_channel one[3];
    density d;

    clear(s, out, n);
    for (uint32_t i = 0; i < s->count; i++) {
        find_density(m, s->of[i].medium, points, n, &d);
        find_optics(s->of[i].medium, is_lit(m, &s->of[i], by), one);
        add(s, out, one, &d, n);
    }
}

void media_set_at(const model *m, const media_set *s, const media_segment *on, const double *at, uint32_t n,
                  const light *by, media_optics *out)
{
    texture_points points;

    if (!s->varies) {
        set_even(m, s, by, n, out);
        return;
    }
    place(on, at, n, &points);
    media_set_at_points(m, s, &points, n, by, out);
}

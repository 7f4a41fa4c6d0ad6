#include "media/set.h"

#include "texture/texture.h"

#include <string.h>

void media_set_add(media_set *s, const media *m, uint32_t leaf)
{
    for (uint32_t i = 0; i < m->count && s->count < MEDIA_SET_MAX; i++) {
        const medium *one = &m->items[i];

        s->varies |= medium_varies(one);
        s->scatters |= !colour_is_black(one->scattering);
        s->strata = one->strata > s->strata ? one->strata : s->strata;
        s->of[s->count++] = (media_member){ one, leaf };
    }
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

static void add_channel(double *restrict loss, double *restrict emitted, double *restrict scatter, const double *restrict by,
                        const double coefficients[3], uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        loss[i] += by[i] * coefficients[0];
        emitted[i] += by[i] * coefficients[1];
        scatter[i] += by[i] * coefficients[2];
    }
}

static void add(media_optics *o, const medium *of, const density *d, bool lit, uint32_t n)
{
    const float a[3] = { of->absorption.r, of->absorption.g, of->absorption.b };
    const float e[3] = { of->emission.r, of->emission.g, of->emission.b };
    const float s[3] = { of->scattering.r, of->scattering.g, of->scattering.b };

    for (int c = 0; c < 3; c++) {
        const double coefficients[3] = { (double)a[c] + (double)of->extinction * (double)s[c], (double)e[c],
                                         lit ? (double)s[c] : 0.0 };

        add_channel(o->loss[c], o->emitted[c], o->scatter[c], d->by[c], coefficients, n);
    }
}

static void place(const media_segment *on, const double *at, uint32_t n, texture_points *out)
{
    out->has_surface = false;
    out->parts = NULL;
    for (uint32_t i = 0; i < n; i++)
        texture_point(NULL, pov_add(on->from, pov_scale(on->dir, at[i])), pov_vec3_of(0.0, 0.0, 0.0), i, out);
}

static void clear(media_optics *o, uint32_t n)
{
    for (int c = 0; c < 3; c++)
        for (uint32_t i = 0; i < n; i++)
            o->loss[c][i] = o->emitted[c][i] = o->scatter[c][i] = 0.0;
}

/* All lanes are as the first one. */
static void repeat(media_optics *o, uint32_t n)
{
    for (int c = 0; c < 3; c++)
        for (uint32_t i = 1; i < n; i++) {
            o->loss[c][i] = o->loss[c][0];
            o->emitted[c][i] = o->emitted[c][0];
            o->scatter[c][i] = o->scatter[c][0];
        }
}

void media_set_at(const model *m, const media_set *s, const media_segment *on, const double *at, uint32_t n,
                  const light *by, media_optics *out)
{
    const uint32_t some = s->varies ? n : 1;
    texture_points points;
    density d;

    if (s->varies)
        place(on, at, n, &points);
    clear(out, some);
    for (uint32_t i = 0; i < s->count; i++) {
        find_density(m, s->of[i].medium, &points, some, &d);
        add(out, s->of[i].medium, &d, is_lit(m, &s->of[i], by), some);
    }
    if (!s->varies)
        repeat(out, n);
}

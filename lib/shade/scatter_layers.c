#include "shade/scatter.h"
#include "shade/scatter_rays.h"
#include "shade/unscattered.h"

/* The rays of one hit, by layer from `first` to `end`: coefficients that are 0 where rays were added to an earlier one. */
typedef struct hit_rays {
    scattering *to;
    const layers *from;
    const interfaces *crossed;   /* NULL: nothing is refracted */
    uint32_t first, end;
    coefficient reflected[BATCH_MAX], through[BATCH_MAX], shut[BATCH_MAX];
    bool reflects[BATCH_MAX], goes_on[BATCH_MAX], is_dark[BATCH_MAX], is_shut[BATCH_MAX];
    uint32_t reflected_count, open;      /* at most so many reflect or are shut, and go on */
} hit_rays;

static bool is_same_normal(const geometry *g, uint32_t a, uint32_t b)
{
    return g->bent.x[a] == g->bent.x[b] && g->bent.y[a] == g->bent.y[b] && g->bent.z[a] == g->bent.z[b];
}

static float exponent_of(const layers *l, uint32_t i) { return l->on.at[i].appearance->finish->reflection.exponent; }

/* Total reflection takes the place of what a stack, from `top` to `last`, reflects with the same normal. */
static void shut_stack(hit_rays *f, uint32_t top, uint32_t last)
{
    const layers *l = f->from;

    for (uint32_t i = top; i <= last; i++)
        f->reflects[i] = f->reflects[i] && !is_same_normal(&l->on.geometry, top, i);
    f->goes_on[top] = false;
    f->is_shut[top] = true;
    f->reflected_count++;
    f->shut[top] = scatter_shut_by(f->to, &l->on.at[top], top, &l->of[last].through);
    f->shut[top].by = colour_scale(f->shut[top].by, l->of[last].share);
}

/* The ray through a stack. The normal of its upper layer bends it, and that layer's film colours it where it is totally
 * reflected, as in POV-Ray: the ray is kept there. */
static void find_through(hit_rays *f, uint32_t top, uint32_t last)
{
    const layers *l = f->from;
    const appearance *a = l->on.at[top].appearance;

    if (!a->transmissive || !l->on.at[last].appearance->transmissive)
        return;
    f->goes_on[top] = true;
    f->open++;
    f->through[top] = l->of[last].through;
    f->is_dark[top] = l->of[last].is_dark;
    if (f->crossed && !a->clear && !f->is_dark[top] && scatter_is_shut(f->to, f->crossed, &l->on.at[top], top))
        shut_stack(f, top, last);
}

static void find_rays(hit_rays *f)
{
    const layers *l = f->from;
    uint32_t top = f->first;

    f->reflected_count = f->open = 0;
    for (uint32_t i = f->first; i < f->end; i++) {
        f->reflects[i] = l->on.at[i].appearance->reflective;
        f->reflected_count += f->reflects[i];
        f->reflected[i] = l->of[i].reflection;
        f->is_shut[i] = f->goes_on[i] = false;
        if (l->of[i].first)
            top = i;
        if (l->of[i].last)
            find_through(f, top, i);
    }
}

/* Add later rays of the same direction to one. Those of different weights are cut off at different levels, so they are not
 * one. */
static void merge(const geometry *g, uint32_t end, uint32_t i, bool *is, coefficient *by, bool any_normal)
{
    for (uint32_t k = i + 1; is[i] && k < end; k++) {
        if (!is[k] || by[k].weight != by[i].weight || !(any_normal || is_same_normal(g, i, k)))
            continue;
        is[k] = false;
        by[i].by = colour_add(by[i].by, by[k].by);
    }
}

/* Mirrors with an exponent are not joined to others. */
static void send_reflected(hit_rays *f)
{
    const layers *l = f->from;
    bool plain[BATCH_MAX];

    for (uint32_t i = f->first; i < f->end; i++)
        plain[i] = f->reflects[i] && exponent_of(l, i) == 1.0f;
    for (uint32_t i = f->first; i < f->end; i++) {
        if (!f->reflects[i] && !f->is_shut[i])
            continue;
        if (f->reflected_count > 1) {
            merge(&l->on.geometry, f->end, i, plain, f->reflected, false);
            merge(&l->on.geometry, f->end, i, f->is_shut, f->shut, false);
        }
        if (plain[i])
            scatter_reflect(f->to, &l->on.at[i], i, &f->reflected[i]);
        else if (f->reflects[i] && exponent_of(l, i) != 1.0f)
            scatter_reflect_power(f->to, &l->on.at[i], i, &f->reflected[i], exponent_of(l, i));
        if (f->is_shut[i])
            scatter_reflect_inside(f->to, &l->on.at[i], i, &f->shut[i]);
    }
}

static void send_through(hit_rays *f)
{
    const layers *l = f->from;

    for (uint32_t i = f->first; i < f->end; i++) {
        const surface *s = &l->on.at[i];

        if (!f->goes_on[i] || f->is_dark[i])
            continue;
        merge(&l->on.geometry, f->end, i, f->goes_on, f->through, !f->crossed);
        if (f->crossed && !s->appearance->clear)
            scatter_cross(f->to, f->crossed, s, i, &f->through[i]);
        else
            scatter_transmit(f->to, s, i, &f->through[i]);
    }
}

void scatter_layers(shade_context *c, layers *l, batch_queue *q)
{
    const bool refraction = c->scene->plan->refraction;
    scattering to = scatter_begin(c, &l->on, q);
    interfaces crossed;
    hit_rays f;

    f.to = &to;
    f.from = l;
    f.crossed = refraction ? &crossed : NULL;
    if (refraction)
        scatter_find_interfaces(c, &l->on, &crossed);
    for (f.first = 0; f.first < l->on.count; f.first = f.end) {
        for (f.end = f.first + 1; f.end < l->on.count && l->of[f.end].of == l->of[f.first].of; f.end++)
            ;
        find_rays(&f);
        if (f.reflected_count > 0)
            send_reflected(&f);
        if (f.open > 0)
            send_through(&f);
    }
    if (c->scene->plan->subsurface && !c->photons_fly)
        unscattered_rays(&to, &l->on, l->of);
    scatter_count(&to);
}

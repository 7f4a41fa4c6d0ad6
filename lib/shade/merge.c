#include "shade/merge.h"

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
    appearance_light_of(&one, m, of->finish, &t->pigment, upper);
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

void merge_terms(const shading *scene, surfaces *s, painted *p)
{
    if (!merge_is_possible(scene))
        return;
    for (uint32_t i = 0; i < s->count; i++)
        if (!paint_is_single(p, i))
            p->merged |= (uint64_t)merge(scene, p, i, s) << i;
}

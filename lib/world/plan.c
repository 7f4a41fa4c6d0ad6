#include "world/plan.h"

#include "base/err.h"
#include "base/vec.h"
#include "plug/shape_class.h"

#include <stdio.h>
#include <string.h>

/* ---- rows ---- */

pov_status plan_add(plan *p, pov_error *err, bool used, const char *subject, const char *state, const char *reason, ...)
{
    plan_row row = { used, NULL, state, NULL };
    char text[512];
    va_list args;

    va_start(args, reason);
    vsnprintf(text, sizeof text, reason, args);
    va_end(args);
    row.subject = arena_text(&p->memory, subject, strlen(subject));
    row.reason = arena_text(&p->memory, text, strlen(text));
    if (!row.subject || !row.reason || !VEC_PUSH(p->memory.env, &p->rows, row))
        return err_memory(err);
    return POV_OK;
}

void plan_free(plan *p)
{
    if (p->memory.env)
        env_free(p->memory.env, p->rows.items);
    if (p->memory.env)
        arena_free(&p->memory);
    memset(p, 0, sizeof *p);
}

/* ---- what there is in the model ---- */

typedef struct survey {
    size_t emitting;             /* lights that are not black */
    size_t lit;                  /* objects with diffuse light or highlights */
    size_t casting, filtering;   /* objects that cast a shadow; transparent ones of them */
    size_t glossy, metallic, varying, reflective, transparent, refracting, dielectrics;
} survey;

static bool is_solid(const leaf_node *o) { return (o->shape->flags & POV_SHAPE_SOLID) && o->shape->inside; }

bool plan_is_dielectric(const model *m, const leaf_node *o)
{
    return is_solid(o) && material_is_transparent(&m->materials.items[o->material]);
}

/* Count n objects with the same properties. */
static void count_objects(survey *s, const material *m, bool casts, bool solid, size_t n)
{
    bool transparent = material_is_transparent(m), glossy = m->phong != 0.0f;

    s->lit += glossy || (m->diffuse != 0.0f && !colour_is_black(m->pigment)) ? n : 0;
    s->casting += casts ? n : 0;
    s->filtering += casts && transparent ? n : 0;
    s->glossy += glossy ? n : 0;
    s->metallic += glossy && m->metallic != 0.0f ? n : 0;
    s->varying += m->pattern ? n : 0;
    s->reflective += !colour_is_black(m->reflection) ? n : 0;
    s->transparent += transparent ? n : 0;
    s->refracting += transparent && m->has_interior && m->ior != 1.0 ? n : 0;
    s->dielectrics += transparent && solid ? n : 0;
}

/* Many objects have few materials: objects are counted by material first. False: no memory. */
static bool survey_model(const model *m, survey *s)
{
    enum { CASTS = 1, SOLID = 2, KINDS = 4 };
    size_t *counts = env_alloc(m->env, m->materials.count * KINDS, sizeof *counts), i;
    bool done;

    memset(s, 0, sizeof *s);
    for (i = 0; i < m->lights.count; i++)
        s->emitting += !colour_is_black(m->lights.items[i].color);
    for (i = 0; counts && i < m->leaves.count; i++) {
        const leaf_node *o = &m->leaves.items[i];
        counts[(size_t)o->material * KINDS + (o->flags & LEAF_NO_SHADOW ? 0 : CASTS) + (is_solid(o) ? SOLID : 0)]++;
    }
    for (i = 0; counts && i < m->materials.count * KINDS; i++)
        count_objects(s, &m->materials.items[i / KINDS], i & CASTS, i & SOLID, counts[i]);
    done = counts != NULL;
    env_free(m->env, counts);
    return done;
}

/* ---- needs ---- */

static void derive_needs(plan *p, const survey *s)
{
    p->lighting = s->emitting > 0 && s->lit > 0;
    p->shadows = p->lighting && s->casting > 0;
    p->coloured_shadows = p->shadows && s->filtering > 0;
    p->highlights = p->lighting && s->glossy > 0;
    p->metallic = p->lighting && s->metallic > 0;
    p->textures = s->varying > 0;
    p->reflection = s->reflective > 0;
    p->transmission = s->transparent > 0;
    p->refraction = s->refracting > 0;
    p->dielectrics_at_start = p->refraction && s->dielectrics > 0;
}

static const char *no_light(const survey *s)
{
    return s->emitting == 0 ? "no light emits" : "no surface has a diffuse colour or a highlight";
}

static pov_status explain_light(plan *p, const survey *s, pov_error *err)
{
    pov_status status;

    if (p->lighting)
        status = plan_add(p, err, true, "lighting", "computed", "lights that emit: %zu; objects with diffuse or highlights: %zu",
                          s->emitting, s->lit);
    else
        status = plan_add(p, err, false, "lighting", "left out", "%s", no_light(s));
    if (status == POV_OK && p->shadows)
        status = plan_add(p, err, true, "shadow rays", "sent", "objects that throw a shadow: %zu", s->casting);
    else if (status == POV_OK)
        status = plan_add(p, err, false, "shadow rays", "left out", "%s",
                          p->lighting ? "every object is no_shadow" : no_light(s));
    if (status == POV_OK && p->coloured_shadows)
        status = plan_add(p, err, true, "coloured shadows", "collected", "transparent objects that throw a shadow: %zu",
                          s->filtering);
    else if (status == POV_OK)
        status = plan_add(p, err, false, "coloured shadows", "left out", "%s",
                          p->shadows ? "nothing that throws a shadow is transparent: the first object hit ends it"
                                     : "no shadow rays are sent");
    return status;
}

/* A row on a part that objects of some kind need. */
static pov_status explain_kind(plan *p, bool used, const char *subject, const char *state, const char *kind,
                               size_t count, const char *why_not, pov_error *err)
{
    if (used)
        return plan_add(p, err, true, subject, state, "objects %s: %zu", kind, count);
    return plan_add(p, err, false, subject, "left out", "%s", why_not);
}

static pov_status explain_surfaces(plan *p, const survey *s, pov_error *err)
{
    pov_status status = explain_kind(p, p->highlights, "highlights", "computed", "with phong", s->glossy,
                                     s->glossy > 0 ? no_light(s) : "no surface has phong", err);

    if (status == POV_OK)
        status = explain_kind(p, p->metallic, "metallic", "computed", "with metallic highlights", s->metallic,
                              s->metallic > 0 ? no_light(s) : "no surface has a metallic highlight", err);
    if (status == POV_OK)
        status = explain_kind(p, p->textures, "textures", "evaluated", "whose texture varies", s->varying,
                              "every texture is constant", err);
    if (status == POV_OK)
        status = explain_kind(p, p->reflection, "reflection", "followed", "with reflection", s->reflective,
                              "no surface has reflection", err);
    if (status == POV_OK)
        status = explain_kind(p, p->transmission, "transparency", "followed", "that let light through", s->transparent,
                              "no surface lets light through", err);
    if (status == POV_OK)
        status = explain_kind(p, p->refraction, "refraction", "computed", "that refract light", s->refracting,
                              p->transmission ? "no transparent surface has an interior of ior other than 1"
                                              : "no surface lets light through", err);
    if (status == POV_OK)
        status = explain_kind(p, p->dielectrics_at_start, "dielectrics at the camera", "looked up", "that may hold it",
                              s->dielectrics, "nothing refracts light", err);
    return status;
}

pov_status plan_make(plan *p, const model *m, pov_error *err)
{
    survey s;
    pov_status status;

    memset(p, 0, sizeof *p);
    arena_init(&p->memory, m->env);
    if (!survey_model(m, &s))
        return err_memory(err);
    derive_needs(p, &s);
    status = plan_add(p, err, true, "dialect", m->dialect == POV_DIALECT_COURSE ? "course" : "povray", "%s",
                          m->dialect_reason ? m->dialect_reason : "asked for");
    if (status == POV_OK)
        status = explain_light(p, &s, err);
    if (status == POV_OK)
        status = explain_surfaces(p, &s, err);
    if (status < 0)
        plan_free(p);
    return status;
}

#include "world/plan.h"

#include "base/err.h"
#include "plug/shape_class.h"

#include <string.h>

/* ---- what there is in the model ---- */

bool plan_is_solid(const leaf_node *o) { return shape_is_solid(o->shape, o->instance); }

bool plan_is_filled(const leaf_node *o) { return plan_is_solid(o) && !(o->flags & LEAF_HOLLOW); }

bool plan_is_dielectric(const model *m, const leaf_node *o)
{
    const material *of = &m->materials.items[o->material];

    return plan_is_solid(o) && (material_is_transparent(of) || of->interior.media);
}

/* Has it light that is reflected in all directions? */
static bool is_matt(const finish *f) { return f->diffuse != 0.0f || f->diffuse_back != 0.0f || f->crand != 0.0f; }

static bool is_refracting(const interior *i)
{
    return i->given && (i->ior != 1.0 || i->dispersion != 1.0 || i->fade_distance > 0.0);
}

/* Count n objects with the same properties. */
static void count_objects(plan_counts *s, const material *m, bool casts, bool solid, size_t n)
{
    bool transparent = material_is_transparent(m), glossy = finish_is_glossy(&m->finish);

    s->lit += glossy || (is_matt(&m->finish) && !colour_is_black(m->pigment)) ? n : 0;
    s->diffuse += m->finish.diffuse != 0.0f || m->finish.diffuse_back != 0.0f ? n : 0;
    s->casting += casts ? n : 0;
    s->filtering += casts && transparent ? n : 0;
    s->glossy += glossy ? n : 0;
    s->metallic += glossy && m->finish.metallic != 0.0f ? n : 0;
    s->varying += m->texture ? n : 0;
    s->reflective += finish_is_mirror(&m->finish) ? n : 0;
    s->transparent += transparent ? n : 0;
    s->refracting += transparent && is_refracting(&m->interior) ? n : 0;
    s->dispersive += transparent && m->interior.dispersion != 1.0 ? n : 0;
    s->fading += transparent && m->interior.fade_distance > 0.0 ? n : 0;
    s->located += transparent && interior_is_located(&m->interior) ? n : 0;
    s->dielectrics += (transparent || m->interior.media) && solid ? n : 0;
    s->filled += m->interior.media ? n : 0;
    s->fresnel += transparent && finish_is_mirror(&m->finish) && (m->texture || m->finish.reflection.fresnel) ? n : 0;
}

/* Are photons sent to some object that reflects or refracts them? */
static void count_photons(const model *m, plan_counts *s)
{
    const uint32_t acts = PHOTON_REFLECTS | PHOTON_REFRACTS;
    uint32_t of_lights = 0;

    if (!m->photons.given)
        return;
    for (size_t i = 0; i < m->lights.count; i++) {
        of_lights |= m->lights.items[i].flags & acts;
        s->photon_lights += !colour_is_black(m->lights.items[i].color) && !(m->lights.items[i].flags & LIGHT_SHADOWLESS);
    }
    for (size_t i = 0; i < m->leaves.count; i++) {
        const uint32_t flags = m->leaves.items[i].flags;

        s->targets += (flags & PHOTON_TARGET) && !(flags & LEAF_NO_SHADOW) && ((flags | of_lights) & acts);
    }
}

/* Many objects have few materials: objects are counted by material first. */
enum { CASTS = 1, SOLID = 2, KINDS = 4 };

/* Of leaves that are there so many times. */
static void count_leaves(const model *m, size_t times, uint32_t hides, size_t *counts, plan_counts *s)
{
    for (size_t i = 0; i < m->leaves.count; i++) {
        const leaf_node *o = &m->leaves.items[i];
        s->hidden += (o->flags & hides) != 0 ? times : 0;
        counts[(size_t)o->material * KINDS + (o->flags & LEAF_NO_SHADOW ? 0 : CASTS) + (plan_is_solid(o) ? SOLID : 0)] += times;
        s->smooth += o->shape->shading_normals != NULL ? times : 0;
    }
}

/* False: no memory. */
static bool survey_model(const model *m, plan_counts *s)
{
    size_t *counts = env_alloc(m->env, m->materials.count * KINDS, sizeof *counts), i;
    const uint32_t hides = LEAF_NO_IMAGE | LEAF_NO_REFLECTION | (m->radiosity.given ? LEAF_NO_RADIOSITY : 0u);
    bool done;

    memset(s, 0, sizeof *s);
    for (i = 0; i < m->lights.count; i++) {
        s->emitting += !colour_is_black(m->lights.items[i].color);
        s->attenuated += (m->lights.items[i].flags & LIGHT_ATTENUATED) != 0;
    }
    count_photons(m, s);
    if (counts)
        count_leaves(m, 1, hides, counts, s);
    for (i = 0; counts && i < m->parts.count; i++)
        count_leaves(m->parts.items[i], m->parts.items[i]->uses, hides, counts, s);
    for (i = 0; counts && i < m->materials.count * KINDS; i++)
        count_objects(s, &m->materials.items[i / KINDS], i & CASTS, i & SOLID, counts[i]);
    done = counts != NULL;
    env_free(m->env, counts);
    return done;
}

/* ---- needs ---- */

/* Does anything scatter light? */
static bool any_scatters(const model *m)
{
    bool any = media_scatter(m->atmosphere);

    for (size_t i = 0; !any && i < m->materials.count; i++)
        any = media_scatter(m->materials.items[i].interior.media);
    return any;
}

bool plan_attenuates(const model *m)
{
    bool any = false;

    for (size_t i = 0; i < m->lights.count; i++)
        any = any || (m->lights.items[i].flags & LIGHT_ATTENUATED);
    return any && (m->atmosphere || m->fogs.count > 0);
}

/* Fog and media end at solids, and dielectrics within others; gathered light and photons count surfaces. */
static bool drops_clear_members(const plan *p, const model *m)
{
    bool through = false;

    for (size_t i = 0; i < m->lights.count; i++)
        through = through || m->lights.items[i].through_count > 0;
    return p->transmission && !(through || p->refraction || p->media || p->subsurface || m->radiosity.given || m->photons.given ||
                                m->fogs.count > 0 || m->rainbows.count > 0);
}

static void derive_needs(plan *p, const model *m, const plan_counts *s)
{
    p->media = s->filled > 0 || m->atmosphere;
    p->scattering = p->media && s->emitting > 0 && any_scatters(m);
    p->lighting = s->emitting > 0 && (s->lit > 0 || p->scattering);
    p->shadows = p->lighting && (s->casting > 0 || s->attenuated > 0);
    p->coloured_shadows = p->shadows && s->filtering > 0;
    p->highlights = p->lighting && s->glossy > 0;
    p->metallic = p->lighting && s->metallic > 0;
    p->smooth = s->smooth > 0;
    p->textures = s->varying > 0;
    p->reflection = s->reflective > 0;
    p->transmission = s->transparent > 0;
    p->refraction = s->refracting > 0 || s->filled > 0;
    p->dispersion = s->dispersive > 0;
    p->fading = s->fading > 0;
    p->located = s->located > 0 || (s->transparent > 0 && plan_attenuates(m));
    p->hidden = s->hidden > 0;
    p->radiosity = m->radiosity.given && s->diffuse > 0;
    p->photons = p->lighting && s->targets > 0 && s->photon_lights > 0;
    p->subsurface = m->subsurface.given && m->subsurface.used;
    p->random = p->radiosity || p->photons || p->media || p->subsurface;
    p->dielectrics_at_start = p->refraction && s->dielectrics > 0;
    p->opaque_at_start = p->dielectrics_at_start && s->fresnel > 0;
    p->clear_members = drops_clear_members(p, m);
}

pov_status plan_make(plan *p, const model *m, pov_error *err)
{
    memset(p, 0, sizeof *p);
    if (!survey_model(m, &p->counts))
        return err_memory(err);
    derive_needs(p, m, &p->counts);
    return POV_OK;
}

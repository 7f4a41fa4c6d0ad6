#include "render/maps.h"

#include "query/passage.h"
#include "render/raygen.h"
#include "shade/albedo.h"

#include <string.h>

/* Neighbours of a row: their rays, and what these hit. */
typedef struct run {
    uint32_t count;
    pov_ray rays[WORLD_MANY];
    uint64_t met;                /* by ray: it hits something that the camera sees */
    hit hits[WORLD_MANY];        /* complete */
    double depth[WORLD_MANY];    /* their distances */
    bool certain[WORLD_MANY];
} run;

typedef struct maps {
    pov_tracer *tracer;
    const shading *scene;
    const settings *settings;
    const pov_camera *camera;
    pov_pixels format;
} maps;

/* ---- rays ---- */

static void aim(const maps *m, run *r, int x, int y, uint32_t count)
{
    const settings *s = m->settings;
    raygen_screen through = { .u = { 0.0 } };   /* and the middle of a lens */

    for (uint32_t i = 0; i < count; i++) {
        through.u[i] = raygen_u(s->crop.x + x + (int)i, 0.5, s->width);
        through.v[i] = raygen_v(s->crop.y + y, 0.5, s->height);
    }
    r->count = count;
    raygen_begin(m->camera, r->rays, count);
    raygen_cast(m->scene->model, m->camera, &through, count, r->rays);
}

static bool is_ray(const pov_ray *ray)
{
    return isfinite(ray->org.x + ray->org.y + ray->org.z) && pov_largest(pov_unit(ray->dir)) > 0.0;
}

/* ---- hits ---- */

/* Straight on through what the camera does not see. */
static bool pass_unseen(const maps *m, const pov_ray *ray, hit *h)
{
    passage p = { .world = m->scene->world, .context = m->tracer->context.context, .ray = *ray };

    while (passage_next(&p, h))
        if (!shading_info(m->scene, h->object)->no_image)
            return true;
    return false;
}

static void find(const maps *m, run *r)
{
    query_context *k = m->tracer->context.context;
    const pov_ray *rays[WORLD_MANY];
    uint32_t of[WORLD_MANY], count = 0;
    hit hits[WORLD_MANY];
    uint64_t found;

    for (uint32_t i = 0; i < r->count; i++)
        if (is_ray(&r->rays[i])) {
            rays[count] = &r->rays[i];
            of[count++] = i;
        }
    found = count > 0 ? query_nearest(m->scene->world, k, rays, count, HUGE_VAL, hits) : 0;
    r->met = 0;
    for (uint32_t i = 0; i < count; i++)
        if (found >> i & 1) {
            r->hits[of[i]] = hits[i];
            r->met |= (uint64_t)1 << of[i];
        }
}

static double length(pov_vec3 v)
{
    const double m = pov_largest(v);

    return m > 0.0 ? m * sqrt(pov_dot(pov_scale(v, 1.0 / m), pov_scale(v, 1.0 / m))) : 0.0;
}

/* Behind something that is not seen a crossing counts from there. False: the camera sees nothing. */
static bool complete_one(const maps *m, const pov_ray *ray, hit *h, double *depth)
{
    if (shading_info(m->scene, h->object)->no_image) {
        if (!pass_unseen(m, ray, h))
            return false;
        *depth = length(pov_add(pov_sub(h->point, ray->org), h->point_lo));
        return true;
    }
    world_surface(m->scene->world, ray, h);
    *depth = h->crossing.t * length(ray->dir);
    return true;
}

static void complete(const maps *m, run *r)
{
    for (uint32_t i = 0; i < r->count; i++)
        if (r->met >> i & 1 && !complete_one(m, &r->rays[i], &r->hits[i], &r->depth[i]))
            r->met &= ~((uint64_t)1 << i);
}

/* Of a hit its own crossing counts, because the tree decides which objects behind it are tested. A miss is certain if nothing
 * on the way was escalated: such a ray is traced alone. */
static void judge(const maps *m, run *r)
{
    query_context *k = m->tracer->context.context;

    for (uint32_t i = 0; i < r->count; i++) {
        const pov_ray *ray = &r->rays[i];
        const uint64_t before = query_context_escalated(k);
        hit h;

        if (r->met >> i & 1) {
            r->certain[i] = (r->hits[i].crossing.mark.flags & POV_MARK_ESCALATED) == 0;
            continue;
        }
        if (is_ray(ray))
            query_nearest(m->scene->world, k, &ray, 1, HUGE_VAL, &h);
        r->certain[i] = query_context_escalated(k) == before;
    }
}

/* ---- values ---- */

size_t maps_bytes(pov_pixels format)
{
    const bool is_of_four = format == POV_PIXELS_NORMAL || format == POV_PIXELS_POSITION || format == POV_PIXELS_ALBEDO;

    return is_of_four ? 4 * sizeof(float) : sizeof(float);
}

static void put_vec(void *to, double x, double y, double z)
{
    const float v[4] = { (float)x, (float)y, (float)z, 1.0f };

    memcpy(to, v, sizeof v);
}

static void put_float(void *to, double value)
{
    const float v = (float)value;

    memcpy(to, &v, sizeof v);
}

static void put_object(const maps *m, const hit *h, void *to)
{
    const uint32_t number = model_object_of(m->scene->model, h->object);

    memcpy(to, &number, sizeof number);
}

static void put_hit(const maps *m, const run *r, uint32_t i, void *to)
{
    const hit *h = &r->hits[i];
    const double side = h->entering ? 1.0 : -1.0;
    colour c;

    switch ((int)m->format) {
    case POV_PIXELS_DEPTH: put_float(to, r->depth[i]); break;
    case POV_PIXELS_NORMAL: put_vec(to, side * h->normal.x, side * h->normal.y, side * h->normal.z); break;
    case POV_PIXELS_POSITION: put_vec(to, h->point.x, h->point.y, h->point.z); break;
    case POV_PIXELS_OBJECT: put_object(m, h, to); break;
    default:
        c = albedo_of(m->tracer, &r->rays[i], h);
        put_vec(to, (double)c.r, (double)c.g, (double)c.b);
    }
}

static void put_hits(const maps *m, run *r, unsigned char *to)
{
    complete(m, r);
    for (uint32_t i = 0; i < r->count; i++, to += maps_bytes(m->format)) {
        memset(to, m->format == POV_PIXELS_OBJECT ? 0xff : 0, maps_bytes(m->format));
        if (r->met >> i & 1)
            put_hit(m, r, i, to);
    }
}

static void put_certain(const maps *m, run *r, unsigned char *to)
{
    judge(m, r);
    for (uint32_t i = 0; i < r->count; i++)
        put_float(to + sizeof(float) * i, r->certain[i] ? 1.0 : 0.0);
}

static void put_alpha(const maps *m, const run *r, unsigned char *to)
{
    colour seen[WORLD_MANY];
    float alpha[WORLD_MANY];

    tracer_colors(m->tracer, r->rays, r->count, 0, NULL, seen, alpha);
    memcpy(to, alpha, r->count * sizeof *alpha);
}

static void read_row(const maps *m, pov_rect rect, int y, unsigned char *to)
{
    run r;

    for (int x = 0; x < rect.width; x += WORLD_MANY) {
        aim(m, &r, rect.x + x, y, rect.width - x < WORLD_MANY ? (uint32_t)(rect.width - x) : WORLD_MANY);
        if (m->format == POV_PIXELS_ALPHA) {
            put_alpha(m, &r, to + maps_bytes(m->format) * (size_t)x);
            continue;
        }
        find(m, &r);
        if (m->format == POV_PIXELS_CERTAINTY)
            put_certain(m, &r, to + maps_bytes(m->format) * (size_t)x);
        else
            put_hits(m, &r, to + maps_bytes(m->format) * (size_t)x);
    }
}

/* All bits set: no number in floats, and no object. */
static void put_unknown(pov_rect rect, pov_pixels format, unsigned char *to, size_t stride)
{
    for (int y = 0; y < rect.height; y++)
        memset(to + (size_t)y * stride, 0xff, maps_bytes(format) * (size_t)rect.width);
}

static bool has_failed(const pov_tracer *t) { return t->context.failed || query_context_failed(t->context.context); }

void maps_read(const shading *scene, const settings *s, const pov_camera *camera, pov_rect rect, pov_pixels format, void *dst,
               size_t stride)
{
    maps m = { NULL, scene, s, camera, format };

    if (!scene || tracer_create(&m.tracer, scene, NULL) < 0) {
        put_unknown(rect, format, dst, stride);
        return;
    }
    for (int y = 0; y < rect.height && !has_failed(m.tracer); y++)
        read_row(&m, rect, rect.y + y, (unsigned char *)dst + (size_t)y * stride);
    if (has_failed(m.tracer))
        put_unknown(rect, format, dst, stride);
    tracer_destroy(m.tracer);
}

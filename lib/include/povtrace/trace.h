/* povtrace/trace.h - single rays, for programs that want no image. */
#ifndef POVTRACE_TRACE_H
#define POVTRACE_TRACE_H

#include <povtrace/scene.h>

/* A tracer holds one thread's working memory: make one for each thread. It reads its scene, which must outlive it. */
typedef struct pov_tracer pov_tracer;

typedef struct pov_hit {
    size_t size;
    double distance;             /* in lengths of dir */
    pov_vec3 point, normal;      /* world space; normal is unit and faces the ray */
    uint32_t object;             /* 0 .. pov_scene_object_count() - 1 */
    bool certain;                /* double precision decided; false: double-double arithmetic was needed */
    pov_vec3 shading_normal;     /* the shading normal: differs from `normal` where a texture perturbs it */
} pov_hit;

POV_API pov_status pov_tracer_create(pov_tracer **out, const pov_scene *scene, pov_error *err);
POV_API void pov_tracer_destroy(pov_tracer *tracer);
/* The nearest hit of the open ray, dir of any length but zero. False: no hit, and only `certain` is valid. */
POV_API bool pov_trace_hit(pov_tracer *tracer, pov_vec3 org, pov_vec3 dir, pov_hit *out);
/* What pov_trace_many() finds, by ray; a member that is NULL is left out. A miss: distance infinite, normal 0, object
 * UINT32_MAX. */
typedef struct pov_found {
    size_t size;
    double *distance;            /* in lengths of dir */
    pov_vec3 *point, *normal;    /* as in pov_hit; point of a miss: 0 */
    uint32_t *object;
    float *rgba;                 /* four a ray: the colour seen along it, also where it hits nothing */
    double *uv;                  /* two a ray: where a pigment with uv_mapping is asked; of a miss: 0 */
} pov_found;

/* pov_trace_hit() and pov_trace_color() for `count` rays, with the same results, at the speed of packets where rays that follow
 * each other are alike. A ray without a finite start or a direction hits nothing, and sees black. Fails on bad arguments,
 * and when memory ends. */
POV_API pov_status pov_trace_many(pov_tracer *tracer, size_t count, const pov_vec3 *org, const pov_vec3 *dir, const pov_found *out,
                                  pov_error *err);
/* All hits from near to far: the ray goes straight on through transparent and opaque surfaces. Calls `visit` for each
 * hit, which returns false to stop. Returns the number of calls; the first hit is that of pov_trace_hit(). */
POV_API size_t pov_trace_hits(pov_tracer *tracer, pov_vec3 org, pov_vec3 dir,
                              bool (*visit)(void *user, const pov_hit *hit), void *user);
/* Is there a surface strictly between the two points? Transparent objects count, no_shadow objects do not. */
POV_API bool pov_trace_blocked(pov_tracer *tracer, pov_vec3 from, pov_vec3 to);
/* The colour seen along the ray: linear red, green, blue, and 1. Fails only when memory ends. */
POV_API pov_status pov_trace_color(pov_tracer *tracer, pov_vec3 org, pov_vec3 dir, float rgba[4], pov_error *err);

#endif

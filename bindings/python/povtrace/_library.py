"""The library by cffi, without a compiler: what of its headers is used here.

Structs that begin with their size may end early: the library takes what is missing for the default.
"""
from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from cffi import FFI

ffi = FFI()
ffi.cdef('''
typedef struct { int status, line, column, caret; char file[256], message[512], excerpt[256], hint[64]; } pov_error;
typedef struct { double x, y, z; } pov_vec3;
typedef struct { int x, y, width, height; } pov_rect;
typedef struct pov_context pov_context;
typedef struct pov_scene pov_scene;
typedef struct pov_job pov_job;
typedef struct pov_tracer pov_tracer;
typedef struct pov_builder pov_builder;
typedef struct {
    size_t size;
    pov_vec3 location, direction, right, up;
    int type;
    double angles[2], lens_radius, focal_distance;
    int lens_samples;
} pov_camera;
typedef struct {
    size_t size;
    const pov_vec3 *corners;
    size_t corner_count;
    const uint32_t *faces;
    size_t face_count;
    const pov_vec3 *normals;
    size_t normal_count;
    const uint32_t *normal_faces;
    const double *uvs;
    size_t uv_count;
    const uint32_t *uv_faces;
    pov_vec3 inside;
    const uint32_t *face_materials;
    int materials_a_face;
} pov_mesh;
typedef struct { size_t size; const uint32_t *materials; const double *colours; int channels; const double *matrices; } pov_each;
typedef struct {
    size_t size;
    int dialect, accel, max_trace_level, threads, accuracy;
    bool strict;
    int width, height;
    const char *library_path, *write_path;
    const char *const *declares;
    const void *animation;
    struct { size_t depth, array, string; uint64_t turns; size_t memory; double seconds; } limits;
    bool soft_lights, quick_colours;
    uint64_t most_rays;
    bool (*progress)(void *user, double fraction, size_t objects);
    void *progress_user;
} pov_load_desc;
typedef struct {
    size_t size;
    int width, height;
    pov_rect crop;
    int preview, threads, samples;
    const void *camera;
    void (*wake)(void *user);
    void *wake_user;
    int sampling;
    double target_error, time_limit;
    const float *reference;
    uint32_t seed;
    bool reference_clipped;
    int time_map, alpha;
} pov_render_desc;
typedef struct {
    size_t size;
    double fraction, seconds;
    int pass, passes, threads;
    uint64_t counts[10];
    double spp_mean, est_rmse;
} pov_progress;
typedef struct {
    size_t size;
    int dialect;
    const char *dialect_reason;
    int transfer;
    double parse_seconds, build_seconds;
} pov_scene_info;
typedef struct {
    size_t size;
    double *distance;
    pov_vec3 *point, *normal;
    uint32_t *object;
    float *rgba;
    double *uv;
} pov_found;
typedef struct { size_t size; int bits, transfer; const char *format; } pov_image_options;
typedef struct { void *user; bool (*put)(void *user, const void *bytes, size_t count); } pov_output;

int pov_context_create(pov_context **out, const void *desc, pov_error *err);
void pov_context_destroy(pov_context *context);
int pov_scene_load_file(pov_scene **out, pov_context *context, const char *path, const pov_load_desc *desc,
                        pov_error *err);
int pov_scene_load_text(pov_scene **out, pov_context *context, const char *text, size_t length, const char *name,
                        const pov_load_desc *desc, pov_error *err);
int pov_scene_load_builder(pov_scene **out, const pov_builder *builder, const pov_load_desc *desc, pov_error *err);
void pov_scene_destroy(pov_scene *scene);
int pov_builder_create(pov_builder **out, pov_context *context, pov_error *err);
void pov_builder_destroy(pov_builder *builder);
int pov_builder_add_text(pov_builder *b, const char *text, size_t length, const char *name, pov_error *err);
int pov_builder_material(pov_builder *b, const char *text, uint32_t *material, pov_error *err);
int pov_builder_each(pov_builder *b, const pov_each *each, pov_error *err);
int pov_builder_add_spheres(pov_builder *b, size_t n, const pov_vec3 *centres, const double *radii, uint32_t material,
                            pov_error *err);
int pov_builder_add_cylinders(pov_builder *b, size_t n, const pov_vec3 *bases, const pov_vec3 *tops, const double *radii,
                              uint32_t material, pov_error *err);
int pov_builder_add_cones(pov_builder *b, size_t n, const pov_vec3 *bases, const double *base_radii, const pov_vec3 *tops,
                          const double *top_radii, uint32_t material, pov_error *err);
int pov_builder_add_boxes(pov_builder *b, size_t n, const pov_vec3 *corners, const pov_vec3 *opposite, uint32_t material,
                          pov_error *err);
int pov_builder_add_triangles(pov_builder *b, size_t n, const pov_vec3 *corners, const pov_vec3 *normals, uint32_t material,
                              pov_error *err);
int pov_builder_add_mesh(pov_builder *b, const pov_mesh *mesh, uint32_t material, pov_error *err);
int pov_builder_add_lights(pov_builder *b, size_t n, const pov_vec3 *positions, const pov_vec3 *colours, uint32_t material,
                           pov_error *err);
int pov_builder_camera(pov_builder *b, const pov_camera *camera, pov_error *err);
size_t pov_scene_object_count(const pov_scene *scene);
void pov_scene_get_camera(const pov_scene *scene, pov_camera *out);
void pov_scene_get_info(const pov_scene *scene, pov_scene_info *out);
int pov_job_create(pov_job **out, const pov_scene *scene, const pov_render_desc *desc, pov_error *err);
void pov_job_destroy(pov_job *job);
int pov_job_start(pov_job *job, pov_error *err);
int pov_job_wait(pov_job *job, double seconds);
void pov_job_read(pov_job *job, pov_rect rect, int format, void *dst, size_t stride);
void pov_job_get_progress(pov_job *job, pov_progress *out);
int pov_job_get_error(pov_job *job, pov_error *err);
int pov_tracer_create(pov_tracer **out, const pov_scene *scene, pov_error *err);
void pov_tracer_destroy(pov_tracer *tracer);
int pov_trace_many(pov_tracer *tracer, size_t count, const pov_vec3 *org, const pov_vec3 *dir, const pov_found *out,
                   pov_error *err);
int pov_image_put(pov_context *context, const pov_output *output, int width, int height, const float *rgba,
                  size_t stride, const pov_image_options *options, pov_error *err);
''')

NAME = 'libpovtrace.so.0'


def _place() -> str:
    """$POVTRACE_LIBRARY, or the package's own, or what the system's loader finds."""
    own = Path(__file__).parent / 'lib' / NAME
    return os.environ.get('POVTRACE_LIBRARY') or (str(own) if own.exists() else NAME)


lib: Any = ffi.dlopen(_place())

/* object_subject.h - a leaf that has been read, ready to be asked before there is a world, and the map that moves it. */
#ifndef SDL_OBJECT_SUBJECT_H
#define SDL_OBJECT_SUBJECT_H

#include "sdl/parse.h"

#include <string.h>

/* A leaf's shape, ready to be asked. */
typedef struct subject {
    const shape_class *shape;
    const void *self;
    void *own;           /* the same where it was prepared for this */
    void *scratch;
    unsigned char buffer[POV_PREPARED_MAX + 64];
} subject;

static inline bool subject_begin(pov_reader *in, const object_parsed *o, subject *s)
{
    size_t bytes;

    s->shape = o->leaf.shape;
    s->self = o->leaf.instance;
    s->own = NULL;
    s->scratch = NULL;
    if (s->shape->prepare) {
        void *at = s->buffer + (64 - ((uintptr_t)s->buffer & 63));

        memset(s->buffer, 0, sizeof s->buffer);
        s->shape->prepare(at, o->leaf.instance);
        s->self = s->own = at;
    }
    bytes = s->shape->scratch ? s->shape->scratch(s->self) : 0;
    if (bytes > 0)
        s->scratch = env_alloc_aligned(in->model->env, bytes, 64);
    if (bytes > 0 && !s->scratch)
        report_memory(in);
    return !in->failed;
}

static inline void subject_end(pov_reader *in, subject *s)
{
    if (s->scratch)
        env_free_aligned(in->model->env, s->scratch);
}

/* The map of an object, if it has one. */
static inline bool subject_map(const object_parsed *o, pov_affine *map)
{
    return o->map && transform_compose(o->map, map);
}

static inline pov_vec3 subject_back(const pov_affine *map, pov_vec3 p, double weight)
{
    const double (*m)[4] = map->inv;

    return pov_vec3_of(m[0][0] * p.x + m[0][1] * p.y + m[0][2] * p.z + weight * m[0][3],
                       m[1][0] * p.x + m[1][1] * p.y + m[1][2] * p.z + weight * m[1][3],
                       m[2][0] * p.x + m[2][1] * p.y + m[2][2] * p.z + weight * m[2][3]);
}

/* By the transposed inverse. */
static inline pov_vec3 subject_map_normal(const pov_affine *map, pov_vec3 n)
{
    const double (*m)[4] = map->inv;

    return pov_unit(pov_vec3_of(m[0][0] * n.x + m[1][0] * n.y + m[2][0] * n.z,
                                m[0][1] * n.x + m[1][1] * n.y + m[2][1] * n.z,
                                m[0][2] * n.x + m[1][2] * n.y + m[2][2] * n.z));
}

#endif

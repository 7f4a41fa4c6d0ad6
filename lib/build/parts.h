/* parts.h - the parts of a scene in their order: texts, and arrays of a program that stand for objects. */
#ifndef BUILD_PARTS_H
#define BUILD_PARTS_H

#include "base/arena.h"

#include <povtrace/scene.h>

/* Numbers or vectors: of the i-th object those at at + i*stride. */
typedef struct build_column { const double *at; size_t stride; int width; } build_column;

/* A list in braces behind its word: vectors, or three whole numbers each. Without braces: one vector. */
typedef struct build_list {
    const char *word;
    size_t count;
    build_column vectors;        /* of two or three numbers; at NULL: these are the indices */
    const uint32_t *indices;
    const uint32_t *textures;    /* instead of these: numbers of materials */
    bool is_bare;
    const uint32_t *materials;   /* behind each item so many numbers of materials, unless the first is 0; or NULL */
    int width;
    const uint32_t *places;      /* of the materials, by their number, in the list of those that occur */
} build_list;

/* What differs from object to object; each is NULL where nothing does. */
typedef struct build_each {
    const uint32_t *materials;
    build_column colours, matrices;
} build_each;

typedef enum build_kind { BUILD_TEXT, BUILD_SHAPES, BUILD_LIGHTS, BUILD_CAMERA } build_kind;

enum { BUILD_COLUMNS_MAX = 6 };

typedef struct build_part {
    build_kind kind;
    const char *text, *name;     /* of a text; both end with a zero byte */
    size_t length;
    const char *word;            /* the shapes' keyword */
    size_t count;
    build_column columns[BUILD_COLUMNS_MAX];   /* in the order in which a text has them; the last ones have no width */
    const build_list *lists;     /* instead of columns, of one shape */
    size_t list_count;
    uint32_t material;           /* 0: none, else its number; of those without one of their own */
    build_each each;
    const pov_camera *camera;
} build_part;

typedef struct build_material { const char *text; size_t length; } build_material;

typedef struct build_parts { build_part *items; size_t count, capacity; } build_parts;
typedef struct build_materials { build_material *items; size_t count, capacity; } build_materials;

typedef struct scene_parts {
    const env *env;
    arena texts;
    build_parts parts;
    build_materials materials;   /* number 1 is the first */
} scene_parts;

void parts_init(scene_parts *p, const env *e);
void parts_free(scene_parts *p);

/* Each checks what it is given, and adds it or nothing. */
pov_status parts_add_text(scene_parts *p, const char *text, size_t length, const char *name, pov_error *err);
pov_status parts_add_material(scene_parts *p, const char *text, uint32_t *number, pov_error *err);
/* part: all but the text; its lists are copied. */
pov_status parts_add_shapes(scene_parts *p, const build_part *part, pov_error *err);
pov_status parts_add_camera(scene_parts *p, const pov_camera *camera, pov_error *err);

static inline const build_material *parts_material(const scene_parts *p, uint32_t number)
{
    return number > 0 ? &p->materials.items[number - 1] : NULL;
}

#endif

/* parse.h - who reads which part of a scene. Each is called when its word has been taken, and takes what
 * belongs to it: straight-line code, for errors stick in the reader. Parts are returned as values; statements add them
 * to the model. */
#ifndef SDL_PARSE_H
#define SDL_PARSE_H

#include "sdl/items.h"
#include "sdl/report.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* What is read of one object's surface and interior. */
typedef struct surface_parsed {
    material material;           /* its finish, which is that of the layer on top, and its interior */
    const pigment_node *pigment;   /* of the layer on top; NULL: black */
    const normal_node *normal;   /* NULL: the surface's own */
    const texture *whole;        /* instead of these: a patterned texture; NULL: there is none */
    const texture *under;        /* the layers below; NULL: there is none */
    const texture *inside;       /* the interior_texture, or NULL */
    bool uv;                     /* all of it upon the surface's uv coordinates */
    const transform *before_uv;  /* of the object, those in front of that word */
    bool has_look;               /* a pigment, finish, normal or texture was given */
    unsigned albedos;            /* strengths of the finish that were given as albedos */
    uint32_t moves;              /* transformations of the object that came behind its texture */
} surface_parsed;

/* GROUP: made of others. MISSING: a kind of object that is not drawn yet. */
typedef enum object_kind { OBJECT_LEAF, OBJECT_GROUP, OBJECT_LIGHT } object_kind;

/* Of a group in which no shape is, or in which what is not there, or is everywhere, decides. */
typedef enum object_content { CONTENT_SHAPES, CONTENT_NOTHING, CONTENT_EVERYTHING } object_content;

/* An object with all that its block says; as the value of a name it is never written again. */
typedef struct object_parsed {
    object_kind kind;
    node_op op;                  /* of a group */
    leaf_node leaf;              /* its map and flags are those below */
    struct object_parsed *through;        /* what a light is projected through, or NULL */
    bool is_light_group, global_lights;   /* a union that is one */
    bool is_named;               /* it is what a name stands for */
    const transform *map;
    uint32_t flags;
    struct object_parsed *first, *next;   /* members of a group, in their order */
    object_content content;      /* of them; see object_content_of() */
    const texture *const *parts; /* textures of parts of a leaf */
    uint32_t part_count;
    bool both_sides;             /* the parts are seen from the back as from the front */
    struct object_parsed *clips;          /* the surface is seen where these are */
    struct object_parsed *bounds;         /* of bounded_by, which only clipped_by { bounded_by } asks for */
    const transform *since;      /* of one that clips or belongs to a light: their map when it was written, which does not move it */
    const surface_parsed *shared;   /* of one that is kept: its surface; NULL: it is the one below */
    /* What follows is there while the object is read, in names' values, and of lights. */
    surface_parsed surface;
    light light;                 /* before its map; what it looks like is `first` */
    pov_vec3 point_at;
    const transform *aimed, *spread;      /* a light's map when its point_at and its area's axes were written */
} object_parsed;

static inline const surface_parsed *parse_surface_of(const object_parsed *o)
{
    return o->shared ? o->shared : &o->surface;
}

/* A copy to be changed: one that is kept ends before its surface. */
static inline object_parsed parse_copy(const object_parsed *o)
{
    object_parsed copy;

    memset(&copy, 0, sizeof copy);
    memcpy(&copy, o, o->shared ? offsetof(object_parsed, surface) : sizeof copy);
    return copy;
}

/* The whole text, statement by statement. */
void parse_scene(pov_reader *in);
/* Is one of the words that a statement begins with meant? */
void parse_scene_guess(guess *g);
/* The words of all shapes. */
void parse_shapes_guess(const pov_reader *in, guess *g);
/* A statement that a name can be given to, if one is next: texture { }, sphere { } ... */
bool parse_value(pov_reader *in, value *out);
/* Part of the scene's memory as a value. */
value parse_part(pov_reader *in, value_kind kind, const void *part, size_t bytes);

/* The next token is a word that is no other statement. */
void parse_object(pov_reader *in);
/* An object is next: a statement, or the name of one. False: none is. */
bool parse_object_try(pov_reader *in, object_parsed *out);
bool parse_object_follows(pov_reader *in);
/* An object of which nothing has been read. */
void parse_object_begin(pov_reader *in, object_parsed *o);
/* Its modifiers, up to the end, which is not taken; `pigment { color rgbft C }`; `matrix M`, false: it has no inverse, or
 * the reader has failed. */
void parse_modifiers(pov_reader *in, object_parsed *o, int end);
void parse_object_colour(pov_reader *in, object_parsed *o, const pigment *p);
bool parse_object_matrix(pov_reader *in, object_parsed *o, const double m[12]);
/* The class that the word names, or NULL. */
const shape_class *parse_shape_class(pov_reader *in, symbol *word);
/* Bytes of what a class parses. */
static inline size_t parse_shape_size(const shape_class *shape)
{
    return shape->prepare ? shape->parsed_size : shape->instance_size;
}
/* Many a scene is of a few shapes in many places: what was written as it was the last time that its word stood there is
 * kept once. */
void parse_share_shape(pov_reader *in, symbol *word, leaf_node *o);
/* A copy that lives while the scene is read, without what is not needed of it any more. NULL: no memory, and the reader
 * has failed. */
object_parsed *parse_keep(pov_reader *in, const object_parsed *o);
/* Textures of parts of a leaf, as of the faces of a mesh: a list that its plugin's parse() fills. */
typedef struct part_list {
    const texture **items;
    size_t count, capacity;
    struct part_list *outer;
    surface_parsed component;    /* what was read of the texture of a component, */
    size_t before;               /* how many there are without it, */
    bool textured, stale;        /* whether anything was, and whether it has changed since it has its number */
    bool of_components;          /* those of components are seen from both sides */
} part_list;
void parse_parts_begin(pov_reader *in, part_list *parts);
void parse_parts_end(pov_reader *in, part_list *parts, object_parsed *o);
/* A leaf's texture that has parts: theirs, and its own. map, moves: its transformations, and how many of them came
 * behind its own texture. */
void parse_parts_surface(pov_reader *in, const object_parsed *o, const transform *map, uint32_t moves,
                         surface_parsed *s);
/* A texture is next, behind its word; its number. */
uint32_t parse_part_texture(pov_reader *in);
/* The same of the content of its block, up to the end, which is not taken. */
uint32_t parse_part_content(pov_reader *in, int end);
/* The same of texture { } or of pigment, normal and finish without it, behind those of the same component, as the moves since
 * have left them. In: POV_OWN_TEXTURE, or what it gave. False: none is next. */
bool parse_component_texture(pov_reader *in, uint32_t *number);
void parse_component_move(pov_reader *in, const transform *moves);
/* What was read of a whole object becomes part of the model. */
void parse_add_object(pov_reader *in, const object_parsed *o);
void parse_light(pov_reader *in, object_parsed *out);
/* A light of which position and colour are set: what stands behind them, up to the end of the text. */
void parse_light_modifiers(pov_reader *in, object_parsed *out);
void parse_camera(pov_reader *in, camera_parsed *out);
void parse_global_settings(pov_reader *in, void *self, keyword_id keyword);
void parse_background(pov_reader *in, void *self, keyword_id keyword);
/* Directives: #default, and settings that old scenes have at the top level. */
void parse_default(pov_reader *in, const place *at);
void parse_old_level(pov_reader *in, const place *at);
void parse_old_limit(pov_reader *in, const place *at);

/* translate, rotate, scale, matrix, transform: more behind the list. */
void parse_transform(pov_reader *in, const transform **list, keyword_id keyword);
value parse_transform_value(pov_reader *in);
/* One list behind another, without what it has up to `since`, which is in it or NULL. */
void parse_append_transforms(pov_reader *in, const transform **list, const transform *more, const transform *since);
uint32_t parse_count_transforms(const transform *list);
void parse_append_translation(pov_reader *in, const transform **list, pov_vec3 by);
/* False: it has no inverse, or the reader has failed. */
bool parse_append_matrix(pov_reader *in, const transform **list, const double m[12]);
/* What undoes them. */
const transform *parse_invert_transforms(pov_reader *in, const transform *list);
/* The last so many of a list, as a list of their own. */
const transform *parse_last_transforms(pov_reader *in, const transform *list, size_t count);
/* The words of transformations in a table of items. */
#define PARSE_MOVES(read) \
    { KEYWORD_TRANSLATE, read }, { KEYWORD_ROTATE, read }, { KEYWORD_SCALE, read }, { KEYWORD_MATRIX, read }, \
    { KEYWORD_TRANSFORM, read }

void parse_pigment(pov_reader *in, surface_parsed *s);
void parse_surface_colour(pov_reader *in, surface_parsed *s, const pigment *p);
void parse_normal(pov_reader *in, surface_parsed *s);
void parse_finish(pov_reader *in, surface_parsed *s);
/* Does the finish of the upper texture say what belongs to the interior? Then that counts, whatever the interior says. */
bool parse_finish_is_old(const surface_parsed *s);
void parse_finish_settle(surface_parsed *s);
void parse_texture(pov_reader *in, surface_parsed *s);
void parse_interior(pov_reader *in, surface_parsed *s);
void parse_interior_texture(pov_reader *in, surface_parsed *s);
void parse_material(pov_reader *in, surface_parsed *s);
/* As if nothing but the defaults had been given. */
void parse_surface_begin(const pov_reader *in, surface_parsed *s);
/* One without a look has these defaults, whenever it was written. */
void parse_surface_default(const surface_parsed *defaults, surface_parsed *s);

/* When all has been read and the dialect is known. */
void parse_camera_finish(pov_reader *in);
void parse_settings_finish(pov_reader *in);

void parse_camera_defaults(camera_parsed *c);

/* Neither beyond what a double holds nor NaN. */
static inline bool parse_is_finite(pov_vec3 v)
{
    return fabs(v.x) <= DBL_MAX && fabs(v.y) <= DBL_MAX && fabs(v.z) <= DBL_MAX;
}

#endif

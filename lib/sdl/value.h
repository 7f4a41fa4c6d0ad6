/* value.h - what an identifier can hold, and reading one value from the text. */
#ifndef SDL_VALUE_H
#define SDL_VALUE_H

#include "model/colour.h"

#include <povtrace/math.h>
#include <povtrace/plugin.h>

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct env;

typedef enum value_kind {
    VALUE_NOTHING,               /* an element of an array that was not set yet */
    VALUE_NUMBER,
    VALUE_VECTOR,                /* of 2 to 5 numbers; a colour has 5 */
    /* Those of values that are counted. */
    VALUE_STRING, VALUE_ARRAY, VALUE_MACRO, VALUE_SPLINE, VALUE_FILE,
    /* Those that live as long as the scene. */
    VALUE_FUNCTION, VALUE_TRANSFORM, VALUE_OBJECT, VALUE_TEXTURE, VALUE_PIGMENT, VALUE_NORMAL, VALUE_FINISH, VALUE_MATERIAL,
    VALUE_INTERIOR, VALUE_MEDIA, VALUE_DENSITY, VALUE_CAMERA, VALUE_LIGHT, VALUE_SKY_SPHERE, VALUE_FOG, VALUE_RAINBOW,
    VALUE_COLOUR_MAP, VALUE_PIGMENT_MAP, VALUE_NORMAL_MAP, VALUE_TEXTURE_MAP, VALUE_SLOPE_MAP, VALUE_DENSITY_MAP,
    VALUE_KINDS
} value_kind;

/* What values share: counted, and freed with the reader at the latest. */
typedef struct shared {
    struct shared *next, *previous;
    unsigned uses;
    value_kind kind;             /* VALUE_NOTHING: a binding */
    size_t bytes;
} shared;

typedef struct value {
    value_kind kind;
    bool is_colour;              /* of a vector of 5 */
    bool is_part;                /* of a number: the component of a vector, whose others stand behind it */
    int size;                    /* components of a vector */
    union {
        double v[5];             /* a number is v[0] */
        struct shared *shared;
        const void *part;        /* in the scene's memory */
    } as;
} value;

typedef struct string {
    shared head;
    size_t length;
    char text[];                 /* UTF-8 with an end mark */
} string;

enum { ARRAY_DIMENSIONS = 5 };

typedef struct array {
    shared head;
    int dimensions;
    size_t sizes[ARRAY_DIMENSIONS], count;
    value_kind kind;             /* of its elements, fixed by the first one set */
    int size;                    /* of vectors */
    bool is_colour;
    value items[];
} array;

/* All that is shared in one reader. */
typedef struct value_heap {
    const struct env *env;
    shared *first;
    size_t bytes, most_bytes;    /* in use, and allowed; 0: without a limit */
    bool is_full;                /* more was asked for */
    void (*drop)(struct value_heap *heap, shared *item);   /* lets go of what it refers to; not called at the end */
} value_heap;

/* Zeroed, in use once. NULL: no memory, or more than is allowed. */
void *value_share(value_heap *heap, value_kind kind, size_t bytes);
void value_unshare(value_heap *heap, shared *item);
void value_free_all(value_heap *heap);

static inline bool value_is_shared(const value *v) { return v->kind >= VALUE_STRING && v->kind <= VALUE_FILE; }

static inline bool value_is_arithmetic(const value *v) { return v->kind == VALUE_NUMBER || v->kind == VALUE_VECTOR; }

static inline value value_keep(value v)
{
    if (value_is_shared(&v))
        v.as.shared->uses++;
    return v;
}

static inline void value_drop(value_heap *heap, value *v)
{
    if (value_is_shared(v))
        value_unshare(heap, v->as.shared);
    v->kind = VALUE_NOTHING;
}

static inline value value_of_number(double number)
{
    value v = { VALUE_NUMBER, false, false, 1, { { number, 0.0, 0.0, 0.0, 0.0 } } };

    return v;
}
value value_of_vector(pov_vec3 v);
value value_of_part(value_kind kind, const void *part);
/* As messages call it: `a number`. */
const char *value_kind_name(value_kind kind);
const char *value_name(const value *v);
/* The same kind, as the elements of an array must be. */
bool value_is_alike(const value *a, const value *b);

static inline string *value_string(const value *v) { return (string *)v->as.shared; }
static inline array *value_array(const value *v) { return (array *)v->as.shared; }

/* ---- from the text: expressions of the additive grammar, literals by a fast path ---- */

/* An expression whose vectors are of finite numbers; `wanted` is what a message says where there is none. */
value value_read(pov_reader *in, const char *wanted);
/* Does a value come next? */
bool value_follows(const pov_reader *in);
/* Finite, else the reader fails. */
double value_number(pov_reader *in);
/* A number that a float holds: fails where it doesn't. */
float value_float(pov_reader *in);
/* A number that may be left out, as behind `hollow`: `otherwise` then. */
double value_optional(pov_reader *in, double otherwise);
/* A number stands for all components, a component of a vector for the first, two numbers have a 0 behind them, as in POV-Ray (for
 * flat polygons). */
pov_vec3 value_vector(pov_reader *in);
/* A corner or a normal of faces: what is not finite becomes NaN, with a warning. */
pov_vec3 value_vector_of_face(pov_reader *in);
/* A vector of `least` to `most` components; returns how many there are, behind them are zeros. A number fills all
 * and returns 1. */
int value_components(pov_reader *in, int least, int most, double *out);

enum { VALUE_LIST_MAX = 12 };
/* `<...>` of `least` to `most` numbers as written, with no operator behind it. */
int value_list(pov_reader *in, const char *wanted, int least, int most, double *out);
/* A string expression, which the reader keeps as long as it reads. NULL after an error. */
const string *value_text(pov_reader *in);

typedef struct paint {
    colour colour;
    float filter, transmit;
} paint;

/* A colour begins with one of its words or a colour's identifier; a bare number or vector counts as one where bare
 * is true. */
bool value_colour_follows(const pov_reader *in, bool bare);
paint value_colour(pov_reader *in, bool bare);
/* The same as five numbers; the first takes any, as a name may hold them: what they are counts where they are used. */
void value_colour_any(pov_reader *in, bool bare, double out[5]);
void value_colour_components(pov_reader *in, bool bare, double out[5]);

#endif

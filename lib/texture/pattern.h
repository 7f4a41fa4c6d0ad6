/* pattern.h - the kinds of patterns: values of points in the space in which they were written. One row of a table, and
 * one file, each. */
#ifndef TEXTURE_PATTERN_H
#define TEXTURE_PATTERN_H

#include "base/lanes.h"
#include "model/model.h"
#include "texture/noise.h"

enum { PATTERN_LIST_MAX = 8, PATTERN_SELF_MAX = 512 };

/* ---- the text of a pattern ---- */

/* What stands behind a word, and the type of the member of the parsed form that it is kept in. */
typedef enum pattern_type {
    PATTERN_FLAG,                /* nothing, or a number that is not 0: bool */
    PATTERN_NUMBER,              /* double */
    PATTERN_FLOAT,               /* double, rounded to float first as POV-Ray's is */
    PATTERN_INTEGER,             /* int32_t: cut down to a whole number */
    PATTERN_UV,                  /* double[2]: a vector of two */
    PATTERN_VECTOR               /* pov_vec3; a number stands for all three */
} pattern_type;

typedef struct pattern_word {
    const char *keyword;         /* NULL: one more argument of the row before, of the pattern's word in the first rows;
                                  * commas may stand between them */
    pattern_type type;
    size_t offset;               /* in the parsed form */
    bool is_optional;            /* of an argument: it may be left out, and those behind it */
} pattern_word;

/* One of a map. */
typedef struct colour_entry { float value; pigment pigment; } colour_entry;

/* ---- evaluation ---- */

struct texture_points;

typedef struct pattern_input {
    const vec_lanes *at;         /* lanes up to lanes_whole(n) are there */
    uint32_t n;
    const pattern *of;
    const vec_lanes *normal, *view;   /* unit, of the world: the surface's, turned against the ray; the ray's direction.
                                       * NULL where there is no surface */
    const noise_tables *noise;   /* NULL unless the class or its turbulence need noise */
    int generator;               /* the pattern's, or else the scene's: 1 to 3 */
    uint32_t waves;              /* number_of_waves */
    const model *model;
    const struct texture_points *points;   /* where the points come from: their surfaces */
    struct function_memo *memo;  /* what members of an average have asked; or NULL */
} pattern_input;

enum {
    PATTERN_NEEDS_NOISE = 1,
    PATTERN_UNSHAPED = 2,        /* frequency, phase and wave form do nothing */
    PATTERN_OWN_TURBULENCE = 4,  /* turbulence does not move the points: evaluate() sees to it */
    PATTERN_NEEDS_NORMAL = 8,    /* there is no value without a surface */
    PATTERN_BRACED = 16,         /* words and arguments may stand in braces behind the pattern's word */
    PATTERN_FILE = 32,           /* an image or a volume, whose text is read apart */
    PATTERN_NEEDS_VIEW = 128,    /* it depends on where it is seen from */
    PATTERN_NEEDS_WORLD = 256,   /* or on where points are in the world */
    PATTERN_UNFOLDED = 64        /* without a frequency values stay as they are, whatever the phase */
};

typedef struct pattern_class {
    const char *keyword;
    uint32_t count;              /* its values are whole, 0 to count - 1, and number a list; 0: they are those of maps */
    pigment list[PATTERN_LIST_MAX];   /* pigments of a list that are not given */
    const colour_entry *map;     /* the map where none is given; NULL: from black to white */
    uint32_t map_count;
    bool (*has_map)(const void *self);   /* false: not this parsed form, whose map is from black to white; may be NULL */
    size_t self_size;            /* at most PATTERN_SELF_MAX */
    const void *self;            /* parsed form where nothing is given; NULL: zeros */
    const pattern_word *words;
    uint32_t word_count;
    const char *(*check)(const void *self);   /* what is wrong with the parsed form, or NULL; may be NULL */
    wave_form form;
    unsigned flags;
    /* Values of the points, lane by lane. Lanes up to lanes_whole(n) may be read and written. */
    void (*evaluate)(const pattern_input *in, double *value);
    /* Of images: colours instead of values, which no map replaces. */
    void (*colours)(const pattern_input *in, pigment *out);
    const pigment_node *(*inner)(const void *self);   /* a pigment that the pattern asks; may be NULL */
    pigment (*most)(const void *self);   /* the largest that each component of these can be */
    /* Of patterns with a rule of their own for normals: perturb unit normals in the pattern's space. They need not be
     * unit afterwards. NULL: the slope of the values counts. */
    void (*perturb)(const pattern_input *in, double amount, vec_lanes *normal);
} pattern_class;

/* The class of a keyword. NULL: not a pattern. */
const pattern_class *pattern_find(const char *keyword);
/* All classes, by index. NULL: past the last. */
const pattern_class *pattern_at(size_t index);
/* Of blends without a pattern: it has a space only, and neither evaluate() nor colours(). */
extern const pattern_class pattern_average;
/* Of images; of textures alone; and of volumes, which have no block. */
extern const pattern_class pattern_image_map, pattern_material_map, pattern_density_file;
bool pattern_needs_noise(const pattern *p);

#endif

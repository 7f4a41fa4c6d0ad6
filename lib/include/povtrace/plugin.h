/* povtrace/plugin.h - the form of a plugin, and the host's services while a scene loads.
 *
 * A plugin is a shared object named after its scene keyword (primitives/torus.so) or file ending (images/png.so),
 * linked against nothing of povtrace, exporting one data symbol. Nothing in it ranges when it is loaded. Its contents are
 * described in shape.h (its fast extension in shape_fast.h), image.h and plot.h. Growth is by appending members: each
 * side reads only as many bytes as the other side's `size` says.
 *
 * [load] is called on the thread that loads a scene; several scenes may load at once, each with instances of its own.
 *
 * [render] is called from many threads at once on the same const object: no writes, statics, locks, allocation. */
#ifndef POVTRACE_PLUGIN_H
#define POVTRACE_PLUGIN_H

#include <povtrace/base.h>
#include <povtrace/math.h>

#define POV_PLUGIN_ABI 4u   /* raised only when an old plugin could not work */

struct pov_shape_class;
struct pov_image_format;
struct pov_plot_format;
struct pov_hits;
struct pov_ray;

/* ---- what the host offers while a scene loads --------------------------- */

typedef struct pov_reader pov_reader;

typedef bool pov_visit_range(void *user, uint32_t first, uint32_t count);
/* rays: as bits. Returns those that want no more, and adds to *lowered those whose limits it lowered. */
typedef uint64_t pov_visit_rays(void *user, uint32_t first, uint32_t count, uint64_t rays, uint64_t *lowered);

/* A bounding volume hierarchy over the items of one shape: made while the scene loads, traversed by rays. */
typedef struct pov_hierarchy {
    /* [render] Calls visit() for each item whose box the ray may hit from 0 to hits->tmax, which may decrease meanwhile;
     * usually near ones first. False: visit() returned false, which ends the traversal. The ray is in the boxes' space. */
    bool (*visit)(const struct pov_hierarchy *self, const struct pov_ray *ray, const struct pov_hits *hits,
                  bool (*visit)(void *user, uint32_t item), void *user);
    /* [render] The same, with all items of a leaf at once, as hierarchy_in_order() numbered them; all leaves; and those of
     * up to 64 rays side by side, to their limits; nearest: near ones first. */
    bool (*visit_ranges)(const struct pov_hierarchy *self, const struct pov_ray *ray, const struct pov_hits *hits,
                         pov_visit_range *visit, void *user);
    bool (*each_range)(const struct pov_hierarchy *self, pov_visit_range *visit, void *user);
    void (*visit_rays)(const struct pov_hierarchy *self, const struct pov_ray *const *rays, uint32_t n, double *limit,
                       bool nearest, pov_visit_rays *visit, void *user);
} pov_hierarchy;

/* A function of the scene, of which any thread may ask. */
typedef struct pov_function {
    /* [render] Its value at as many arguments as it has parameters; `memory`: as many doubles as it says, of any content. */
    double (*value)(const struct pov_function *self, const double *arguments, double *memory);
    uint32_t parameters, memory;
    /* [render] At up to POV_VALUES points: argument a of point i is arguments[a * POV_VALUES + i]; `memory`: memory_many. */
    void (*values)(const struct pov_function *self, const double *arguments, uint32_t n, double *memory, double *out);
    uint32_t memory_many;
} pov_function;

/* A number over stretches of lines, one in each lane. Let u go from -1 to 1 along a stretch: the number is middle + slope u,
 * off by at most `off`, and its derivative by u is slope, off by at most `slope_off`. What is not known is infinite or NaN. */
enum { POV_FORMS = 8, POV_SLOPES = 4, POV_VALUES = 16 };
typedef struct pov_form { double middle[POV_FORMS], slope[POV_FORMS], off[POV_FORMS], slope_off[POV_FORMS]; } pov_form;
/* A number at points of lines, and its derivative along them. */
typedef struct pov_slope { double value[POV_SLOPES], slope[POV_SLOPES]; } pov_slope;

/* Bounds of a function, roundings included. `memory` has `registers` elements, of which the first are the arguments; the
 * result stands in it. */
typedef struct pov_function_bounds {
    /* [render] Over stretches. */
    const pov_form *(*over)(const struct pov_function_bounds *self, pov_form *memory);
    /* [render] At points. Values may differ from those of pov_function by what rounding does. */
    const pov_slope *(*at)(const struct pov_function_bounds *self, pov_slope *memory);
    uint32_t registers;
} pov_function_bounds;

/* Errors stick: after the first, every read gives zero, every accept() gives
 * false, more() gives false and warn() says nothing, so a parse function needs no checks. */
typedef struct pov_host {
    uint32_t abi, size;
    void *(*alloc)(pov_reader *in, size_t bytes);   /* zeroed, lives as long as the scene, as all that these give; NULL after an error */
    double (*number)(pov_reader *in);
    void (*vector)(pov_reader *in, pov_vec3 *out);
    bool (*accept)(pov_reader *in, const char *keyword);  /* a keyword or a punctuation mark */
    void (*expect)(pov_reader *in, const char *keyword);
    bool (*more)(pov_reader *in);                      /* does a value come next? */
    void (*fail)(pov_reader *in, const char *format, ...) POV_PRINTF(2, 3);   /* at the last value read */
    void (*warn)(pov_reader *in, const char *format, ...) POV_PRINTF(2, 3);
    /* A vector of n components, 2 to 5; a number stands for n equal components. */
    void (*vector_of)(pov_reader *in, double *out, int n);
    void (*color)(pov_reader *in, double rgbft[5]);    /* red, green, blue, filter, transmit, as written */
    bool (*boolean)(pov_reader *in);                   /* on, yes, true, off, no, false, or a number: not 0 is true */
    const char *(*string)(pov_reader *in);             /* ends with a zero byte, lives as long as the scene; "" after an error */
    /* The bytes of a file, searched for and restricted like included ones. NULL after an error; a missing file is an error. */
    const void *(*file)(pov_reader *in, const char *name, size_t *bytes);
    /* A hierarchy over n boxes, at least one, finite; items are numbered like their boxes. NULL after an error. */
    const pov_hierarchy *(*hierarchy)(pov_reader *in, const pov_box *boxes, uint32_t n);
    /* The heights, in 1/65536, that an image stands for: `png "name"`, a format's word or none before the name. Rows from
     * the top; they live as long as the scene. NULL after an error. */
    const uint16_t *(*heights)(pov_reader *in, uint32_t *width, uint32_t *height);

    /* Memory that parse() itself needs, as realloc() gives it: NULL begins, and 0 bytes free it, which parse() does
     * before it returns. NULL after an error; what was there is then freed. */
    void *(*resize)(pov_reader *in, void *memory, size_t bytes);
    /* As hierarchy(), with boxes that box() gives, from several threads. Items get new numbers, so that those of a leaf
     * follow one another: order[new] becomes the old one. */
    const pov_hierarchy *(*hierarchy_in_order)(pov_reader *in, uint32_t n,
                                               void (*box)(void *user, uint32_t which, pov_box *out), void *user,
                                               uint32_t *order);
    /* A texture, which is next: its number among those of this object, for textures() of the class. Equal ones share one. */
    uint32_t (*texture)(pov_reader *in);
    bool (*next_is)(pov_reader *in, const char *word);   /* is it next? As accept(), but it stays there */
    bool (*more_numbers)(pov_reader *in);                /* does a value come next that is a number? */
    /* The parameters, n unless it names its own, and the block behind the word `function`, accepted. NULL after an error. */
    const pov_function *(*function)(pov_reader *in, uint32_t n);
    /* A transformation behind those of `map`, if one is next. All zero, the map is that of no transformation. */
    bool (*transform)(pov_reader *in, pov_affine *map);
    /* As texture(), or pigment, normal and finish alone, if next. Again behind each transform(), which moves it. At first POV_OWN_TEXTURE. */
    bool (*component_texture)(pov_reader *in, uint32_t *number);
    /* Bounds of what function() gave. NULL: of some part nothing is known between points, as of noise, patterns and images. */
    const pov_function_bounds *(*function_bounds)(pov_reader *in, const pov_function *f);
} pov_host;

/* ---- the one exported symbol -------------------------------------------- */

typedef struct pov_plugin {
    uint32_t abi, size;
    const char *name, *version;
    const struct pov_shape_class *const *shapes;     /* each list ends with NULL; or is NULL */
    const struct pov_image_format *const *images;
    const struct pov_plot_format *const *plots;
    /* abi 4 began with these; patterns, lights, cameras append their own lists */
} pov_plugin;

#define POV_PLUGIN_SYMBOL "povtrace_plugin"
#ifdef POV_STATIC_PLUGINS
#define POV_PLUGIN(id) const pov_plugin povtrace_plugin_##id
#else
#define POV_PLUGIN(id) POV_EXPORT const pov_plugin povtrace_plugin; const pov_plugin povtrace_plugin
#endif

#endif

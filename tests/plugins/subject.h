/* subject.h - the plugin under test: instances of its shape, and rays at them. */
#ifndef PLUGINS_SUBJECT_H
#define PLUGINS_SUBJECT_H

#include "plug/shape_class.h"

enum { OWNER = 3, MOST = 64, SHAPES = 40, RAYS = 20000 };

typedef struct thing {
    void *self;
    char text[2048];         /* what stands between its braces */
    pov_box box;
    bool finite;
    double size, thickness;  /* the longest and the shortest side of the box that has a length */
    pov_vec3 middle;
} thing;

/* What is under test: a class and instances of it. */
typedef struct plugin_subject {
    char file[1024];
    const shape_class *shape;
    pov_reader *in;
    thing things[SHAPES];
    int count, hard;         /* how many; and how many more for block filters only */
    char sides[256];         /* of the comparison that went wrong last; "" where the test says none */
} plugin_subject;

extern plugin_subject subject;

/* Both sides of a comparison that went wrong, for subject_each_ray() to print with the shape and the ray. */
void subject_sides(const char *format, ...) POV_PRINTF(1, 2);

/* Does the class have this member? */
#define HAS(member) (subject.shape->member != NULL)

/* Load a file and make instances of its first shape. False: there are none. */
bool subject_set_up(const char *file);
/* Memory for an instance; lives as long as the subject. */
void *subject_memory(void);

double subject_length(pov_vec3 a);
double subject_uniform(void);        /* 0 <= x < 1 */
pov_vec3 subject_direction(void);    /* unit, all directions alike */

/* From somewhere, near or far, towards the thing or past it. */
pov_ray subject_ray(const thing *t);
/* Each of `rays` rays, as `make` gives them, at every instance; `visit` gives false where something is wrong: then the
 * shape's text and the ray are printed. */
void subject_each(int rays, pov_ray (*make)(const thing *t), bool (*visit)(const thing *t, const pov_ray *ray));
/* Of subject_ray()'s. */
void subject_each_ray(int rays, bool (*visit)(const thing *t, const pov_ray *ray));
/* Skips the test: what the shape lacks or is not, after its keyword. */
void subject_skip(const char *why);
/* Working memory for intersect(). */
void *subject_scratch(const void *self);
/* Crossings in growing order; how many. */
uint32_t subject_ask_in(const void *self, const pov_ray *ray, pov_want want, double tmin, double tmax, bool exact,
                        pov_crossing at[MOST]);
uint32_t subject_ask(const void *self, const pov_ray *ray, pov_crossing at[MOST]);
/* A sink for the nearest crossing up to tmax. */
pov_hits subject_nearest(double tmax, pov_crossing *at);
/* Is a contact where the crossing is, with the normal that is found there? */
bool subject_is_contact(const void *self, const pov_ray *ray, const pov_crossing *at, const pov_contact *found);
/* The point at t, in double-double. */
void subject_point(const pov_ray *ray, double t, double t_lo, pov_vec3 *hi, pov_vec3 *lo);

#endif

/* reading.h - reads a scene text with shapes of the tests' own, and keeps the results. */
#ifndef SUPPORT_READING_H
#define SUPPORT_READING_H

#include "sdl/reader.h"

enum { READING_NOTES = 128 };

typedef struct reading {
    env env;
    registry *plugins;
    model model;
    pov_status status;
    pov_error error;
    pov_error notes[READING_NOTES];      /* logged messages */
    int note_count;
} reading;

/* The six primitives of the base language, and a `blob7` that is not in the language. */
typedef struct test_shape {
    double numbers[12];
    pov_vec3 vectors[3];
    bool open;
    int count;                   /* sums of a polygon's points */
    pov_vec3 *points;
} test_shape;

extern const pov_plugin reading_plugin;

/* Free with reading_end(), whatever the status. */
void reading_begin(reading *r, const char *text);
void reading_begin_bytes(reading *r, const char *text, size_t length, const reader_options *options,
                         const pov_allocator *allocator);
void reading_end(reading *r);

const test_shape *reading_shape(const reading *r, size_t index);

#endif

/* reading.h - read a scene text with shapes of the tests' own, and keep what came of it. */
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
    pov_error notes[READING_NOTES];      /* what was logged */
    int note_count;
} reading;

/* The six primitives of the base language and a `blob7`, which the language does not know. */
typedef struct test_shape {
    double numbers[12];
    pov_vec3 vectors[3];
    bool open;
    int count;                   /* of a polygon's points */
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

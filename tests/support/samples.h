/* samples.h - values of POV-Ray's patterns at points, as measured: tests/patterns/samples.txt and others. A line ": TEXT" begins a
 * pattern, lines "x y z value" follow. */
#ifndef SUPPORT_SAMPLES_H
#define SUPPORT_SAMPLES_H

#include "base/lanes.h"
#include "support/check.h"

#include <stdio.h>
#include <string.h>

enum { SAMPLES_TEXT = 160, SAMPLES_MAX = 64 };
typedef struct samples {
    char text[SAMPLES_TEXT];
    pov_vec3 at[SAMPLES_MAX];
    double value[SAMPLES_MAX];
    uint32_t count;
} samples;

static inline FILE *samples_open(const char *name)
{
    char path[sizeof TEST_ROOT + 64];
    FILE *file;

    snprintf(path, sizeof path, TEST_ROOT "/tests/patterns/%s", name);
    file = fopen(path, "r");
    assert_non_null(file);
    return file;
}

/* The rows of one pattern. False: there are no more. */
static inline bool samples_next(FILE *file, samples *s)
{
    if (fscanf(file, " : %159[^\n]", s->text) != 1)
        return false;
    for (s->count = 0; s->count < SAMPLES_MAX; s->count++) {
        pov_vec3 *p = &s->at[s->count];

        if (fscanf(file, "%lf %lf %lf %lf", &p->x, &p->y, &p->z, &s->value[s->count]) != 4)
            break;
    }
    return true;
}

#endif

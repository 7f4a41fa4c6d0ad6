/* builders.h - builders of the public calls beside the texts that stand for them, and what tests put into both. */
#ifndef SUPPORT_BUILDERS_H
#define SUPPORT_BUILDERS_H

#include <povtrace/povtrace.h>

enum { BUILT_WIDTH = 64, BUILT_HEIGHT = 48, BUILT_NUMBERS = BUILT_WIDTH * BUILT_HEIGHT * 4, BUILT_TEXT_MAX = 1 << 16 };

/* A text that grows; too long a one fails the test. */
typedef struct built_text { char at[BUILT_TEXT_MAX]; size_t length; } built_text;

void built_put(built_text *t, const char *format, ...) POV_PRINTF(2, 3);

/* Each fails the test on any error. */
pov_builder *built_create(pov_context *context);
void built_add_text(pov_builder *b, const char *text);
uint32_t built_material(pov_builder *b, const char *text);
pov_scene *built_load(const pov_builder *b);
/* BUILT_NUMBERS of a picture of BUILT_WIDTH x BUILT_HEIGHT; the caller frees them. */
float *built_draw(const pov_builder *b);

/* From 0 to 1, the same on every machine. */
double built_next(uint32_t *state);

#endif

/* reader.h - scene text to model. */
#ifndef SDL_READER_H
#define SDL_READER_H

#include "model/model.h"
#include "plug/registry.h"

typedef struct reader_options {
    pov_dialect dialect;         /* AUTO: the text decides */
    int max_trace_level;         /* 0: what the scene says */
} reader_options;

/* Reads the whole text into m, which model_init() made ready. On failure m may hold a part; model_free() it.
 * */
pov_status reader_read(model *m, registry *plugins, const char *text, size_t length, const char *name,
                       const reader_options *options, pov_error *err);

#endif

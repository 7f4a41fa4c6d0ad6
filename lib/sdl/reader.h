/* reader.h - scene text to model. */
#ifndef SDL_READER_H
#define SDL_READER_H

#include "build/parts.h"
#include "model/model.h"
#include "plug/registry.h"

/* No honest scene meets them; 0 stands for the default. */
typedef struct reader_limits {
    size_t depth;                /* macros and include files within each other */
    size_t array, string;        /* elements, bytes */
    uint64_t turns;              /* of loops, and calls of macros */
    size_t memory;               /* bytes of values, and of what loops make of the scene */
    double seconds;
    size_t input;                /* bytes of the text and of all files that it reads */
    size_t images;               /* bytes of the pixels of images */
} reader_limits;

/* Which picture of an animation is read. */
typedef struct reader_frames {
    bool has_clock;
    double clock, first_clock, last_clock, delta;
    int frame, first, last;      /* 0: one picture */
} reader_frames;

typedef struct reader_options {
    pov_dialect dialect;         /* AUTO: the text decides */
    int max_trace_level;         /* 0: what the scene says */
    bool quick_colours;          /* pigments are their quick_color */
    bool strict;                 /* what is not supported yet is an error */
    int width, height;           /* of the picture; 0: not known */
    const char *library_path;    /* folders of include files, colon separated, or NULL */
    const char *write_path;      /* below this folder the scene may write files; NULL: nowhere */
    const char *const *declares; /* "NAME=VALUE", ending with NULL; or NULL */
    /* Makes a hierarchy for a plugin, which the model then keeps; see pov_host.hierarchy. NULL: there are none. */
    const pov_hierarchy *(*hierarchy)(model *m, int threads, uint32_t n,
                                      void (*box)(void *user, uint32_t item, pov_box *out), void *user, uint32_t *order);
    int threads;                 /* for that */
    reader_limits limits;
    reader_frames frames;
    /* How much of the text has been read, and how many objects. False: no more. NULL: nobody is told. */
    bool (*progress)(void *user, double fraction, size_t objects);
    void *progress_user;
} reader_options;

/* Reads all parts of a scene into m, which model_init() made ready. On failure m may hold a part; model_free() it. */
pov_status reader_read_parts(model *m, registry *plugins, const scene_parts *parts, const char *name,
                             const reader_options *options, pov_error *err);
/* The same of one text. */
pov_status reader_read(model *m, registry *plugins, const char *text, size_t length, const char *name,
                       const reader_options *options, pov_error *err);

#endif

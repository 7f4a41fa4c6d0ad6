/* settings.h - the settings of a job, checked and with defaults filled in. */
#ifndef RENDER_SETTINGS_H
#define RENDER_SETTINGS_H

#include <povtrace/render.h>

enum { SETTINGS_NOTE = 256 };    /* characters of a note, with its end */

typedef struct settings {
    int width, height;           /* of the whole picture */
    pov_rect crop;               /* the traced part of it */
    int first_step;              /* edge of a pixel of the first pass; 1: there is one pass */
    int threads;
    int samples;                 /* samples a pixel, on average: the maximum */
    uint32_t seed;
    bool sampling, adaptive;     /* more than one sample a pixel; more samples where the error is */
    bool ends_early;             /* cells take no more samples once their error is too small to be seen */
    double target_error, time_limit;   /* 0: none */
    const float *reference;      /* the caller's; or NULL */
    bool time_map, alpha;        /* see pov_render_desc */
    bool reference_clipped;
    int part, parts;             /* 1 .. parts; 0: the picture is in one piece, or joined */
    const char *note;            /* the caller's; or NULL */
    void (*wake)(void *user);
    void *wake_user;
} settings;

pov_status settings_make(settings *s, const pov_render_desc *desc, const pov_camera *camera, pov_error *err);

#endif

/* args.h - povview's command line as values. */
#ifndef VIEWER_ARGS_H
#define VIEWER_ARGS_H

#include <povtrace/scene.h>

typedef enum args_verdict { ARGS_RUN, ARGS_HELP, ARGS_VERSION, ARGS_WRONG } args_verdict;

typedef struct args {
    const char *scene;           /* NULL: the window begins with the start page */
    int width, height;           /* 0: not said */
    const char *shot;            /* draw without a display, to this file */
    int frames;                  /* passes that a shot waits for; 0: all */
    const char *keys;            /* keys of a shot; "" for none */
    bool bench, remember;        /* the scene becomes a recent one: where it is shown in a window */
    int threads, max_depth;
    int samples;                 /* samples a pixel, on average and at most */
    double error;                /* error that ends sampling; 0: no such limit */
    pov_dialect dialect;
    const char *plugin_path;
    const char *reference;       /* a picture to compare with; NULL: none */
    char problem[256];           /* after ARGS_WRONG */
} args;

args_verdict args_parse(args *a, int argc, char **argv);

#endif

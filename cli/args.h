/* args.h - povc's command line. Parsing changes nothing but its own struct, so that it can be tested. */
#ifndef CLI_ARGS_H
#define CLI_ARGS_H

#include "frames.h"

typedef enum args_verdict { ARGS_RUN, ARGS_HELP, ARGS_VERSION, ARGS_WRONG } args_verdict;
typedef enum args_progress {
    ARGS_PROGRESS_AUTO,
    ARGS_PROGRESS_BAR,
    ARGS_PROGRESS_JSON,
    ARGS_PROGRESS_NONE
} args_progress;
typedef enum args_color { ARGS_COLOR_AUTO, ARGS_COLOR_ALWAYS, ARGS_COLOR_NEVER } args_color;
/* Maps besides the picture, from the camera rays' hits and from the pixels' time. */
typedef enum args_aov { ARGS_AOV_CERTAINTY, ARGS_AOV_NORMAL, ARGS_AOV_DEPTH, ARGS_AOV_TIME, ARGS_AOV_OBJECT, ARGS_AOV_POSITION,
    ARGS_AOV_ALBEDO, ARGS_AOV_ALPHA, ARGS_AOVS } args_aov;
typedef enum args_transfer { ARGS_TRANSFER_SCENE, ARGS_TRANSFER_SRGB, ARGS_TRANSFER_LINEAR } args_transfer;

typedef enum args_sampling { ARGS_SAMPLING_AUTO, ARGS_SAMPLING_UNIFORM, ARGS_SAMPLING_ADAPTIVE } args_sampling;

/* How often -L and -D may be given. */
enum { ARGS_LIST = 64 };

typedef struct args {
    const char *scene;
    const char *output;          /* NULL: nothing is rendered */
    int width, height;           /* of the whole picture */
    pov_rect crop;               /* width 0: all of it */
    bool alpha;                  /* what hides the background is stored, too */
    bool in_whole;               /* the part is written in its place in a black picture, as POV-Ray does */
    int threads, samples, max_depth, bits;   /* 0: the library's default */
    int preview;                 /* edge of a pixel of the first pass, 0: none; below zero: as the limits need it */
    args_transfer transfer;
    double gamma;                /* of the picture's integers, for a transfer of ARGS_TRANSFER_SCENE; 0: the scene's */
    int seed;
    int part, parts;             /* of --part; 0: the whole picture */
    bool merge;                  /* join the parts of the output */
    double partial_every;        /* seconds between checkpoints; 0: none */
    bool resume;
    double error, time;          /* limits that end refinement; 0: none */
    args_sampling sampling;
    char command[1024];          /* the words of the command line, as a shell takes them; cut off where there are more */
    const char *format;          /* an image ending, or NULL: by the output's name */
    pov_dialect dialect;
    pov_accel accel;
    pov_accuracy accuracy;
    const char *aov[ARGS_AOVS];  /* output file of each map; NULL: none */
    const char *plugin_path;     /* or NULL */
    const char *tev;             /* HOST:PORT of a viewer that is shown the picture; or NULL */
    const char *folders[ARGS_LIST], *declares[ARGS_LIST + 1];   /* of -L; of -D, ending with NULL */
    int folder_count, declare_count;
    const char *write_path;      /* or NULL */
    bool strict, soft_lights, quick_colours;
    pov_limits limits;
    size_t most_input, most_images;   /* bytes; 0: the library's defaults */
    uint64_t most_rays;          /* that follow from one of the camera; 0: the library's default */
    const pov_animation *animation;   /* or NULL */
    frames frames;
    bool has_clock;              /* --clock is given */
    struct progress *progress_of_all; /* of an animation; NULL: each picture has its own */
    const char *report, *reference;   /* files, or NULL */
    char **compared;             /* of --compare: reports, and the plot to draw; or NULL */
    int compared_count;
    bool compare;
    char **checked;              /* scenes of --check, the first of which is `scene` */
    int checked_count;
    bool json;                   /* messages are one JSON object a line */
    char note[3][160];           /* what is odd about the command line, and counts for less than it seems */
    int note_count;
    bool explain, check, stats, quiet, verbose;
    args_progress progress;
    args_color color;
    char named[256];             /* the output's name where none is given */
    char problem[256];           /* what is wrong, for ARGS_WRONG */
} args;

/* The strings of argv are kept, not copied; getopt_long may change their order. */
args_verdict args_parse(args *a, int argc, char **argv);

#endif

/* povray.h - POV-Ray's command line and INI files, as settings of povc.
 *
 * A switch is another form of a setting: +W320 is Width=320, -D is Display=Off. So there is one table of settings, and
 * each row defines the setting's use in povc. Parsing changes nothing but its own struct and reads no files but the
 * named INI files, so that it can be tested. */
#ifndef CLI_POVRAY_H
#define CLI_POVRAY_H

#include "frames.h"

#include <limits.h>

enum { POVRAY_TEXT = 1024, POVRAY_LIST = 64, POVRAY_NO_FRAME = INT_MIN };

/* Texts of settings that may be given several times. */
typedef struct povray_list { char item[POVRAY_LIST][POVRAY_TEXT]; int count; } povray_list;

/* Names and defaults are POV-Ray's. */
typedef struct povray {
    int width, height;
    char input[POVRAY_TEXT], output[POVRAY_TEXT];
    char found[POVRAY_TEXT];     /* where the input is: in a folder of Library_Path, or with its ending; empty: nowhere */
    bool output_to_file;
    char type;                   /* N PNG, P PPM, E OpenEXR, J JPEG, ...: the letter of +F */
    int bits;                    /* bits a channel; 0: the usual depth */
    bool alpha;
    char gamma[POVRAY_TEXT];
    bool antialias;
    double threshold;
    int depth, method, quality, threads, seed;
    double start_column, end_column, start_row, end_row;   /* below 1: fractions of the picture; else pixels from 1 on;
                                                            * 0: not given */
    bool has_clock, cyclic, resume;
    double clock, first_clock, last_clock;
    int first_frame, last_frame; /* POVRAY_NO_FRAME: not given */
    int frame_step;
    char subset_start[32], subset_end[32];   /* frames, or fractions of all below 1 */
    bool verbose;
    povray_list library, declares, ignored;   /* ignored: unsupported settings, for a warning each */
    povray_list doubts;          /* whole lines of warning */
    int ini_depth;               /* INI files within each other */
    char problem[POVRAY_TEXT];   /* message; empty: no problem */
} povray;

/* Is this POV-Ray's command line? It is if the program is started under the name povray, if a word begins with "+", or
 * if the first word is an INI file. */
bool povray_is_asked(int argc, char *const *argv);
/* Settings from the command line, in its order, on top of the INI file that POVINI names or that is in the working or
 * the home folder. False: problem has the reason. */
bool povray_parse(povray *p, int argc, char *const *argv);
/* One setting as an INI file has it. */
bool povray_set(povray *p, const char *name, const char *value);

/* The pictures of an animation, if there is one: not so if neither the first nor the last frame is given. */
frames povray_frames(const povray *p);
/* The output's name, before a frame's number is put in; "-" is standard output. False: it is too long. */
bool povray_output(const povray *p, char *out, size_t size);
/* The crop of the picture; width 0: all of it. False: empty. */
bool povray_crop(const povray *p, pov_rect *out);
/* The ending of the image format. */
const char *povray_ending(const povray *p);

#endif

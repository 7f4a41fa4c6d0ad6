/* povray.h - the command line and the INI files of POV-Ray, as settings of povc.
 *
 * A switch is another way to write a setting: +W320 is Width=320, -D is Display=Off. So there is one table of settings,
 * and each row says what the setting is to povc. Reading touches nothing but its own struct and the INI files that it
 * is told to read, so that it can be tested. */
#ifndef CLI_POVRAY_H
#define CLI_POVRAY_H

#include <povtrace/povtrace.h>

enum { POVRAY_TEXT = 1024, POVRAY_LIST = 64 };

/* Texts of settings that may be given several times. */
typedef struct povray_list { char item[POVRAY_LIST][POVRAY_TEXT]; int count; } povray_list;

/* Names and defaults are POV-Ray's. */
typedef struct povray {
    int width, height;
    char input[POVRAY_TEXT], output[POVRAY_TEXT];
    bool output_to_file;
    char type;                   /* N PNG, P PPM, E OpenEXR, J JPEG, ...: the letter of +F */
    int bits;                    /* a channel; 0: as usual */
    bool alpha;
    char gamma[POVRAY_TEXT];
    bool antialias;
    double threshold;
    int depth, method, quality, threads, seed;
    double start_column, end_column, start_row, end_row;   /* below 1: parts of the picture; else pixels from 1 on; 0: not given */
    bool has_clock, cyclic, resume;
    double clock, first_clock, last_clock;
    int first_frame, last_frame, frame_step;
    char subset_start[32], subset_end[32];   /* frames, or parts of all below 1 */
    bool verbose;
    povray_list library, declares, ignored;   /* ignored: settings that povc cannot follow, for a warning each */
    char problem[POVRAY_TEXT];   /* what is wrong; empty: nothing */
} povray;

/* Does this command line speak POV-Ray's? It does when the program is started under the name povray, when a word begins
 * with "+", or when the first word is an INI file. */
bool povray_is_asked(int argc, char *const *argv);
/* Settings from the command line, in its order, on top of the INI file that POVINI names or that stands in the working or
 * the home folder. False: problem says why. */
bool povray_parse(povray *p, int argc, char *const *argv);
/* One setting as an INI file has it. */
bool povray_set(povray *p, const char *name, const char *value);

/* The frames that are drawn, from first to last; one picture without an animation: 0 to 0. */
void povray_frames(const povray *p, int *first, int *last);
/* The clock of a frame. */
double povray_clock(const povray *p, int frame);
/* The output's name for a frame; "-" is standard output. False: it is too long. */
bool povray_output(const povray *p, int frame, char *out, size_t size);
/* The part of the picture that is drawn; width 0: all of it. False: it is none. */
bool povray_crop(const povray *p, pov_rect *out);
/* The ending of the image format. */
const char *povray_ending(const povray *p);

#endif

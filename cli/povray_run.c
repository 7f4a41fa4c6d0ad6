#include "povray_run.h"
#include "frames_run.h"
#include "messages.h"
#include "povray.h"
#include "signals.h"
#include "usage.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { EXIT_DRAWN = 0, EXIT_FATAL = 1 };

/* POV-Ray samples more where neighbours differ by more than the threshold, whose default is 0.3, and stops at a depth.
 * Its error was measured on two scenes of the gallery, 200 x 150: an rms error of 0.007 and 0.016 for 0.3, 0.005 and
 * 0.013 for 0.1. Here the threshold requests an error, and reaches it. */
static const double error_of_threshold = 1.0 / 30.0;

/* A scene without gamma, of old versions, is written as it is whatever the setting. */
static void say_gamma(const povray *p, const messages *m, args *a)
{
    char *end;
    const double number = strtod(p->gamma, &end);

    if (!p->gamma[0] || strcasecmp(p->gamma, "srgb") == 0)
        return;
    if (end == p->gamma || *end != '\0' || !(number > 0.0 && number <= 100.0))
        messages_say(m, "File_Gamma=%s is no number and not sRGB; taken as sRGB", p->gamma);
    else if (number == 1.0)
        a->transfer = ARGS_TRANSFER_LINEAR;
    else
        a->gamma = number;
}

static bool stores_alpha(const povray *p) { return strchr("NTCB", p->type) != NULL; }

/* Unsupported settings, one line each. */
static void say_ignored(const povray *p, const messages *m)
{
    for (int i = 0; i < p->doubts.count; i++)
        messages_say(m, "%s", p->doubts.item[i]);
    for (int i = 0; i < p->ignored.count; i++)
        messages_say(m, "\"%s\" is not a setting of povc; it is left out", p->ignored.item[i]);
    if (p->alpha && !stores_alpha(p))
        messages_say(m, "Output_Alpha: a picture of this type is written without transparency");
    if (p->type == 'C')
        messages_say(m, "Output_File_Type=C: the TGA is written without compression");
    if (p->quality < 9)
        messages_say(m, "Quality=%d: pictures are drawn at full quality%s", p->quality, p->quality <= 5 ? ", but with each pigment's quick_color" : "");
}

static void fill_lists(const povray *p, args *a)
{
    for (int i = 0; i < p->library.count && i < ARGS_LIST; i++)
        a->folders[a->folder_count++] = p->library.item[i];
    for (int i = 0; i < p->declares.count && i < ARGS_LIST; i++)
        a->declares[a->declare_count++] = p->declares.item[i];
}

static bool fill(const povray *p, const messages *m, args *a)
{
    static pov_animation still;

    still.clock = p->clock;
    a->animation = p->has_clock ? &still : NULL;
    a->frames = povray_frames(p);
    a->preview = -1;
    a->scene = p->found[0] ? p->found : p->input;
    a->width = p->width;
    a->height = p->height;
    a->threads = p->threads > 0 ? p->threads : 0;
    a->bits = p->bits > 8 && strchr("NP", p->type) ? 16 : 0;
    a->seed = p->seed > 0 ? p->seed : 0;
    a->resume = p->resume;
    a->alpha = p->alpha && stores_alpha(p);
    a->progress = p->verbose ? ARGS_PROGRESS_AUTO : ARGS_PROGRESS_NONE;
    a->format = povray_ending(p);
    a->in_whole = true;
    a->quick_colours = p->quality <= 5;
    if (p->antialias)
        a->error = p->threshold > 0.0 ? p->threshold * error_of_threshold : error_of_threshold;
    fill_lists(p, a);
    say_gamma(p, m, a);
    return povray_crop(p, &a->crop);
}

static int refuse(const messages *m, const char *why)
{
    pov_error err = { 0 };

    snprintf(err.message, sizeof err.message, "%.500s", why);
    messages_error(m, &err);
    return EXIT_FATAL;
}

static bool is_word_of(const char *word, const char *const *words)
{
    while (*words && strcmp(word, *words) != 0)
        words++;
    return *words != NULL;
}

/* Programs that find povc under the name povray ask it for its version before they draw. */
static bool answer(int argc, char *const *argv)
{
    static const char *const helps[] = { "--help", "-help", "-h", "-?", NULL }, *const versions[] = { "--version", "-version", NULL };

    for (int i = 1; i < argc; i++)
        if (is_word_of(argv[i], helps)) {
            usage_print_help();
            return true;
        } else if (is_word_of(argv[i], versions)) {
            usage_print_version();
            printf("reads scenes and the command line of POV-Ray 3.7\n");
            return true;
        }
    return false;
}

int povray_run(int argc, char **argv)
{
    static povray p;             /* large, and once a process */
    static char output[POVRAY_TEXT + 32];
    args a = { .progress = ARGS_PROGRESS_NONE };
    run_end end = RUN_COMPLETE;
    pov_error err = { 0 };
    messages m;

    messages_init(&m, &a);
    if (answer(argc, argv))
        return fflush(stdout) == 0 ? EXIT_DRAWN : EXIT_FATAL;
    if (!povray_parse(&p, argc, argv))
        return refuse(&m, p.problem);
    if (!povray_output(&p, output, sizeof output))
        return refuse(&m, "the output's name is too long");
    a.output = p.output_to_file ? output : "/dev/null";
    if (!fill(&p, &m, &a))
        return refuse(&m, "the part of the picture that is asked for holds no pixel");
    say_ignored(&p, &m);
    if (frames_run(&a, &m, &end, &err) < 0) {
        messages_error(&m, &err);
        return EXIT_FATAL;
    }
    if (signals_end_asked())
        signals_end_by(signals_end_asked());
    return EXIT_DRAWN;
}

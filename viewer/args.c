#include "args.h"

#include "script.h"

#include <getopt.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LARGEST_SIDE = 16384, MOST_THREADS = 4096, MOST_SAMPLES = 65536, DEEPEST = 65535, MOST_FRAMES = 1000000 };

enum {
    OPTION_SHOT = 256, OPTION_FRAMES, OPTION_KEYS, OPTION_BENCH, OPTION_SPP, OPTION_ERROR, OPTION_MAX_DEPTH, OPTION_DIALECT,
    OPTION_PLUGIN_PATH, OPTION_VERSION, OPTION_REFERENCE
};

static const struct option long_options[] = {
    { "shot", required_argument, NULL, OPTION_SHOT },
    { "frames", required_argument, NULL, OPTION_FRAMES },
    { "keys", required_argument, NULL, OPTION_KEYS },
    { "bench", no_argument, NULL, OPTION_BENCH },
    { "threads", required_argument, NULL, 't' },
    { "spp", required_argument, NULL, OPTION_SPP },
    { "error", required_argument, NULL, OPTION_ERROR },
    { "max-depth", required_argument, NULL, OPTION_MAX_DEPTH },
    { "dialect", required_argument, NULL, OPTION_DIALECT },
    { "plugin-path", required_argument, NULL, OPTION_PLUGIN_PATH },
    { "reference", required_argument, NULL, OPTION_REFERENCE },
    { "help", no_argument, NULL, 'h' },
    { "version", no_argument, NULL, OPTION_VERSION },
    { NULL, 0, NULL, 0 },
};

static bool refuse(args *a, const char *format, ...) POV_PRINTF(2, 3);

static bool refuse(args *a, const char *format, ...)
{
    va_list list;

    va_start(list, format);
    vsnprintf(a->problem, sizeof a->problem, format, list);
    va_end(list);
    return false;
}

static bool read_whole(args *a, const char *what, const char *text, int most, int *out)
{
    long value = 0;
    const char *at = text;

    for (; *at >= '0' && *at <= '9' && value <= most; at++)
        value = 10 * value + (*at - '0');
    if (*at || value < 1 || value > most)
        return refuse(a, "%s must be a whole number from 1 to %d, not \"%s\"", what, most, text);
    *out = (int)value;
    return true;
}

static bool read_error(args *a, const char *text)
{
    char *end;

    a->error = strtod(text, &end);
    if (end == text || *end || !(a->error > 0.0 && a->error < 1.0))
        return refuse(a, "--error must be a number above 0 and below 1, not \"%s\"", text);
    return true;
}

static bool read_dialect(args *a, const char *text)
{
    static const char *const words[] = { "auto", "course", "povray" };

    for (int i = 0; i < 3; i++) {
        if (strcmp(text, words[i]) == 0) {
            a->dialect = (pov_dialect)i;
            return true;
        }
    }
    return refuse(a, "--dialect must be auto, course or povray, not \"%s\"", text);
}

static bool read_option(args *a, int option, const char *text)
{
    switch (option) {
    case OPTION_SHOT:
        a->shot = text;
        return *text || refuse(a, "--shot wants the name of an image file");
    case OPTION_FRAMES:
        return read_whole(a, "--frames", text, MOST_FRAMES, &a->frames);
    case OPTION_KEYS:
        a->keys = text;
        return script_check(text, a->problem, sizeof a->problem);
    case OPTION_BENCH:
        a->bench = true;
        return true;
    case 't':
        return read_whole(a, "--threads", text, MOST_THREADS, &a->threads);
    case OPTION_SPP:
        return read_whole(a, "--spp", text, MOST_SAMPLES, &a->samples);
    case OPTION_ERROR:
        return read_error(a, text);
    case OPTION_MAX_DEPTH:
        return read_whole(a, "--max-depth", text, DEEPEST, &a->max_depth);
    case OPTION_DIALECT:
        return read_dialect(a, text);
    case OPTION_REFERENCE:
        a->reference = text;
        return *text || refuse(a, "--reference wants the name of an image file");
    default:
        a->plugin_path = text;
        return true;
    }
}

/* A file of options, or an option: +Iscene.pov. */
static bool is_povrays(const char *word)
{
    const size_t length = strlen(word);

    return word[0] == '+' || (length > 4 && strcmp(word + length - 4, ".ini") == 0);
}

static bool read_places(args *a, int count, char **places)
{
    if (count < 1 && !a->shot && !a->bench)
        return true;
    if (count < 1 || !places[0][0])
        return refuse(a, "SCENE is missing: povview wants SCENE [WIDTH HEIGHT]");
    a->scene = places[0];
    if (is_povrays(places[0]))
        return refuse(a, "\"%s\" is for POV-Ray: povc reads that, and povview wants SCENE [WIDTH HEIGHT]", places[0]);
    if (count > 1 && !read_whole(a, "WIDTH", places[1], LARGEST_SIDE, &a->width))
        return false;
    if (count == 2)
        return refuse(a, "HEIGHT is missing: povview wants SCENE [WIDTH HEIGHT]");
    if (count > 3)
        return refuse(a, "\"%s\" is one word too many: povview wants SCENE [WIDTH HEIGHT]", places[3]);
    return count < 3 || read_whole(a, "HEIGHT", places[2], LARGEST_SIDE, &a->height);
}

static bool check_together(args *a)
{
    if (!a->shot && a->frames)
        return refuse(a, "--frames goes with --shot");
    if (!a->shot && a->keys[0])
        return refuse(a, "--keys goes with --shot");
    if (a->shot && a->bench)
        return refuse(a, "--shot and --bench do not go together");
    return true;
}

/* A window refines until the eye sees no difference; a file or a measurement takes the first complete picture. */
static void fill_in(args *a)
{
    const int plenty = 1024;
    const double unseen = 0.002;

    if (a->samples > 0 || a->error > 0.0) {
        a->samples = a->samples > 0 ? a->samples : MOST_SAMPLES;
        return;
    }
    a->samples = a->shot || a->bench ? 1 : plenty;
    a->error = a->shot || a->bench ? 0.0 : unseen;
}

/* getopt_long has found an unknown option, or one whose value is missing or not allowed. */
static bool refuse_option(args *a, int verdict, char **argv)
{
    if (verdict == ':')
        return refuse(a, "\"%s\" wants a value", argv[optind - 1]);
    if (optopt > 0 && optopt < 256 && strncmp(argv[optind - 1], "--", 2) != 0)
        return refuse(a, "there is no option \"-%c\"", optopt);
    return refuse(a, optopt ? "\"%s\": this option takes no value" : "there is no option \"%s\"", argv[optind - 1]);
}

args_verdict args_parse(args *a, int argc, char **argv)
{
    int option;

    memset(a, 0, sizeof *a);
    a->keys = "";
    optind = 0;      /* glibc begins anew at 0 */
    opterr = 0;
    while ((option = getopt_long(argc, argv, ":t:h", long_options, NULL)) != -1) {
        if (option == 'h')
            return ARGS_HELP;
        if (option == OPTION_VERSION)
            return ARGS_VERSION;
        if (option == '?' || option == ':') {
            refuse_option(a, option, argv);
            return ARGS_WRONG;
        }
        if (!read_option(a, option, optarg))
            return ARGS_WRONG;
    }
    if (!read_places(a, argc - optind, argv + optind) || !check_together(a))
        return ARGS_WRONG;
    fill_in(a);
    a->remember = !a->shot && !a->bench;
    return ARGS_RUN;
}

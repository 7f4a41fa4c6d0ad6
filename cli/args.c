#include "args_read.h"

#include <getopt.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum {
    MOST_THREADS = 4096,
    MOST_SAMPLES = 65536,        /* as the library has it */
    DEEPEST = 65535,
    MOST_PARTS = 1000000
};

/* Options without a letter of their own. */
enum {
    OPTION_SPP = 256, OPTION_MAX_DEPTH, OPTION_BITS, OPTION_TRANSFER, OPTION_FORMAT, OPTION_EXPLAIN,
    OPTION_DIALECT, OPTION_ACCEL, OPTION_ACCURACY, OPTION_AOV, OPTION_CROP, OPTION_CHECK, OPTION_STATS, OPTION_PREVIEW, OPTION_PROGRESS,
    OPTION_COLOR, OPTION_ERROR, OPTION_TIME, OPTION_SAMPLING, OPTION_COMPARE, OPTION_PARTIAL_EVERY, OPTION_RESUME, OPTION_SEED, OPTION_REPORT, OPTION_REFERENCE,
    OPTION_PLUGIN_PATH, OPTION_STRICT, OPTION_SOFT_LIGHTS, OPTION_ALLOW_WRITE, OPTION_LIMIT, OPTION_ALPHA, OPTION_PART, OPTION_MERGE, OPTION_TEV, OPTION_FRAMES, OPTION_CLOCK, OPTION_MESSAGES, OPTION_HELP, OPTION_VERSION
};

static const struct option long_options[] = {
    { "threads", required_argument, NULL, 't' },
    { "spp", required_argument, NULL, OPTION_SPP },
    { "error", required_argument, NULL, OPTION_ERROR },
    { "time", required_argument, NULL, OPTION_TIME },
    { "sampling", required_argument, NULL, OPTION_SAMPLING },
    { "max-depth", required_argument, NULL, OPTION_MAX_DEPTH },
    { "output", required_argument, NULL, 'o' },
    { "size", required_argument, NULL, 's' },
    { "bits", required_argument, NULL, OPTION_BITS },
    { "transfer", required_argument, NULL, OPTION_TRANSFER },
    { "alpha", no_argument, NULL, OPTION_ALPHA },
    { "format", required_argument, NULL, OPTION_FORMAT },
    { "frames", required_argument, NULL, OPTION_FRAMES },
    { "clock", required_argument, NULL, OPTION_CLOCK },
    { "explain", no_argument, NULL, OPTION_EXPLAIN },
    { "dialect", required_argument, NULL, OPTION_DIALECT },
    { "accel", required_argument, NULL, OPTION_ACCEL },
    { "accuracy", required_argument, NULL, OPTION_ACCURACY },
    { "aov", required_argument, NULL, OPTION_AOV },
    { "crop", required_argument, NULL, OPTION_CROP },
    { "check", no_argument, NULL, OPTION_CHECK },
    { "stats", no_argument, NULL, OPTION_STATS },
    { "preview", required_argument, NULL, OPTION_PREVIEW },
    { "progress", required_argument, NULL, OPTION_PROGRESS },
    { "quiet", no_argument, NULL, 'q' },
    { "verbose", no_argument, NULL, 'v' },
    { "messages", required_argument, NULL, OPTION_MESSAGES },
    { "color", required_argument, NULL, OPTION_COLOR },
    { "seed", required_argument, NULL, OPTION_SEED },
    { "partial-every", required_argument, NULL, OPTION_PARTIAL_EVERY },
    { "resume", no_argument, NULL, OPTION_RESUME },
    { "part", required_argument, NULL, OPTION_PART },
    { "merge", no_argument, NULL, OPTION_MERGE },
    { "tev", required_argument, NULL, OPTION_TEV },
    { "compare", no_argument, NULL, OPTION_COMPARE },
    { "report", required_argument, NULL, OPTION_REPORT },
    { "reference", required_argument, NULL, OPTION_REFERENCE },
    { "plugin-path", required_argument, NULL, OPTION_PLUGIN_PATH },
    { "declare", required_argument, NULL, 'D' },
    { "library-path", required_argument, NULL, 'L' },
    { "strict", no_argument, NULL, OPTION_STRICT },
    { "soft-lights", no_argument, NULL, OPTION_SOFT_LIGHTS },
    { "allow-write", required_argument, NULL, OPTION_ALLOW_WRITE },
    { "limit", required_argument, NULL, OPTION_LIMIT },
    { "help", no_argument, NULL, OPTION_HELP },
    { "version", no_argument, NULL, OPTION_VERSION },
    { NULL, 0, NULL, 0 },
};

/* Words that an option takes, in the order of its enumeration; ends with NULL. */
static const char *const transfers[] = { "scene", "srgb", "linear", NULL };
static const char *const dialects[] = { "auto", "course", "povray", NULL };
static const char *const accels[] = { "tree", "none", NULL };
static const char *const accuracies[] = { "certified", "max", NULL };
static const char *const aovs[] = { "certainty", "normal", "depth", "time", "object", "position", "albedo", "alpha", NULL };
static const char *const progresses[] = { "auto", "bar", "json", "none", NULL };
static const char *const samplings[] = { "auto", "uniform", "adaptive", NULL };
static const char *const forms[] = { "text", "json", NULL };
static const char *const colors[] = { "auto", "always", "never", NULL };

/* x0,y0,x1,y1: the first pixel, and the one behind the last. Whether they lie in the picture is checked later. */
static bool read_crop(args *a, const char *text)
{
    int corner[4];
    const char *at = text;

    for (int i = 0; i < 4; i++) {
        const char *end = i < 3 ? strchr(at, ',') : at + strlen(at);

        corner[i] = end ? args_digits(at, end, ARGS_LARGEST_SIDE) : -1;
        if (corner[i] < 0)
            return args_refuse(a, "--crop wants four whole numbers x0,y0,x1,y1, not \"%s\"", text);
        at = end + 1;
    }
    if (corner[2] <= corner[0] || corner[3] <= corner[1])
        return args_refuse(a, "--crop %s holds no pixel: x1 and y1 must be above x0 and y0", text);
    a->crop.x = corner[0];
    a->crop.y = corner[1];
    a->crop.width = corner[2] - corner[0];
    a->crop.height = corner[3] - corner[1];
    return true;
}

/* I/N */
static bool read_part(args *a, const char *text)
{
    const char *slash = strchr(text, '/');

    a->part = slash ? args_digits(text, slash, MOST_PARTS) : -1;
    a->parts = slash ? args_digits(slash + 1, NULL, MOST_PARTS) : -1;
    return (a->part >= 1 && a->part <= a->parts) ||
           args_refuse(a, "--part wants I/N, such as 3/24 for the third of 24 parts, not \"%s\"", text);
}

/* WIDTHxHEIGHT */
static bool read_size(args *a, const char *text)
{
    const char *x = strchr(text, 'x');

    a->width = x ? args_digits(text, x, ARGS_LARGEST_SIDE) : -1;
    a->height = x ? args_digits(x + 1, NULL, ARGS_LARGEST_SIDE) : -1;
    return (a->width > 0 && a->height > 0) || args_refuse(a, "-s wants WIDTHxHEIGHT, such as 640x480, not \"%s\"", text);
}

static bool read_format(args *a, const char *text)
{
    a->format = *text == '.' ? text + 1 : text;
    return *a->format != '\0' || args_refuse(a, "--format wants an image ending, such as png");
}

static bool read_messages(args *a, const char *text)
{
    int word = 0;

    if (!args_word(a, "--messages", text, forms, &word))
        return false;
    a->json = word == 1;
    return true;
}

static bool read_option_word(args *a, int option, const char *text)
{
    int word = 0;

    switch (option) {
    case OPTION_TRANSFER:
        if (!args_word(a, "--transfer", text, transfers, &word))
            return false;
        a->transfer = (args_transfer)word;
        return true;
    case OPTION_DIALECT:
        if (!args_word(a, "--dialect", text, dialects, &word))
            return false;
        a->dialect = (pov_dialect)word;
        return true;
    case OPTION_ACCEL:
        if (!args_word(a, "--accel", text, accels, &word))
            return false;
        a->accel = (pov_accel)word;
        return true;
    case OPTION_ACCURACY:
        if (!args_word(a, "--accuracy", text, accuracies, &word))
            return false;
        a->accuracy = (pov_accuracy)word;
        return true;
    case OPTION_SAMPLING:
        if (!args_word(a, "--sampling", text, samplings, &word))
            return false;
        a->sampling = (args_sampling)word;
        return true;
    case OPTION_PROGRESS:
        if (!args_word(a, "--progress", text, progresses, &word))
            return false;
        a->progress = (args_progress)word;
        return true;
    default:
        if (!args_word(a, "--color", text, colors, &word))
            return false;
        a->color = (args_color)word;
        return true;
    }
}

static bool read_option_number(args *a, int option, const char *text)
{
    static const int depths[] = { 8, 16, -1 }, edges[] = { 0, 2, 4, 8, 16, -1 };

    switch (option) {
    case 't': case 'j':
        return args_whole(a, "--threads", text, 1, MOST_THREADS, &a->threads);
    case OPTION_SPP:
        return args_whole(a, "--spp", text, 1, MOST_SAMPLES, &a->samples);
    case OPTION_SEED:
        return args_whole(a, "--seed", text, 0, 2000000000, &a->seed);
    case OPTION_MAX_DEPTH:
        return args_whole(a, "--max-depth", text, 1, DEEPEST, &a->max_depth);
    case OPTION_BITS:
        return args_choice(a, "--bits", text, depths, "8 or 16", &a->bits);
    default:
        return args_choice(a, "--preview", text, edges, "0, 2, 4, 8 or 16", &a->preview);
    }
}

static bool put(args *a, const char *option, const char *text, const char **list, int *count)
{
    if (*count == ARGS_LIST)
        return args_refuse(a, "%s is given more than %d times", option, ARGS_LIST);
    list[(*count)++] = text;
    return true;
}

/* Options for loading the scene. */
static bool read_option_language(args *a, int option, const char *text)
{
    switch (option) {
    case 'D':
        if (!strchr(text, '=') || text[0] == '=')
            return args_refuse(a, "-D wants NAME=VALUE, not \"%s\"", text);
        return put(a, "-D", text, a->declares, &a->declare_count);
    case 'L':
        return put(a, "-L", text, a->folders, &a->folder_count);
    case OPTION_FRAMES:
        return args_frames(a, text);
    case OPTION_CLOCK:
        return args_clock(a, text);
    case OPTION_STRICT:
        a->strict = true;
        return true;
    case OPTION_SOFT_LIGHTS:
        a->soft_lights = true;
        return true;
    case OPTION_ALLOW_WRITE:
        a->write_path = text;
        return true;
    default:
        return args_limit(a, text);
    }
}

static bool read_option(args *a, int option, const char *text)
{
    switch (option) {
    case 't': case 'j': case OPTION_SEED: case OPTION_SPP: case OPTION_MAX_DEPTH: case OPTION_BITS: case OPTION_PREVIEW:
        return read_option_number(a, option, text);
    case OPTION_ACCURACY:
    case OPTION_TRANSFER: case OPTION_DIALECT: case OPTION_ACCEL: case OPTION_PROGRESS: case OPTION_COLOR:
    case OPTION_SAMPLING:
        return read_option_word(a, option, text);
    case OPTION_ERROR:
        return args_positive(a, "--error", text, &a->error);
    case OPTION_TIME:
        return args_positive(a, "--time", text, &a->time);
    case 's':
        return read_size(a, text);
    case 'o':
        a->output = text;
        return true;
    case OPTION_CROP:
        return read_crop(a, text);
    case OPTION_FORMAT:
        return read_format(a, text);
    case OPTION_PARTIAL_EVERY:
        return args_positive(a, "--partial-every", text, &a->partial_every);
    case OPTION_RESUME:
        a->resume = true;
        return true;
    case OPTION_PART:
        return read_part(a, text);
    case OPTION_MERGE:
        a->merge = true;
        return true;
    case OPTION_TEV:
        a->tev = text;
        return strrchr(text, ':') || args_refuse(a, "--tev wants HOST:PORT, such as localhost:14158, not \"%s\"", text);
    case OPTION_COMPARE:
        a->compare = true;
        return true;
    case OPTION_REPORT:
        a->report = text;
        return true;
    case OPTION_REFERENCE:
        a->reference = text;
        return true;
    case OPTION_PLUGIN_PATH:
        a->plugin_path = text;
        return true;
    case 'L': case 'D': case OPTION_STRICT: case OPTION_SOFT_LIGHTS: case OPTION_ALLOW_WRITE: case OPTION_LIMIT:
    case OPTION_FRAMES: case OPTION_CLOCK:
        return read_option_language(a, option, text);
    case OPTION_EXPLAIN:
        a->explain = true;
        return true;
    case OPTION_CHECK:
        a->check = true;
        return true;
    case OPTION_STATS:
        a->stats = true;
        return true;
    case OPTION_MESSAGES:
        return read_messages(a, text);
    case OPTION_ALPHA:
        a->alpha = true;
        return true;
    case 'q':
        a->quiet = true;
        return true;
    default:
        a->verbose = true;
        return true;
    }
}

/* The only option with two arguments: the map, and its file, which getopt_long has not reached yet. */
static bool read_aov(args *a, const char *text, int argc, char **argv)
{
    int word = 0;

    if (!args_word(a, "--aov", text, aovs, &word))
        return false;
    if (optind >= argc || argv[optind][0] == '\0')
        return args_refuse(a, "--aov %s wants the name of an image file", text);
    if (a->aov[word])
        return args_refuse(a, "--aov %s is given twice", text);
    a->aov[word] = argv[optind++];
    return true;
}

/* Edit distance of two words. */
static size_t distance(const char *a, const char *b)
{
    size_t row[32], width = strlen(b);

    if (width >= 31)
        return width;
    for (size_t j = 0; j <= width; j++)
        row[j] = j;
    for (size_t i = 1; a[i - 1]; i++) {
        size_t diagonal = row[0];

        row[0] = i;
        for (size_t j = 1; j <= width; j++) {
            size_t best = diagonal + (a[i - 1] != b[j - 1]);

            diagonal = row[j];
            best = best < row[j] + 1 ? best : row[j] + 1;
            row[j] = best < row[j - 1] + 1 ? best : row[j - 1] + 1;
        }
    }
    return row[width];
}

static bool refuse_unknown(args *a, const char *word)
{
    const char *nearest = NULL;
    size_t least = 3;
    char name[32];

    if (strncmp(word, "--", 2) != 0)
        return args_refuse(a, "there is no option \"%s\"", word);
    snprintf(name, sizeof name, "%.*s", (int)strcspn(word + 2, "="), word + 2);
    for (const struct option *o = long_options; o->name; o++) {
        size_t d = distance(name, o->name);

        if (d < least) {
            least = d;
            nearest = o->name;
        }
    }
    if (nearest)
        return args_refuse(a, "there is no option \"--%s\"; did you mean \"--%s\"?", name, nearest);
    return args_refuse(a, "there is no option \"--%s\"", name);
}

/* getopt_long has found something unknown (optopt 0 or a letter), or a value for an option that takes none (optopt is
 * that option). */
static bool refuse_option(args *a, char **argv)
{
    char letter[3] = { '-', (char)optopt, '\0' };

    if (optopt > 255)
        return args_refuse(a, "\"%s\": this option takes no value", argv[optind - 1]);
    if (optopt == 0)
        return refuse_unknown(a, argv[optind - 1]);
    if (optopt >= '0' && optopt <= '9')
        return args_refuse(a, "there is no option \"%s\"; sizes are whole numbers above zero", letter);
    if (strchr("WHIOAQK", optopt))
        return args_refuse(a, "there is no option \"%s\"; povc takes POV-Ray's words if one begins with +, as in +W640 +H480",
                           letter);
    return args_refuse(a, "there is no option \"%s\"", letter);
}

/* ---- what is odd ---- */

static void note(args *a, const char *format, ...) POV_PRINTF(2, 3);

static void note(args *a, const char *format, ...)
{
    va_list list;

    if (a->note_count == (int)(sizeof a->note / sizeof a->note[0]))
        return;
    va_start(list, format);
    vsnprintf(a->note[a->note_count++], sizeof a->note[0], format, list);
    va_end(list);
}

/* The last of several counts, as shells' aliases want it. */
static void note_twice(args *a, int option, uint64_t *seen)
{
    const int bit = option >= 256 ? option - 256 : 40 + (option & 15);
    const struct option *o = long_options;

    if (option == 'D' || option == 'L' || option == 'q' || option == 'v' || option == OPTION_LIMIT)
        return;
    while (o->name && o->val != option && !(option == 'j' && o->val == 't'))
        o++;
    if ((*seen >> bit & 1) && o->name && o->has_arg)
        note(a, "--%s is given twice: the last one counts", o->name);
    *seen |= (uint64_t)1 << bit;
}

/* Does the name end as another format's does? */
static bool is_named_otherwise(const char *name, const char *format)
{
    static const char *const endings[] = { "png", "ppm", "pfm", "exr", "hdr", "jpg", "jpeg", "tga", "bmp" };
    const char *dot = strrchr(name, '.');

    for (size_t i = 0; dot && i < sizeof endings / sizeof endings[0]; i++)
        if (strcasecmp(dot + 1, endings[i]) == 0)
            return strcasecmp(dot + 1, format) != 0;
    return false;
}

static void note_odd(args *a)
{

    if (a->reference && !a->report)
        note(a, "--reference counts for a --report only");
    if (a->output && a->format && is_named_otherwise(a->output, a->format))
        note(a, "%s holds %s: --format counts, not the name", a->output, a->format);
}

static void append(args *a, const char *text)
{
    const size_t used = strlen(a->command);

    snprintf(a->command + used, sizeof a->command - used, "%s", text);
}

/* One word more of the command, in quotation marks where a shell wants them. */
static void note_word(args *a, const char *word)
{
    const bool plain = word[0] && word[strspn(word, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/%@")] == '\0';

    append(a, a->command[0] ? " " : "");
    append(a, plain ? "" : "'");
    if (plain)
        append(a, word);
    for (; !plain && *word; word++) {
        const char letter[2] = { *word, '\0' };

        append(a, *word == '\'' ? "'\\''" : letter);
    }
    append(a, plain ? "" : "'");
}

args_verdict args_parse(args *a, int argc, char **argv)
{
    uint64_t seen = 0;
    int option;

    memset(a, 0, sizeof *a);
    a->preview = -1;
    note_word(a, "povc");
    for (int i = 1; i < argc; i++)
        note_word(a, argv[i]);
    optind = 0;      /* glibc begins anew at 0 */
    opterr = 0;
    while ((option = getopt_long(argc, argv, ":t:j:o:s:D:L:qvhV", long_options, NULL)) != -1) {
        if (option == 'h' || option == OPTION_HELP)
            return ARGS_HELP;
        if (option == OPTION_VERSION || option == 'V')
            return ARGS_VERSION;
        if (option == '?') {
            refuse_option(a, argv);
            return ARGS_WRONG;
        }
        if (option == ':') {
            args_refuse(a, "\"%s\" wants a value", argv[optind - 1]);
            return ARGS_WRONG;
        }
        if (option != OPTION_AOV)
            note_twice(a, option, &seen);
        if (option == OPTION_AOV ? !read_aov(a, optarg, argc, argv) : !read_option(a, option, optarg))
            return ARGS_WRONG;
    }
    if (!args_check_frames(a) || !args_places(a, argc - optind, argv + optind))
        return ARGS_WRONG;
    note_odd(a);
    return ARGS_RUN;
}

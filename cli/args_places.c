/* Words that belong to no option: SCENE WIDTH HEIGHT OUTPUT, or what --compare, --merge and --check take. */
#include "args_read.h"

#include <stdio.h>
#include <string.h>

static bool read_compared(args *a, int count, char **places)
{
    if (count < 2)
        return args_refuse(a, "--compare wants one or more reports in .csv, and the name of the plot");
    a->compared = places;
    a->compared_count = count;
    return true;
}

static bool read_merged(args *a, int count, char **places)
{
    if (a->parts > 0 || count > 1 || (count == 1 && a->output))
        return args_refuse(a, "--merge wants the name of the picture whose parts are to be joined, and no scene");
    a->output = count == 1 ? places[0] : a->output;
    return (a->output && a->output[0] && strcmp(a->output, "-") != 0) ||
           args_refuse(a, "--merge wants the name of the picture whose parts are to be joined");
}

/* What a part has no place for: the whole picture, or another run, decides it. */
static bool check_part(args *a)
{
    bool maps = false;

    for (int i = 0; i < ARGS_AOVS; i++)
        maps = maps || a->aov[i];
    if (a->time > 0.0 || a->preview > 0)
        return args_refuse(a, "--part goes with neither --time nor --preview: its bits depend on no clock");
    if (a->resume || a->partial_every > 0.0)
        return args_refuse(a, "--part goes with neither --resume nor --partial-every: a part is traced anew");
    if (a->tev)
        return args_refuse(a, "--part does not go with --tev, which shows a whole picture");
    if (a->report || a->reference || maps)
        return args_refuse(a, "--part goes with none of --report, --reference and --aov, which are of a whole picture");
    return strcmp(a->output, "-") != 0 || args_refuse(a, "--part writes a file beside OUTPUT, which must be a file for that");
}

/* The scene's name with the picture's ending, in the working folder. */
static bool name_output(args *a)
{
    const char *slash = strrchr(a->scene, '/'), *name = slash ? slash + 1 : a->scene, *dot = strrchr(name, '.');
    const int stem = dot && dot != name ? (int)(dot - name) : (int)strlen(name);

    if (strcmp(a->scene, "-") == 0)
        return args_refuse(a, "OUTPUT is missing: a scene from standard input has no name");
    if (snprintf(a->named, sizeof a->named, "%.*s.%s", stem, name, a->format ? a->format : "png") >= (int)sizeof a->named)
        return args_refuse(a, "OUTPUT is missing, and the scene's name is too long for one");
    a->output = a->named;
    return true;
}

static bool is_number(const char *text) { return args_digits(text, NULL, ARGS_LARGEST_SIDE) >= 0; }

static bool read_sizes(args *a, char **places)
{
    if (a->width > 0)
        return args_refuse(a, "the size is given twice");
    return args_whole(a, "WIDTH", places[1], 1, ARGS_LARGEST_SIDE, &a->width) &&
           args_whole(a, "HEIGHT", places[2], 1, ARGS_LARGEST_SIDE, &a->height);
}

/* SCENE alone, SCENE OUTPUT, SCENE WIDTH HEIGHT with -o, or all four. */
static bool take_places(args *a, int count, char **places)
{
    const bool has_sizes = count > 2, has_output = count == 4 || (count == 2 && !is_number(places[1]));

    if (count == 0)
        return args_refuse(a, "SCENE is missing: povc wants SCENE WIDTH HEIGHT OUTPUT");
    if (count > 4)
        return args_refuse(a, "\"%s\" is one word too many: povc wants SCENE WIDTH HEIGHT OUTPUT", places[4]);
    if (count > 1 && is_number(places[0]) && is_number(places[1]))
        return args_refuse(a, "\"%s\" stands where SCENE belongs: povc wants SCENE WIDTH HEIGHT OUTPUT", places[0]);
    if (count == 2 && !has_output)
        return args_refuse(a, "HEIGHT is missing: povc wants SCENE WIDTH HEIGHT OUTPUT");
    if (has_sizes && !read_sizes(a, places))
        return false;
    if (count == 3 && !a->output)
        return args_refuse(a, "OUTPUT is missing: povc wants SCENE WIDTH HEIGHT OUTPUT");
    if (has_output && a->output)
        return args_refuse(a, "OUTPUT is given twice");
    a->scene = places[0];
    if (has_output)
        a->output = places[count - 1];
    return true;
}

static bool read_checked(args *a, int count, char **places)
{
    a->scene = places[0];
    a->checked = places;
    a->checked_count = count;
    return true;
}

bool args_places(args *a, int count, char **places)
{
    if (a->compare)
        return read_compared(a, count, places);
    if (a->merge)
        return read_merged(a, count, places);
    if (a->check && !a->explain && count > 0 && (count == 1 || !is_number(places[1])) && !a->output)
        return read_checked(a, count, places);
    if (!take_places(a, count, places))
        return false;
    if (count == 1 && !a->output && (a->check || a->explain))
        return true;
    if (a->width == 0) {
        a->width = 800;
        a->height = 600;
    }
    if (!a->output && !name_output(a))
        return false;
    if (a->output[0] == '\0')
        return args_refuse(a, "OUTPUT is empty; povc wants the name of an image file, or -");
    if (strcmp(a->output, "-") == 0 && (a->resume || a->partial_every > 0.0))
        return args_refuse(a, "--resume and --partial-every keep a checkpoint beside OUTPUT, which must be a file for that");
    if (a->parts > 0 && !check_part(a))
        return false;
    if (a->crop.width > 0 && (a->crop.x + a->crop.width > a->width || a->crop.y + a->crop.height > a->height))
        return args_refuse(a, "--crop reaches out of the picture of %d x %d", a->width, a->height);
    return true;
}

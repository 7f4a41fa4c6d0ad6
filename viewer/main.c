/* povview - an interactive progressive renderer. */
#include "loop.h"
#include "reference.h"
#include "say.h"

#include <povtrace/povtrace.h>

#include <stdio.h>

enum { EXIT_COMPLETE = 0, EXIT_ERROR = 1, EXIT_USAGE = 2, USUAL_WIDTH = 1024, USUAL_HEIGHT = 768 };

static const char *const help[] = {
    "Usage: povview [SCENE [WIDTH HEIGHT]] [options]\n"
    "       povview SCENE [WIDTH HEIGHT] --shot FILE [--frames N] [--keys TEXT]\n"
    "\n"
    "Watch a scene in the POV-Ray language become a picture, walk about in it, and see\n"
    "it change when its file is saved. H shows what the keys and the mouse do.\n"
    "Without SCENE the window lists recent scenes; a file may be dropped on it.\n"
    "\n",
    "Without a display\n"
    "      --shot FILE          draw what the window would show into an image file\n"
    "      --frames N           after N passes, the first one the coarsest (default: all)\n"
    "      --keys TEXT          what the user does before: characters are keys, and in brackets\n"
    "                           <tab> <enter> <home> <f1> <f5> <esc> <up> <down> <pageup> <pagedown>\n"
    "                           <drag X,Y> <pan X,Y> <look X,Y>\n"
    "                           <move X,Y> <wheel N> <fly KEYS SECONDS> <size W,H> <load FILE>\n"
    "\n",
    "Scene and work\n"
    "      --dialect auto|course|povray\n"
    "                           the rules to read by (default: the text decides)\n"
    "      --reference FILE     compare with this picture (B, D, L), whose size the window gets\n"
    "      --max-depth N        depth of reflections and refractions, over the scene's own\n"
    "      --spp N              samples a pixel, on average and at most, where the error is\n"
    "      --error E            until the estimated error is this; without either a window goes\n"
    "                           on to 0.002, and a shot has one sample, through the centre\n"
    "  -t, --threads N          threads (default: one for each core)\n"
    "      --plugin-path DIRS   look for plugins in these folders, colon separated\n"
    "      --bench              measure: first picture, restarts, how long the window is busy\n"
    "  -h, --help               this text\n"
    "      --version\n"
    "\n",
    "Exit status: 0 complete, 1 error in the scene or no display, 2 wrong usage.\n",
};

static void print_help(void)
{
    for (size_t i = 0; i < sizeof help / sizeof help[0]; i++)
        fputs(help[i], stdout);
}

static void print_version(void)
{
    int major, minor, patch;

    pov_version(&major, &minor, &patch);
    printf("povview %d.%d.%d (libpovtrace %d.%d.%d)\n", POVTRACE_VERSION_MAJOR, POVTRACE_VERSION_MINOR,
           POVTRACE_VERSION_PATCH, major, minor, patch);
}

static int window_run(const args *a)
{
    int width = a->width > 0 ? a->width : USUAL_WIDTH, height = a->height > 0 ? a->height : USUAL_HEIGHT;
    pov_error err = { 0 };
    surface *s = surface_glfw_open(width, height, "povview", &err);
    viewer v;

    if (!s || viewer_open(&v, a, s, false, &err) < 0) {
        say("error", &err);
        return EXIT_ERROR;
    }
    v.app.greets = true;
    viewer_run(&v);
    viewer_close(&v);
    return EXIT_COMPLETE;
}

int main(int argc, char **argv)
{
    pov_error err = { 0 };
    args a;

    switch (args_parse(&a, argc, argv)) {
    case ARGS_HELP:
        print_help();
        return EXIT_COMPLETE;
    case ARGS_VERSION:
        print_version();
        return EXIT_COMPLETE;
    case ARGS_WRONG:
        fprintf(stderr, "povview: error: %s\nTry \"povview --help\".\n", a.problem);
        return EXIT_USAGE;
    default:
        if (reference_fill_size(&a, &err) < 0) {
            say("error", &err);
            return EXIT_ERROR;
        }
        return a.shot ? shot_run(&a) : a.bench ? bench_run(&a) : window_run(&a);
    }
}

#include "usage.h"

#include <povtrace/povtrace.h>

#include <stdio.h>

static const char *const help[] = {
    "Usage: povc SCENE WIDTH HEIGHT OUTPUT [options]\n"
    "       povc SCENE [-s WIDTHxHEIGHT] [-o OUTPUT] [options]\n"
    "       povc --check SCENE... | --explain SCENE\n"
    "       povc --merge OUTPUT\n"
    "       povc --compare REPORT.csv... PLOT.svg|PLOT.png\n"
    "\n"
    "  povc scene.pov                               800x600, to scene.png\n"
    "  povc scene.pov 1920 1080 out.png --time 60   the best picture of a minute\n"
    "  povc scene.pov -s 640x480 --error 0.002 --report error.html\n"
    "\n"
    "Render a scene in the POV-Ray language to an image file. OUTPUT's ending says\n"
    "which format: .png, .jpg, .ppm, .tga or .bmp; .pfm and .exr hold linear floats.\n"
    "\"-\" stands for standard input as SCENE and for standard output as OUTPUT.\n"
    "\n",
    "Picture\n"
    "  -s, --size WxH           its size (default 800x600)\n"
    "  -o, --output OUTPUT      its file (default: named after the scene, .png)\n"
    "      --spp N              samples a pixel (default 1, through its centre)\n"
    "      --error E            add samples, most where the error is, until the\n"
    "                           estimated rms error is E\n"
    "      --time S             or until S seconds have passed\n"
    "      --sampling auto|uniform|adaptive\n"
    "                           alike everywhere, or more where the error is\n"
    "                           (default: as --error and --time need)\n"
    "      --seed N             other places for the samples (default 0)\n"
    "      --max-depth N        depth of reflections and refractions, over the\n"
    "                           scene's own\n"
    "      --crop X0,Y0,X1,Y1   only this part: its first pixel, and the one behind\n"
    "                           its last\n"
    "      --bits 8|16          bits a channel in PNG and PPM (default 8)\n"
    "      --alpha              with alpha (png, tga, bmp): what is transparent\n"
    "                           of the background\n"
    "      --transfer scene|srgb|linear\n"
    "                           how values are encoded in PNG and PPM (default:\n"
    "                           as the scene asks)\n"
    "      --format ENDING      image format, whatever OUTPUT is called (default for\n"
    "                           \"-\": png)\n"
    "      --frames A..B        an animation: a picture for each frame from A to B,\n"
    "                           out.png is out01.png, ...; to - one behind the other\n"
    "      --clock C,D          of the first and the last frame (default 0,1)\n"
    "      --aov certainty|normal|depth|object|position|albedo|alpha|time FILE\n"
    "                           besides the picture a map of what the pixels' centres\n"
    "                           meet, or of the time that the pixels took\n"
    "\n",
    "Scene\n"
    "      --dialect auto|course|povray\n"
    "                           the rules to read by (default: the text decides)\n"
    "      --check              read the scenes, say what is wrong, render nothing\n"
    "      --explain            print what was compiled for this scene and what was\n"
    "                           left out\n"
    "  -D, --declare NAME=VALUE a number, or a string in quotation marks, that\n"
    "                           the scene finds declared\n"
    "  -L, --library-path DIR   look for included files there too\n"
    "      --strict             what is read and not drawn yet is an error\n"
    "      --soft-lights        area lights are lit all over, and not at the\n"
    "                           points of their grids only\n"
    "      --allow-write DIR    the scene may write files below this folder\n"
    "      --limit NAME=N       how far reading may go: depth, array, string,\n"
    "                           turns, memory, seconds, input, images; and rays\n"
    "                           that follow from one of the camera\n"
    "      --plugin-path DIRS   look for plugins in these folders first, colon\n"
    "                           separated\n"
    "\n"
    "Work\n"
    "  -t, -j, --threads N      threads (default: one for each core)\n"
    "      --accel tree|none    a bounding volume tree, or ask every object of\n"
    "                           every ray\n"
    "      --accuracy certified|max\n"
    "                           double where it is certain, or two doubles throughout\n"
    "      --partial-every S    write the picture so far, and a checkpoint\n"
    "                           beside it, each S seconds\n"
    "      --resume             go on from that checkpoint, and keep one; frames\n"
    "                           that are there stay\n"
    "      --part I/N           trace the I-th of N parts of the picture, into\n"
    "                           OUTPUT.part-I-of-N\n"
    "      --tev HOST:PORT      show the growing picture in tev (localhost:14158)\n"
    "      --merge              join the parts of OUTPUT\n"
    "      --preview N          a first coarse pass, a pixel in N: 2, 4, 8 or 16\n"
    "                           (default 0: none, with --time 16)\n"
    "\n",
    "Messages\n"
    "      --report FILE        error against run time: .csv, .json, .html,\n"
    "                           .svg or .png\n"
    "      --reference IMAGE    a PFM, PNG or PPM to hold every pass of the\n"
    "                           report against\n"
    "      --stats              print times, rays, memory: one \"name: value\n"
    "                           unit\" a line\n"
    "      --progress auto|bar|json|none\n"
    "                           on standard error (default: a bar on a terminal,\n"
    "                           else a line each 10 s)\n"
    "  -q, --quiet              errors only\n"
    "  -v, --verbose            notes of the library too\n"
    "      --color auto|always|never\n"
    "      --messages text|json\n"
    "                           JSON: one object a line, with kind, file, line,\n"
    "                           column, message and hint\n"
    "  -h, --help               this text\n"
    "      --version\n"
    "\n",
    "Exit status: 0 complete, 1 error in the scene or while rendering, 2 wrong\n"
    "usage, 3 a limit ended it before what was asked for was reached, 4 the parts\n"
    "are to go on; a signal that ends povc saves the part that is there and shows\n"
    "as 128 + its number. SIGUSR1 writes the picture so far.\n",
};

void usage_print_help(void)
{
    for (size_t i = 0; i < sizeof help / sizeof help[0]; i++)
        fputs(help[i], stdout);
}

void usage_print_version(void)
{
    int major, minor, patch;

    pov_version(&major, &minor, &patch);
    printf("povc %d.%d.%d (libpovtrace %d.%d.%d, %s)\n", POVTRACE_VERSION_MAJOR, POVTRACE_VERSION_MINOR,
           POVTRACE_VERSION_PATCH, major, minor, patch, pov_built_for());
}

/* --limit NAME=N. */
#include "args_read.h"

#include <stdlib.h>
#include <string.h>

/* In the order of the names; depth .. memory, input and images are sizes. */
static void set(args *a, size_t index, double value)
{
    pov_limits *limits = &a->limits;
    size_t *const sizes[] = { &limits->depth, &limits->array, &limits->string, &limits->memory, &a->most_input, &a->most_images };

    if (index < sizeof sizes / sizeof sizes[0])
        *sizes[index] = value < 1.0 ? 1 : (size_t)value;
    else if (index == 6)
        limits->turns = (uint64_t)value;
    else if (index == 7)
        limits->seconds = value;
    else
        a->most_rays = value < 1.0 ? 1 : (uint64_t)value;
}

bool args_limit(args *a, const char *text)
{
    static const char *const names[] = { "depth", "array", "string", "memory", "input", "images", "turns", "seconds", "rays" };
    const char *equals = strchr(text, '=');
    char *end = NULL;
    const double value = equals ? strtod(equals + 1, &end) : 0.0;

    for (size_t i = 0; equals && i < sizeof names / sizeof names[0]; i++) {
        if (strncmp(text, names[i], (size_t)(equals - text)) != 0 || names[i][equals - text] != '\0')
            continue;
        if (end == equals + 1 || *end != '\0' || !(value > 0.0 && value <= 1e15))
            break;
        set(a, i, value);
        return true;
    }
    return args_refuse(a, "--limit wants depth, array, string, memory, input, images, turns, seconds or rays, and =N, not \"%s\"",
                       text);
}

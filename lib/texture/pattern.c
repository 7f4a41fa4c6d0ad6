#include "texture/pattern.h"

#include <string.h>

extern const pattern_class pattern_checker, pattern_square;

static const pattern_class *const classes[] = {
    &pattern_checker,
    &pattern_square,
};

const pattern_class *pattern_find(const char *keyword)
{
    for (size_t i = 0; i < sizeof classes / sizeof classes[0]; i++)
        if (strcmp(classes[i]->keyword, keyword) == 0)
            return classes[i];
    return NULL;
}

/* squares.h - a texture of four squares, for tests. */
#ifndef SUPPORT_SQUARES_H
#define SUPPORT_SQUARES_H

#include "texture/pattern.h"
#include "model/material.h"

#include <string.h>

typedef struct squares { texture texture; pigment_node pigment; pattern pattern; } squares;

/* The material gets the texture, which lives in the memory given. */
static inline void squares_set(squares *s, const pigment *list, material *m)
{
    memset(s, 0, sizeof *s);
    s->pattern.class = pattern_find("square");
    s->pattern.turbulence = turbulence_default();
    s->pattern.wave = (wave){ WAVE_RAMP, 0.0f, 0.0f, 1.0f };
    s->pigment.blend = BLEND_LIST;
    s->pigment.count = 4;
    s->pigment.pattern = &s->pattern;
    s->pigment.colours = list;
    s->pigment.most = list[0];
    for (int i = 1; i < 4; i++)
        s->pigment.most = pigment_most(s->pigment.most, list[i]);
    s->texture.pigment = &s->pigment;
    s->texture.finish = m->finish;
    material_set_textures(m, &s->texture, NULL);
}

#endif

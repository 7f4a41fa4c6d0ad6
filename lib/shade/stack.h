/* stack.h - layers of a texture, and stacks of them that are alike everywhere: what each of their layers gives is known
 * before the first ray. */
#ifndef SHADE_STACK_H
#define SHADE_STACK_H

#include "shade/appearance.h"

typedef struct layer {
    uint8_t of;                  /* the surface of the batch */
    bool first, last;            /* of its stack */
    bool is_dark;                /* nothing is left for what lies below */
    bool is_weighed;             /* the factors below are known, whatever the ray */
    float share;                 /* of the stack */
    colour by;                   /* factor of its emitted and reflected light */
    coefficient reflection, through;   /* of its reflected ray, and the last one's transmitted ray */
} layer;

typedef struct stack_layer { appearance appearance; layer of; } stack_layer;

/* Layers of stacks that are lit at one hit. */
enum { STACK_LEVELS = 4 };

/* From the top. */
typedef struct stack {
    uint32_t count;
    bool weighed;                /* nothing that rays see of it depends on their angle */
    bool flat;                   /* ... its layers are lit side by side, and it sends rays as a surface of one layer does */
    stack_layer *layers;
} stack;

/* The appearance of a surface's layer, from the top; NULL: there is none. */
static inline const appearance *stack_level(const appearance *a, uint32_t level)
{
    if (!a->stack)
        return level == 0 ? a : NULL;
    return level < a->stack->count ? &a->stack->layers[level].appearance : NULL;
}

/* Weigh the next layer of its stack, from which this goes on. What it lets through, of what is left by those above it, is left for those below it,
 * and at the end for the transmitted ray. False: nothing is left for it, and it is to be hidden. */
bool layer_weigh(layer *out, float share, const model *m, const appearance *a, const onward *on, colour *left);
/* A layer that nothing is left for is as if it were not there. */
void layer_hide(layer *out, appearance *own);

/* Is the texture of this material a stack of constant layers, of surfaces on both sides? */
bool stack_is_there(const material *of);
/* Of such a material. NULL: no memory. */
stack *stack_create(const plan *p, const model *m, const material *of);
/* Weigh it, if nothing that rays see of it depends on their angle. */
void stack_weigh(stack *of, const plan *p, const model *m);
/* Make it flat, where that can be: then a surface of this appearance sends its rays. */
void stack_make_flat(stack *of, appearance *whole);

#endif

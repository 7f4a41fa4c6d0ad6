#include "common/steps.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

typedef struct sample { double t, value; } sample;

/* Values that lines wait for. */
typedef enum question { AT_START, AT_END, BETWEEN, AT_ROOT } question;

/* Right ends of the stretches that are left stand on a stack. From its half on stretches are halved, and so it ends. */
enum { DEPTH = 128 };

typedef struct walk {
    const common_steps_line *of;
    question now;
    double asked;                /* the place in question */
    /* The root between two samples: Chandrupatla's method. */
    sample a, b;
    double place;                /* the guess, from 0 at a to 1 at b */
    uint32_t turns;
    uint32_t depth;
    sample from, to[DEPTH];      /* the left end; right ends, the nearest last */
} walk;

enum { LANES = POV_VALUES, TURNS = 200 };

typedef struct search {
    const common_steps *s;
    uint32_t count;
    walk at[LANES];
} search;

static void ask(walk *w, question now, double t)
{
    w->now = now;
    w->asked = t;
}

/* ---- a root ---- */

/* Where an inverse parabola through three samples is zero, from a to b; the middle where it would not be between them. */
static double guess_between(sample a, sample b, sample c)
{
    const double along = (a.t - b.t) / (c.t - b.t), up = (a.value - b.value) / (c.value - b.value);

    if (!(up * up < along && (1.0 - up) * (1.0 - up) < 1.0 - along))
        return 0.5;
    return a.value / (b.value - a.value) * (c.value / (b.value - c.value)) +
           (c.t - a.t) / (b.t - a.t) * (a.value / (c.value - a.value)) * (b.value / (c.value - b.value));
}

/* The least step, as a share of what is between a and b. */
static double least_of(const common_steps *s, const walk *w)
{
    const double fine = 0x1p-51 * (fabs(w->a.t) + s->size / w->of->speed);

    return fine / fabs(w->b.t - w->a.t);
}

static void ask_root(const common_steps *s, walk *w)
{
    const double least = least_of(s, w), held = w->place > least ? w->place < 1.0 - least ? w->place : 1.0 - least : least;

    ask(w, AT_ROOT, w->a.t + held * (w->b.t - w->a.t));
}

/* Takes what was asked: true if that is the root, as far as doubles tell, or as there have been enough. */
static bool take_root(const common_steps *s, walk *w, sample next)
{
    const bool is_last = !(least_of(s, w) < 0.5) || next.value == 0.0;
    sample c = w->a;

    if (is_last)
        return true;
    if ((next.value < 0.0) != (w->a.value < 0.0)) {
        c = w->b;
        w->b = w->a;
    }
    w->a = next;
    w->place = guess_between(w->a, w->b, c);
    return ++w->turns == TURNS;
}

/* ---- stretches ---- */

static void pass(walk *w) { w->from = w->to[--w->depth]; }

/* Up to the next value that is needed. False: the line is done. */
static bool go_on(const common_steps *s, walk *w)
{
    const double speed = w->of->speed, rate = s->gradient * speed;

    while (w->depth > 0) {
        const sample a = w->from, b = w->to[w->depth - 1];
        const bool differ = (a.value < 0.0) != (b.value < 0.0), is_short = !((b.t - a.t) * speed > s->accuracy) || w->depth == DEPTH;
        const double near = a.t + fabs(a.value) / rate, far = b.t - fabs(b.value) / rate;

        if (!differ && (is_short || !(near < far))) {
            pass(w);
        } else if (is_short) {
            w->a = a;
            w->b = b;
            w->place = a.value / (a.value - b.value);
            w->turns = 0;
            ask_root(s, w);
            return true;
        } else {
            ask(w, BETWEEN, near < far && w->depth <= DEPTH / 2 ? 0.5 * (near + far) : 0.5 * (a.t + b.t));
            return true;
        }
    }
    if (w->from.value < 0.0)
        s->found(w->of->user, COMMON_STEPS_BELOW_END, w->from.t);
    return false;
}

static bool begin_stretch(const common_steps *s, walk *w, sample end)
{
    w->to[w->depth++] = end;
    if (w->from.value < 0.0 && !s->found(w->of->user, COMMON_STEPS_BELOW_START, 0.0))
        return false;
    return go_on(s, w);
}

/* The answer, and the next question. False: the line is done. */
static bool take(const common_steps *s, walk *w, double value)
{
    const sample at = { w->asked, value };

    switch (w->now) {
    case AT_START:
        w->from = at;
        ask(w, AT_END, w->of->end);
        return true;
    case AT_END: return begin_stretch(s, w, at);
    case BETWEEN:
        w->to[w->depth++] = at;
        return go_on(s, w);
    default: break;
    }
    if (!take_root(s, w, at)) {
        ask_root(s, w);
        return true;
    }
    if (!s->found(w->of->user, COMMON_STEPS_ROOT, at.t))
        return false;
    pass(w);
    return go_on(s, w);
}

static void begin(walk *w, const common_steps_line *of)
{
    w->of = of;
    w->depth = 0;
    w->from.t = 0.0;
    w->from.value = of->start;
    ask(w, of->start_is_known ? AT_END : AT_START, of->start_is_known ? of->end : 0.0);
}

/* ---- all lines ---- */

static void find_values(const search *x, double *memory, double value[LANES])
{
    const pov_function *f = x->s->function;
    double at[3 * LANES];

    for (uint32_t l = 0; l < x->count; l++) {
        const walk *w = &x->at[l];
        const pov_vec3 p = pov_add(w->of->o, pov_scale(w->of->d, w->asked));

        at[l] = p.x;
        at[LANES + l] = p.y;
        at[2 * LANES + l] = p.z;
    }
    if (x->count > 1) {
        f->values(f, at, x->count, memory, value);
    } else {
        const double one[3] = { at[0], at[LANES], at[2 * LANES] };

        value[0] = f->value(f, one, memory);
    }
    for (uint32_t l = 0; l < x->count; l++)
        value[l] -= x->s->threshold;
}

/* As one line is done the next takes its lane. */
void common_steps_search(const common_steps *s, const common_steps_line *lines, uint32_t n, double *memory)
{
    uint32_t next = 0;
    search x;

    x.s = s;
    x.count = 0;
    for (;;) {
        double value[LANES];

        while (x.count < LANES && next < n)
            begin(&x.at[x.count++], &lines[next++]);
        if (x.count == 0)
            return;
        find_values(&x, memory, value);
        for (uint32_t l = x.count; l-- > 0;)
            if (!take(s, &x.at[l], value[l]) && l < --x.count)
                memcpy(&x.at[l], &x.at[x.count], offsetof(walk, to) + x.at[x.count].depth * sizeof(sample));
    }
}

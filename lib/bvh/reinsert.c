#include "bvh/corner.h"

/* Twigs are taken out, one after the other, and put where they add least to the surfaces of those above them (Bittner,
 * Hapala, Havran 2013: Fast insertion-based optimization of bounding volume hierarchies). Cuts that part by centres
 * leave what is large among what is small, deep in the tree. */

/* More rounds find little. Some 20 twigs are looked at for a place, and no more than LOOKS where boxes lie in boxes. As
 * many wait as there are levels, unless the tree is a chain. */
enum { ROUNDS = 2, LOOKS = 200, WAITING_MOST = 64 };

static inline box box_of(const bvh_twig *t)
{
    const char *at = (const char *)&t->range;
    const box b = { corner_at(at + offsetof(bvh_range, lo)), corner_at(at + offsetof(bvh_range, hi)) };

    return b;
}

/* A place beside a twig, and how much less the surfaces are with it there. */
typedef struct seat { uint32_t beside; float gain; } seat;

typedef struct search {
    box own;                     /* of what is to be put elsewhere */
    float area;
    int looks;                   /* that are left */
    seat best;
} search;

/* In all below a twig, and beside it. gain: of what becomes of all above it. */
static void look_below(search *s, const bvh_twig *twigs, uint32_t top, float gain)
{
    seat waiting[WAITING_MOST];
    int n = 1;

    waiting[0].beside = top;
    waiting[0].gain = gain;
    while (n > 0 && s->looks > 0) {
        seat at = waiting[--n];
        const bvh_twig *t = &twigs[at.beside];
        box both;

        if (at.gain - s->area <= s->best.gain)
            continue;
        s->looks--;
        both = box_of(t);
        both = add(both, s->own.lo, s->own.hi);
        at.gain -= area_of(&both);
        if (at.gain > s->best.gain)
            s->best = at;
        at.gain += t->range.area;
        if (!t->is_end && at.gain - s->area > s->best.gain && n + 2 <= WAITING_MOST) {
            const seat a = { t->half[0], at.gain }, b = { t->half[1], at.gain };
            waiting[n++] = a;
            waiting[n++] = b;
        }
    }
}

static uint32_t other_half(const bvh_twig *twigs, uint32_t which)
{
    const uint32_t *half = twigs[twigs[which].above].half;

    return half[half[0] == which];
}

/* The best of all places but its own, or beside the root: none. Whatever held it becomes as small as what is left. */
static seat find_seat(const bvh_twig *twigs, uint32_t which)
{
    const bvh_twig *t = &twigs[which], *left = &twigs[other_half(twigs, which)];
    search s = { box_of(t), t->range.area, LOOKS, { 0, 0.0f } };
    float gain = twigs[t->above].range.area;
    box rest = box_of(left);
    uint32_t i;

    for (i = 0; !left->is_end && i < 2; i++)
        look_below(&s, twigs, left->half[i], left->range.area);
    for (i = t->above; i != 0 && s.looks > 0; i = twigs[i].above, s.looks--) {
        const uint32_t other = other_half(twigs, i);
        const box more = box_of(&twigs[other]);

        look_below(&s, twigs, other, gain);
        rest = add(rest, more.lo, more.hi);
        gain += twigs[twigs[i].above].range.area - area_of(&rest);
    }
    return s.best;
}

/* Find a twig's box anew. False: it is as it was. */
static bool measure(bvh_twig *twigs, uint32_t which)
{
    bvh_range *r = &twigs[which].range;
    const box old = box_of(&twigs[which]), more = box_of(&twigs[twigs[which].half[1]]);
    box both = box_of(&twigs[twigs[which].half[0]]);
    bool changed = false;
    int k;

    both = add(both, more.lo, more.hi);
    for (k = 0; k < 3; k++) {
        r->lo[k] = LANE(both.lo, k);
        r->hi[k] = LANE(both.hi, k);
        changed = changed || r->lo[k] != LANE(old.lo, k) || r->hi[k] != LANE(old.hi, k);
    }
    r->area = area_of(&both);
    return changed;
}

static void measure_above(bvh_twig *twigs, uint32_t which)
{
    while (which != 0) {
        which = twigs[which].above;
        if (!measure(twigs, which))
            return;
    }
}

static void replace(bvh_twig *twigs, uint32_t old, uint32_t new)
{
    const uint32_t above = twigs[old].above;

    twigs[above].half[twigs[above].half[1] == old] = new;
    twigs[new].above = above;
}

/* What held it goes with it. */
static void reseat(bvh_twig *twigs, uint32_t which, uint32_t beside)
{
    const uint32_t holder = twigs[which].above, left = other_half(twigs, which);

    replace(twigs, holder, left);
    measure_above(twigs, left);
    replace(twigs, beside, holder);
    twigs[holder].half[0] = beside;
    twigs[holder].half[1] = which;
    twigs[beside].above = twigs[which].above = holder;
    measure(twigs, holder);
    measure_above(twigs, holder);
}

void bvh_improve_twigs(bvh_twig *twigs, uint32_t count)
{
    uint32_t i;
    int round;

    for (round = 0; round < ROUNDS; round++)
        for (i = 1; i < count; i++) {
            const seat none = { 0, 0.0f }, s = twigs[i].above == 0 ? none : find_seat(twigs, i);

            if (s.beside != 0)
                reseat(twigs, i, s.beside);
        }
}

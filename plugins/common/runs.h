/* runs.h - many parts of a shape, by boxes around runs of them and around runs of runs. They are arranged so that neighbours in the
 * list are neighbours in space. */
#ifndef COMMON_RUNS_H
#define COMMON_RUNS_H

#include "common/local.h"

#include <math.h>

enum { COMMON_RUN = 16, COMMON_RUNS = 8 * COMMON_RUN };

/* In coordinates of the order of one. No boxes: all parts count. */
typedef struct common_runs { uint32_t count; pov_box *box, *around; } common_runs;

/* A part's place, and its number in the text. */
typedef struct common_part { double at[3]; uint32_t number; } common_part;

/* Arranges parts in space. */
void common_runs_arrange(common_part *parts, uint32_t n);

static inline void common_run_extend(pov_box *box, bool first, pov_vec3 lo, pov_vec3 hi)
{
    box->lo = first ? lo : pov_vec3_of(pov_min(box->lo.x, lo.x), pov_min(box->lo.y, lo.y), pov_min(box->lo.z, lo.z));
    box->hi = first ? hi : pov_vec3_of(pov_max(box->hi.x, hi.x), pov_max(box->hi.y, hi.y), pov_max(box->hi.z, hi.z));
}

/* The box of part i; far more than roundings around it. */
static inline void common_runs_add(common_runs *r, uint32_t i, pov_vec3 lo, pov_vec3 hi)
{
    const double by = 0x1p-20;

    lo = pov_vec3_of(lo.x - by, lo.y - by, lo.z - by);
    hi = pov_vec3_of(hi.x + by, hi.y + by, hi.z + by);
    common_run_extend(&r->box[i / COMMON_RUN], i % COMMON_RUN == 0, lo, hi);
    common_run_extend(&r->around[i / COMMON_RUNS], i % COMMON_RUNS == 0, lo, hi);
}

static inline bool common_run_near(const pov_box *box, pov_vec3 p)
{
    return p.x >= box->lo.x && p.x <= box->hi.x && p.y >= box->lo.y && p.y <= box->hi.y && p.z >= box->lo.z && p.z <= box->hi.z;
}

/* Where 0 times infinity is no number, the line runs in a face of the box, far from the parts. */
static inline bool common_run_axis(double lo, double hi, double o, double inverse, double *from, double *to)
{
    const double a = (lo - o) * inverse, b = (hi - o) * inverse, first = a < b ? a : b, last = a < b ? b : a;

    *from = first > *from ? first : *from;
    *to = last < *to ? last : *to;
    return !(*from > *to);
}

/* A line from o, with 1 / its direction, between two distances. */
static inline bool common_run_hit(const pov_box *box, pov_vec3 o, pov_vec3 inverse, double from, double to)
{
    return common_run_axis(box->lo.x, box->hi.x, o.x, inverse.x, &from, &to) &&
           common_run_axis(box->lo.y, box->hi.y, o.y, inverse.y, &from, &to) &&
           common_run_axis(box->lo.z, box->hi.z, o.z, inverse.z, &from, &to);
}

/* The first part from i on whose run may have the point. */
static inline uint32_t common_runs_near(const common_runs *r, uint32_t i, pov_vec3 p)
{
    while (r->box && i < r->count && i % COMMON_RUN == 0)
        if (i % COMMON_RUNS == 0 && !common_run_near(&r->around[i / COMMON_RUNS], p))
            i += COMMON_RUNS;
        else if (!common_run_near(&r->box[i / COMMON_RUN], p))
            i += COMMON_RUN;
        else
            break;
    return i;
}

/* Whose run may have a place of the line. */
static inline uint32_t common_runs_hit(const common_runs *r, uint32_t i, pov_vec3 o, pov_vec3 inverse, double from, double to)
{
    while (r->box && i < r->count && i % COMMON_RUN == 0)
        if (i % COMMON_RUNS == 0 && !common_run_hit(&r->around[i / COMMON_RUNS], o, inverse, from, to))
            i += COMMON_RUNS;
        else if (!common_run_hit(&r->box[i / COMMON_RUN], o, inverse, from, to))
            i += COMMON_RUN;
        else
            break;
    return i;
}

#endif

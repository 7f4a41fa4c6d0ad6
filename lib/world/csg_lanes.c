/* Several rays and one tree: which of them certainly pass it, and which crossing is certainly the first of each other. As
 * csg_outline.c finds it for one ray, of trees that have chords. What is open is left to csg_intersect(). */
#include "base/simd.h"
#include "world/csg_outline.h"

#include <string.h>

enum { TOGETHER = 8 };
typedef double lane[TOGETHER];

/* Rays in the tree's units, as near_ray; where they start, and the columns that they start on. */
typedef struct SIMD_ALIGNED near_rays { lane at[3], along[3], start, per_unit, most, from, far; } near_rays;

/* By column where each ray is inside it; numbers other than 0 where that is open, and where it certainly passes the tree. */
typedef struct SIMD_ALIGNED intervals { lane in[CSG_FEW], out[CSG_FEW], open, passed; } intervals;

/* The first crossing: its place, whose it is, and 1 if that is entered. */
typedef struct SIMD_ALIGNED firsts { lane at, leave, column, enters, moved, unclear; } firsts;

static const double margin = CSG_OUTLINE_MARGIN;

SIMD_INLINE int is_near(double a, double b) { return fabs(a - b) <= margin; }

/* ---- rays ---- */

static double column_of(const csg_tree *t, uint32_t name)
{
    const uint32_t member = name - t->members[0].leaf;

    for (uint32_t i = 0; member < t->member_count && i < t->few.count; i++)
        if (t->chords.member[i] == member)
            return i;
    return CSG_COLUMNS;
}

SIMD_INLINE void come_near(const csg_outline *of, const pov_rays *restrict rays, uint32_t first, uint32_t n, near_rays *restrict out)
{
    const pov_vec3 centre = of->centre;
    const double size = of->size, per_size = of->per_size;

    for (uint32_t i = 0; i < n; i++) {
        const uint32_t k = first + i;
        const double x = (rays->org[0][k] - centre.x) * per_size, y = (rays->org[1][k] - centre.y) * per_size,
            z = (rays->org[2][k] - centre.z) * per_size, per_length = rays->per_length[k];
        const double dx = rays->dir[0][k] * per_length, dy = rays->dir[1][k] * per_length, dz = rays->dir[2][k] * per_length;
        const double start = x * dx + y * dy + z * dz;

        out->at[0][i] = x - dx * start;
        out->at[1][i] = y - dy * start;
        out->at[2][i] = z - dz * start;
        out->along[0][i] = dx;
        out->along[1][i] = dy;
        out->along[2][i] = dz;
        out->start[i] = start;
        out->per_unit[i] = per_length * size;
        out->most[i] = rays->tmax[k];
        out->far[i] = (int)(fabs(x) < CSG_FARTHEST) & (int)(fabs(y) < CSG_FARTHEST) & (int)(fabs(z) < CSG_FARTHEST) ? 0.0 : 1.0;
    }
}

/* Behind so many lanes they come again: a small packet has no more. */
static void repeat(near_rays *all, uint32_t n)
{
    unsigned char *const first = (unsigned char *)all;

    for (size_t i = 0; i < sizeof *all; i += sizeof(lane))
        memcpy(first + i + n * sizeof(double), first + i, n * sizeof(double));
}

/* ---- columns ---- */

SIMD_INLINE pov_vec3 lane_at(const lane *from, uint32_t i) { return pov_vec3_of(from[0][i], from[1][i], from[2][i]); }

/* What a slab or quadric and the column have in common. */
SIMD_INLINE void narrow(csg_stretch s, uint32_t column, uint32_t i, intervals *restrict io)
{
    io->in[column][i] = s.in > io->in[column][i] ? s.in : io->in[column][i];
    io->out[column][i] = s.out < io->out[column][i] ? s.out : io->out[column][i];
    io->open[i] = s.open > io->open[i] ? s.open : io->open[i];
}

SIMD_INLINE void cross_column(const csg_outline *of, uint32_t column, const near_rays *restrict k, intervals *restrict io)
{
    const double *quadrics = of->numbers + CSG_SLAB_NUMBERS * of->slabs;

    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
        io->in[column][i] = -HUGE_VAL;
        io->out[column][i] = HUGE_VAL;
    }
    for (uint32_t slab = of->first_slab[column]; slab < of->first_slab[column + 1]; slab++) {
        const double *number = of->numbers + csg_number(CSG_SLAB_NUMBERS, slab);

        SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++)
            narrow(csg_cross_slab(number, lane_at(k->at, i), lane_at(k->along, i), CSG_LEAST_HEIGHT), column, i, io);
    }
    if (!(of->round >> column & 1))
        return;
    quadrics += csg_number(CSG_QUADRIC_NUMBERS, of->quadric[column]);
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
        csg_stretch s = csg_cross_quadric(quadrics, lane_at(k->at, i), lane_at(k->along, i), 1.0);

        s.open = s.square < 0.0 ? 1.0 : s.open;
        narrow(s, column, i, io);
    }
}

/* What the columns of `within` have in common: rays that are never within all ahead and before their end pass the tree. */
SIMD_INLINE void find_common(uint32_t within, const near_rays *restrict k, intervals *restrict io, firsts *restrict out)
{
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
        out->at[i] = -HUGE_VAL;
        out->leave[i] = HUGE_VAL;
    }
    for (; within; within &= within - 1) {
        const uint32_t c = first_of(within);

        SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
            out->at[i] = io->in[c][i] > out->at[i] ? io->in[c][i] : out->at[i];
            out->leave[i] = io->out[c][i] < out->leave[i] ? io->out[c][i] : out->leave[i];
        }
    }
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
        const double enter = out->at[i], leave = out->leave[i], start = k->start[i];
        const int never = (int)(enter > leave + margin) | (int)(leave < start - margin) |
                          (int)((enter - start - margin) * k->per_unit[i] > k->most[i]);

        io->passed[i] = never & (int)(io->open[i] == 0.0) ? 1.0 : io->passed[i];
    }
}

/* As begin() in csg_outline.c. */
SIMD_INLINE void begin(uint32_t columns, const near_rays *restrict k, intervals *restrict io)
{
    for (uint32_t c = 0; c < columns; c++)
        SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
            const double in = io->in[c][i], out = io->out[c][i], start = k->start[i];
            const int enters = is_near(in, start), leaves = is_near(out, start), own = k->from[i] == (double)c;
            const int odd = own ? (int)(enters == leaves) | (int)(in > out) : (int)(in < out) & (enters | leaves);
            const int none = (int)(in > out) | leaves | (int)(out < start), within = enters | (int)(in < start);

            io->open[i] = odd | is_near(in, out) ? 1.0 : io->open[i];
            io->in[c][i] = none ? HUGE_VAL : within ? -HUGE_VAL : in;
            io->out[c][i] = none ? -HUGE_VAL : out;
        }
}

/* ---- the first crossing ---- */

/* Beyond the hollow, of rays that are in it; unclear: it may begin or end where they are. */
SIMD_INLINE void leave_hollow(uint32_t c, const intervals *restrict of, firsts *restrict io)
{
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
        const double in = of->in[c][i], out = of->out[c][i], at = io->at[i];
        const int beside = (int)(in >= at + margin) | (int)(out <= at - margin) | (int)(in > out);
        const int near = is_near(in, at) | is_near(out, at), moves = (int)(!beside) & (int)(!near);

        io->unclear[i] = (int)(!beside) & near & (int)(out != at) ? 1.0 : io->unclear[i];
        io->moved[i] = moves ? 1.0 : io->moved[i];
        io->at[i] = moves ? out : at;
    }
}

SIMD_INLINE double any_of(const double *restrict a)
{
    double any = 0.0;

    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++)
        any += a[i];
    return any;
}

/* One after the other, until none moves any ray: each does so at most once. */
SIMD_INLINE void leave_hollows(uint32_t hollows, const intervals *restrict of, firsts *restrict io)
{
    for (uint32_t pass = 0; pass <= CSG_FEW; pass++) {
        SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++)
            io->moved[i] = io->unclear[i] = 0.0;
        for (uint32_t rest = hollows; rest; rest &= rest - 1)
            leave_hollow(first_of(rest), of, io);
        if (!(any_of(io->moved) > 0.0))
            break;
    }
}

/* Rays that start inside the solid leave it where all columns of `within` end, or a hollow begins. */
SIMD_INLINE void find_exits(uint32_t hollows, const intervals *restrict of, const near_rays *restrict k, firsts *restrict io)
{
    for (; hollows; hollows &= hollows - 1) {
        const uint32_t c = first_of(hollows);

        SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++)
            io->leave[i] = of->in[c][i] > -HUGE_VAL && of->in[c][i] < io->leave[i] ? of->in[c][i] : io->leave[i];
    }
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++)
        io->at[i] = io->at[i] == k->start[i] ? io->leave[i] : io->at[i];
}

/* Whose crossing it is; that of several that are near each other is open. */
SIMD_INLINE void find_ends(uint32_t columns, intervals *restrict of, firsts *restrict io)
{
    lane times = { 0.0 };

    for (uint32_t c = 0; c < columns; c++)
        SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
            const double in = of->in[c][i], out = of->out[c][i], at = io->at[i];

            io->column[i] = (int)(in == at) | (int)(out == at) ? (double)c : io->column[i];
            io->enters[i] = in == at ? 1.0 : io->enters[i];
            times[i] += (is_near(in, at) ? 1.0 : 0.0) + (is_near(out, at) ? 1.0 : 0.0);
        }
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++)
        of->open[i] = times[i] == 1.0 ? of->open[i] : 1.0;
}

SIMD_INLINE void find_firsts(const csg_tree *t, const near_rays *restrict k, intervals *restrict io, firsts *restrict out)
{
    const uint32_t hollows = t->chords.all & ~t->chords.within;

    begin(t->few.count, k, io);
    find_common(t->chords.within, k, io, out);
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
        io->open[i] = out->at[i] > out->leave[i] - margin ? 1.0 : io->open[i];
        out->at[i] = out->at[i] > -HUGE_VAL ? out->at[i] : k->start[i];
        out->column[i] = out->enters[i] = 0.0;
    }
    leave_hollows(hollows, io, out);
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
        const int open = (int)(io->open[i] > 0.0) | (int)(out->moved[i] > 0.0) | (int)(out->unclear[i] > 0.0);

        io->passed[i] = !open & (int)(out->at[i] > out->leave[i] + margin) ? 1.0 : io->passed[i];
        io->open[i] = open | (int)(out->at[i] > out->leave[i] - margin) ? 1.0 : io->open[i];
    }
    find_exits(hollows, io, k, out);
    find_ends(t->few.count, io, out);
}

SIMD_CLONES static void find(const csg_tree *t, const pov_rays *restrict rays, uint32_t first, uint32_t n, near_rays *restrict k,
                             intervals *restrict io, firsts *restrict out)
{
    come_near(t->outline, rays, first, n, k);
    if (n < TOGETHER)
        repeat(k, n);
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
        io->open[i] = k->far[i];
        io->passed[i] = 0.0;
    }
    for (uint32_t left = t->chords.within; left; left &= left - 1)
        cross_column(t->outline, first_of(left), k, io);
    find_common(t->chords.within, k, io, out);
    if (any_of(io->passed) == TOGETHER)
        return;
    for (uint32_t left = t->chords.all & ~t->chords.within; left; left &= left - 1)
        cross_column(t->outline, first_of(left), k, io);
    find_firsts(t, k, io, out);
}

/* ---- candidates ---- */

/* Bits of notes: they say which crossing it is. */
enum { ENTERS = 0x100, INWARD = 0x200 };

static pov_candidate candidate_of(const csg_tree *t, const near_rays *k, const intervals *io, const firsts *f, uint32_t i)
{
    const double per_unit = k->per_unit[i], at = f->at[i] - k->start[i];
    const uint32_t column = (uint32_t)f->column[i];
    const bool enters = f->enters[i] > 0.0;
    pov_candidate m = { .lo = 0.0 };

    if (io->open[i] > 0.0)
        return m;
    m.lo = (at - margin) * per_unit;
    m.hi = (at + margin) * per_unit;
    m.definite = m.hi * (1.0 + 0x1p-40) < k->most[i];
    m.note = column | (enters ? ENTERS : 0) | (enters == (t->chords.within >> column & 1) ? INWARD : 0);
    return m;
}

/* The rays of `some`, eight from `first` on. */
static uint32_t filter_some(const csg_tree *t, const pov_rays *rays, uint32_t first, uint32_t some, uint32_t which, pov_candidate *out)
{
    near_rays k;
    intervals io;
    firsts f;
    uint32_t n = 0;

    for (uint32_t i = 0; i < TOGETHER; i++)
        k.from[i] = some >> i & 1 ? column_of(t, rays->rays[first + i]->origin_surface) : CSG_COLUMNS;
    find(t, rays, first, some >> TOGETHER / 2 ? TOGETHER : TOGETHER / 2, &k, &io, &f);
    for (; some; some &= some - 1) {
        const uint32_t i = first_of(some);

        if (io.passed[i] > 0.0)
            continue;
        out[n] = candidate_of(t, &k, &io, &f, i);
        if (out[n].lo > k.most[i])
            continue;
        out[n].ray = (uint8_t)(first + i);
        out[n++].lane = (uint8_t)which;
    }
    return n;
}

static uint32_t decline(uint64_t lanes, uint32_t which, pov_candidate *out)
{
    uint32_t n = 0;

    for (; lanes; lanes &= lanes - 1, n++)
        out[n] = (pov_candidate){ .ray = (uint8_t)first_of64(lanes), .lane = (uint8_t)which };
    return n;
}

/* A single ray is left to csg_intersect(), which looks at the columns side by side. */
uint32_t csg_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes, pov_candidate *out)
{
    const csg_block *b = block;
    uint32_t n = 0;

    (void)owners;
    for (uint32_t which = 0; which < b->count; which++) {
        const csg_tree *t = b->tree[which];

        if ((lanes & (lanes - 1)) == 0 || !t->outline) {
            n += decline(lanes, which, out + n);
            continue;
        }
        for (uint32_t first = 0; first < POV_RAYS_MAX && lanes >> first; first += TOGETHER)
            if (lanes >> first & ((1u << TOGETHER) - 1))
                n += filter_some(t, rays, first, (uint32_t)(lanes >> first) & ((1u << TOGETHER) - 1), which, out + n);
    }
    return n;
}

bool csg_pack(void *block, const pov_frame *frame, const void *const *selves, uint32_t n)
{
    csg_block *b = block;

    (void)frame;
    b->count = n;
    for (uint32_t i = 0; i < n; i++)
        b->tree[i] = ((const csg_root *)selves[i])->tree;
    return true;
}

void csg_cross_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        const csg_tree *t = ((const csg_root *)selves[i])->tree;
        const uint32_t note = ((const csg_user *)hits[i]->user)->note;
        const csg_first first = { .column = note & (CSG_COLUMNS - 1), .enters = (note & ENTERS) != 0, .inward = (note & INWARD) != 0 };
        csg_traversal w;

        csg_traversal_init(&w, t, rays[i], hits[i]);
        if (!csg_chords_report(&w, &first, hits[i]))
            csg_intersect(selves[i], rays[i], hits[i]);
    }
}

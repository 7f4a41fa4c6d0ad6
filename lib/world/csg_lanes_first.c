/* Several rays and one tree, with chords or a table: which crossing is certainly the first. As csg_outline.c and csg_sweep.c find it for
 * one ray. */
#include "world/csg_lanes.h"

static const double margin = CSG_OUTLINE_MARGIN;

/* Is any lane's other than 0? */
SIMD_INLINE bool is_any(const uint64_t *restrict a)
{
    uint64_t some[CSG_TOGETHER / 2];

    for (uint32_t i = 0; i < CSG_TOGETHER / 2; i++)
        some[i] = a[i] | a[i + CSG_TOGETHER / 2];
    return (some[0] | some[1] | some[2] | some[3]) != 0;
}

SIMD_INLINE double greatest(const double *restrict a)
{
    double most = a[0];

    for (uint32_t i = 1; i < CSG_TOGETHER; i++)
        most = csg_greater(a[i], most);
    return most;
}

/* ---- crossings that are near each other ---- */

SIMD_INLINE double nearest(double in, double out, double start)
{
    return csg_lesser(fabs(in - out), csg_lesser(fabs(in - start), fabs(out - start)));
}

/* How much farther from each other, and from the start, are the ends of a column than what is near? Ends that are not there tell nothing.
 * aside: if not 0, those near the start tell nothing either. */
SIMD_INLINE double clearance(const csg_near_rays *restrict of, uint32_t c, uint32_t i, double aside, bool endless)
{
    const double in = of->in[c][i], out = of->out[c][i], start = of->of[CSG_NEAR_START][i], between = fabs(in - out);
    const double at_start = aside > 0.0 ? HUGE_VAL : csg_lesser(fabs(in - start), fabs(out - start));

    if (!endless)
        return csg_lesser(between, at_start) - margin;
    return csg_lesser(between - csg_lanes_near(of, i, csg_lesser(fabs(in), fabs(out)), true), at_start - csg_lanes_near(of, i, start, true));
}

/* aside: NULL is as 0 everywhere. */
SIMD_INLINE void find_clearance(uint32_t columns, const csg_near_rays *restrict of, const double *aside, bool endless,
                                double *restrict least)
{
    SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++)
        least[i] = HUGE_VAL;
    for (uint32_t c = 0; c < columns; c++)
        SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++)
            least[i] = csg_lesser(clearance(of, c, i, aside ? aside[i] : 0.0, endless), least[i]);
}

/* Where rays start certainly outside of a column that the tree is within, what they cross at the start does not show, such as the plane of a
 * floor that a solid stands on. */
SIMD_INLINE void find_aside(uint32_t within, const csg_near_rays *restrict of, bool endless, double *restrict aside)
{
    for (; within; within &= within - 1) {
        const uint32_t c = first_of(within);

        SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++) {
            const double start = of->of[CSG_NEAR_START][i], near = 2.0 * csg_lanes_near(of, i, start, endless);
            const double beside = csg_greater(of->in[c][i] - start, start - of->out[c][i]);

            aside[i] = beside > near ? 1.0 : aside[i];
        }
    }
}

/* Of rays that start on a column's surface, the crossing there is behind; where it is not known which one that is all is open. */
SIMD_INLINE void leave_column(uint32_t c, const double *restrict from, csg_near_rays *restrict io, bool endless)
{
    SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++) {
        const double in = io->in[c][i], out = io->out[c][i], start = io->of[CSG_NEAR_START][i], open = io->of[CSG_NEAR_OPEN][i];
        const double near = csg_lanes_near(io, i, start, endless);
        const double enters = fabs(in - start) <= near ? 1.0 : 0.0, leaves = fabs(out - start) <= near ? 1.0 : 0.0;
        const double one = in > out ? 0.0 : enters != leaves ? 1.0 : 0.0, mine = from[i] == c ? 1.0 : 0.0, moves = mine * one;

        io->in[c][i] = moves > 0.0 ? enters > 0.0 ? -HUGE_VAL : HUGE_VAL : in;
        io->out[c][i] = moves * leaves > 0.0 ? -HUGE_VAL : out;
        io->of[CSG_NEAR_OPEN][i] = mine > moves ? 1.0 : open;
    }
}

/* Where crossings are near the start, or near each other, all is open but for those of the surface that the ray starts on, and those that do not
 * show. */
SIMD_CLONES SIMD_NOINLINE static void leave_by_name(const csg_tree *t, const pov_rays *restrict rays, const double *restrict least,
                                                    csg_near_rays *restrict io, bool endless)
{
    SIMD_ALIGNED csg_lane from, left, aside;
    uint32_t columns = 0;

    for (uint32_t i = 0; i < CSG_TOGETHER; i++) {
        aside[i] = 0.0;
        const uint32_t c = least[i] > 0.0 ? CSG_COLUMNS : csg_lanes_column(t, rays->rays[io->ray[i]]->origin_surface);

        from[i] = c;
        columns |= 1u << c;
    }
    for (columns &= (1u << CSG_COLUMNS) - 1; columns; columns &= columns - 1)
        leave_column(first_of(columns), from, io, endless);
    find_aside(csg_lanes_within(t), io, endless, aside);
    find_clearance(t->outline->count, io, aside, endless, left);
    SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++)
        io->of[CSG_NEAR_OPEN][i] = left[i] > 0.0 ? io->of[CSG_NEAR_OPEN][i] : 1.0;
}

/* Crossings near the start, or ends of an interval that are near each other, leave all open. Behind this rays start within a column,
 * or not, for certain. */
SIMD_INLINE void check_near(const csg_tree *t, const pov_rays *restrict rays, csg_near_rays *restrict io, bool endless)
{
    SIMD_ALIGNED uint64_t near[CSG_TOGETHER];
    SIMD_ALIGNED csg_lane least;

    find_clearance(t->outline->count, io, NULL, endless, least);
    SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++)
        near[i] = least[i] > 0.0 ? 0 : 1;
    if (is_any(near))
        leave_by_name(t, rays, least, io, endless);
}

/* ---- of a tree with chords ---- */

/* Beyond the hollows that rays are certainly in, one after the other, until none moves any ray: each does so at most once. Ends of
 * others that are near are found when all is looked at. */
SIMD_INLINE void leave_hollows(uint32_t hollows, const csg_near_rays *restrict of, double *restrict at)
{
    for (uint32_t left = hollows; left; left &= left - 1) {
        SIMD_ALIGNED csg_lane deepest;

        SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++)
            deepest[i] = 0.0;
        for (uint32_t rest = hollows; rest; rest &= rest - 1) {
            const uint32_t c = first_of(rest);

            SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++) {
                const double out = of->out[c][i], depth = csg_lesser(at[i] - of->in[c][i], out - at[i]);

                at[i] = depth > margin ? out : at[i];
                deepest[i] = csg_greater(depth, deepest[i]);
            }
        }
        if (!(greatest(deepest) > margin))
            break;
    }
}

/* Rays that start inside the solid leave it where all columns of `within` end, or a hollow begins. */
SIMD_INLINE void find_exits(uint32_t hollows, const csg_near_rays *restrict of, const double *restrict leave, double *restrict at)
{
    SIMD_ALIGNED csg_lane first;

    SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++)
        first[i] = leave[i];
    for (; hollows; hollows &= hollows - 1) {
        const uint32_t c = first_of(hollows);

        SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++) {
            const double in = of->in[c][i], ahead = in > of->of[CSG_NEAR_START][i] ? in : HUGE_VAL;

            first[i] = csg_lesser(in < of->out[c][i] ? ahead : HUGE_VAL, first[i]);
        }
    }
    SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++)
        at[i] = at[i] == of->of[CSG_NEAR_START][i] ? first[i] : at[i];
}

/* Whose crossing it is; that of several that are near each other is open. */
SIMD_INLINE void find_ends(uint32_t columns, const csg_near_rays *restrict of, csg_firsts *restrict io)
{
    SIMD_ALIGNED csg_lane near;

    SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++)
        near[i] = io->crossing[i] = 0.0;
    for (uint32_t c = 0; c < columns; c++) {
        const double entry = 2.0 * c + 1.0, end = 2.0 * c;

        SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++) {
            const double in = of->in[c][i], out = of->out[c][i], at = io->at[i];

            near[i] += (fabs(in - at) > margin ? 0.0 : 1.0) + (fabs(out - at) > margin ? 0.0 : 1.0);
            io->crossing[i] = in == at ? entry : out == at ? end : io->crossing[i];
        }
    }
    SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++)
        io->open[i] = near[i] == 1.0 ? io->open[i] : 1.0;
}

SIMD_CLONES SIMD_NOINLINE void csg_lanes_first_chord(const csg_tree *t, const pov_rays *restrict rays, csg_near_rays *restrict k,
                                                  csg_firsts *restrict out)
{
    const uint32_t hollows = t->chords.all & ~t->chords.within;
    SIMD_ALIGNED csg_lane leave;

    for (uint32_t left = hollows; left; left &= left - 1)
        csg_lanes_cross(t->outline, first_of(left), first_of(left), k, false);
    check_near(t, rays, k, false);
    SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++) {
        out->at[i] = k->of[CSG_NEAR_START][i];
        leave[i] = HUGE_VAL;
    }
    for (uint32_t left = t->chords.within; left; left &= left - 1) {
        const uint32_t c = first_of(left);

        SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++) {
            out->at[i] = csg_greater(k->in[c][i], out->at[i]);
            leave[i] = csg_lesser(k->out[c][i], leave[i]);
        }
    }
    leave_hollows(hollows, k, out->at);
    SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++) {
        const double beyond = out->at[i] - leave[i], open = k->of[CSG_NEAR_OPEN][i];

        out->passed[i] = open > 0.0 ? 0.0 : beyond > margin ? 1.0 : 0.0;
        out->open[i] = beyond < -margin ? open : 1.0;
    }
    find_exits(hollows, k, leave, out->at);
    find_ends(t->outline->count, k, out);
    SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++) {
        const double at = out->at[i] - k->of[CSG_NEAR_START][i], per_unit = k->of[CSG_NEAR_PER_UNIT][i];

        out->lo[i] = (at - margin) * per_unit;
        out->hi[i] = (at + margin) * per_unit;
    }
}

/* ---- of a tree with a table ---- */

/* At a crossing of a column: the others that hold it, as bits, and how near another crossing is. */
SIMD_INLINE void find_holding(uint32_t columns, uint32_t column, const csg_near_rays *restrict of, const double *restrict at,
                              uint64_t *restrict holding, double *restrict near)
{
    SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++) {
        holding[i] = 0;
        near[i] = fabs(of->in[column][i] - of->out[column][i]);
    }
    for (uint32_t c = 0; c < columns; c++) {
        const uint64_t bit = (uint64_t)1 << c;

        if (c == column)
            continue;
        SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++) {
            const double in = of->in[c][i], out = of->out[c][i];

            holding[i] |= in < at[i] && at[i] < out ? bit : 0;
            near[i] = csg_lesser(nearest(at[i], in, out), near[i]);
        }
    }
}

/* Crossings ahead and within the box, if there is one, which is the last column; else infinity. False: all are, or behind others that
 * show. */
SIMD_INLINE bool find_ahead(const csg_outline *of, uint32_t column, const csg_near_rays *restrict k, const double *restrict at,
                            const double *restrict first, bool endless, double *restrict out)
{
    SIMD_ALIGNED uint64_t counts[CSG_TOGETHER];

    SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++) {
        const double ahead = at[i] > k->of[CSG_NEAR_START][i] ? at[i] : HUGE_VAL;
        const double within = k->in[column][i] < k->out[column][i] ? ahead : HUGE_VAL;

        out[i] = endless ? within : within < k->in[of->count][i] ? HUGE_VAL : within > k->out[of->count][i] ? HUGE_VAL : within;
        counts[i] = out[i] < HUGE_VAL ? out[i] > first[i] + csg_lanes_near(k, i, first[i], endless) ? 0 : 1 : 0;
    }
    return is_any(counts);
}

/* What happens at a crossing, where that is the first so far that shows; and the first place where crossings are too near each other. */
SIMD_INLINE void try_crossing(const csg_outline *of, uint32_t column, bool enters, const csg_near_rays *restrict k,
                              const double *restrict at, bool endless, csg_firsts *restrict io, double *restrict close)
{
    const uint64_t shows = of->shows[column], grows = of->grows[column];
    const double crossing = 2.0 * column + (enters ? 1.0 : 0.0);
    SIMD_ALIGNED uint64_t holding[CSG_TOGETHER];
    SIMD_ALIGNED csg_lane near, counts;

    if (!find_ahead(of, column, k, at, io->at, endless, counts))
        return;
    find_holding(of->count, column, k, at, holding, near);
    SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++) {
        const double shown = shows >> holding[i] & 1 ? counts[i] : HUGE_VAL, grown = grows >> holding[i] & 1 ? 1.0 : 0.0;
        const double inward = enters ? grown : 1.0 - grown;

        close[i] = near[i] > csg_lanes_near(k, i, at[i], endless) ? close[i] : csg_lesser(counts[i], close[i]);
        io->crossing[i] = shown < io->at[i] ? crossing : io->crossing[i];
        io->inward[i] = shown < io->at[i] ? inward : io->inward[i];
        io->at[i] = csg_lesser(shown, io->at[i]);
    }
}

SIMD_INLINE void find_swept(const csg_tree *t, const pov_rays *restrict rays, bool endless, csg_near_rays *restrict k, csg_firsts *restrict out)
{
    const csg_outline *of = t->outline;
    SIMD_ALIGNED csg_lane close;

    for (uint32_t c = 0; c < of->count; c++)
        if (!(of->within >> c & 1))
            csg_lanes_cross(of, c, c, k, endless);
    check_near(t, rays, k, endless);
    SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++) {
        out->at[i] = close[i] = HUGE_VAL;
        out->crossing[i] = out->inward[i] = 0.0;
    }
    for (uint32_t c = 0; c < of->count; c++) {
        try_crossing(of, c, true, k, k->in[c], endless, out, close);
        try_crossing(of, c, false, k, k->out[c], endless, out, close);
    }
    SIMD_LOOP for (uint32_t i = 0; i < CSG_TOGETHER; i++) {
        const double at = out->at[i] - k->of[CSG_NEAR_START][i], per_unit = k->of[CSG_NEAR_PER_UNIT][i];
        const double near = csg_lanes_near(k, i, out->at[i], endless), last = csg_lesser(out->at[i] + near, 0x1p1000);

        out->open[i] = close[i] <= last ? 1.0 : k->of[CSG_NEAR_OPEN][i];
        out->passed[i] = out->open[i] > 0.0 ? 0.0 : out->at[i] < HUGE_VAL ? 0.0 : 1.0;
        out->lo[i] = (at - near) * per_unit;
        out->hi[i] = (at + near) * per_unit;
    }
}

SIMD_CLONES SIMD_NOINLINE void csg_lanes_first_swept(const csg_tree *t, const pov_rays *restrict rays, csg_near_rays *restrict k,
                                                csg_firsts *restrict out)
{
    if (t->outline->endless)
        find_swept(t, rays, true, k, out);
    else
        find_swept(t, rays, false, k, out);
}

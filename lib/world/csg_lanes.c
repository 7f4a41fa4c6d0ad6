/* Several rays and one tree: which of them certainly pass it, and which crossing is certainly the first of each other. As
 * csg_outline.c and csg_sweep.c find it for one ray, of trees with chords or a table. What is open is left to csg_intersect(). */
#include "base/simd.h"
#include "world/csg_outline.h"

#include <string.h>

enum { TOGETHER = 8, GROUPS = POV_RAYS_MAX / TOGETHER };
typedef double lane[TOGETHER];

/* Rays in the tree's units, as near_ray, and by column where each is inside that; OPEN: a number other than 0 where that is not known. */
enum { AT, ALONG = AT + 3, SQUARE = ALONG + 3, START, PER_UNIT, OPEN, KNOWN };
typedef struct SIMD_ALIGNED near_rays {
    lane of[KNOWN], in[CSG_FEW], out[CSG_FEW];
    uint8_t ray[TOGETHER];       /* its lane */
} near_rays;

/* The first crossing: its place, between which distances it is, twice its column and 1 if that is entered; numbers other than 0
 * if the tree is entered, where all that is open, and where there is none. */
typedef struct SIMD_ALIGNED firsts { lane at, lo, hi, crossing, inward, open, passed; } firsts;

static const double margin = CSG_OUTLINE_MARGIN;

SIMD_INLINE double lesser(double a, double b) { return a < b ? a : b; }
SIMD_INLINE double greater(double a, double b) { return a > b ? a : b; }

/* Is any lane's other than 0? */
SIMD_INLINE bool is_any(const uint64_t *restrict a)
{
    uint64_t some[TOGETHER / 2];

    for (uint32_t i = 0; i < TOGETHER / 2; i++)
        some[i] = a[i] | a[i + TOGETHER / 2];
    return (some[0] | some[1] | some[2] | some[3]) != 0;
}

SIMD_INLINE double greatest(const double *restrict a)
{
    double most = a[0];

    for (uint32_t i = 1; i < TOGETHER; i++)
        most = greater(a[i], most);
    return most;
}

/* ---- rays ---- */

SIMD_INLINE void come_near(const csg_outline *of, const pov_rays *restrict rays, uint32_t first, uint32_t n,
                           near_rays *restrict out)
{
    const pov_vec3 centre = of->centre;
    const double size = of->size, per_size = of->per_size;

    for (uint32_t i = 0; i < n; i++) {
        const uint32_t k = first + i;
        const double x = (rays->org[0][k] - centre.x) * per_size, y = (rays->org[1][k] - centre.y) * per_size,
            z = (rays->org[2][k] - centre.z) * per_size, per_length = rays->per_length[k];
        const double dx = rays->dir[0][k] * per_length, dy = rays->dir[1][k] * per_length, dz = rays->dir[2][k] * per_length;
        const double start = x * dx + y * dy + z * dz, px = x - dx * start, py = y - dy * start, pz = z - dz * start;

        out->of[AT][i] = px;
        out->of[AT + 1][i] = py;
        out->of[AT + 2][i] = pz;
        out->of[ALONG][i] = dx;
        out->of[ALONG + 1][i] = dy;
        out->of[ALONG + 2][i] = dz;
        out->of[SQUARE][i] = px * px + py * py + pz * pz;
        out->of[START][i] = start;
        out->of[PER_UNIT][i] = per_length * size;
        out->of[OPEN][i] = greater(greater(fabs(x), fabs(y)), fabs(z)) < CSG_FARTHEST ? 0.0 : 1.0;
    }
}

/* A small packet has no more than four lanes: behind them they come again. */
static void repeat(near_rays *k)
{
    for (uint32_t i = 0; i < KNOWN; i++)
        memcpy(k->of[i] + TOGETHER / 2, k->of[i], sizeof(lane) / 2);
}

/* The ray in lane i to lane j of others, with its columns `some`. */
static void move(const near_rays *from, uint32_t i, uint32_t some, near_rays *to, uint32_t j)
{
    for (uint32_t k = 0; k < KNOWN; k++)
        to->of[k][j] = from->of[k][i];
    for (; some; some &= some - 1) {
        const uint32_t c = first_of(some);

        to->in[c][j] = from->in[c][i];
        to->out[c][j] = from->out[c][i];
    }
}

/* ---- columns ---- */

SIMD_INLINE pov_vec3 vector(const near_rays *restrict k, uint32_t which, uint32_t i)
{
    return pov_vec3_of(k->of[which][i], k->of[which + 1][i], k->of[which + 2][i]);
}

/* What a slab or quadric and the column have in common. */
SIMD_INLINE void narrow(csg_stretch s, uint32_t column, uint32_t i, near_rays *restrict io)
{
    io->in[column][i] = greater(s.in, io->in[column][i]);
    io->out[column][i] = lesser(s.out, io->out[column][i]);
    io->of[OPEN][i] = greater(s.open, io->of[OPEN][i]);
}

SIMD_INLINE void cross_slab(const double *restrict number, uint32_t column, near_rays *restrict k)
{
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++)
        narrow(csg_cross_slab(number, vector(k, AT, i), vector(k, ALONG, i), CSG_LEAST_HEIGHT), column, i, k);
}

SIMD_INLINE void cross_general(const double *restrict of, uint32_t column, near_rays *restrict k)
{
    double number[CSG_FOUR * CSG_QUADRIC_NUMBERS];

    for (uint32_t i = 0; i < CSG_QUADRIC_NUMBERS; i++)
        number[CSG_FOUR * i] = of[CSG_FOUR * i];
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
        csg_stretch s = csg_cross_quadric(number, vector(k, AT, i), vector(k, ALONG, i), 1.0);

        s.open = s.square < 0.0 ? 1.0 : s.open;
        narrow(s, column, i, k);
    }
}

SIMD_INLINE void cross_round(const csg_outline *of, uint32_t column, near_rays *restrict k)
{
    const uint32_t quadric = of->quadric[column];
    const double *restrict number = of->numbers + CSG_SLAB_NUMBERS * of->slabs + csg_number(CSG_QUADRIC_NUMBERS, quadric);
    const csg_turned turned = of->turned[quadric];

    if (turned.kind == CSG_SPHERE)
        SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++)
            narrow(csg_cross_turned(number, &turned, false, vector(k, AT, i), vector(k, ALONG, i), k->of[SQUARE][i]), column, i, k);
    else if (turned.kind == CSG_TURNED)
        SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++)
            narrow(csg_cross_turned(number, &turned, true, vector(k, AT, i), vector(k, ALONG, i), k->of[SQUARE][i]), column, i, k);
    else
        cross_general(number, column, k);
}

/* What is certainly missed has no ends: those of its slabs may lie where something else is crossed. */
SIMD_INLINE void leave_out_missed(uint32_t column, near_rays *restrict k)
{
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
        const double in = k->in[column][i], out = k->out[column][i], missed = in - out > margin ? 1.0 : 0.0;

        k->in[column][i] = missed > 0.0 ? HUGE_VAL : in;
        k->out[column][i] = missed > 0.0 ? -HUGE_VAL : out;
    }
}

SIMD_INLINE void cross_column(const csg_outline *of, uint32_t column, near_rays *restrict k)
{
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
        k->in[column][i] = -HUGE_VAL;
        k->out[column][i] = HUGE_VAL;
    }
    for (uint32_t slab = of->first_slab[column]; slab < of->first_slab[column + 1]; slab++)
        cross_slab(of->numbers + csg_number(CSG_SLAB_NUMBERS, slab), column, k);
    if (of->round >> column & 1)
        cross_round(of, column, k);
    leave_out_missed(column, k);
}

/* The columns that hold the tree: a ray that is never within all of them passes it. */
static uint32_t within_of(const csg_tree *t)
{
    const csg_outline *of = t->outline;

    const uint32_t box = of->boxed ? 1u << of->count : 0;

    return t->clipped.outlined ? box | (((1u << t->clipped.count) - 1) & ~t->clipped.hollows) : box ? box | of->within : t->chords.within;
}

/* Rays that are never within all members that are no complements, ahead and before their end, certainly pass the tree. Others do not
 * cross it before `lo`. */
SIMD_CLONES SIMD_NOINLINE static void find_passing(const csg_tree *t, const pov_rays *restrict rays, uint32_t first, uint32_t n,
                                     near_rays *restrict k, double *restrict passed, double *restrict lo)
{
    SIMD_ALIGNED lane enter, leave, most;

    come_near(t->outline, rays, first, n, k);
    for (uint32_t i = 0; i < n; i++)
        most[i] = rays->tmax[first + i];
    if (n < TOGETHER) {
        repeat(k);
        memcpy(most + n, most, sizeof most / 2);
    }
    for (uint32_t i = 0; i < TOGETHER; i++) {
        enter[i] = -HUGE_VAL;
        leave[i] = HUGE_VAL;
    }
    for (uint32_t left = within_of(t); left; left &= left - 1) {
        const uint32_t c = first_of(left);

        cross_column(t->outline, c, k);
        SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
            enter[i] = greater(k->in[c][i], enter[i]);
            leave[i] = lesser(k->out[c][i], leave[i]);
        }
    }
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
        const double start = k->of[START][i], beside = greater(enter[i], start) - leave[i];
        const double from = (enter[i] - start - margin) * k->of[PER_UNIT][i], never = beside > margin ? 1.0 : from > most[i] ? 1.0 : 0.0;

        passed[i] = k->of[OPEN][i] > 0.0 ? 0.0 : never;
        lo[i] = k->of[OPEN][i] > 0.0 ? 0.0 : greater(from, 0.0);
    }
}

/* ---- the first crossing ---- */

/* The column that a ray starts on, or CSG_COLUMNS. */
static uint32_t column_of(const csg_tree *t, uint32_t name)
{
    const uint32_t member = name - t->members[0].leaf;

    for (uint32_t i = 0; member < t->member_count && i < t->outline->count; i++)
        if (t->outline->member[i] == member)
            return i;
    return CSG_COLUMNS;
}

SIMD_INLINE double nearest(double in, double out, double start)
{
    return lesser(fabs(in - out), lesser(fabs(in - start), fabs(out - start)));
}

SIMD_INLINE void find_nearest(uint32_t columns, const near_rays *restrict of, double *restrict least)
{
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++)
        least[i] = HUGE_VAL;
    for (uint32_t c = 0; c < columns; c++)
        SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++)
            least[i] = lesser(nearest(of->in[c][i], of->out[c][i], of->of[START][i]), least[i]);
}

/* Of rays that start on a column's surface, the crossing there is behind; where it is not known which one that is all is open. */
SIMD_INLINE void leave_column(uint32_t c, const double *restrict from, near_rays *restrict io)
{
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
        const double in = io->in[c][i], out = io->out[c][i], start = io->of[START][i], open = io->of[OPEN][i];
        const double enters = fabs(in - start) <= margin ? 1.0 : 0.0, leaves = fabs(out - start) <= margin ? 1.0 : 0.0;
        const double one = in > out ? 0.0 : enters != leaves ? 1.0 : 0.0, mine = from[i] == c ? 1.0 : 0.0, moves = mine * one;

        io->in[c][i] = moves > 0.0 ? enters > 0.0 ? -HUGE_VAL : HUGE_VAL : in;
        io->out[c][i] = moves * leaves > 0.0 ? -HUGE_VAL : out;
        io->of[OPEN][i] = mine > moves ? 1.0 : open;
    }
}

/* Where crossings are near the start, or near each other, all is open but for those of the surface that the ray starts on. */
SIMD_CLONES SIMD_NOINLINE static void leave_by_name(const csg_tree *t, const pov_rays *restrict rays, const double *restrict least,
                                                    near_rays *restrict io)
{
    SIMD_ALIGNED lane from, left;
    uint32_t columns = 0;

    for (uint32_t i = 0; i < TOGETHER; i++) {
        const uint32_t c = least[i] > margin ? CSG_COLUMNS : column_of(t, rays->rays[io->ray[i]]->origin_surface);

        from[i] = c;
        columns |= 1u << c;
    }
    for (columns &= (1u << CSG_COLUMNS) - 1; columns; columns &= columns - 1)
        leave_column(first_of(columns), from, io);
    find_nearest(t->outline->count, io, left);
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++)
        io->of[OPEN][i] = left[i] > margin ? io->of[OPEN][i] : 1.0;
}

/* Crossings near the start, or ends of an interval that are near each other, leave all open. Behind this rays start within a column,
 * or not, for certain. */
SIMD_INLINE void check_near(const csg_tree *t, const pov_rays *restrict rays, near_rays *restrict io)
{
    SIMD_ALIGNED uint64_t near[TOGETHER];
    SIMD_ALIGNED lane least;

    find_nearest(t->outline->count, io, least);
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++)
        near[i] = least[i] > margin ? 0 : 1;
    if (is_any(near))
        leave_by_name(t, rays, least, io);
}

/* Beyond the hollows that rays are certainly in, one after the other, until none moves any ray: each does so at most once. Ends of
 * others that are near are found when all is looked at. */
SIMD_INLINE void leave_hollows(uint32_t hollows, const near_rays *restrict of, double *restrict at)
{
    for (uint32_t left = hollows; left; left &= left - 1) {
        SIMD_ALIGNED lane deepest;

        SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++)
            deepest[i] = 0.0;
        for (uint32_t rest = hollows; rest; rest &= rest - 1) {
            const uint32_t c = first_of(rest);

            SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
                const double out = of->out[c][i], depth = lesser(at[i] - of->in[c][i], out - at[i]);

                at[i] = depth > margin ? out : at[i];
                deepest[i] = greater(depth, deepest[i]);
            }
        }
        if (!(greatest(deepest) > margin))
            break;
    }
}

/* Rays that start inside the solid leave it where all columns of `within` end, or a hollow begins. */
SIMD_INLINE void find_exits(uint32_t hollows, const near_rays *restrict of, const double *restrict leave, double *restrict at)
{
    SIMD_ALIGNED lane first;

    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++)
        first[i] = leave[i];
    for (; hollows; hollows &= hollows - 1) {
        const uint32_t c = first_of(hollows);

        SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
            const double in = of->in[c][i], ahead = in > of->of[START][i] ? in : HUGE_VAL;

            first[i] = lesser(in < of->out[c][i] ? ahead : HUGE_VAL, first[i]);
        }
    }
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++)
        at[i] = at[i] == of->of[START][i] ? first[i] : at[i];
}

/* Whose crossing it is; that of several that are near each other is open. */
SIMD_INLINE void find_ends(uint32_t columns, const near_rays *restrict of, firsts *restrict io)
{
    SIMD_ALIGNED lane near;

    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++)
        near[i] = io->crossing[i] = 0.0;
    for (uint32_t c = 0; c < columns; c++) {
        const double entry = 2.0 * c + 1.0, end = 2.0 * c;

        SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
            const double in = of->in[c][i], out = of->out[c][i], at = io->at[i];

            near[i] += (fabs(in - at) > margin ? 0.0 : 1.0) + (fabs(out - at) > margin ? 0.0 : 1.0);
            io->crossing[i] = in == at ? entry : out == at ? end : io->crossing[i];
        }
    }
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++)
        io->open[i] = near[i] == 1.0 ? io->open[i] : 1.0;
}

SIMD_CLONES SIMD_NOINLINE static void find_firsts(const csg_tree *t, const pov_rays *restrict rays, near_rays *restrict k,
                                                  firsts *restrict out)
{
    const uint32_t hollows = t->chords.all & ~t->chords.within;
    SIMD_ALIGNED lane leave;

    for (uint32_t left = hollows; left; left &= left - 1)
        cross_column(t->outline, first_of(left), k);
    check_near(t, rays, k);
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
        out->at[i] = k->of[START][i];
        leave[i] = HUGE_VAL;
    }
    for (uint32_t left = t->chords.within; left; left &= left - 1) {
        const uint32_t c = first_of(left);

        SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
            out->at[i] = greater(k->in[c][i], out->at[i]);
            leave[i] = lesser(k->out[c][i], leave[i]);
        }
    }
    leave_hollows(hollows, k, out->at);
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
        const double beyond = out->at[i] - leave[i], open = k->of[OPEN][i];

        out->passed[i] = open > 0.0 ? 0.0 : beyond > margin ? 1.0 : 0.0;
        out->open[i] = beyond < -margin ? open : 1.0;
    }
    find_exits(hollows, k, leave, out->at);
    find_ends(t->outline->count, k, out);
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
        const double at = out->at[i] - k->of[START][i], per_unit = k->of[PER_UNIT][i];

        out->lo[i] = (at - margin) * per_unit;
        out->hi[i] = (at + margin) * per_unit;
    }
}

/* ---- the same of a tree with a table ---- */

/* At a crossing of a column: the others that hold it, as bits, and how near another crossing is. */
SIMD_INLINE void find_holding(uint32_t columns, uint32_t column, const near_rays *restrict of, const double *restrict at,
                              uint64_t *restrict holding, double *restrict near)
{
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
        holding[i] = 0;
        near[i] = fabs(of->in[column][i] - of->out[column][i]);
    }
    for (uint32_t c = 0; c < columns; c++) {
        const uint64_t bit = (uint64_t)1 << c;

        if (c == column)
            continue;
        SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
            const double in = of->in[c][i], out = of->out[c][i];

            holding[i] |= in < at[i] && at[i] < out ? bit : 0;
            near[i] = lesser(nearest(at[i], in, out), near[i]);
        }
    }
}

/* Crossings ahead and within the box, which is the last column; else infinity. False: all are, or behind others that show. */
SIMD_INLINE bool find_ahead(const csg_outline *of, uint32_t column, const near_rays *restrict k, const double *restrict at,
                            const double *restrict first, double *restrict out)
{
    SIMD_ALIGNED uint64_t counts[TOGETHER];

    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
        const double ahead = at[i] > k->of[START][i] ? at[i] : HUGE_VAL, within = k->in[column][i] < k->out[column][i] ? ahead : HUGE_VAL;

        out[i] = within < k->in[of->count][i] ? HUGE_VAL : within > k->out[of->count][i] ? HUGE_VAL : within;
        counts[i] = out[i] < HUGE_VAL ? out[i] > first[i] + margin ? 0 : 1 : 0;
    }
    return is_any(counts);
}

/* What happens at a crossing, where that is the first so far that shows; and the first place where crossings are too near each other. */
SIMD_INLINE void try_crossing(const csg_outline *of, uint32_t column, bool enters, const near_rays *restrict k, const double *restrict at,
                              firsts *restrict io, double *restrict close)
{
    const uint64_t shows = of->shows[column], grows = of->grows[column];
    const double crossing = 2.0 * column + (enters ? 1.0 : 0.0);
    SIMD_ALIGNED uint64_t holding[TOGETHER];
    SIMD_ALIGNED lane near, boxed;

    if (!find_ahead(of, column, k, at, io->at, boxed))
        return;
    find_holding(of->count, column, k, at, holding, near);
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
        const double shown = shows >> holding[i] & 1 ? boxed[i] : HUGE_VAL, grown = grows >> holding[i] & 1 ? 1.0 : 0.0;
        const double inward = enters ? grown : 1.0 - grown;

        close[i] = near[i] > margin ? close[i] : lesser(boxed[i], close[i]);
        io->crossing[i] = shown < io->at[i] ? crossing : io->crossing[i];
        io->inward[i] = shown < io->at[i] ? inward : io->inward[i];
        io->at[i] = lesser(shown, io->at[i]);
    }
}

SIMD_CLONES SIMD_NOINLINE static void sweep_all(const csg_tree *t, const pov_rays *restrict rays, near_rays *restrict k,
                                                firsts *restrict out)
{
    const csg_outline *of = t->outline;
    SIMD_ALIGNED lane close;

    for (uint32_t c = 0; c < of->count; c++)
        if (!(of->within >> c & 1))
            cross_column(of, c, k);
    check_near(t, rays, k);
    memset(out, 0, sizeof *out);
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++)
        out->at[i] = close[i] = HUGE_VAL;
    for (uint32_t c = 0; c < of->count; c++) {
        try_crossing(of, c, true, k, k->in[c], out, close);
        try_crossing(of, c, false, k, k->out[c], out, close);
    }
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
        const double at = out->at[i] - k->of[START][i], per_unit = k->of[PER_UNIT][i], last = lesser(out->at[i] + margin, 0x1p1000);

        out->open[i] = close[i] <= last ? 1.0 : k->of[OPEN][i];
        out->passed[i] = out->open[i] > 0.0 ? 0.0 : out->at[i] < HUGE_VAL ? 0.0 : 1.0;
        out->lo[i] = (at - margin) * per_unit;
        out->hi[i] = (at + margin) * per_unit;
    }
}

/* ---- candidates ---- */

/* Rays that do not certainly pass the tree, `count` of them; the group behind them is filled before it is known which ones these are. */
typedef struct waiting { near_rays group[GROUPS + 1]; uint32_t count; } waiting;

static void add(const near_rays *of, uint32_t i, uint32_t within, waiting *to)
{
    near_rays *group = &to->group[to->count / TOGETHER];
    const uint32_t j = to->count++ % TOGETHER;

    if (j == 0 && of != group)
        *group = *of;
    if (of != group || j != i)
        move(of, i, within, group, j);
    group->ray[j] = of->ray[i];
}

/* Those of the rays of `some`, eight from `first` on, that do not leave a convex member outward, and so the tree, which is within it. */
static uint32_t staying(const csg_tree *t, const pov_rays *rays, uint32_t first, uint32_t some)
{
    const uint32_t leaf = t->members[0].leaf, members = t->member_count;
    uint32_t any = 0;

    for (uint32_t i = 0; i < TOGETHER; i++)
        any |= rays->excluded[first + i] - leaf < members ? 1 : 0;
    for (uint32_t left = any ? some : 0; left; left &= left - 1) {
        const pov_ray *ray = rays->rays[first + first_of(left)];

        if (ray->origin_mark.flags & POV_MARK_OUTWARD && t->chords.within >> column_of(t, ray->origin_surface) & 1)
            some &= ~(1u << first_of(left));
    }
    return some;
}

/* The rays of `some`, eight from `first` on. */
static void take(const csg_tree *t, const pov_rays *rays, uint32_t first, uint32_t some, waiting *to)
{
    near_rays *k = &to->group[to->count % TOGETHER ? GROUPS : to->count / TOGETHER];
    SIMD_ALIGNED lane passed, lo;
    uint32_t n;

    some = staying(t, rays, first, some);
    if (!some)
        return;
    n = some >> TOGETHER / 2 ? TOGETHER : TOGETHER / 2;
    find_passing(t, rays, first, n, k, passed, lo);
    for (uint32_t i = 0; i < TOGETHER; i++) {
        k->ray[i] = (uint8_t)(first + i % n);
        some &= ~((passed[i] > 0.0 ? 1u : 0u) << i);
    }
    for (; some; some &= some - 1)
        add(k, first_of(some), within_of(t), to);
}

static pov_candidate candidate_of(const csg_tree *t, const firsts *f, uint32_t i, double most)
{
    const uint32_t crossing = (uint32_t)f->crossing[i], column = crossing >> 1;
    const bool enters = crossing & 1;
    pov_candidate m = { .lo = 0.0 };
    bool inward;

    if (f->open[i] > 0.0)
        return m;
    m.lo = f->lo[i];
    m.hi = f->hi[i];
    m.definite = m.hi * (1.0 + 0x1p-40) < most;
    inward = t->chords.all ? enters == (t->chords.within >> column & 1) : f->inward[i] > 0.0;
    m.note = column | (enters ? CSG_NOTE_ENTERS : 0) | (inward ? CSG_NOTE_INWARD : 0);
    return m;
}

/* The first n rays of a group. */
static uint32_t examine(const csg_tree *t, const pov_rays *rays, near_rays *k, uint32_t n, uint32_t which, pov_candidate *out)
{
    uint32_t found = 0;
    firsts f;

    (t->chords.all ? find_firsts : sweep_all)(t, rays, k, &f);
    for (uint32_t i = 0; i < n; i++) {
        const double most = rays->tmax[k->ray[i]];

        if (f.passed[i] > 0.0)
            continue;
        out[found] = candidate_of(t, &f, i, most);
        out[found].ray = k->ray[i];
        out[found].lane = (uint8_t)which;
        found += !(out[found].lo > most);
    }
    return found;
}

static uint32_t filter(const csg_tree *t, const pov_rays *rays, uint64_t lanes, uint32_t which, pov_candidate *out)
{
    uint32_t found = 0;
    waiting k;

    k.count = 0;
    for (uint32_t first = 0; first < POV_RAYS_MAX && lanes >> first; first += TOGETHER)
        if (lanes >> first & ((1u << TOGETHER) - 1))
            take(t, rays, first, (uint32_t)(lanes >> first) & ((1u << TOGETHER) - 1), &k);
    for (uint32_t i = 0; i < k.count; i += TOGETHER)
        found += examine(t, rays, &k.group[i / TOGETHER], k.count - i < TOGETHER ? k.count - i : TOGETHER, which, out + found);
    return found;
}

/* What is clipped is left to csg_intersect() where its clips do not tell. */
static uint32_t filter_clipped(const csg_tree *t, const pov_rays *rays, uint64_t lanes, uint32_t which, pov_candidate *out)
{
    SIMD_ALIGNED lane passed, lo;
    uint32_t found = 0;
    near_rays k;

    for (uint32_t first = 0; first < POV_RAYS_MAX && lanes >> first; first += TOGETHER) {
        uint32_t some = (uint32_t)(lanes >> first) & ((1u << TOGETHER) - 1);

        if (some)
            find_passing(t, rays, first, some >> TOGETHER / 2 ? TOGETHER : TOGETHER / 2, &k, passed, lo);
        for (; some; some &= some - 1) {
            const uint32_t i = first_of(some);

            out[found] = (pov_candidate){ .lo = lo[i], .ray = (uint8_t)(first + i), .lane = (uint8_t)which };
            found += !(passed[i] > 0.0);
        }
    }
    return csg_clipped_narrow(t, rays, out, found);
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

        if ((lanes & (lanes - 1)) == 0 || !t->outline || !within_of(t))
            n += decline(lanes, which, out + n);
        else if (t->clipped.outlined)
            n += filter_clipped(t, rays, lanes, which, out + n);
        else
            n += filter(t, rays, lanes, which, out + n);
    }
    return n;
}

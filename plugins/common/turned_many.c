/* The first crossings of rays with straight pieces that are turned about the y axis, side by side: by the operations of lathe.c. A lane in
 * which anything is near anything else is not known, nor is that of a ray that hardly rises. */
#include "common/revolved.h"

enum { N = COMMON_ENTRIES };
typedef common_by_entry lane;

/* As in lathe.c. */
static const double SLOW = 0x1p-6, REFINED = 0x1p-9;

/* By lane, as the line of lathe.c; crossings near `begin` or before it are not the first. */
typedef struct lines { lane oy, dy, a, b, c, base, unit, lo, hi, per_height, foot, begin; } lines;

/* The equation of a piece: what of it depends on the ray alone. */
typedef struct terms { lane square, linear, rest, noise; } terms;

/* The first crossing, at u of a piece; above 0 where it is open. */
typedef struct sums { lane s, u, piece, open; } sums;

COMMON_INLINE double greater(double a, double b) { return a > b ? a : b; }
COMMON_INLINE double lesser(double a, double b) { return a < b ? a : b; }

COMMON_SEPARATE static void find_lines(const common_entries *restrict l, lines *restrict n, sums *restrict of)
{
    for (uint32_t i = 0; i < N; i++) {
        const double fx = l->f[0][i], fy = l->f[2][i], fz = l->f[4][i], kx = l->d[0][i], ky = l->d[1][i], kz = l->d[2][i];
        const double across = kx * kx + kz * kz, unit = 1.0 / sqrt(kx * kx + ky * ky + kz * kz), lo = l->lo[i], hi = l->hi[i];
        const double nearest = across > 0.0 ? -(fx * kx + fz * kz) / across : lo, base = lesser(greater(nearest, lo), hi);
        const double x = pov_along(pov_two_of(fx, l->f[1][i]), base, kx, l->d_lo[0][i]);
        const double y = pov_along(pov_two_of(fy, l->f[3][i]), base, ky, l->d_lo[1][i]);
        const double z = pov_along(pov_two_of(fz, l->f[5][i]), base, kz, l->d_lo[2][i]);
        const double dx = kx * unit, dy = ky * unit, dz = kz * unit, a = dx * dx + dz * dz, b = x * dx + z * dz;

        n->oy[i] = y;
        n->dy[i] = dy;
        n->a[i] = a;
        n->b[i] = b;
        n->c[i] = x * x + z * z;
        n->base[i] = base;
        n->unit[i] = unit;
        n->lo[i] = (lo - base) / unit;
        n->hi[i] = (hi - base) / unit;
        n->per_height[i] = 1.0 / dy;
        n->foot[i] = a > 0.0 ? -b / a : 0.0;
        n->begin[i] = (l->least[i] - base) / unit + 2.0 * REFINED;
        of->s[i] = HUGE_VAL;
        of->u[i] = of->piece[i] = 0.0;
        of->open[i] = fabs(dy) > SLOW ? 0.0 : 1.0;
    }
}

COMMON_SEPARATE static void find_terms(const lines *restrict n, terms *restrict out)
{
    for (uint32_t i = 0; i < N; i++) {
        const double a = n->a[i], b = n->b[i], c = n->c[i], oy = n->oy[i], dy = n->dy[i], square = dy * dy, linear = 2.0 * (b * dy - a * oy);
        const double rest = (a * oy - 2.0 * b * dy) * oy + square * c;

        out->square[i] = square;
        out->linear[i] = linear;
        out->rest[i] = rest;
        out->noise[i] = 0x1p-51 * (a + fabs(linear) + fabs(rest) + square);
    }
}

/* The equation's coefficients, and 1 where the line may cross the piece: it comes near enough to the axis at its heights, and they are not
 * on one side of zero. */
typedef struct equations { lane b0, b1, b2, may; } equations;

COMMON_SEPARATE static bool find_equations(const common_turned *p, const lines *restrict n, const terms *restrict of, equations *restrict out)
{
    const double low = p->low, high = p->high, wide = p->widest * (1.0 + 0x1p-30) + 0x1p-60, y0 = p->y[0], y1 = p->y[1], y2 = p->y[2];
    const double s0 = p->y_square[0], s1 = p->y_square[1], s2 = p->y_square[2], r0 = p->r_square[0], r1 = p->r_square[1], r2 = p->r_square[2];
    double most[N / 2];

    for (uint32_t i = 0; i < N; i++) {
        const double a = n->a[i], per = n->per_height[i], s = (low - n->oy[i]) * per, t = (high - n->oy[i]) * per;
        const double lo = greater(lesser(s, t), n->lo[i]), hi = lesser(greater(s, t), n->hi[i]), nearest = a > 0.0 ? lesser(greater(n->foot[i], lo), hi) : lo;
        const double near = (a * nearest + 2.0 * n->b[i]) * nearest + n->c[i], linear = of->linear[i], rest = of->rest[i], square = of->square[i];
        const double b0 = a * s0 + linear * y0 + (rest - square * r0), b1 = a * s1 + linear * y1 + (rest - square * r1);
        const double b2 = a * s2 + linear * y2 + (rest - square * r2), least = lesser(lesser(b0, b1), b2), largest = greater(greater(b0, b1), b2);
        const double reached = lo <= hi + 0x1p-30 ? 1.0 : 0.0, within = near <= wide ? reached : 0.0;

        out->b0[i] = b0;
        out->b1[i] = b1;
        out->b2[i] = b2;
        out->may[i] = least < 0.0 ? largest >= 0.0 ? within : 0.0 : 0.0;
    }
    for (uint32_t i = 0; i < N / 2; i++)
        most[i] = out->may[i] + out->may[i + N / 2];
    return most[0] + most[1] + most[2] + most[3] > 0.0;
}

COMMON_INLINE double fraction_of(double a, double b) { return a + b != 0.0 ? a / (a + b) : a; }

/* A crossing at u of the piece. Of two that are near each other, or one near the beginning, it is not known which is the first. */
COMMON_INLINE void add(const lines *restrict n, uint32_t i, double found, double u, double y0, double y1, double piece, sums *restrict io)
{
    const double s = (y0 * (1.0 - u) + y1 * u - n->oy[i]) / n->dy[i], begin = n->begin[i], ahead = s > begin ? found : 0.0;
    const double beside = s > begin - 4.0 * REFINED ? found - ahead : 0.0, near = fabs(s - io->s[i]) > 4.0 * REFINED ? 0.0 : ahead;
    const double first = s < io->s[i] ? ahead : 0.0;

    io->open[i] += near + beside;
    io->s[i] = first > 0.0 ? s : io->s[i];
    io->u[i] = first > 0.0 ? u : io->u[i];
    io->piece[i] = first > 0.0 ? piece : io->piece[i];
}

/* The roots, as common_bernstein_roots() finds them. */
COMMON_SEPARATE static void add_piece(const common_turned *p, double piece, const lines *restrict n, const terms *restrict of,
                                      const equations *restrict at, sums *restrict io)
{
    const double y0 = p->curve.y[0], y1 = p->curve.y[1];

    for (uint32_t i = 0; i < N; i++) {
        const double b0 = at->b0[i], b1 = at->b1[i], b2 = at->b2[i], may = at->may[i], d = b1 * b1 - b0 * b2, root = sqrt(greater(d, 0.0));
        const double from = b0 >= 0.0 ? 1.0 : -1.0, to = b2 >= 0.0 ? 1.0 : -1.0, up = b1 > 0.0 ? 1.0 : -1.0;
        const double q = b1 > 0.0 ? -b1 - root : root - b1, along = q > 0.0 ? to : -to;
        const double one = fraction_of(q, b2), other = fraction_of(b0, q), bends = d > 0.0 ? fabs(b1) > of->noise[i] ? 0.5 * (1.0 - up * from) : 0.0 : 0.0;
        const double single = 0.5 * (1.0 - from * to) * may, both = (1.0 - 0.5 * (1.0 - from * to)) * bends * may;

        add(n, i, single + both, single > 0.0 ? along > 0.0 ? one : other : lesser(one, other), y0, y1, piece, io);
        add(n, i, both, greater(one, other), y0, y1, piece, io);
    }
}

/* Points of the piece that is crossed. */
typedef struct ends { lane x0, y0, x1, y1; } ends;

/* Newton's method for height and radius together, twice. */
COMMON_SEPARATE static void refine(const lines *restrict n, const ends *restrict e, sums *restrict io)
{
    for (uint32_t i = 0; i < N; i++) {
        const double a = n->a[i], b = n->b[i], c = n->c[i], oy = n->oy[i], dy = n->dy[i], x0 = e->x0[i], y0 = e->y0[i], x1 = e->x1[i], y1 = e->y1[i];
        const double turn = x1 - x0, rise = y1 - y0;
        double s = io->s[i], u = io->u[i], going = 1.0;

        COMMON_UNROLLED for (int k = 0; k < 2; k++) {
            const double w = 1.0 - u, x = x0 * w + x1 * u, y = y0 * w + y1 * u, height = oy + s * dy - y, radius = (a * s + 2.0 * b) * s + c - x * x;
            const double radial = 2.0 * (a * s + b), det = 2.0 * x * turn * -dy + rise * radial;
            const double ds = (2.0 * x * turn * height - rise * radius) / det, du = (radial * height - dy * radius) / det;

            going = fabs(ds) < 0x1p-10 ? fabs(du) < 0x1p-10 ? going : 0.0 : 0.0;
            s = going > 0.0 ? s + ds : s;
            u = going > 0.0 ? u + du : u;
        }
        io->s[i] = s;
        io->u[i] = u;
    }
}

COMMON_SEPARATE static void tell(const lines *restrict n, const sums *restrict of, common_first_crossings *restrict out)
{
    for (uint32_t i = 0; i < N; i++) {
        const pov_two t = pov_two_sum(n->base[i], of->s[i] * n->unit[i]);

        out->known[i] = of->open[i] > 0.0 ? 0.0 : of->s[i] < HUGE_VAL ? 1.0 : 0.0;
        out->t[i] = t.hi;
        out->t_lo[i] = t.lo;
        out->feature[i] = of->piece[i];
        out->u[i] = of->u[i];
        out->v[i] = 0.0;
    }
}

void common_turned_first(const common_turned *parts, uint32_t count, const common_entries *restrict l, common_first_crossings *restrict out)
{
    lines n;
    terms all;
    ends e;
    sums of;

    find_lines(l, &n, &of);
    find_terms(&n, &all);
    for (uint32_t k = 0; k < count; k++) {
        equations at;

        if (find_equations(&parts[k], &n, &all, &at))
            add_piece(&parts[k], k, &n, &all, &at, &of);
    }
    for (uint32_t i = 0; count > 0 && i < N; i++) {
        const common_piece *c = &parts[(uint32_t)of.piece[i]].curve;

        e.x0[i] = c->x[0];
        e.y0[i] = c->y[0];
        e.x1[i] = c->x[1];
        e.y1[i] = c->y[1];
    }
    if (count > 0)
        refine(&n, &e, &of);
    tell(&n, &of, out);
}

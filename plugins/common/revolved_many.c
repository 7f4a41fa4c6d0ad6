/* The first crossings of rays with a surface of revolution whose squared radius is a cubic in the height, piece by piece, side by side: by
 * the operations of sor.c. A lane in which anything is near anything else is not known. */
#include "common/revolved.h"

#include "common/bernstein.h"

enum { N = COMMON_ENTRIES };
typedef common_by_entry lane;

/* By lane: the ray from its base on, as far as the box; a t^2 + 2 b t + c is the square of its distance to the axis. Crossings near `enough`
 * or before it are not the first. */
typedef struct lines { lane ox, oy, oz, dx, dy, dz, base, end, a, b, c, foot, enough; } lines;

/* By lane: the first crossing from the base on, the numbers of its piece, and how near others are; above 0 where it is open. */
typedef struct sums { lane t, feature, open; } sums;

/* A piece's stretch of a ray, and where it begins and ends on the piece; above 0 where there is none. */
typedef struct stretches { lane lo, hi, from, to, none, inside; } stretches;

COMMON_SEPARATE static void find_lines(const common_entries *restrict l, lines *restrict n, sums *restrict of)
{
    for (uint32_t i = 0; i < N; i++) {
        const double base = l->lo[i], dx = l->d[0][i], dy = l->d[1][i], dz = l->d[2][i];
        const double ox = pov_along(pov_two_of(l->f[0][i], l->f[1][i]), base, dx, l->d_lo[0][i]);
        const double oy = pov_along(pov_two_of(l->f[2][i], l->f[3][i]), base, dy, l->d_lo[1][i]);
        const double oz = pov_along(pov_two_of(l->f[4][i], l->f[5][i]), base, dz, l->d_lo[2][i]);
        const double a = dx * dx + dz * dz, b = ox * dx + oz * dz, c = ox * ox + oz * oz, off = 0x1p-40 * (1.0 + fabs(base));

        n->ox[i] = ox;
        n->oy[i] = oy;
        n->oz[i] = oz;
        n->dx[i] = dx;
        n->dy[i] = dy;
        n->dz[i] = dz;
        n->base[i] = base;
        n->end[i] = l->hi[i] - base;
        n->a[i] = a;
        n->b[i] = b;
        n->c[i] = c;
        n->foot[i] = a > 0.0 ? -b / a : 0.0;
        n->enough[i] = l->least[i] - base + off;
        of->t[i] = HUGE_VAL;
        of->feature[i] = 0.0;
        of->open[i] = fabs(dy) > 0x1p-100 ? 0.0 : 1.0;
    }
}

/* False: there is none on any ray. */
COMMON_SEPARATE static bool find_stretches(const common_revolved_piece *p, const lines *restrict n, stretches *restrict out)
{
    const double low = p->low, high = p->high, wide = p->widest * (1.0 + 0x1p-30) + 0x1p-40;
    double some[N / 2];

    for (uint32_t i = 0; i < N; i++) {
        const double dy = n->dy[i], oy = n->oy[i], end = n->end[i], rises = dy > 0.0 ? 1.0 : 0.0;
        const double least = ((rises > 0.0 ? low : high) - oy) / dy, most = ((rises > 0.0 ? high : low) - oy) / dy;
        const double lo = least > 0.0 ? least : 0.0, hi = most < end ? most : end;
        const double first = (oy + 0.0 * dy - low) / (high - low), last = (oy + end * dy - low) / (high - low);
        const double foot = n->foot[i], at = foot > lo ? foot < hi ? foot : hi : lo, near = (n->a[i] * at + 2.0 * n->b[i]) * at + n->c[i];
        const double begins = least < end ? 1.0 : 0.0, ends = most > 0.0 ? begins : 0.0, reached = lo < hi ? ends : 0.0;
        const double from = least > 0.0 ? 1.0 - rises : first, to = most < end ? rises : last;

        out->lo[i] = lo;
        out->hi[i] = hi;
        out->from[i] = from;
        out->to[i] = to;
        out->none[i] = near > wide ? 1.0 : 1.0 - reached;
        out->inside[i] = from * (1.0 - from) != 0.0 ? to * (1.0 - to) != 0.0 ? reached : 0.0 : 0.0;
    }
    for (uint32_t i = 0; i < N / 2; i++)
        some[i] = 2.0 - out->none[i] - out->none[i + N / 2];
    return some[0] + some[1] + some[2] + some[3] > 0.0;
}

COMMON_INLINE double mix(double a, double b, double t) { return (1.0 - t) * a + t * b; }

/* The coefficients of the piece's stretch, where that begins or ends with the piece. */
COMMON_SEPARATE static void restrict_pieces(const common_revolved_piece *piece, const stretches *restrict s, common_bernsteins *restrict out)
{
    const double b0 = piece->square[0], b1 = piece->square[1], b2 = piece->square[2], b3 = piece->square[3];

    for (uint32_t i = 0; i < N; i++) {
        const double from = s->from[i], to = s->to[i], ahead = from == 0.0 ? 1.0 : from == 1.0 ? 1.0 : 0.0;
        const double t = ahead > 0.0 ? to : from, end = ahead > 0.0 ? from : to, low = end == 0.0 ? 1.0 : 0.0;
        const double p = mix(b0, b1, t), q = mix(b1, b2, t), r = mix(b2, b3, t), left = mix(p, q, t), right = mix(q, r, t);
        const double o0 = low > 0.0 ? b0 : b3, o1 = low > 0.0 ? p : r, o2 = low > 0.0 ? left : right, o3 = mix(left, right, t);

        out->b[0][i] = ahead > 0.0 ? o0 : o3;
        out->b[1][i] = ahead > 0.0 ? o1 : o2;
        out->b[2][i] = ahead > 0.0 ? o2 : o1;
        out->b[3][i] = ahead > 0.0 ? o3 : o0;
    }
}

COMMON_INLINE double blossom(const common_revolved_piece *p, double t, double u, double v)
{
    const double a = mix(p->square[0], p->square[1], t), b = mix(p->square[1], p->square[2], t), c = mix(p->square[2], p->square[3], t);

    return mix(mix(a, b, u), mix(b, c, u), v);
}

/* The same where it does neither. */
COMMON_SEPARATE static void restrict_inside(const common_revolved_piece *piece, const stretches *restrict s, common_bernsteins *restrict io)
{
    const common_revolved_piece p = *piece;

    for (uint32_t i = 0; i < N; i++) {
        const double from = s->from[i], to = s->to[i], inside = s->inside[i];

        io->b[0][i] = inside > 0.0 ? blossom(&p, from, from, from) : io->b[0][i];
        io->b[1][i] = inside > 0.0 ? blossom(&p, to, from, from) : io->b[1][i];
        io->b[2][i] = inside > 0.0 ? blossom(&p, to, to, from) : io->b[2][i];
        io->b[3][i] = inside > 0.0 ? blossom(&p, to, to, to) : io->b[3][i];
    }
}

/* The square of the distance to the axis less that of the radius. False: all are above zero. */
COMMON_SEPARATE static bool find_equations(const lines *restrict n, const stretches *restrict s, common_bernsteins *restrict io)
{
    double least[N / 2];
    lane all;

    for (uint32_t i = 0; i < N; i++) {
        const double lo = s->lo[i], hi = s->hi[i], none = s->none[i];
        const double ax = n->ox[i] + n->dx[i] * lo, az = n->oz[i] + n->dz[i] * lo, bx = n->ox[i] + n->dx[i] * hi, bz = n->oz[i] + n->dz[i] * hi;
        const double aa = ax * ax + az * az, ab = ax * bx + az * bz, bb = bx * bx + bz * bz;
        const double c0 = aa - io->b[0][i], c1 = (aa + 2.0 * ab) / 3.0 - io->b[1][i], c2 = (bb + 2.0 * ab) / 3.0 - io->b[2][i], c3 = bb - io->b[3][i];
        const double most = common_greater(common_greater(fabs(c0), fabs(c1)), common_greater(fabs(c2), fabs(c3)));
        const double lowest = common_lesser(common_lesser(c0, c1), common_lesser(c2, c3)), above = lowest > 0.0 ? 1.0 : none;

        io->b[0][i] = above > 0.0 ? 1.0 : c0;
        io->b[1][i] = above > 0.0 ? 1.0 : c1;
        io->b[2][i] = above > 0.0 ? 1.0 : c2;
        io->b[3][i] = above > 0.0 ? 1.0 : c3;
        io->noise[i] = 4.0 * 0x1p-53 * (3 + 1) * most;
        io->beyond[i] = above > 0.0 ? 0.0 : (n->enough[i] - lo) / (hi - lo);
        io->within[i] = -HUGE_VAL;
        all[i] = above;
    }
    for (uint32_t i = 0; i < N / 2; i++)
        least[i] = common_lesser(all[i], all[i + N / 2]);
    return !(common_lesser(common_lesser(least[0], least[1]), common_lesser(least[2], least[3])) > 0.0);
}

/* A crossing at t. Of two that are near each other it is not known which is the first. */
COMMON_INLINE void add(uint32_t i, double found, double t, double off, double feature, sums *restrict io)
{
    const double first = t < io->t[i] ? found : 0.0, near = fabs(t - io->t[i]) > off ? 0.0 : found;

    io->open[i] += near;
    io->t[i] = first > 0.0 ? t : io->t[i];
    io->feature[i] = first > 0.0 ? feature : io->feature[i];
}

COMMON_SEPARATE static void add_piece(const lines *restrict n, const stretches *restrict s, const common_first_of_bernsteins *restrict at, double feature,
                                      sums *restrict io)
{
    for (uint32_t i = 0; i < N; i++) {
        const double lo = s->lo[i], t = lo + at->root[i] * (s->hi[i] - lo);

        io->open[i] += at->open[i];
        add(i, at->found[i], t, 0x1p-40 * (1.0 + fabs(n->base[i])), feature, io);
    }
}

/* The disc at an end. */
COMMON_SEPARATE static void add_cap(const common_revolved_piece *p, bool is_high, const lines *restrict n, double feature, sums *restrict io)
{
    const double height = is_high ? p->high : p->low, square = p->square[is_high ? 3 : 0];

    for (uint32_t i = 0; i < N; i++) {
        const double t = (height - n->oy[i]) / n->dy[i], x = n->ox[i] + n->dx[i] * t, z = n->oz[i] + n->dz[i] * t;
        const double off = 0x1p-40 * (1.0 + fabs(n->base[i]) + fabs(t)), crossed = x * x + z * z < square ? 1.0 : 0.0;

        io->open[i] += fabs(t - n->enough[i]) > 4.0 * off ? 0.0 : crossed;
        add(i, t > n->enough[i] ? crossed : 0.0, t, off, feature, io);
    }
}

COMMON_SEPARATE static void tell(const common_revolved_pieces *s, const common_entries *restrict l, const lines *restrict n, const sums *restrict of,
                                 common_first_crossings *restrict out)
{
    const pov_two low = s->low, high = s->high;
    const double cap = s->cap;

    for (uint32_t i = 0; i < N; i++) {
        const double feature = of->feature[i], is_cap = feature >= cap ? 1.0 : 0.0, to_high = feature > cap ? 1.0 : 0.0;
        const pov_two from = pov_two_of(l->f[2][i], l->f[3][i]), height = pov_two_of(to_high > 0.0 ? high.hi : low.hi, to_high > 0.0 ? high.lo : low.lo);
        const pov_two plane = pov_two_div(pov_two_sub(height, from), pov_two_of(l->d[1][i], l->d_lo[1][i]));
        const pov_two piece = pov_two_sum(n->base[i], of->t[i]);

        out->known[i] = of->open[i] > 0.0 ? 0.0 : of->t[i] < HUGE_VAL ? 1.0 : 0.0;
        out->t[i] = is_cap > 0.0 ? plane.hi : piece.hi;
        out->t_lo[i] = is_cap > 0.0 ? plane.lo : piece.lo;
        out->feature[i] = feature;
        out->u[i] = 0.0;
        out->v[i] = 0.0;
    }
}

void common_revolved_first(const common_revolved_pieces *s, const common_entries *restrict l, common_first_crossings *restrict out)
{
    lines n;
    sums of;

    find_lines(l, &n, &of);
    for (uint32_t k = 0; k < s->count; k++) {
        common_first_of_bernsteins at;
        common_bernsteins all;
        stretches part;
        bool any = false;

        if (!find_stretches(&s->at[k], &n, &part))
            continue;
        for (uint32_t i = 0; i < N; i++)
            any = any || part.inside[i] > 0.0;
        restrict_pieces(&s->at[k], &part, &all);
        if (any)
            restrict_inside(&s->at[k], &part, &all);
        if (!find_equations(&n, &part, &all))
            continue;
        common_bernstein_first_many(&all, 3, &at);
        add_piece(&n, &part, &at, k, &of);
    }
    for (int end = 0; !s->open && end < 2; end++)
        add_cap(&s->at[end ? s->count - 1 : 0], end, &n, (double)s->cap + end, &of);
    tell(s, l, &n, &of, out);
}

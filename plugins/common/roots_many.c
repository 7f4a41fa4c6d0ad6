/* The first roots of four quartics side by side, by the arithmetic of roots.c: of each the piece of its interval that holds the first
 * root is halved. Where another piece has to be looked at again, or another cut is needed, the lane is left open. */
#include "common/roots.h"
#include "common/simd.h"

typedef common_by_quartic four;

/* Lanes that are not `going` are decided. behind: above 0 where pieces follow that may hold a root too. */
typedef struct walk { four b[5], lo, hi, error, behind, going; } walk;

/* Most roots are found after one to three halvings. */
enum { HALVINGS = 8, TURNS = 64 };

/* ---- a lane ---- */

typedef struct quartic { double b0, b1, b2, b3, b4; } quartic;

typedef struct halves { quartic left, right; } halves;

COMMON_INLINE double between(double a, double b) { return a + 0.5 * (b - a); }

COMMON_INLINE halves halve(quartic q)
{
    const double c0 = between(q.b0, q.b1), c1 = between(q.b1, q.b2), c2 = between(q.b2, q.b3), c3 = between(q.b3, q.b4);
    const double d0 = between(c0, c1), d1 = between(c1, c2), d2 = between(c2, c3), e0 = between(d0, d1), e1 = between(d1, d2);
    const double middle = between(e0, e1);
    const halves h = { { q.b0, c0, d0, e0, middle }, { middle, e1, d2, c3, q.b4 } };

    return h;
}

COMMON_INLINE double change_of(double a, double b) { return a * b < 0.0 ? 1.0 : 0.0; }

COMMON_INLINE double changes_of(quartic q)
{
    return change_of(q.b0, q.b1) + change_of(q.b1, q.b2) + change_of(q.b2, q.b3) + change_of(q.b3, q.b4);
}

/* 1 if a sign is not certain. */
COMMON_INLINE double open_of(quartic q, double error)
{
    const double first = common_lesser(fabs(q.b0), fabs(q.b1)), second = common_lesser(fabs(q.b2), fabs(q.b3));
    const double least = common_lesser(common_lesser(first, second), fabs(q.b4));

    return least > error ? 0.0 : 1.0;
}

COMMON_INLINE double largest_of(quartic q)
{
    const double first = common_greater(fabs(q.b0), fabs(q.b1)), second = common_greater(fabs(q.b2), fabs(q.b3));

    return common_greater(common_greater(first, second), fabs(q.b4));
}

COMMON_INLINE quartic piece_of(const walk *w, uint32_t i)
{
    const quartic q = { w->b[0][i], w->b[1][i], w->b[2][i], w->b[3][i], w->b[4][i] };

    return q;
}

COMMON_INLINE void put_piece(walk *w, uint32_t i, quartic q)
{
    w->b[0][i] = q.b0;
    w->b[1][i] = q.b1;
    w->b[2][i] = q.b2;
    w->b[3][i] = q.b3;
    w->b[4][i] = q.b4;
}

COMMON_INLINE quartic choose(double which, quartic a, quartic b)
{
    const quartic q = { which > 0.0 ? a.b0 : b.b0, which > 0.0 ? a.b1 : b.b1, which > 0.0 ? a.b2 : b.b2, which > 0.0 ? a.b3 : b.b3,
                        which > 0.0 ? a.b4 : b.b4 };

    return q;
}

COMMON_INLINE double part(double a, double b, double at) { return a + at * (b - a); }

/* What is behind a fraction of the interval. */
COMMON_INLINE quartic behind_of(quartic q, double at)
{
    const double c0 = part(q.b0, q.b1, at), c1 = part(q.b1, q.b2, at), c2 = part(q.b2, q.b3, at), c3 = part(q.b3, q.b4, at);
    const double d0 = part(c0, c1, at), d1 = part(c1, c2, at), d2 = part(c2, c3, at), e0 = part(d0, d1, at), e1 = part(d1, d2, at);
    const quartic r = { part(e0, e1, at), e1, d2, c3, q.b4 };

    return r;
}

/* The products of bases with zeros are left out. */
COMMON_INLINE void begin(const common_quartics *q, uint32_t i, walk *w, common_first_roots *out)
{
    const double third = 0x1.5555555555555p-2, a0 = q->a[0][i], a1 = q->a[1][i], a2 = q->a[2][i], a3 = q->a[3][i], a4 = q->a[4][i];
    const double sum = fabs(a0) + fabs(a1) + fabs(a2) + fabs(a3) + fabs(a4);
    const quartic all = { a0 - a1 + a2 - a3 + a4, a0 - 0.5 * a1 + 0.5 * a3 - a4, a0 - third * a2 + a4, a0 + 0.5 * a1 - 0.5 * a3 - a4,
                          a0 + a1 + a2 + a3 + a4 };
    const double from = q->from[i], ahead = q->ahead[i], to = q->to[i], across = 2.0 * (ahead - from) + COMMON_ASIDE, at = from + across;
    const double error = q->error[i] + 8.0 * 0x1p-53 * sum, error_ahead = error + 5.0 * 0x1p-53 * largest_of(all);
    const double steepest = ((fabs(a1) + 2.0 * fabs(a2)) + 3.0 * fabs(a3)) + 4.0 * fabs(a4);
    const quartic rest = behind_of(all, 0.5 * (at + 1.0));
    const double sure = fabs(rest.b0) > 2.0 * error_ahead + steepest * across ? 1.0 : 0.0, cut = (int)(ahead > -1.0) & (int)(at < 1.0) ? sure : 0.0;
    const quartic wanted = choose(cut, rest, all);
    const double lo = cut > 0.0 ? at : -1.0, off = cut > 0.0 ? error_ahead : error, aside = (int)(1.0 < from) | (int)(lo > to) ? 1.0 : 0.0;
    const double known = open_of(wanted, off) + aside > 0.0 ? 0.0 : 1.0, changes = known * changes_of(wanted), early = lo > ahead ? 1.0 : 0.0;
    const double many = changes > 1.0 ? 1.0 : 0.0, one = changes == 1.0 ? 1.0 : 0.0, none = changes > 0.0 ? 0.0 : known, found = one * early;

    put_piece(w, i, wanted);
    w->lo[i] = lo;
    w->hi[i] = 1.0;
    w->error[i] = off;
    w->behind[i] = 0.0;
    w->going[i] = many;
    out->open[i] = many + found + none + aside > 0.0 ? 0.0 : 1.0;
    out->found[i] = found;
}

/* Looks at both halves of a lane's piece: the root is in one of them, or the half that may hold it is the next piece. */
COMMON_INLINE void advance(const common_quartics *q, uint32_t i, walk *w, common_first_roots *out)
{
    const quartic all = piece_of(w, i);
    const double lo = w->lo[i], hi = w->hi[i], middle = lo + (hi - lo) * 0.5, from = q->from[i], to = q->to[i], ahead = q->ahead[i];
    const double error = w->error[i] + 5.0 * 0x1p-53 * largest_of(all), going = w->going[i], behind = w->behind[i];
    const double was_open = out->open[i], was_found = out->found[i];
    const halves h = halve(all);
    const double past = (int)(middle < from) | (int)(lo > to) ? 0.0 : 1.0, beside = (int)(hi < from) | (int)(middle > to) ? 0.0 : 1.0;
    const double left = past * changes_of(h.left), left_open = past * open_of(h.left, error);
    const double right = beside * changes_of(h.right), right_open = beside * open_of(h.right, error);
    const double here = left > 0.0 ? left : right, on = left > 0.0 ? lo : middle, off = left > 0.0 ? middle : hi;
    const double one = here == 1.0 ? going : 0.0, late = on > ahead ? 0.0 : one, cut = fabs(h.left.b4) > 2.0 * error ? 0.0 : 1.0;
    const double more = left > 0.0 ? 0.0 : right_open, last = here > 0.0 ? 0.0 : behind, unsure = cut + left_open + more + last + late;
    const double lost = unsure > 0.0 ? going : 0.0, sure = unsure > 0.0 ? 0.0 : going;

    put_piece(w, i, choose(going, choose(left, h.left, h.right), all));
    w->lo[i] = going > 0.0 ? on : lo;
    w->hi[i] = going > 0.0 ? off : hi;
    w->error[i] = error;
    w->behind[i] = behind + (left > 0.0 ? right + right_open : 0.0);
    w->going[i] = here > 1.0 ? sure : 0.0;
    out->open[i] = was_open + lost;
    out->found[i] = was_found + (here == 1.0 ? sure : 0.0);
}

/* Where the polygon of the coefficients, which change their sign once, crosses zero. */
COMMON_INLINE void place(uint32_t i, const walk *w, common_first_roots *out)
{
    const quartic q = piece_of(w, i);
    const double side = q.b0, lo = w->lo[i], hi = w->hi[i];
    const double first = q.b1 * side > 0.0 ? 1.0 : 0.0, second = q.b2 * side > 0.0 ? first : 0.0, third = q.b3 * side > 0.0 ? second : 0.0;
    const double from1 = first > 0.0 ? q.b1 : q.b0, from2 = second > 0.0 ? q.b2 : from1, from = third > 0.0 ? q.b3 : from2;
    const double to1 = first > 0.0 ? q.b2 : q.b1, to2 = second > 0.0 ? q.b3 : to1, to = third > 0.0 ? q.b4 : to2;

    out->lo[i] = lo;
    out->hi[i] = hi;
    out->rise[i] = q.b4 > 0.0 ? 1.0 : -1.0;
    out->x[i] = lo + (hi - lo) * ((first + second + third + from / (from - to)) / 4.0);
}

/* ---- four ---- */

static bool is_any(const double *flags) { return flags[0] + flags[1] + flags[2] + flags[3] > 0.0; }

COMMON_CLONES static void begin_four(const common_quartics *restrict q, walk *restrict w, common_first_roots *restrict out)
{
    for (uint32_t i = 0; i < COMMON_QUARTICS; i++)
        begin(q, i, w, out);
}

COMMON_CLONES static void advance_four(const common_quartics *restrict q, walk *restrict w, common_first_roots *restrict out)
{
    for (uint32_t i = 0; i < COMMON_QUARTICS; i++)
        advance(q, i, w, out);
}

COMMON_CLONES static void place_four(const walk *restrict w, common_first_roots *restrict out)
{
    for (uint32_t i = 0; i < COMMON_QUARTICS; i++)
        place(i, w, out);
}

void common_isolate_four(const common_quartics *q, common_first_roots *out)
{
    walk w;

    begin_four(q, &w, out);
    for (int turn = 0; turn < HALVINGS && is_any(w.going); turn++)
        advance_four(q, &w, out);
    for (uint32_t i = 0; i < COMMON_QUARTICS; i++)
        out->open[i] = w.going[i] > 0.0 ? 1.0 : out->open[i];
    place_four(&w, out);
}

/* ---- the roots ---- */

typedef struct polishing { four lo, hi, going; } polishing;

COMMON_CLONES static void step_four(const common_quartics *restrict q, polishing *restrict p, common_first_roots *restrict io)
{
    static const double SMALL = 0x1p-24;

    COMMON_LOOP for (uint32_t i = 0; i < COMMON_QUARTICS; i++) {
        const double x = io->x[i], going = p->going[i], a0 = q->a[0][i], a1 = q->a[1][i], a2 = q->a[2][i], a3 = q->a[3][i], a4 = q->a[4][i];
        const double v3 = a4 * x + a3, v2 = v3 * x + a2, v1 = v2 * x + a1, value = v1 * x + a0;
        const double s3 = a4 * x + v3, s2 = s3 * x + v2, slope = s2 * x + v1, rise = io->rise[i];
        const double side = value > 0.0 ? rise : -rise, before = p->lo[i], beyond = p->hi[i];
        const double hi = side > 0.0 ? x : beyond, lo = side > 0.0 ? before : x, newton = x - value / slope, middle = 0.5 * (lo + hi);
        const double step = slope != 0.0 ? newton : lo, next = (int)(step > lo) & (int)(step < hi) ? step : middle;

        p->lo[i] = lo;
        p->hi[i] = hi;
        io->x[i] = going > 0.0 ? next : x;
        p->going[i] = fabs(next - x) <= SMALL ? 0.0 : going;
    }
}

void common_polish_four(const common_quartics *q, common_first_roots *io)
{
    polishing p;

    for (uint32_t i = 0; i < COMMON_QUARTICS; i++) {
        p.lo[i] = io->lo[i];
        p.hi[i] = io->hi[i];
        p.going[i] = io->found[i];
    }
    for (int turn = 0; turn < TURNS && is_any(p.going); turn++)
        step_four(q, &p, io);
}

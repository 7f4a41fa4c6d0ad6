#include "common/curve.h"

bool common_spline_read(const pov_host *host, pov_reader *in, common_spline *kind)
{
    static const char *const words[] = { "linear_spline", "quadratic_spline", "cubic_spline", "bezier_spline" };

    for (uint32_t i = 0; i < 4; i++)
        if (host->accept(in, words[i])) {
            *kind = (common_spline)i;
            return true;
        }
    return false;
}

double (*common_points_read(const pov_host *host, pov_reader *in, uint32_t *count))[2]
{
    const double n = floor(host->number(in));
    double (*at)[2];

    *count = 0;
    if (!(n >= 1.0 && n <= 1e6)) {
        host->fail(in, "a spline needs a number of points");
        return NULL;
    }
    at = host->alloc(in, ((uint32_t)n + 1) * sizeof *at);
    for (uint32_t i = 0; at && i < (uint32_t)n; i++) {
        host->accept(in, ",");
        if (!host->more(in)) {
            host->fail(in, "there are fewer points than it says");
            return NULL;
        }
        host->vector_of(in, at[i], 2);
    }
    *count = at ? (uint32_t)n : 0;
    return at;
}

/* Bezier points of one component, `stride` doubles apart. */
static void bezier(common_spline kind, const double *p, double *b)
{
    b[0] = p[0];
    b[1] = b[2] = p[2];
    if (kind == COMMON_QUADRATIC)
        b[1] = p[0] + 0.25 * (p[2] - p[-2]);
    if (kind == COMMON_CUBIC) {
        b[1] = p[0] + (p[2] - p[-2]) / 6.0;
        b[2] = p[2] - (p[4] - p[0]) / 6.0;
        b[3] = p[2];
    }
    if (kind == COMMON_BEZIER) {
        b[2] = p[4];
        b[3] = p[6];
    }
}

common_piece common_spline_piece(common_spline kind, const double (*p)[2])
{
    common_piece c = { kind == COMMON_LINEAR ? 1 : kind == COMMON_QUADRATIC ? 2 : 3, { 0.0 }, { 0.0 } };

    bezier(kind, &p[0][0], c.x);
    bezier(kind, &p[0][1], c.y);
    return c;
}

bool common_sturm_read(const pov_host *host, pov_reader *in)
{
    if (!host->accept(in, "sturm"))
        return false;
    if (host->more(in))
        host->boolean(in);
    return true;
}

#include "media/strata.h"

#include "base/elementary.h"

/* Matter that takes less than this from the light counts as thin: equal lengths are as good. */
static const double thin = 2.0;

/* ---- edges between lo and hi ---- */

/* Without an end half of the edges lie within the scene's own scale. */
static double even_edge(const media_division *by, double u)
{
    const double length = by->hi - by->lo, scale = by->scale > 0.0 ? by->scale : 1.0;

    if (length < MEDIA_ENDLESS)
        return by->lo + u * length;
    return by->lo + scale * u / (1.0 - u * (1.0 - scale / length));
}

static double loss_edge(const media_division *by, double u)
{
    const double all = 1.0 - elementary_exp(-by->loss * (by->hi - by->lo));

    return by->lo - elementary_log(1.0 - u * all) / by->loss;
}

static double angle_edge(const media_division *by, double u)
{
    const double from = elementary_atan2(by->lo - by->middle, by->distance);
    const double to = elementary_atan2(by->hi - by->middle, by->distance), angle = from + u * (to - from);

    return by->middle + by->distance * elementary_sin(angle) / elementary_cos(angle);
}

typedef double edge_fn(const media_division *by, double u);

/* Where nothing but lengths counts. */
static void put_even(const media_division *by, uint32_t cells, media_strata *out)
{
    const double step = (by->hi - by->lo) / (double)cells;

    for (uint32_t i = 1; i < cells; i++)
        out->edge[i] = by->lo + (double)i * step;
    out->count = cells - 1;
}

static void put(const media_division *by, edge_fn *edge, uint32_t cells, media_strata *out)
{
    for (uint32_t i = 1; i < cells; i++) {
        const double at = edge(by, (double)i / (double)cells);
        uint32_t k = ++out->count;

        for (; k > 1 && out->edge[k - 1] > at; k--)
            out->edge[k] = out->edge[k - 1];
        out->edge[k] = at < by->lo ? by->lo : at > by->hi ? by->hi : at;
    }
}

void media_divide(const media_division *by, media_strata *out)
{
    const bool dense = by->loss * (by->hi - by->lo) > thin;
    const uint32_t kinds = 1u + dense + by->has_middle, wanted = by->wanted < MEDIA_STRATA_MAX ? by->wanted : MEDIA_STRATA_MAX;
    const uint32_t each = wanted / kinds;

    out->count = 0;
    out->edge[0] = by->lo;
    if (kinds == 1 && by->hi - by->lo < MEDIA_ENDLESS)
        put_even(by, each, out);
    else
        put(by, even_edge, each, out);
    if (dense)
        put(by, loss_edge, each, out);
    if (by->has_middle)
        put(by, angle_edge, each, out);
    out->edge[++out->count] = by->hi;
}

media_random media_random_of(const media_segment *s)
{
    const double numbers[6] = { s->from.x, s->from.y, s->from.z, s->dir.x, s->dir.y, s->dir.z };
    media_random r = { 0, 0.0 };

    for (int i = 0; i < 6; i++)
        r.key = mix_bits(r.key * 0x9E3779B97F4A7C15u ^ elementary_bits(numbers[i]));
    return r;
}

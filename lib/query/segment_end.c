#include "query/segment_end.h"

#include "query/own_space.h"

/* In double-double, a surface that is nearer to the end than this fraction of the lengths involved lies at the end: the
 * formulas reach 2^-98 of them. Along the ray that is more by the cosine between the two. */
static const double same_end = 0x1p-96;
/* The smallest of these that is told from zero. */
static const double least_cosine = 0x1p-54;

double segment_end_slack(const world *w, const pov_ray *ray, double tmax)
{
    const double size = pov_largest(ray->org) + w->extent;

    return tmax < HUGE_VAL ? same_end * (tmax + size / pov_largest(ray->dir)) : 0.0;
}

/* Does a crossing lie at the end because its surface is met at a small angle? Then the packet's slack is made to cover it. */
static bool covers(packet *p, const pov_crossing *at)
{
    const double gap = (p->tmax - at->t) - at->t_lo;
    double reach = segment_end_slack(p->world, p->rays[0], p->tmax);
    own_space own;

    if (!(gap * least_cosine <= reach))
        return false;
    own_space_of(p->world, at->owner, p->rays[0], &own);
    reach = same_end * (p->tmax + own.size / own.speed);
    if (!(gap * pov_max(own_space_cosine(&own, at), least_cosine) <= reach))
        return false;
    p->slack = pov_max(p->slack, gap * (1.0 + 0x1p-50));
    return true;
}

static bool covers_any(packet *p)
{
    bool any = p->hits[0].count > 0 && covers(p, p->hits[0].at);

    for (uint32_t i = 0; !p->any_blocks && i < p->filter_hits[0].count; i++)
        any |= covers(p, &p->filter_hits[0].at[i]);
    return any;
}

uint64_t segment_end_occlusion(packet *p)
{
    uint64_t blocked;

    p->slack = segment_end_slack(p->world, p->rays[0], p->tmax);
    do {
        packet_begin_light(p, 0);
        p->hits[0].always_exact = true;
        if (!p->any_blocks)
            p->filter_hits[0].always_exact = true;
        blocked = packet_occlusion(p, p->world->kernels->any_single);
    } while (p->slack > 0.0 && covers_any(p));
    return blocked;
}

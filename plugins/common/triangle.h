/* triangle.h - triangles as rays meet them: one alone, or many faces over shared corners.
 *
 * Corners are in scaled units: as written, times a power of two that makes all of them together of the order of one.
 * Which side of an edge a ray passes is decided by the ray and that edge's two corners alone, so no ray passes between
 * two faces that share an edge. */
#ifndef COMMON_TRIANGLE_H
#define COMMON_TRIANGLE_H

#include "common/edges.h"

/* A ray among faces that lie around an anchor. */
typedef struct common_triangle_ray {
    common_view view;
    common_ray about;            /* the ray about the anchor */
    pov_vec3 anchor, org, org_lo;   /* scaled */
    double along;                /* of `about`, to the point that corners are seen from */
} common_triangle_ray;

void common_triangle_enter(common_triangle_ray *r, const pov_ray *ray, pov_vec3 anchor, double scale,
                           bool always_exact);
/* The same in two steps where `about` is there already. The first is all that common_triangle_cross() needs, unless all is to be exact. */
void common_triangle_place(common_triangle_ray *r, const pov_ray *ray, pov_vec3 anchor, double scale);
void common_triangle_look(common_triangle_ray *r, bool always_exact);

/* A corner as the ray sees it. */
static inline common_seen common_triangle_see(common_triangle_ray *r, const pov_vec3 *corner)
{
    return common_view_project(&r->view, pov_sub(*corner, r->anchor), corner);
}

/* Does the line of the ray pass through the triangle? Its edges and corners belong to it, each to one of the faces that
 * share it. */
static inline bool common_triangle_is_passed(common_triangle_ray *r, const pov_vec3 *a, common_seen p, const pov_vec3 *b,
                                             common_seen q, const pov_vec3 *c, common_seen s)
{
    common_view *v = &r->view;
    bool within = false;

    if (p.above == q.above && q.above == s.above)
        return false;
    if (p.above != q.above)
        within = common_view_is_right(v, a, p, b, q);
    if (q.above != s.above)
        within ^= common_view_is_right(v, b, q, c, s);
    if (s.above != p.above)
        within ^= common_view_is_right(v, c, s, a, p);
    return within;
}

/* Are four corners certainly all above or below the ray's level, or all on one side of it? */
static inline bool common_triangle_are_beside(const common_triangle_ray *r, const common_seen s[4])
{
    const double a = s[0].across, b = s[1].across, c = s[2].across, d = s[3].across, error = r->view.error;
    const int above = s[0].above + s[1].above + s[2].above + s[3].above;

    return above == 0 || above == 4 || (a > error && b > error && c > error && d > error) ||
           (a < -error && b < -error && c < -error && d < -error);
}

static inline bool common_triangle_is_hit(common_triangle_ray *r, const pov_vec3 *a, const pov_vec3 *b,
                                          const pov_vec3 *c)
{
    return common_triangle_is_passed(r, a, common_triangle_see(r, a), b, common_triangle_see(r, b), c, common_triangle_see(r, c));
}

/* Report the crossing of a triangle that the line of the ray hits. False: nothing more is wanted. */
bool common_triangle_cross(common_triangle_ray *r, const pov_vec3 *a, const pov_vec3 *b, const pov_vec3 *c,
                           pov_mark mark, pov_hits *hits);

/* A ray and a triangle that its line passes. */
typedef struct common_triangle_pair { const pov_vec3 *corner[3]; const pov_ray *ray; pov_hits *hits; uint32_t feature; } common_triangle_pair;
enum { COMMON_TRIANGLES = 8 };
/* As common_triangle_cross() with each of up to eight pairs, side by side. Corners are read with the double behind them. Returns
 * those that are left open, as bits. */
uint32_t common_triangle_cross_many(const common_triangle_pair *pairs, uint32_t n, double scale);

/* Unit normals of up to eight faces by their corners, as pov_unit() of common_triangle_normal() has them. */
void common_triangle_normals(const pov_vec3 *const corner[COMMON_TRIANGLES][3], uint32_t n, pov_vec3 *const *out);

/* Do the corners lie on a line? */
bool common_triangle_is_degenerate(const pov_vec3 *a, const pov_vec3 *b, const pov_vec3 *c);
/* (c - a) x (b - a), of any length: the corners run clockwise, seen from where it points. */
pov_vec3 common_triangle_normal(const pov_vec3 *a, const pov_vec3 *b, const pov_vec3 *c);
/* Shares of the corners in a point of the triangle; they add up to one. */
void common_triangle_shares(const pov_vec3 *a, const pov_vec3 *b, const pov_vec3 *c, pov_vec3 point, pov_vec3 point_lo,
                            double share[3]);

/* Normals at the corners, blended by the shares in the point: a unit vector. False: it has no direction. */
bool common_triangle_blend(const pov_vec3 normal[3], const double share[3], pov_vec3 *out);

/* A point of a triangle; what is pointed to is read with the double behind it. */
typedef struct common_triangle_point { const pov_vec3 *corner[3], *normal[3]; pov_vec3 point, point_lo; } common_triangle_point;
/* common_triangle_blend() by common_triangle_shares(), bit for bit, for up to eight of them. Returns those with a direction, as bits. */
uint32_t common_triangle_blend_many(const common_triangle_point *at, uint32_t n, pov_vec3 *out);

#endif

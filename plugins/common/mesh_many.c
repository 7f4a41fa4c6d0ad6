/* Rays and a mesh, up to 64 of them side by side.
 *
 * Floats tell of most faces that a line misses them or certainly passes them, and between which distances. So of the nearest
 * face that is certainly passed only that is noted while the rays go through the hierarchy; where it is crossed is computed at
 * the end, for several rays at once. What floats leave open is decided at once. */
#include "common/mesh.h"

#include "common/report.h"
#include "common/simd.h"

#if defined(__GNUC__)
#define COMMON_PREFETCH(address) __builtin_prefetch(address)
#else
#define COMMON_PREFETCH(address) ((void)(address))
#endif

enum { LINE = 16 };              /* floats of a cache line */

/* A face that a ray certainly passes, no nearer than lo. */
typedef struct deferred { uint32_t face; double lo; } deferred;

typedef struct search {
    const common_mesh *mesh;
    const pov_ray *const *rays;
    pov_hits *const *hits;
    common_face_views views;
    double limit[POV_RAYS_MAX];
    uint32_t left[POV_RAYS_MAX];   /* the face that the ray starts on, or none */
    uint64_t entered, waiting;     /* rays of `exact`, and of `deferred` */
    uint64_t done;                 /* rays that want no more */
    bool defers;
    deferred deferred[POV_RAYS_MAX];
    common_triangle_ray exact[POV_RAYS_MAX];
} search;

static inline uint64_t bit_of(uint32_t i) { return (uint64_t)1 << i; }

static const pov_vec3 *corner_of(const common_mesh *m, uint32_t face, int i)
{
    return &m->corners[m->faces[face].at[i]];
}

/* ---- one ray ---- */

static common_triangle_ray *enter(search *s, uint32_t i)
{
    if (!(s->entered & bit_of(i))) {
        s->entered |= bit_of(i);
        common_triangle_enter(&s->exact[i], s->rays[i], s->mesh->anchor, s->mesh->scale, s->hits[i]->unfiltered);
    }
    return &s->exact[i];
}

/* passed: that the line passes the face is known. */
static void test_face(search *s, uint32_t i, uint32_t face, bool passed)
{
    const common_mesh *m = s->mesh;
    const pov_vec3 *a = corner_of(m, face, 0), *b = corner_of(m, face, 1), *c = corner_of(m, face, 2);
    common_triangle_ray *r = enter(s, i);

    r->view.escalated = false;
    if ((passed || common_triangle_is_hit(r, a, b, c)) && !common_triangle_cross(r, a, b, c, common_mark(face, 0), s->hits[i]))
        s->done |= bit_of(i);
    s->hits[i]->escalated += r->view.escalated;
}

/* ---- leaves ---- */

/* A face that is certainly passed. What was deferred before is tested at once if it may be the nearer one. */
static void defer(search *s, uint32_t i, uint32_t face, double lo, double hi)
{
    deferred *d = &s->deferred[i];

    if (hi < s->limit[i])
        s->limit[i] = hi;
    if ((s->waiting & bit_of(i)) && d->lo <= s->limit[i])
        test_face(s, i, d->face, true);
    d->face = face;
    d->lo = lo;
    s->waiting |= bit_of(i);
    COMMON_PREFETCH(&s->mesh->faces[face]);
}

/* Is it enough that the face is passed between these distances? Of any crossing, and of the number of them, it does not matter where
 * they are. */
static inline bool is_enough(const pov_hits *hits, double lo, double hi)
{
    return (hits->want == POV_WANT_ANY || hits->count_only) && lo > hits->tmin && hi < hits->tmax - hits->slack;
}

/* A face that is certainly passed, between these distances. */
static void take_sure(search *s, uint32_t i, uint32_t face, double lo, double hi)
{
    pov_hits *hits = s->hits[i];

    if (lo > s->limit[i] || hi < hits->tmin)
        return;
    if (s->defers && lo > hits->tmin)
        defer(s, i, face, lo, hi);
    else if (!is_enough(hits, lo, hi))
        test_face(s, i, face, true);
    else if (!pov_cross(hits, lo, 0.0, common_mark(face, 0)))
        s->done |= bit_of(i);
}

static void take_faces(search *s, uint32_t i, uint32_t first, const common_face_found *found)
{
    const double near = s->views.near[i], pace = s->views.pace[i];
    uint32_t maybe;

    for (maybe = found->maybe; maybe && !(s->done & bit_of(i)); maybe &= maybe - 1) {
        const uint32_t lane = common_first_lane(maybe), face = first + lane;
        const double a = (double)found->lo[lane] * pace, b = (double)found->hi[lane] * pace;
        const double off = (fabs(near) + fabs(a) + fabs(b)) * 0x1p-46;

        if (face == s->left[i])
            continue;
        if (found->sure >> lane & 1)
            take_sure(s, i, face, near + common_lesser(a, b) - off, near + common_greater(a, b) + off);
        else
            test_face(s, i, face, false);
    }
}

/* Most blocks that a ray comes to have no face that it may pass; where the nearest is sought more have one. */
static void visit_face(search *s, uint32_t i, uint32_t first, uint32_t count, const float *block, uint32_t k)
{
    common_face_found found;

    if (!s->defers && !common_face_find_any(block, count, k, &s->views, i))
        return;
    common_face_find(block, count, k, &s->views, i, &found);
    if (found.maybe)
        take_faces(s, i, first + k, &found);
}

/* Blocks stand in the order of the hierarchy's leaves: behind one is often the next that is asked for. */
COMMON_INLINE void fetch_block(const float *block)
{
    for (uint32_t i = 0; i < COMMON_FACE_ROWS * POV_BLOCK_MAX; i += LINE)
        COMMON_PREFETCH(block + i);
}

static uint64_t visit_faces(void *user, uint32_t first, uint32_t count, uint64_t rays, uint64_t *lowered)
{
    search *s = user;
    const float *block = s->mesh->blocks + (size_t)COMMON_FACE_ROWS * first;
    const uint64_t all = rays;

    fetch_block(block + COMMON_FACE_ROWS * count);
    for (; rays; rays &= rays - 1) {
        const uint32_t i = common_first_lane64(rays);
        const double before = s->limit[i];

        for (uint32_t k = 0; k < count; k += POV_BLOCK_MAX)
            visit_face(s, i, first, count, block, k);
        if (s->hits[i]->tmax < s->limit[i])
            s->limit[i] = s->hits[i]->tmax;
        *lowered |= s->limit[i] < before ? bit_of(i) : 0;
    }
    return s->done & all;
}

/* ---- the whole ---- */

static void begin(search *s, uint32_t n)
{
    const common_mesh *m = s->mesh;

    s->entered = s->waiting = s->done = 0;
    s->defers = s->hits[0]->want == POV_WANT_NEAREST;
    common_face_views_make(&s->views, s->rays, n, m->anchor, m->scale);
    for (uint32_t i = 0; i < n; i++) {
        const pov_ray *ray = s->rays[i];

        s->left[i] = ray->origin_surface == s->hits[i]->owner ? ray->origin_mark.feature : m->face_count;
        s->limit[i] = s->hits[i]->tmax;
        if (s->hits[i]->always_exact)
            s->views.error[i] = HUGE_VALF;
        else if (!(s->views.error[i] < HUGE_VALF)) {
            const common_triangle_ray *r = enter(s, i);

            common_face_views_set(&s->views, i, &r->view, r->along, r->about.unit);
        }
    }
}

/* Corners come from anywhere in memory: those of all faces that wait are asked for before the first is needed. */
static void fetch_corners(const search *s)
{
    for (uint64_t rest = s->waiting; rest; rest &= rest - 1)
        for (int k = 0; k < 3; k++)
            COMMON_PREFETCH(corner_of(s->mesh, s->deferred[common_first_lane64(rest)].face, k));
}

/* Where the faces that wait are crossed. */
static void end(search *s)
{
    const common_mesh *m = s->mesh;
    common_triangle_pair pairs[COMMON_TRIANGLES];
    uint8_t of[COMMON_TRIANGLES];

    fetch_corners(s);
    while (s->waiting) {
        uint32_t n = 0, open;

        for (; s->waiting && n < COMMON_TRIANGLES; s->waiting &= s->waiting - 1) {
            const uint32_t i = common_first_lane64(s->waiting), face = s->deferred[i].face;

            if (s->deferred[i].lo > s->limit[i])
                continue;
            for (int k = 0; k < 3; k++)
                pairs[n].corner[k] = corner_of(m, face, k);
            pairs[n].ray = s->rays[i];
            pairs[n].hits = s->hits[i];
            pairs[n].feature = face;
            of[n++] = (uint8_t)i;
        }
        for (open = n > 0 ? common_triangle_cross_many(pairs, n, m->scale) : 0; open; open &= open - 1)
            test_face(s, of[common_first_lane(open)], pairs[common_first_lane(open)].feature, true);
    }
}

static void intersect(const common_mesh *m, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    search s;

    s.mesh = m;
    s.rays = rays;
    s.hits = hits;
    begin(&s, n);
    m->tree->visit_rays(m->tree, rays, n, s.limit, s.defers, visit_faces, &s);
    end(&s);
}

void common_mesh_intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const common_mesh *m = self;

    if (m->face_count > 0)
        intersect(m, &ray, &hits, 1);
}

/* Pairs of one mesh and of one kind of question go together. */
void common_mesh_intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    uint32_t some;

    for (; n > 0; n -= some, selves += some, rays += some, hits += some) {
        const common_mesh *m = selves[0];

        for (some = 1; some < n && some < POV_RAYS_MAX && selves[some] == m && hits[some]->want == hits[0]->want; some++)
            ;
        if (m->face_count > 0)
            intersect(m, rays, hits, some);
    }
}

static const pov_shape_fast mesh_fast = {
    .size = sizeof(pov_shape_fast),
    .intersect_many = common_mesh_intersect_many,
    .intersect_between = common_mesh_intersect,
    .intersect_between_many = common_mesh_intersect_many,
    .normal_many = common_mesh_normal_many,
    .shading_normals_many = common_mesh_shading_normals_many,
};

const void *common_mesh_extension(const char *name) { return common_is_fast(name) ? &mesh_fast : NULL; }

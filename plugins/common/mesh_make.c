/* Meshes from what was read: faces in the order of a hierarchy, in memory of their size. */
#include "common/mesh.h"

void common_mesh_drop(common_mesh_parts *p, const pov_host *host, pov_reader *in)
{
    void *const all[] = { p->corners, p->faces, p->normals, p->normal_faces, p->uvs, p->uv_faces, p->textures };
    size_t i;

    for (i = 0; i < sizeof all / sizeof *all; i++)
        if (all[i])
            host->resize(in, all[i], 0);
    memset(p, 0, sizeof *p);
}

/* ---- the size ---- */

/* Corners that are no numbers lie in any box. */
static void find_box(common_mesh *m, const common_mesh_parts *p)
{
    pov_vec3 lo = pov_vec3_of(HUGE_VAL, HUGE_VAL, HUGE_VAL), hi = pov_scale(lo, -1.0);
    uint32_t i;
    int k;

    for (i = 0; i < p->face_count; i++)
        for (k = 0; k < 3; k++) {
            const pov_vec3 v = p->corners[p->faces[i].at[k]];

            lo = pov_vec3_of(v.x < lo.x ? v.x : lo.x, v.y < lo.y ? v.y : lo.y, v.z < lo.z ? v.z : lo.z);
            hi = pov_vec3_of(v.x > hi.x ? v.x : hi.x, v.y > hi.y ? v.y : hi.y, v.z > hi.z ? v.z : hi.z);
        }
    m->box.lo = lo;
    m->box.hi = hi;
    m->scale = pov_inverse_power(pov_largest(pov_sub(pov_scale(hi, 0.5), pov_scale(lo, 0.5))));
    m->anchor = pov_scale(pov_add(pov_scale(lo, 0.5), pov_scale(hi, 0.5)), m->scale);
}

static void scale_corners(const common_mesh *m, common_mesh_parts *p)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    uint32_t i;

    for (i = 0; i < p->corner_count; i++)   /* of two zeros the positive one */
        p->corners[i] = pov_add(pov_scale(p->corners[i], m->scale), zero);
}

/* ---- faces ---- */

static void move_face(common_face *of, uint32_t from, uint32_t to)
{
    if (of)
        of[to] = of[from];
}

/* Leave out faces whose corners lie on a line, or are no numbers. */
static void drop_degenerate(common_mesh_parts *p)
{
    uint32_t i, kept = 0;

    for (i = 0; i < p->face_count; i++) {
        const uint32_t *at = p->faces[i].at;

        if (common_triangle_is_degenerate(&p->corners[at[0]], &p->corners[at[1]], &p->corners[at[2]]))
            continue;
        move_face(p->faces, i, kept);
        move_face(p->normal_faces, i, kept);
        move_face(p->uv_faces, i, kept);
        move_face(p->textures, i, kept);
        kept++;
    }
    p->face_count = kept;
}

/* ---- is it closed? ---- */

static uint64_t mix(uint64_t a, uint64_t b)
{
    a = (a ^ b) * 0x9e3779b97f4a7c15;
    a = (a ^ a >> 32) * 0xd6e8feb86659fd93;
    return a ^ a >> 29;
}

static uint64_t hash_of(const pov_vec3 *v)
{
    uint64_t bits[3];

    memcpy(bits, v, sizeof bits);
    return mix(mix(mix(0x5851f42d4c957f2d, bits[0]), bits[1]), bits[2]);
}

/* If each edge belongs to an even number of faces, then so many crossings has every line. The hashes of edges that occur
 * in pairs cancel out. */
static bool is_closed(const common_mesh_parts *p)
{
    uint64_t all[2] = { 0, 0 };
    uint32_t i;
    int k;

    for (i = 0; i < p->face_count; i++)
        for (k = 0; k < 3; k++) {
            const uint64_t a = hash_of(&p->corners[p->faces[i].at[k]]);
            const uint64_t b = hash_of(&p->corners[p->faces[i].at[(k + 1) % 3]]);

            if (a == b)
                continue;
            all[0] ^= mix(a < b ? a : b, a < b ? b : a);
            all[1] ^= mix(a < b ? b : a, (a < b ? a : b) + 1);
        }
    return all[0] == 0 && all[1] == 0;
}

/* ---- the hierarchy ---- */

typedef struct boxing { const common_mesh_parts *parts; double back; } boxing;

static double least(double a, double b, double c) { return a < b ? (a < c ? a : c) : b < c ? b : c; }

static void box_of_face(void *user, uint32_t face, pov_box *out)
{
    const boxing *b = user;
    const uint32_t *at = b->parts->faces[face].at;
    const pov_vec3 p = b->parts->corners[at[0]], q = b->parts->corners[at[1]], r = b->parts->corners[at[2]];

    out->lo = pov_vec3_of(least(p.x, q.x, r.x), least(p.y, q.y, r.y), least(p.z, q.z, r.z));
    out->hi = pov_vec3_of(-least(-p.x, -q.x, -r.x), -least(-p.y, -q.y, -r.y), -least(-p.z, -q.z, -r.z));
    out->lo = pov_scale(out->lo, b->back);
    out->hi = pov_scale(out->hi, b->back);
}

/* ---- in memory that stays ---- */

typedef struct making {
    const pov_host *host;
    pov_reader *in;
    uint32_t *order, count;
    uint32_t *now, corners;      /* by corner of the text, where it stands now, or NOWHERE; how many there are */
} making;

#define NOWHERE 0xffffffffu

/* What has been copied is not needed any more: no two of these are there at once. */
static void *drop(const making *k, void *of)
{
    return of ? k->host->resize(k->in, of, 0) : NULL;
}

/* Corners stand in the order in which the hierarchy's leaves meet them first: those of near faces are near each other. */
static void order_corners(making *k, const common_mesh_parts *p)
{
    k->now = k->host->resize(k->in, NULL, p->corner_count * sizeof *k->now);
    if (!k->now)
        return;
    memset(k->now, 0xff, p->corner_count * sizeof *k->now);
    for (uint32_t i = 0; i < k->count; i++)
        for (int j = 0; j < 3; j++) {
            uint32_t *now = &k->now[p->faces[k->order[i]].at[j]];

            if (*now == NOWHERE)
                *now = k->corners++;
        }
}

/* What is at corners, in their order. */
static const void *keep_at_corners(const making *k, const void *of, uint32_t count, size_t bytes)
{
    unsigned char *kept = of && k->now ? k->host->alloc(k->in, k->corners * bytes + sizeof(double)) : NULL;

    for (uint32_t i = 0; kept && i < count; i++)
        if (k->now[i] != NOWHERE)
            memcpy(kept + k->now[i] * bytes, (const unsigned char *)of + i * bytes, bytes);
    return kept;
}

/* Rows by face, in the hierarchy's order. */
static const common_face *keep_faces(const making *k, const common_face *of)
{
    common_face *kept = of ? k->host->alloc(k->in, (size_t)k->count * sizeof *kept) : NULL;
    uint32_t i;

    for (i = 0; kept && i < k->count; i++)
        kept[i] = of[k->order[i]];
    return kept;
}

/* The same, of corners. */
static const common_face *keep_corner_faces(const making *k, const common_face *of)
{
    common_face *kept = k->now ? k->host->alloc(k->in, (size_t)k->count * sizeof *kept) : NULL;

    for (uint32_t i = 0; kept && i < k->count; i++)
        for (int j = 0; j < 3; j++)
            kept[i].at[j] = k->now[of[k->order[i]].at[j]];
    return kept;
}

/* With room for a double behind them, which may be read. */
static const void *keep_bytes(const making *k, const void *of, uint32_t count, size_t bytes)
{
    void *kept = of ? k->host->alloc(k->in, count * bytes + sizeof(double)) : NULL;

    if (kept)
        memcpy(kept, of, count * bytes);
    return kept;
}

/* Blocks of the leaves' faces. */
typedef struct filling { const common_mesh *mesh; float *blocks; } filling;

static bool fill_block(void *user, uint32_t first, uint32_t count)
{
    const filling *f = user;
    const common_mesh *m = f->mesh;
    uint32_t i;

    for (i = 0; i < count; i++) {
        const uint32_t *at = m->faces[first + i].at;

        common_face_put(f->blocks + (size_t)COMMON_FACE_ROWS * first, count, i, pov_sub(m->corners[at[0]], m->anchor),
                        pov_sub(m->corners[at[1]], m->anchor), pov_sub(m->corners[at[2]], m->anchor));
    }
    return true;
}

static void keep_blocks(common_mesh *m, const making *k)
{
    const size_t floats = (size_t)COMMON_FACE_ROWS * k->count + COMMON_FACE_PAD;
    filling f = { m, m->corners && m->faces ? k->host->alloc(k->in, floats * sizeof(float)) : NULL };

    if (f.blocks)
        m->tree->each_range(m->tree, fill_block, &f);
    m->blocks = f.blocks;
}

/* Where each face of the text is now: the order turned round in its own memory. What is done has a mark. */
static void keep_places(common_mesh *m, const making *k)
{
    const uint32_t mark = 0x80000000u;
    uint32_t i;

    for (i = 0; i < k->count; i++) {
        uint32_t before = i, at = k->order[i];

        if (at & mark)
            continue;
        while (at != i) {
            const uint32_t next = k->order[at];

            k->order[at] = before | mark;
            before = at;
            at = next;
        }
        k->order[i] = before | mark;
    }
    for (i = 0; i < k->count; i++)
        k->order[i] &= ~mark;
    m->places = k->order;
}

static void keep(common_mesh *m, common_mesh_parts *p, making *k)
{
    order_corners(k, p);
    m->corners = keep_at_corners(k, p->corners, p->corner_count, sizeof *p->corners);
    p->corners = drop(k, p->corners);
    m->faces = keep_corner_faces(k, p->faces);
    p->faces = drop(k, p->faces);
    m->normals = p->normal_faces ? keep_bytes(k, p->normals, p->normal_count, sizeof *p->normals)
                                 : keep_at_corners(k, p->normals, p->normal_count, sizeof *p->normals);
    p->normals = drop(k, p->normals);
    m->normal_faces = p->normal_faces ? keep_faces(k, p->normal_faces) : m->faces;
    p->normal_faces = drop(k, p->normal_faces);
    m->uvs = p->uv_faces ? keep_bytes(k, p->uvs, p->uv_count, sizeof *p->uvs) : keep_at_corners(k, p->uvs, p->uv_count, sizeof *p->uvs);
    p->uvs = drop(k, p->uvs);
    m->uv_faces = p->uv_faces ? keep_faces(k, p->uv_faces) : m->faces;
    p->uv_faces = drop(k, p->uv_faces);
    k->now = drop(k, k->now);
    m->textures = keep_faces(k, p->textures);
    p->textures = drop(k, p->textures);
    keep_places(m, k);
    keep_blocks(m, k);
    m->face_count = m->blocks ? p->face_count : 0;
}

static void find_turned(common_mesh *m, const making *k)
{
    uint8_t *turned = k->host->alloc(k->in, m->face_count / 8 + 1);
    uint32_t i;

    for (i = 0; turned && i < m->face_count; i++)
        turned[i / 8] |= (uint8_t)(common_mesh_is_turned(m, i) << i % 8);
    m->turned = turned;
}

void common_mesh_make(common_mesh *m, common_mesh_parts *p, const pov_host *host, pov_reader *in)
{
    making k = { .host = host, .in = in };
    uint32_t *order = NULL;

    if (p->face_count > 0) {
        find_box(m, p);
        scale_corners(m, p);
        drop_degenerate(p);
    }
    if (p->face_count == 0)
        host->fail(in, "there are no triangles in this mesh");
    else
        order = host->alloc(in, p->face_count * sizeof *order);
    if (order) {
        boxing boxes = { p, 1.0 / m->scale };

        m->tree = host->hierarchy_in_order(in, p->face_count, box_of_face, &boxes, order);
        m->toward = p->toward;
        m->closed = pov_largest(p->toward) > 0.0 && is_closed(p);
        k.order = order;
        k.count = p->face_count;
        if (m->tree)
            keep(m, p, &k);
        if (pov_largest(m->toward) > 0.0)
            find_turned(m, &k);
    }
    common_mesh_drop(p, host, in);
}

/* mesh { triangle { } or smooth_triangle { } ... [inside_vector V] }: corners, normals and uv vectors that are equal are
 * stored once. */
#include "common/mesh.h"

/* Equal items of a list, by a hash table of their numbers + 1. */
typedef struct pool {
    double *items;
    uint32_t *slots;
    uint32_t size;               /* doubles of an item */
    uint32_t count, capacity, slot_count;   /* slots: a power of two */
} pool;

typedef struct reading {
    const pov_host *host;
    pov_reader *in;
    pool corners, normals, uvs;
    common_face *faces, *normal_faces, *uv_faces, *textures;
    uint32_t count, capacity;
    bool any_normal, any_uv, any_texture;
    pov_vec3 toward;
} reading;

static const common_face none = { { COMMON_NO_TEXTURE, COMMON_NO_TEXTURE, COMMON_NO_TEXTURE } };

/* ---- pools ---- */

static uint32_t hash_of(const double *item, uint32_t size)
{
    uint64_t hash = 0x5851f42d4c957f2d, bits;
    uint32_t i;

    for (i = 0; i < size; i++) {
        memcpy(&bits, &item[i], sizeof bits);
        hash = (hash ^ bits) * 0x9e3779b97f4a7c15;
        hash ^= hash >> 32;
    }
    return (uint32_t)(hash ^ hash >> 16);
}

static uint32_t *slot_of(const pool *p, const double *item)
{
    uint32_t i = hash_of(item, p->size) & (p->slot_count - 1);

    while (p->slots[i] > 0 &&
           memcmp(p->items + (size_t)(p->slots[i] - 1) * p->size, item, p->size * sizeof *item) != 0)
        i = (i + 1) & (p->slot_count - 1);
    return &p->slots[i];
}

/* Twice the room. The slots are at most half full. */
static bool grow_pool(reading *r, pool *p)
{
    const uint32_t capacity = p->capacity > 0 ? 2 * p->capacity : 1024;
    uint32_t i;

    p->items = r->host->resize(r->in, p->items, (size_t)capacity * p->size * sizeof *p->items);
    p->slots = r->host->resize(r->in, p->slots, (size_t)capacity * 2 * sizeof *p->slots);
    if (!p->items || !p->slots)
        return false;
    p->capacity = capacity;
    p->slot_count = 2 * capacity;
    memset(p->slots, 0, (size_t)p->slot_count * sizeof *p->slots);
    for (i = 0; i < p->count; i++)
        *slot_of(p, p->items + (size_t)i * p->size) = i + 1;
    return true;
}

/* The number of an item. */
static uint32_t pool_add(reading *r, pool *p, const double *item)
{
    uint32_t *slot;

    if (p->count == p->capacity && !grow_pool(r, p))
        return 0;
    slot = slot_of(p, item);
    if (*slot == 0) {
        memcpy(p->items + (size_t)p->count * p->size, item, p->size * sizeof *item);
        *slot = ++p->count;
    }
    return *slot - 1;
}

static uint32_t add_vector(reading *r, pool *p, pov_vec3 v)
{
    const double item[3] = { v.x + 0.0, v.y + 0.0, v.z + 0.0 };   /* of two zeros the positive one */

    return pool_add(r, p, item);
}

static void *drop_slots(reading *r, pool *p)
{
    if (p->slots)
        r->host->resize(r->in, p->slots, 0);
    return p->items;
}

/* ---- faces ---- */

static common_face *grow_faces(reading *r, common_face *of, uint32_t capacity)
{
    return r->host->resize(r->in, of, (size_t)capacity * sizeof *of);
}

/* Room for one more face. */
static bool make_room(reading *r)
{
    const uint32_t capacity = r->capacity > 0 ? 2 * r->capacity : 1024;

    if (r->count < r->capacity)
        return true;
    r->faces = grow_faces(r, r->faces, capacity);
    r->normal_faces = grow_faces(r, r->normal_faces, capacity);
    r->uv_faces = grow_faces(r, r->uv_faces, capacity);
    r->textures = grow_faces(r, r->textures, capacity);
    r->capacity = capacity;
    return r->faces && r->normal_faces && r->uv_faces && r->textures;
}

static pov_vec3 read_vector(reading *r)
{
    pov_vec3 v;

    r->host->vector(r->in, &v);
    return v;
}

static void read_corners(reading *r, bool smooth)
{
    common_face *face = &r->faces[r->count], *normals = &r->normal_faces[r->count];
    int i;

    for (i = 0; i < 3; i++) {
        if (i > 0)
            r->host->accept(r->in, ",");
        face->at[i] = add_vector(r, &r->corners, read_vector(r));
        if (!smooth)
            continue;
        r->host->accept(r->in, ",");
        normals->at[i] = add_vector(r, &r->normals, pov_unit(read_vector(r)));
    }
    r->any_normal |= smooth;
}

static void read_uvs(reading *r)
{
    common_face *face = &r->uv_faces[r->count];
    double uv[2];
    int i;

    for (i = 0; i < 3; i++) {
        if (i > 0)
            r->host->accept(r->in, ",");
        r->host->vector_of(r->in, uv, 2);
        face->at[i] = pool_add(r, &r->uvs, uv);
    }
    r->any_uv = true;
}

/* texture { }, or texture_list { } with one for each corner. */
static void read_textures(reading *r)
{
    common_face *face = &r->textures[r->count];
    int i;

    if (r->host->accept(r->in, "texture_list")) {
        r->host->expect(r->in, "{");
        for (i = 0; i < 3; i++) {
            face->at[i] = r->host->texture(r->in);
            r->host->accept(r->in, ",");
        }
        r->host->expect(r->in, "}");
        r->any_texture = true;
    } else if (r->host->next_is(r->in, "texture")) {
        face->at[0] = face->at[1] = face->at[2] = r->host->texture(r->in);
        r->any_texture = true;
    }
}

static bool is_degenerate(const reading *r)
{
    const pov_vec3 *corners = (const pov_vec3 *)(const void *)r->corners.items;
    const uint32_t *at = r->faces[r->count].at;

    return common_triangle_is_degenerate(&corners[at[0]], &corners[at[1]], &corners[at[2]]);
}

static void read_face(reading *r, bool smooth)
{
    r->host->expect(r->in, "{");
    if (!make_room(r))
        return;
    r->normal_faces[r->count] = r->uv_faces[r->count] = r->textures[r->count] = none;
    read_corners(r, smooth);
    if (!r->corners.items || (smooth && !r->normals.items))
        return;
    if (r->host->accept(r->in, "uv_vectors"))
        read_uvs(r);
    read_textures(r);
    r->host->expect(r->in, "}");
    if (is_degenerate(r))
        r->host->warn(r->in, "the corners of this triangle lie on a line: it is left out");
    else
        r->count++;
}

/* ---- the whole ---- */

static common_face *take_if(reading *r, bool any, common_face *of)
{
    if (!any && of)
        r->host->resize(r->in, of, 0);
    return any ? of : NULL;
}

static void make(void *self, reading *r)
{
    common_mesh_parts p;

    memset(&p, 0, sizeof p);
    p.corners = drop_slots(r, &r->corners);
    p.corner_count = r->corners.count;
    p.normals = drop_slots(r, &r->normals);
    p.normal_count = r->normals.count;
    p.uvs = drop_slots(r, &r->uvs);
    p.uv_count = r->uvs.count;
    p.faces = r->faces;
    p.face_count = r->corners.items && r->faces ? r->count : 0;
    p.normal_faces = take_if(r, r->any_normal, r->normal_faces);
    p.uv_faces = take_if(r, r->any_uv, r->uv_faces);
    p.textures = take_if(r, r->any_texture, r->textures);
    p.toward = r->toward;
    common_mesh_make(self, &p, r->host, r->in);
}

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    reading r;

    memset(&r, 0, sizeof r);
    r.host = host;
    r.in = in;
    r.corners.size = r.normals.size = 3;
    r.uvs.size = 2;
    for (;;) {
        if (host->accept(in, "triangle"))
            read_face(&r, false);
        else if (host->accept(in, "smooth_triangle"))
            read_face(&r, true);
        else
            break;
    }
    if (host->accept(in, "inside_vector"))
        host->vector(in, &r.toward);
    make(self, &r);
}

static const pov_shape_class mesh_class = COMMON_MESH_CLASS("mesh", parse);

static const pov_shape_class *const shapes[] = { &mesh_class, NULL };

POV_PLUGIN(mesh) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "mesh",
    .version = "1",
    .shapes = shapes,
};

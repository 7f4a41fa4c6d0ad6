/* mesh2 { vertex_vectors { n, ... } [normal_vectors { }] [uv_vectors { }] [texture_list { }] face_indices { n, ... }
 * [normal_indices { }] [uv_indices { }] [inside_vector V] } */
#include "common/mesh.h"

typedef struct reading {
    const pov_host *host;
    pov_reader *in;
    common_mesh_parts parts;
    uint32_t *textures;          /* numbers of the textures of the list */
    uint32_t texture_count, normal_face_count, uv_face_count;
    bool has_normal_faces;
} reading;

static const common_face none = { { COMMON_NO_TEXTURE, COMMON_NO_TEXTURE, COMMON_NO_TEXTURE } };

/* ---- lists ---- */

/* A list grows with what there is to read: a scene may claim any number. */
enum { LIKELY = 1 << 16 };

typedef struct list { void *items; size_t bytes; uint32_t count, capacity; } list;

static uint32_t begin_list(reading *r, const char *what)
{
    double n;

    r->host->expect(r->in, "{");
    n = r->host->number(r->in);
    r->host->accept(r->in, ",");
    if (!(n >= 0.0 && n <= 0x1p30 && n == floor(n)))
        r->host->fail(r->in, "the number of %s must be a whole number", what);
    return n >= 0.0 && n <= 0x1p30 ? (uint32_t)n : 0;
}

/* The place of the next item of a list of n; NULL: the reader has failed. */
static void *next_item(reading *r, list *l, uint32_t n)
{
    if (l->count == l->capacity) {
        const uint32_t wanted = l->capacity > 0 ? 2 * l->capacity : LIKELY, capacity = wanted < n ? wanted : n;

        l->items = r->host->resize(r->in, l->items, capacity * l->bytes);
        l->capacity = l->items ? capacity : 0;
    }
    return l->items ? (char *)l->items + l->bytes * l->count++ : NULL;
}

static bool follows(reading *r, uint32_t count, uint32_t n, const char *what)
{
    pov_vec3 missing;

    r->host->accept(r->in, ",");
    if (r->host->more(r->in))
        return true;
    r->host->vector(r->in, &missing);   /* fails where there is no value */
    r->host->fail(r->in, "there are %u of %u %s", count, n, what);
    return false;
}

static list read_vectors(reading *r, const char *what)
{
    list l = { NULL, sizeof(pov_vec3), 0, 0 };
    const uint32_t n = begin_list(r, what);
    pov_vec3 *v;

    while (l.count < n && follows(r, l.count, n, what) && (v = next_item(r, &l, n)))
        r->host->vector(r->in, v);
    r->host->accept(r->in, ",");
    r->host->expect(r->in, "}");
    return l;
}

/* A section may be written twice: the last one counts. */
static void *replace(reading *r, void *before, void *now)
{
    if (before)
        r->host->resize(r->in, before, 0);
    return now;
}

static void take_corners(reading *r)
{
    const list l = read_vectors(r, "corners");

    r->parts.corners = replace(r, r->parts.corners, l.items);
    r->parts.corner_count = l.count;
}

static void take_normals(reading *r)
{
    const list l = read_vectors(r, "normals");
    uint32_t i;

    r->parts.normals = replace(r, r->parts.normals, l.items);
    r->parts.normal_count = l.items ? l.count : 0;
    for (i = 0; i < r->parts.normal_count; i++)
        r->parts.normals[i] = pov_unit(r->parts.normals[i]);
}

static void take_uvs(reading *r)
{
    list l = { NULL, sizeof(common_uv), 0, 0 };
    const uint32_t n = begin_list(r, "uv vectors");
    common_uv *uv;
    double two[2];

    while (l.count < n && follows(r, l.count, n, "uv vectors") && (uv = next_item(r, &l, n))) {
        r->host->vector_of(r->in, two, 2);
        uv->u = two[0];
        uv->v = two[1];
    }
    r->host->accept(r->in, ",");
    r->host->expect(r->in, "}");
    r->parts.uvs = replace(r, r->parts.uvs, l.items);
    r->parts.uv_count = l.count;
}

static void take_textures(reading *r)
{
    list l = { NULL, sizeof(uint32_t), 0, 0 };
    const uint32_t n = begin_list(r, "textures");
    uint32_t *which;

    while (l.count < n && (which = next_item(r, &l, n))) {
        *which = r->host->texture(r->in);
        r->host->accept(r->in, ",");
    }
    r->host->expect(r->in, "}");
    r->textures = replace(r, r->textures, l.items);
    r->texture_count = l.count;
}

/* ---- indices ---- */

/* Numbers below 2^32; others become one that is out of range. */
static uint32_t index_of(double x) { return x >= 0.0 && x < 4294967295.0 ? (uint32_t)x : 0xffffffffu; }

static void read_face(reading *r, common_face *f)
{
    pov_vec3 v;

    r->host->vector(r->in, &v);
    f->at[0] = index_of(v.x);
    f->at[1] = index_of(v.y);
    f->at[2] = index_of(v.z);
}

static list read_faces(reading *r, const char *what)
{
    list l = { NULL, sizeof(common_face), 0, 0 };
    const uint32_t n = begin_list(r, what);
    common_face *f;

    while (l.count < n && follows(r, l.count, n, what) && (f = next_item(r, &l, n)))
        read_face(r, f);
    r->host->accept(r->in, ",");
    r->host->expect(r->in, "}");
    return l;
}

static uint32_t texture_at(reading *r, double number)
{
    const uint32_t i = index_of(number);

    if (i < r->texture_count)
        return r->textures[i];
    r->host->fail(r->in, "the texture list has no number %g", number);
    return 0;
}

/* One number behind a face, or three. False: none. */
static bool read_face_textures(reading *r, common_face *out)
{
    int i;

    for (i = 0; i < 3 && r->host->more_numbers(r->in); i++) {
        out->at[i] = texture_at(r, r->host->number(r->in));
        r->host->accept(r->in, ",");
    }
    if (i == 2)
        r->host->fail(r->in, "a face has one texture or three");
    if (i == 1)
        out->at[1] = out->at[2] = out->at[0];
    return i > 0;
}

static void take_faces(reading *r)
{
    list l = { NULL, sizeof(common_face), 0, 0 }, textures = l;
    const uint32_t n = begin_list(r, "faces");
    common_face *f;

    while (l.count < n && follows(r, l.count, n, "faces") && (f = next_item(r, &l, n))) {
        read_face(r, f);
        r->host->accept(r->in, ",");
        if (r->texture_count == 0)
            continue;
        f = next_item(r, &textures, n);
        if (!f)
            break;
        *f = none;
        read_face_textures(r, f);
    }
    r->host->accept(r->in, ",");
    r->host->expect(r->in, "}");
    r->parts.faces = replace(r, r->parts.faces, l.items);
    r->parts.face_count = l.items ? l.count : 0;
    r->parts.textures = replace(r, r->parts.textures, textures.items);
}

/* ---- checks ---- */

static bool check_range(reading *r, const common_face *faces, uint32_t n, uint32_t end, const char *what)
{
    uint32_t i;

    for (i = 0; faces && i < n; i++)
        if (faces[i].at[0] >= end || faces[i].at[1] >= end || faces[i].at[2] >= end) {
            r->host->fail(r->in, "face %u has a %s that is out of range", i, what);
            return false;
        }
    return true;
}

/* Normals and uv vectors have indices of their own, those of normals for the first faces at least, or are as many as the corners. */
static bool check_indices(reading *r, common_face **own, uint32_t own_count, const void *items, uint32_t count,
                          const char *what)
{
    common_mesh_parts *p = &r->parts;

    if (!items && own_count > 0) {
        r->host->fail(r->in, "there are %s indices, but no %s vectors", what, what);
        return false;
    }
    if (!items) {
        *own = replace(r, *own, NULL);
        return true;
    }
    if (*own && own_count > p->face_count)
        r->host->fail(r->in, "there are more %s indices than faces", what);
    else if (*own && own_count < p->face_count && items != p->normals)
        r->host->fail(r->in, "there must be as many %s indices as faces", what);
    else if (!*own && count != p->corner_count)
        r->host->fail(r->in, "%s indices are missing", what);
    else
        return check_range(r, *own ? *own : p->faces, *own ? own_count : p->face_count, count, what);
    return false;
}

/* Faces behind those that have indices of normals are flat, as in POV-Ray. False: no memory. */
static bool pad_normals(reading *r)
{
    common_mesh_parts *p = &r->parts;

    if (!p->normal_faces || r->normal_face_count == p->face_count)
        return true;
    p->normal_faces = r->host->resize(r->in, p->normal_faces, p->face_count * sizeof *p->normal_faces);
    for (uint32_t i = r->normal_face_count; p->normal_faces && i < p->face_count; i++)
        p->normal_faces[i] = none;
    return p->normal_faces != NULL;
}

static bool check(reading *r)
{
    common_mesh_parts *p = &r->parts;

    if (r->has_normal_faces && r->normal_face_count == 0)
        p->normals = replace(r, p->normals, NULL);
    if (!p->corners)
        r->host->fail(r->in, "a mesh2 needs vertex_vectors");
    else if (!p->faces)
        r->host->fail(r->in, "a mesh2 needs face_indices");
    else
        return check_range(r, p->faces, p->face_count, p->corner_count, "corner") &&
               check_indices(r, &p->normal_faces, r->normal_face_count, p->normals, p->normal_count, "normal") &&
               check_indices(r, &p->uv_faces, r->uv_face_count, p->uvs, p->uv_count, "uv");
    return false;
}

/* ---- the whole ---- */

static void take_normal_faces(reading *r)
{
    const list l = read_faces(r, "normal indices");

    r->parts.normal_faces = replace(r, r->parts.normal_faces, l.items);
    r->normal_face_count = l.count;
    r->has_normal_faces = true;
}

static void take_uv_faces(reading *r)
{
    const list l = read_faces(r, "uv indices");

    r->parts.uv_faces = replace(r, r->parts.uv_faces, l.items);
    r->uv_face_count = l.count;
}

static void take_toward(reading *r) { r->host->vector(r->in, &r->parts.toward); }

static bool take_section(reading *r)
{
    static const struct { const char *word; void (*take)(reading *r); } sections[] = {
        { "vertex_vectors", take_corners }, { "normal_vectors", take_normals }, { "uv_vectors", take_uvs },
        { "texture_list", take_textures },  { "face_indices", take_faces },     { "normal_indices", take_normal_faces },
        { "uv_indices", take_uv_faces },    { "inside_vector", take_toward },
    };
    size_t i;

    for (i = 0; i < sizeof sections / sizeof *sections; i++)
        if (r->host->accept(r->in, sections[i].word)) {
            sections[i].take(r);
            return true;
        }
    return false;
}

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    reading r;

    memset(&r, 0, sizeof r);
    r.host = host;
    r.in = in;
    while (take_section(&r))
        continue;
    r.textures = replace(&r, r.textures, NULL);
    if (check(&r) && pad_normals(&r))
        common_mesh_make(self, &r.parts, host, in);
    else
        common_mesh_drop(&r.parts, host, in);
}

static const pov_shape_class mesh2_class = COMMON_MESH_CLASS("mesh2", parse);

static const pov_shape_class *const shapes[] = { &mesh2_class, NULL };

POV_PLUGIN(mesh2) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "mesh2",
    .version = "1",
    .shapes = shapes,
};

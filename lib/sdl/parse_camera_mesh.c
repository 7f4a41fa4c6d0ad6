/* mesh_camera { rays distribution mesh ... [smooth] } */
#include "sdl/parse_camera_mesh.h"

#include "model/camera_mesh.h"
#include "sdl/value.h"

#include <string.h>

enum { MESHES_MAX = 4096, ROWS_MAX = 1024 };

static bool next_mesh(pov_reader *in, object_parsed *o)
{
    state_accept(in, ',');
    if (in->failed || !parse_object_try(in, o))
        return false;
    if (!in->failed && !(o->kind == OBJECT_LEAF && shape_is_mesh(o->leaf.shape)))
        report_fail(in, &in->last, POV_E_SYNTAX, "a mesh_camera sees by the faces of meshes");
    return !in->failed;
}

/* As a list, in their order. */
static uint32_t read_meshes(pov_reader *in, object_parsed **first)
{
    object_parsed **end = first, o;
    uint32_t count = 0;

    for (*first = NULL; next_mesh(in, &o); end = &(*end)->next, count++) {
        *end = parse_keep(in, &o);
        if (!*end)
            break;
        (*end)->next = NULL;
    }
    return count;
}

/* ---- faces ---- */

static pov_vec3 moved_normal(const pov_affine *map, pov_vec3 n)
{
    const double (*m)[4] = map->inv;

    return pov_unit(pov_vec3_of(m[0][0] * n.x + m[1][0] * n.y + m[2][0] * n.z,
                                m[0][1] * n.x + m[1][1] * n.y + m[2][1] * n.z,
                                m[0][2] * n.x + m[1][2] * n.y + m[2][2] * n.z));
}

/* A face where the object's transformations take it; normals of its corners only if they are wanted. */
static bool take_face(const object_parsed *o, const pov_affine *map, uint32_t number, bool smooth, pov_face *f)
{
    if (!o->leaf.shape->face(o->leaf.instance, number, f))
        return false;
    for (int i = 0; o->map && i < 3; i++)
        f->corners[i] = pov_affine_point(map, f->corners[i]);
    for (int i = 0; o->map && smooth && i < 3; i++)
        f->normals[i] = moved_normal(map, f->normals[i]);
    if (o->map)
        f->normal = moved_normal(map, f->normal);
    return true;
}

static bool find_map(pov_reader *in, const object_parsed *o, pov_affine *map)
{
    if (o->map && !transform_compose(o->map, map))
        report_fail(in, &in->last, POV_E_SYNTAX, "the mesh is moved beyond what a double holds");
    return !in->failed;
}

/* Faces are numbered from 0 on: the first that is not there lies between a power of two and the next. */
static uint32_t count_faces(const object_parsed *o)
{
    uint32_t least = 0, step = 1;
    pov_face f;

    while (step < UINT32_MAX / 2 && o->leaf.shape->face(o->leaf.instance, step - 1, &f))
        step *= 2;
    for (; step > 0; step /= 2)
        if (o->leaf.shape->face(o->leaf.instance, least + step - 1, &f))
            least += step;
    return least;
}

static void make_faces(pov_reader *in, const object_parsed *o, camera_faces *out)
{
    const uint32_t count = count_faces(o);
    camera_face *items = state_alloc(in, count * sizeof *items, 16);
    pov_affine map;
    pov_face f;

    if (!items || !find_map(in, o, &map))
        return;
    for (uint32_t i = 0; i < count && take_face(o, &map, i, false, &f); i++) {
        items[i].middle = pov_scale(pov_add(f.corners[0], pov_add(f.corners[1], f.corners[2])), 1.0 / 3.0);
        items[i].normal = f.normal;
    }
    *out = (camera_faces){ items, count };
}

/* ---- by surface coordinates ---- */

static void put_uv_face(const pov_face *f, bool smooth, camera_uv_face *out)
{
    for (int i = 0; i < 3; i++) {
        out->corners[i] = f->corners[i];
        out->normals[i] = smooth ? f->normals[i] : f->normal;
        out->uv[i][0] = f->uv[i][0];
        out->uv[i][1] = f->uv[i][1];
    }
}

typedef struct span { uint32_t first, last; } span;

static span rows_of(const camera_atlas *a, const camera_uv_face *f)
{
    const double lo = pov_min(f->uv[0][1], pov_min(f->uv[1][1], f->uv[2][1]));
    const double hi = pov_max(f->uv[0][1], pov_max(f->uv[1][1], f->uv[2][1]));

    return (span){ camera_atlas_row(a, lo), camera_atlas_row(a, hi) };
}

/* Counts of rows become their ends, and then, filled from behind, their beginnings. */
static void sort_rows(pov_reader *in, camera_atlas *a, uint32_t count)
{
    uint32_t *first = state_alloc(in, (a->rows + 1) * sizeof *first, 16), *numbers;

    for (uint32_t i = 0; first && i < count; i++)
        for (span s = rows_of(a, &a->faces[i]); s.first <= s.last; s.first++)
            first[s.first]++;
    for (uint32_t row = 1; first && row <= a->rows; row++)
        first[row] += first[row - 1];
    numbers = first ? state_alloc(in, (first[a->rows] + 1) * sizeof *numbers, 16) : NULL;
    for (uint32_t i = count; numbers && i-- > 0;)
        for (span s = rows_of(a, &a->faces[i]); s.first <= s.last; s.first++)
            numbers[--first[s.first]] = i;
    a->first = first;
    a->numbers = numbers;
}

static void make_atlas(pov_reader *in, const object_parsed *o, bool smooth, camera_atlas *out)
{
    const uint32_t count = count_faces(o);
    camera_uv_face *faces = state_alloc(in, count * sizeof *faces, 16);
    pov_affine map;
    pov_face f;

    if (!faces || !find_map(in, o, &map))
        return;
    for (uint32_t i = 0; i < count && take_face(o, &map, i, smooth, &f); i++)
        put_uv_face(&f, smooth, &faces[i]);
    out->faces = faces;
    out->rows = count < ROWS_MAX ? count : ROWS_MAX;
    sort_rows(in, out, count);
}

/* ---- the whole ---- */

static void make_all(pov_reader *in, const object_parsed *first, bool smooth, camera_mesh *out)
{
    camera_faces *meshes;

    if (out->distribution == 3) {
        make_atlas(in, first, smooth, &out->atlas);
        return;
    }
    meshes = state_alloc(in, out->mesh_count * sizeof *meshes, 16);
    for (uint32_t i = 0; meshes && !in->failed && first; i++, first = first->next)
        make_faces(in, first, &meshes[i]);
    out->meshes = meshes;
}

static void read_head(pov_reader *in, camera_mesh *out)
{
    const double rays = value_number(in);
    double distribution;

    if (!in->failed && !(rays >= 1.0 && rays <= MESHES_MAX))
        report_fail(in, &in->value, POV_E_SYNTAX, "a mesh_camera has 1 to %d rays a pixel", (int)MESHES_MAX);
    state_accept(in, ',');
    distribution = value_number(in);
    if (!in->failed && !(distribution >= 0.0 && distribution < 4.0))
        report_fail(in, &in->value, POV_E_SYNTAX, "the distributions of a mesh_camera are 0 to 3");
    if (in->failed)
        return;
    out->rays = (uint32_t)rays;
    out->distribution = (int)distribution;
}

static void check(pov_reader *in, const camera_mesh *m, bool smooth)
{
    if (!in->failed && m->mesh_count == 0)
        report_expected(in, "a mesh");
    if (!in->failed && m->distribution == 0 && m->rays > m->mesh_count)
        report_fail(in, &in->last, POV_E_SYNTAX, "with distribution 0 there must be a mesh for each of the rays of a pixel");
    if (!in->failed && smooth && m->distribution != 3)
        report_fail(in, &in->last, POV_E_SYNTAX, "smooth belongs to distribution 3");
}

static void read_smooth(pov_reader *in, void *self, keyword_id keyword)
{
    (void)in;
    (void)keyword;
    *(bool *)self = true;
}

const camera_mesh *parse_camera_mesh(pov_reader *in)
{
    static const item items[] = { { KEYWORD_SMOOTH, read_smooth } };
    static const item_list list = { "a mesh", ITEMS(items), NULL, NULL, NULL, VALUE_NOTHING, NULL };
    camera_mesh *out = state_alloc(in, sizeof *out, 16);
    object_parsed *first = NULL;
    bool smooth = false;
    block b;

    if (!out)
        return NULL;
    items_open(in, &b);
    read_head(in, out);
    out->mesh_count = read_meshes(in, &first);
    items_close(in, &b, &list, &smooth);
    check(in, out, smooth);
    if (!in->failed)
        make_all(in, first, smooth, out);
    if (out->distribution != 0)
        out->rays = 1;
    return in->failed ? NULL : out;
}

#include "model/camera_mesh.h"
#include "sdl/parse_camera_mesh.h"
#include "sdl/parse_texture.h"
#include "sdl/report.h"
#include "sdl/textures.h"
#include "sdl/value.h"

#include <povtrace/exact.h>

/* ---- as written ---- */

void parse_camera_defaults(camera_parsed *c)
{
    static const camera_parsed none;

    *c = none;
    c->direction = pov_vec3_of(0.0, 0.0, 1.0);
    c->up = c->sky = pov_vec3_of(0.0, 1.0, 0.0);
}

/* Before version 3.5 look_at, angle and orthographic act where they stand, on what was written so far, and what comes later
 * replaces what they made. */
static bool acts_at_once(double version)
{
    return version > 0.0 && version < 3.5;
}

static void act(pov_reader *in, camera_parsed *c, keyword_id keyword);

static void read_location(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    ((camera_parsed *)self)->location = value_vector(in);
}

static void read_look_at(pov_reader *in, void *self, keyword_id keyword)
{
    camera_parsed *c = self;

    c->look_at = value_vector(in);
    c->look_at_place = in->value;
    c->has_look_at = true;
    act(in, c, keyword);
}

/* Of a spherical camera there may be two, of an orthographic one none: it sees what a perspective one would. */
static void read_angle(pov_reader *in, void *self, keyword_id keyword)
{
    camera_parsed *c = self;

    if (c->type == POV_CAMERA_ORTHOGRAPHIC && !value_follows(in)) {
        c->is_sized_by_distance = true;
        return;
    }
    c->angle = value_number(in);
    c->angle_place = in->value;
    c->has_angle = true;
    state_accept(in, ',');
    if (value_follows(in))
        c->angle_upwards = value_number(in);
    act(in, c, keyword);
}

static void read_axis(pov_reader *in, void *self, keyword_id keyword)
{
    camera_parsed *c = self;
    pov_vec3 axis = value_vector(in);

    if (pov_largest(axis) == 0.0 && keyword != KEYWORD_SKY)
        report_fail(in, &in->value, POV_E_SYNTAX, "\"%s\" must not be zero", token_keyword_name(keyword));
    c->has_size = c->has_size || keyword == KEYWORD_RIGHT || keyword == KEYWORD_UP;
    if (keyword == KEYWORD_RIGHT)
        c->right = axis;
    else if (keyword == KEYWORD_UP)
        c->up = axis;
    else if (keyword == KEYWORD_SKY)
        c->sky = axis;
    else
        c->direction = axis;
}

static void move_camera(pov_reader *in, void *self, keyword_id keyword)
{
    parse_transform(in, &((camera_parsed *)self)->map, keyword);
}

static void read_normal(pov_reader *in, void *self, keyword_id keyword)
{
    camera_parsed *c = self;

    (void)keyword;
    c->normal = parse_normal_upon(in, c->normal);
}

/* The values of these words are read for their own sake. */
static const keyword_id quiet[] = { KEYWORD_CONFIDENCE, KEYWORD_VARIANCE, KEYWORD_OTHER };
static const keyword_id coming[] = { KEYWORD_BOKEH, KEYWORD_OTHER };

static void take_camera(pov_reader *in, void *self, const value *v)
{
    camera_parsed *c = self;
    const place at = c->at;

    (void)in;
    *c = *(const camera_parsed *)v->as.part;
    c->at = at;
}

static bool is_flat(const camera_parsed *c)
{
    return c->type == POV_CAMERA_PERSPECTIVE || c->type == POV_CAMERA_ORTHOGRAPHIC;
}

/* Cameras of some kinds may see more than half of what is around them. */
static void check_angle(pov_reader *in, camera_parsed *c)
{
    if (in->failed || !c->has_angle || (c->angle > 0.0 && (c->angle < 180.0 || !is_flat(c))))
        return;
    report_fail(in, &c->angle_place, POV_E_SYNTAX, "the angle of a camera lies between 0 and 180 degrees");
}

static bool check_look_at(pov_reader *in, const camera_parsed *c)
{
    if (!in->failed && c->has_look_at && pov_largest(pov_sub(c->look_at, c->location)) == 0.0)
        report_fail(in, &c->look_at_place, POV_E_SYNTAX, "the camera cannot look at its own location");
    return !in->failed;
}

static void read_mesh_camera(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    ((camera_parsed *)self)->type = POV_CAMERA_MESH;
    ((camera_parsed *)self)->mesh = parse_camera_mesh(in);
}

static void read_cylinder(pov_reader *in, camera_parsed *c)
{
    const double kind = value_number(in);

    if (!in->failed && !(kind >= 1.0 && kind < 5.0))
        report_fail(in, &in->value, POV_E_SYNTAX, "the kinds of cylinder cameras are 1 to 4");
    if (!in->failed)
        c->type = (pov_camera_type)(POV_CAMERA_CYLINDER_1 + (int)kind - 1);
}

static void read_type(pov_reader *in, void *self, keyword_id keyword)
{
    static const struct { keyword_id keyword; pov_camera_type type; } types[] = {
        { KEYWORD_PERSPECTIVE, POV_CAMERA_PERSPECTIVE }, { KEYWORD_ORTHOGRAPHIC, POV_CAMERA_ORTHOGRAPHIC },
        { KEYWORD_FISHEYE, POV_CAMERA_FISHEYE },         { KEYWORD_ULTRA_WIDE_ANGLE, POV_CAMERA_ULTRA_WIDE },
        { KEYWORD_OMNIMAX, POV_CAMERA_OMNIMAX },         { KEYWORD_PANORAMIC, POV_CAMERA_PANORAMIC },
        { KEYWORD_SPHERICAL, POV_CAMERA_SPHERICAL },
    };
    camera_parsed *c = self;

    if (keyword == KEYWORD_CYLINDER)
        read_cylinder(in, c);
    for (size_t i = 0; i < sizeof types / sizeof types[0]; i++)
        if (types[i].keyword == keyword)
            c->type = types[i].type;
    act(in, c, keyword);
}

/* ---- focal blur ---- */

static void read_aperture(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    ((camera_parsed *)self)->aperture = value_number(in);
}

static void read_blur_samples(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    ((camera_parsed *)self)->blur_samples = value_number(in);
    if (state_accept(in, ',') || value_follows(in))
        ((camera_parsed *)self)->blur_samples = value_number(in);
}

static void read_focal_point(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    ((camera_parsed *)self)->focal_point = value_vector(in);
    ((camera_parsed *)self)->has_focal_point = true;
}

void parse_camera(pov_reader *in, camera_parsed *c)
{
    static const item items[] = {
        { KEYWORD_LOCATION, read_location }, { KEYWORD_LOOK_AT, read_look_at }, { KEYWORD_ANGLE, read_angle },
        { KEYWORD_RIGHT, read_axis },        { KEYWORD_UP, read_axis },         { KEYWORD_SKY, read_axis },
        { KEYWORD_DIRECTION, read_axis },    PARSE_MOVES(move_camera),
        { KEYWORD_PERSPECTIVE, read_type },  { KEYWORD_ORTHOGRAPHIC, read_type }, { KEYWORD_FISHEYE, read_type },
        { KEYWORD_ULTRA_WIDE_ANGLE, read_type }, { KEYWORD_OMNIMAX, read_type }, { KEYWORD_PANORAMIC, read_type },
        { KEYWORD_CYLINDER, read_type },     { KEYWORD_SPHERICAL, read_type },  { KEYWORD_MESH_CAMERA, read_mesh_camera },
        { KEYWORD_APERTURE, read_aperture }, { KEYWORD_BLUR_SAMPLES, read_blur_samples },
        { KEYWORD_FOCAL_POINT, read_focal_point }, { KEYWORD_NORMAL, read_normal },
    };
    static const item_list list = { "an item of the camera", ITEMS(items), quiet, NULL, coming, VALUE_CAMERA,
                                    take_camera };

    parse_camera_defaults(c);
    c->at = in->last;
    c->version = in->version;    /* a #version behind the block is read with the token that follows it */
    items_block(in, &list, c);
    check_angle(in, c);
    check_look_at(in, c);
}

/* ---- the frame ---- */

typedef struct camera_frame { pov_vec3 d, r, u; } camera_frame;

static double length(pov_vec3 v)
{
    pov_vec3 w;
    int e;

    frexp(pov_largest(v), &e);
    w = pov_vec3_of(ldexp(v.x, -e), ldexp(v.y, -e), ldexp(v.z, -e));
    return ldexp(sqrt(pov_dot(w, w)), e);
}

/* The cross product of two unit vectors, each component rounded once, so that it stands upright on both
 * however near they are to each other. Zero where they are parallel as far as their own rounding can tell:
 * the components of each are within an ulp of 1, so the sine of the angle between two parallel ones stays
 * below four of them. */
static pov_vec3 upright(pov_vec3 a, pov_vec3 b)
{
    pov_vec3 zero = pov_vec3_of(0.0, 0.0, 0.0);
    pov_vec3 c = pov_two3_hi(pov_two3_cross(pov_two3_of(a, zero), pov_two3_of(b, zero)));

    return length(c) <= 4.0 * DBL_EPSILON ? zero : c;
}

/* From location towards look_at, however far apart they are. */
static pov_vec3 towards(const camera_parsed *c)
{
    pov_vec3 whole = pov_sub(c->look_at, c->location);

    if (pov_largest(whole) <= DBL_MAX)
        return pov_unit(whole);
    return pov_unit(pov_sub(pov_scale(c->look_at, 0.5), pov_scale(c->location, 0.5)));
}

/* `up` is the vertical; where it lies along the view x takes its place, and y where x does too. */
static camera_frame course_frame(const camera_parsed *c)
{
    pov_vec3 view = c->has_look_at ? towards(c) : pov_unit(c->direction);
    pov_vec3 side = upright(pov_unit(c->up), view);
    camera_frame f;

    if (pov_largest(side) == 0.0)
        side = upright(pov_vec3_of(1.0, 0.0, 0.0), view);
    if (pov_largest(side) == 0.0)
        side = upright(pov_vec3_of(0.0, 1.0, 0.0), view);
    side = pov_unit(side);
    f.d = pov_scale(view, length(c->direction));
    f.r = pov_scale(side, length(c->right));
    f.u = pov_scale(pov_unit(upright(view, side)), length(c->up));
    return f;
}

/* With a look_at `sky` is the vertical, and of direction, right and up only the lengths count, and whether
 * the three are left- or right-handed. Where sky lies along the view, right's own direction takes the place of
 * the side. Without a look_at all three stay as written. */
static camera_frame povray_frame(const camera_parsed *c)
{
    camera_frame f = { c->direction, c->right, c->up };
    pov_vec3 view, side, side_as_written;
    bool is_mirrored;

    if (!c->has_look_at)
        return f;
    view = towards(c);
    side = pov_unit(upright(pov_unit(c->sky), view));
    side_as_written = pov_cross_product(pov_unit(c->up), pov_unit(c->direction));
    is_mirrored = !(pov_dot(side_as_written, pov_unit(c->right)) > 0.0);
    f.d = pov_scale(view, length(c->direction));
    if (pov_largest(side) == 0.0)
        side = pov_unit(c->right);
    f.r = pov_scale(side, is_mirrored ? -length(c->right) : length(c->right));
    f.u = pov_scale(pov_unit(upright(view, side)), length(c->up));
    return f;
}

/* Parallel rays see a part of the scene as large as right and up; unless these were written, and with an `angle` that has no
 * number, as large as the picture of a perspective camera is where this one looks. */
static void size_orthographic(const camera_parsed *c, camera_frame *f)
{
    const double half_degree = 3.14159265358979323846 / 360.0;
    const pov_vec3 to = c->has_look_at ? c->look_at : pov_vec3_of(0.0, 0.0, 1.0);
    const double distance = length(pov_sub(to, c->location));
    double size = 1.0;

    if (acts_at_once(c->version))
        size = distance / length(f->d);
    else if (c->angle > 0.0)
        size = 2.0 * distance * tan(c->angle * half_degree) / length(f->r);
    else if (!c->has_size || c->is_sized_by_distance)
        size = distance / length(f->d);
    f->r = pov_scale(f->r, size);
    f->u = pov_scale(f->u, size);
}

static void set_distance(const camera_parsed *c, camera_frame *f)
{
    const double half_degree = 3.14159265358979323846 / 360.0;

    f->d = pov_scale(pov_unit(f->d), 0.5 * length(c->right) / tan(c->angle * half_degree));
}

static camera_frame frame_of(const camera_parsed *c, bool is_povray)
{
    camera_frame f = { c->direction, c->right, c->up };

    if (acts_at_once(c->version))
        return f;
    f = is_povray ? povray_frame(c) : course_frame(c);
    if (c->type == POV_CAMERA_ORTHOGRAPHIC)
        size_orthographic(c, &f);
    else if (c->type == POV_CAMERA_PERSPECTIVE && c->angle > 0.0)
        set_distance(c, &f);
    return f;
}

static void act(pov_reader *in, camera_parsed *c, keyword_id keyword)
{
    camera_frame f;

    if (in->failed || !acts_at_once(c->version))
        return;
    if (pov_largest(c->right) == 0.0)
        c->right = pov_vec3_of(1.33, 0.0, 0.0);
    f = (camera_frame){ c->direction, c->right, c->up };
    if (keyword == KEYWORD_LOOK_AT && check_look_at(in, c))
        f = povray_frame(c);
    else if (keyword == KEYWORD_ANGLE && c->angle > 0.0 && c->angle < 180.0)
        set_distance(c, &f);
    else if (keyword == KEYWORD_ORTHOGRAPHIC)
        size_orthographic(c, &f);
    c->direction = f.d;
    c->right = f.r;
    c->up = f.u;
}

static pov_vec3 turn(const pov_affine *map, pov_vec3 v)
{
    pov_affine linear = *map;

    linear.m[0][3] = linear.m[1][3] = linear.m[2][3] = 0.0;
    return pov_affine_point(&linear, v);
}

static bool is_usable(const pov_camera *c)
{
    return parse_is_finite(c->location) && parse_is_finite(c->direction) && parse_is_finite(c->right) &&
           parse_is_finite(c->up) && pov_largest(c->direction) > 0.0 && pov_largest(c->right) > 0.0 &&
           pov_largest(c->up) > 0.0;
}

static void move(pov_reader *in, const camera_parsed *c, pov_camera *out)
{
    pov_affine map;
    pov_vec3 rest;

    if (!c->map)
        return;
    if (!transform_compose(c->map, &map)) {
        report_fail(in, &c->at, POV_E_SYNTAX, "the camera is moved beyond what a double holds");
        return;
    }
    transform_point(&map, out->location, &out->location, &rest);
    out->direction = turn(&map, out->direction);
    out->right = turn(&map, out->right);
    out->up = turn(&map, out->up);
}

/* What a camera sees that says no angle. */
static void set_angles(const camera_parsed *c, pov_camera *out)
{
    const double degree = 3.14159265358979323846 / 180.0;
    const bool is_spherical = c->type == POV_CAMERA_SPHERICAL;
    const double across = c->angle > 0.0 ? c->angle : is_spherical ? 360.0 : 90.0;

    out->angles[0] = across * degree;
    out->angles[1] = (c->angle_upwards > 0.0 ? c->angle_upwards : 0.5 * across) * degree;
}

/* The lens is half as wide as POV-Ray's aperture is large; what is at the focal point's distance along the view is sharp. */
static void set_lens(const camera_parsed *c, pov_camera *out)
{
    const pov_vec3 focus = c->has_focal_point ? c->focal_point : c->look_at;

    out->focal_distance = length(pov_sub(focus, c->location));
    out->lens_samples = c->blur_samples < 4096.0 ? (int)c->blur_samples : 4096;
    out->lens_radius = c->aperture > 0.0 && c->blur_samples > 0.0 && out->focal_distance > 0.0 ? 0.25 * c->aperture : 0.0;
}

static void set_mesh(const camera_parsed *c, model *m)
{
    m->camera_mesh = c->mesh;
    m->camera.lens_radius = 0.0;
    m->camera.lens_samples = c->mesh ? (int)c->mesh->rays : 0;
}

void parse_camera_finish(pov_reader *in)
{
    bool is_povray = in->model->dialect == POV_DIALECT_POVRAY;
    camera_parsed c = in->camera;
    pov_camera *out = &in->model->camera;
    camera_frame f;

    in->model->has_camera = c.given || c.at.source;
    if (c.given) {
        *out = *c.given;
        return;
    }
    if (pov_largest(c.right) == 0.0)
        c.right = pov_vec3_of(is_povray ? 1.33 : 1.33333, 0.0, 0.0);
    f = frame_of(&c, is_povray);
    out->size = sizeof *out;
    out->type = c.type;
    set_angles(&c, out);
    set_lens(&c, out);
    out->location = c.location;
    out->direction = f.d;
    out->right = f.r;
    out->up = f.u;
    move(in, &c, out);
    if (c.type == POV_CAMERA_MESH)
        set_mesh(&c, in->model);
    in->model->camera_normal = c.normal;
    if (c.normal)
        textures_settle_normal(in, c.normal);
    if (!in->failed && !is_usable(out))
        report_fail(in, &c.at, POV_E_SYNTAX, "the camera's numbers leave it no picture");
}

/* Builders: meshes, what differs from object to object, lights and cameras, bit for bit as their texts. */
#include "support/builders.h"
#include "support/check.h"
#include "support/failing.h"
#include "support/scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { COUNT = 24, EDGE = 6, CORNERS = EDGE * EDGE, FACES = 2 * (EDGE - 1) * (EDGE - 1) };
enum { BYTES = BUILT_NUMBERS * (int)sizeof(float) };

static const char head[] = "#version 3.7; global_settings { assumed_gamma 1 }\n"
                           "camera { location <0, 1, -6> look_at 0 } light_source { <5, 9, -7> rgb 1 }\n";

/* ---- texts ---- */

static void put_numbers(built_text *t, const double *v, int n)
{
    for (int i = 0; i < n; i++)
        built_put(t, "%s%.17g", i ? ", " : "<", v[i]);
    built_put(t, ">");
}

/* ---- builders ---- */

/* Is it what the text gives, and is there anything to see? Ends the builder. */
static void check_is(pov_builder *b, pov_context *context, const built_text *t, const char *what)
{
    float *built = built_draw(b), *written = scenes_draw(t->at, BUILT_WIDTH, BUILT_HEIGHT, 0, 0);
    int seen = 0;

    if (memcmp(built, written, BYTES) != 0)
        fail_msg("%s: not as its text", what);
    for (int i = 4; i < BUILT_NUMBERS; i += 4)
        seen += memcmp(built + i, built, 3 * sizeof *built) != 0;
    assert_true(seen > BUILT_WIDTH);
    free(built);
    free(written);
    pov_builder_destroy(b);
    pov_context_destroy(context);
}

/* ---- meshes ---- */

typedef struct heights {
    pov_vec3 corners[CORNERS], normals[CORNERS];
    double uvs[2 * CORNERS];
    uint32_t faces[3 * FACES], turned[3 * FACES], painted[FACES];
} heights;

static void put_face(uint32_t *to, uint32_t a, uint32_t b, uint32_t c)
{
    to[0] = a;
    to[1] = b;
    to[2] = c;
}

static void fill(heights *h)
{
    uint32_t state = 3, f = 0;

    for (uint32_t i = 0; i < CORNERS; i++) {
        h->corners[i] = pov_vec3_of(0.6 * (i % EDGE) - 1.5, 0.6 * (i / EDGE) - 1.5, 0.8 * built_next(&state));
        h->normals[i] = pov_vec3_of(built_next(&state) - 0.5, built_next(&state) - 0.5, -1.0);
        h->uvs[2 * i] = (i % EDGE) / 3.0;
        h->uvs[2 * i + 1] = (i / EDGE) / 3.0;
    }
    for (uint32_t i = 0; i < CORNERS; i++)
        if (i % EDGE < EDGE - 1 && i / EDGE < EDGE - 1) {
            put_face(h->faces + 3 * f++, i, i + 1, i + EDGE);
            put_face(h->faces + 3 * f++, i + 1, i + EDGE + 1, i + EDGE);
        }
    for (uint32_t i = 0; i < 3 * FACES; i++)
        h->turned[i] = CORNERS - 1 - h->faces[i];
    for (uint32_t i = 0; i < FACES; i++)
        h->painted[i] = i % 2;
}

static void put_vectors(built_text *t, const char *word, const double *v, int width, int n)
{
    built_put(t, "%s { %d", word, n);
    for (int i = 0; i < n; i++) {
        built_put(t, ", ");
        put_numbers(t, v + width * i, width);
    }
    built_put(t, " }\n");
}

/* places: of the textures behind each face, `width` of them; 0: none is there. */
static void put_faces(built_text *t, const char *word, const uint32_t *v, const uint32_t *places, int width)
{
    built_put(t, "%s { %d", word, FACES);
    for (int i = 0; i < FACES; i++) {
        built_put(t, ", <%u, %u, %u>", v[3 * i], v[3 * i + 1], v[3 * i + 2]);
        for (int k = 0; k < width && places[width * i] > 0; k++)
            built_put(t, ", %u", places[width * i + k] - 1);
    }
    built_put(t, " }\n");
}

static const char *const paints[] = { "pigment { rgb <0, .2, .9> }", "pigment { rgb 1 }",
                                      "pigment { granite scale .2 } finish { phong .5 } rotate 20*z" };

static void put_mesh(built_text *t, const pov_mesh *m, const uint32_t *places, const char *behind)
{
    built_put(t, "mesh2 { ");
    put_vectors(t, "vertex_vectors", &m->corners->x, 3, CORNERS);
    if (m->normals)
        put_vectors(t, "normal_vectors", &m->normals->x, 3, CORNERS);
    if (m->uvs)
        put_vectors(t, "uv_vectors", m->uvs, 2, CORNERS);
    if (m->face_materials)
        built_put(t, "texture_list { 2, texture { %s } texture { %s } }", paints[0], paints[2]);
    put_faces(t, "face_indices", m->faces, places, m->face_materials ? m->materials_a_face : 0);
    if (m->normal_faces)
        put_faces(t, "normal_indices", m->normal_faces, NULL, 0);
    if (m->uv_faces)
        put_faces(t, "uv_indices", m->uv_faces, NULL, 0);
    if (pov_largest(m->inside) > 0.0) {
        built_put(t, "inside_vector ");
        put_numbers(t, &m->inside.x, 3);
    }
    built_put(t, "%s }\n", behind);
}

static pov_mesh flat(const heights *h)
{
    pov_mesh m = POV_INIT(m);

    m.corners = h->corners;
    m.corner_count = CORNERS;
    m.faces = h->faces;
    m.face_count = FACES;
    return m;
}

static pov_mesh rich(const heights *h, bool has_faces)
{
    pov_mesh m = flat(h);

    m.normals = h->normals;
    m.uvs = h->uvs;
    m.normal_count = m.uv_count = CORNERS;
    m.normal_faces = m.uv_faces = has_faces ? h->turned : NULL;
    m.inside = pov_vec3_of(0.0, 0.0, 1.0);
    return m;
}

static void meshes_are_as_their_text(void **state)
{
    static const char look[] = "uv_mapping pigment { checker rgb 1, rgb <.9, .3, .2> scale .2 } finish { phong .8 } rotate 20*y";
    static heights h;
    static built_text t;

    (void)state;
    fill(&h);
    for (int i = 0; i < 3; i++) {
        pov_context *context = scenes_context();
        pov_builder *b = built_create(context);
        pov_mesh m = i == 0 ? flat(&h) : rich(&h, i == 2);
        uint32_t material = built_material(b, look);

        built_add_text(b, head);
        assert_int_equal(pov_builder_add_mesh(b, &m, material, NULL), POV_OK);
        memset(&m, 0, sizeof m);
        m = i == 0 ? flat(&h) : rich(&h, i == 2);
        t.length = 0;
        built_put(&t, "%s", head);
        put_mesh(&t, &m, NULL, look);
        check_is(b, context, &t, i == 0 ? "flat" : i == 1 ? "with normals and uv" : "with faces of normals and uv");
    }
}

/* The second paint is no face's: the list has the first and the third. */
static void faces_have_materials(void **state)
{
    static const char look[] = "pigment { rgb <.9, .9, .1> } rotate 20*y";
    static uint32_t numbers[3 * FACES], places[3 * FACES];
    static heights h;
    static built_text t;

    (void)state;
    fill(&h);
    for (int width = 1; width <= 3; width += 2) {
        pov_context *context = scenes_context();
        pov_builder *b = built_create(context);
        pov_mesh m = rich(&h, true);

        for (int i = 0; i < 3; i++)
            assert_int_equal(built_material(b, paints[i]), i + 1);
        for (uint32_t i = 0; i < 3 * FACES; i++) {
            places[i] = i / (uint32_t)width % 5 == 2 ? 0 : 1 + i % 2;
            numbers[i] = places[i] == 2 ? 3 : places[i];
        }
        m.face_materials = numbers;
        m.materials_a_face = width;
        built_add_text(b, head);
        assert_int_equal(pov_builder_add_mesh(b, &m, built_material(b, look), NULL), POV_OK);
        t.length = 0;
        built_put(&t, "%s", head);
        put_mesh(&t, &m, places, look);
        check_is(b, context, &t, width == 1 ? "a material for each face" : "three materials for each face");
    }
}

static void wrong_meshes_are_refused(void **state)
{
    pov_context *context = scenes_context();
    pov_builder *b = built_create(context);
    pov_scene *scene;
    pov_error err;
    pov_mesh m;
    static heights h;

    (void)state;
    fill(&h);
    m = flat(&h);
    assert_int_equal(pov_builder_add_mesh(NULL, &m, 0, &err), POV_E_ARGUMENT);
    assert_int_equal(pov_builder_add_mesh(b, NULL, 0, &err), POV_E_ARGUMENT);
    assert_int_equal(pov_builder_add_mesh(b, &m, 1, &err), POV_E_ARGUMENT);
    m.faces = NULL;
    assert_int_equal(pov_builder_add_mesh(b, &m, 0, &err), POV_E_ARGUMENT);
    m = flat(&h);
    m.normal_count = CORNERS;
    assert_int_equal(pov_builder_add_mesh(b, &m, 0, &err), POV_E_ARGUMENT);
    m = rich(&h, false);
    h.normals[4].y = NAN;
    assert_int_equal(pov_builder_add_mesh(b, &m, 0, &err), POV_E_ARGUMENT);
    assert_string_equal(err.message, "normal_vectors 4 of 36 has a number that is infinite or none");
    m = flat(&h);
    m.corner_count = SIZE_MAX;
    assert_int_equal(pov_builder_add_mesh(b, &m, 0, &err), POV_E_ARGUMENT);
    m = flat(&h);
    m.face_materials = h.faces;
    m.materials_a_face = 2;
    assert_int_equal(pov_builder_add_mesh(b, &m, 0, &err), POV_E_ARGUMENT);
    m.materials_a_face = 1;
    assert_int_equal(pov_builder_add_mesh(b, &m, 0, &err), POV_E_ARGUMENT);
    assert_string_equal(err.message, "there is no material 1: the builder has 0");
    m = flat(&h);
    h.faces[5] = CORNERS;
    assert_int_equal(pov_builder_add_mesh(b, &m, 0, &err), POV_OK);
    assert_int_equal(pov_scene_load_builder(&scene, b, NULL, &err), POV_E_ARGUMENT);
    assert_string_equal(err.message, "mesh2 0 of 1: face 1 has a corner that is out of range");
    pov_builder_destroy(b);
    pov_context_destroy(context);
}

/* ---- what differs ---- */

typedef struct spheres {
    pov_vec3 centres[COUNT];
    double radii[COUNT], colours[5 * COUNT], matrices[12 * COUNT];
    uint32_t materials[COUNT];
} spheres;

static void fill_spheres(spheres *s)
{
    uint32_t state = 9;

    for (int i = 0; i < COUNT; i++) {
        s->centres[i] = pov_vec3_of(4.0 * built_next(&state) - 2.0, 3.0 * built_next(&state) - 1.5, 4.0 * built_next(&state) - 2.0);
        s->radii[i] = 0.2 + 0.3 * built_next(&state);
        s->materials[i] = (uint32_t)(i % 5);
        for (int k = 0; k < 5; k++)
            s->colours[5 * i + k] = k < 3 ? built_next(&state) : 0.4 * built_next(&state);
        for (int k = 0; k < 12; k++)
            s->matrices[12 * i + k] = (k % 4 == 0 && k < 9 ? 1.0 : 0.0) + 0.3 * built_next(&state);
    }
}

static const char *const looks[] = {
    "",
    "finish { phong .8 reflection .2 }",
    "texture { pigment { granite scale .3 } finish { ambient .3 } } rotate 30*y no_shadow",
    "pigment { rgb 1 } clipped_by { sphere { 0, 1.5 } } hollow interior { media { absorption 1 density { gradient x } } }",
    "texture { pigment { checker rgb 1, rgbt 1 } } texture { pigment { bozo } finish { specular .3 } } translate .1*x",
};

/* Bits of `which`: materials, colours, matrices. */
static void compare_spheres(int which, int channels)
{
    const size_t look_count = sizeof looks / sizeof *looks;
    pov_context *context = scenes_context();
    pov_builder *b = built_create(context);
    pov_each each = POV_INIT(each);
    static spheres s;
    static built_text t;
    char what[80];

    fill_spheres(&s);
    t.length = 0;
    built_put(&t, "%s", head);
    built_add_text(b, head);
    for (size_t i = 1; i < look_count; i++)
        assert_int_equal(built_material(b, looks[i]), i);
    each.materials = which & 1 ? s.materials : NULL;
    each.colours = which & 2 ? s.colours : NULL;
    each.channels = channels;
    each.matrices = which & 4 ? s.matrices : NULL;
    assert_int_equal(pov_builder_each(b, &each, NULL), POV_OK);
    assert_int_equal(pov_builder_add_spheres(b, COUNT, s.centres, s.radii, 1, NULL), POV_OK);
    assert_int_equal(pov_builder_add_spheres(b, 1, s.centres, s.radii, 1, NULL), POV_OK);   /* as if there was no each */
    for (int i = 0; i <= COUNT; i++) {
        const int k = i % COUNT;

        built_put(&t, "sphere { ");
        put_numbers(&t, &s.centres[k].x, 3);
        built_put(&t, ", %.17g %s ", s.radii[k], looks[which & 1 && i < COUNT ? s.materials[k] : 1]);
        if (which & 2 && i < COUNT) {
            built_put(&t, "pigment { color rgb%s ", channels == 5 ? "ft" : channels == 4 ? "f" : "");
            put_numbers(&t, s.colours + channels * k, channels);
            built_put(&t, " } ");
        }
        if (which & 4 && i < COUNT) {
            built_put(&t, "matrix ");
            put_numbers(&t, s.matrices + 12 * k, 12);
        }
        built_put(&t, " }\n");
    }
    snprintf(what, sizeof what, "%d with %d channels", which, channels);
    check_is(b, context, &t, what);
}

static void what_differs_is_as_in_a_text(void **state)
{
    (void)state;
    for (int which = 0; which < 8; which++)
        for (int channels = 3; channels <= (which & 2 ? 5 : 3); channels++)
            compare_spheres(which, channels);
}

static void wrong_differences_are_refused(void **state)
{
    pov_context *context = scenes_context();
    pov_builder *b = built_create(context);
    pov_each each = POV_INIT(each);
    pov_scene *scene;
    pov_error err;
    static spheres s;

    (void)state;
    fill_spheres(&s);
    assert_int_equal(pov_builder_each(NULL, &each, &err), POV_E_ARGUMENT);
    each.colours = s.colours;
    each.channels = 2;
    assert_int_equal(pov_builder_each(b, &each, &err), POV_E_ARGUMENT);
    each.channels = 3;
    s.colours[3 * COUNT - 1] = HUGE_VAL;
    assert_int_equal(pov_builder_each(b, &each, &err), POV_OK);
    assert_int_equal(pov_builder_add_spheres(b, COUNT, s.centres, s.radii, 0, &err), POV_E_ARGUMENT);
    each.colours = NULL;
    each.materials = s.materials;
    assert_int_equal(pov_builder_each(b, &each, &err), POV_OK);
    assert_int_equal(pov_builder_add_spheres(b, COUNT, s.centres, s.radii, 0, &err), POV_E_ARGUMENT);
    assert_string_equal(err.message, "there is no material 1: the builder has 0");
    each.materials = NULL;
    each.matrices = s.matrices;
    memset(s.matrices + 12 * 7, 0, 12 * sizeof *s.matrices);
    assert_int_equal(pov_builder_each(b, &each, &err), POV_OK);
    assert_int_equal(pov_builder_add_spheres(b, COUNT, s.centres, s.radii, 0, &err), POV_OK);
    assert_int_equal(pov_scene_load_builder(&scene, b, NULL, &err), POV_E_ARGUMENT);
    assert_string_equal(err.message, "sphere 7 of 24: the matrix has no inverse");
    pov_builder_destroy(b);
    pov_context_destroy(context);
}

/* ---- lights and cameras ---- */

static const char shapes[] = "#version 3.7; global_settings { assumed_gamma 1 } sphere { 0, 1 pigment { rgb 1 } }"
                             "plane { y, -1 pigment { checker rgb 1, rgb .3 } }";

static void lights_are_as_their_text(void **state)
{
    static const char *const words[] = { "", "spotlight point_at <0, .5, 0> radius 10 falloff 20 tightness 2",
                                         "area_light x, z, 3, 3 looks_like { sphere { 0, .2 pigment { rgb x } } } translate .3*y" };
    static const char eye[] = "camera { location <0, 1, -6> look_at 0 }";
    const pov_vec3 at[2] = { { 3.0, 5.0, -4.0 }, { -2.0, 3.0, -1.0 } }, rgb[2] = { { 0.9, 0.8, 0.1 }, { 0.2, 0.3, 1.0 } };
    static built_text t;

    (void)state;
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        pov_context *context = scenes_context();
        pov_builder *b = built_create(context);

        built_add_text(b, shapes);
        built_add_text(b, eye);
        assert_int_equal(pov_builder_add_lights(b, 2, at, rgb, built_material(b, words[i]), NULL), POV_OK);
        t.length = 0;
        built_put(&t, "%s%s", shapes, eye);
        for (int k = 0; k < 2; k++) {
            built_put(&t, "light_source { ");
            put_numbers(&t, &at[k].x, 3);
            built_put(&t, ", rgb ");
            put_numbers(&t, &rgb[k].x, 3);
            built_put(&t, " %s }\n", words[i]);
        }
        check_is(b, context, &t, words[i]);
    }
}

static const char light[] = "light_source { <3, 5, -4> rgb 1 }";

static void a_camera_is_that_of_its_text(void **state)
{
    static const char *const cameras[] = {
        "camera { location <0, 1, -6> look_at <.3, 0, 0> angle 40 }",
        "camera { orthographic location <1, 1, -6> look_at 0 right 4*x up 3*y }",
        "camera { fisheye location <0, 1, -3> look_at 0 angle 120 }",
        "camera { location <0, 1, -6> look_at 0 aperture .4 focal_point 0 blur_samples 7 }",
    };
    static built_text t;

    (void)state;
    for (size_t i = 0; i < sizeof cameras / sizeof *cameras; i++) {
        pov_context *context = scenes_context();
        pov_builder *b = built_create(context);
        pov_camera camera = POV_INIT(camera), again = POV_INIT(again);
        pov_scene *scene;

        t.length = 0;
        built_put(&t, "%s%s%s", shapes, light, cameras[i]);
        scene = scenes_text(context, t.at);
        pov_scene_get_camera(scene, &camera);
        pov_scene_destroy(scene);
        built_add_text(b, "camera { location 5 look_at 0 }");   /* the last one counts */
        assert_int_equal(pov_builder_camera(b, &camera, NULL), POV_OK);
        built_add_text(b, shapes);
        built_add_text(b, light);
        assert_int_equal(pov_scene_load_builder(&scene, b, NULL, NULL), POV_OK);
        pov_scene_get_camera(scene, &again);
        assert_memory_equal(&again, &camera, sizeof camera);
        pov_scene_destroy(scene);
        check_is(b, context, &t, cameras[i]);
    }
}

static void wrong_cameras_and_lights_are_refused(void **state)
{
    pov_context *context = scenes_context();
    pov_builder *b = built_create(context);
    pov_camera camera = POV_INIT(camera);
    const pov_vec3 at = { NAN, 0.0, 0.0 };
    pov_scene *scene;
    pov_error err;

    (void)state;
    assert_int_equal(pov_builder_camera(b, &camera, &err), POV_E_ARGUMENT);
    camera.direction.z = camera.right.x = camera.up.y = 1.0;
    assert_int_equal(pov_builder_camera(NULL, &camera, &err), POV_E_ARGUMENT);
    assert_int_equal(pov_builder_camera(b, NULL, &err), POV_E_ARGUMENT);
    camera.type = POV_CAMERA_MESH;
    assert_int_equal(pov_builder_camera(b, &camera, &err), POV_E_ARGUMENT);
    camera.type = POV_CAMERA_PERSPECTIVE;
    camera.location.x = HUGE_VAL;
    assert_int_equal(pov_builder_camera(b, &camera, &err), POV_E_ARGUMENT);
    assert_int_equal(pov_builder_add_lights(b, 1, &at, &camera.up, 0, &err), POV_E_ARGUMENT);
    assert_int_equal(pov_builder_add_lights(NULL, 1, &camera.up, &camera.up, 0, &err), POV_E_ARGUMENT);
    assert_int_equal(pov_builder_add_lights(b, 1, &camera.up, &camera.up, built_material(b, "radius 3"), &err), POV_OK);
    assert_int_equal(pov_scene_load_builder(&scene, b, NULL, &err), POV_E_SYNTAX);
    pov_builder_destroy(b);
    pov_context_destroy(context);
}

/* ---- memory that ends ---- */

static pov_status build_all(pov_builder *b, const heights *h, const spheres *s)
{
    static const pov_vec3 one = { 1.0, 2.0, 3.0 };   /* read when the scene is */
    pov_mesh m = rich(h, true);
    pov_camera camera = POV_INIT(camera);
    pov_each each = POV_INIT(each);
    uint32_t first;
    pov_status status = POV_OK;

    camera.direction.z = camera.right.x = camera.up.y = 1.0;
    m.face_materials = h->painted;
    m.materials_a_face = 1;
    each.colours = s->colours;
    each.channels = 5;
    each.matrices = s->matrices;
    each.materials = s->materials;
    for (size_t i = 1; status == POV_OK && i < sizeof looks / sizeof *looks; i++)
        status = pov_builder_material(b, looks[i], &first, NULL);
    if (status == POV_OK)
        status = pov_builder_add_mesh(b, &m, 1, NULL);
    if (status == POV_OK)
        status = pov_builder_each(b, &each, NULL);
    if (status == POV_OK)
        status = pov_builder_add_spheres(b, COUNT, s->centres, s->radii, 0, NULL);
    if (status == POV_OK)
        status = pov_builder_add_lights(b, 1, &one, &one, 0, NULL);
    return status == POV_OK ? pov_builder_camera(b, &camera, NULL) : status;
}

static pov_status whole_way(failing *f, const heights *h, const spheres *s)
{
    pov_context_desc d = POV_INIT(d);
    pov_context *context = NULL;
    pov_builder *b = NULL;
    pov_scene *scene = NULL;
    pov_status status;

    d.allocator = failing_allocator(f);
    d.plugin_path = TEST_PLUGINS;
    status = pov_context_create(&context, &d, NULL);
    if (status == POV_OK)
        status = pov_builder_create(&b, context, NULL);
    if (status == POV_OK)
        status = build_all(b, h, s);
    if (status == POV_OK)
        status = pov_scene_load_builder(&scene, b, NULL, NULL);
    pov_scene_destroy(scene);
    pov_builder_destroy(b);
    pov_context_destroy(context);
    return status;
}

static void every_allocation_may_fail(void **state)
{
    pov_status status = POV_E_MEMORY;
    static heights h;
    static spheres s;
    long n;

    (void)state;
    fill(&h);
    fill_spheres(&s);
    for (n = 1; status != POV_OK; n++) {
        failing f;

        failing_init(&f, n);
        status = whole_way(&f, &h, &s);
        if (status != POV_OK && status != POV_E_MEMORY)
            fail_msg("allocation %ld: %s", n, pov_status_name(status));
        assert_int_equal(f.blocks, 0);
    }
    assert_true(n > 20);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(meshes_are_as_their_text),
        cmocka_unit_test(faces_have_materials),
        cmocka_unit_test(wrong_meshes_are_refused),
        cmocka_unit_test(what_differs_is_as_in_a_text),
        cmocka_unit_test(wrong_differences_are_refused),
        cmocka_unit_test(lights_are_as_their_text),
        cmocka_unit_test(a_camera_is_that_of_its_text),
        cmocka_unit_test(wrong_cameras_and_lights_are_refused),
        cmocka_unit_test(every_allocation_may_fail),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}

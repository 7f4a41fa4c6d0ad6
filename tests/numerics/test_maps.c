/* test_maps.c - a map taken into a shape is exact: the crossings are those of the exactly mapped shape, in 512 bits.
 *
 * test_maps RAYS for a long run. */
#include "numerics/families.h"
#include "numerics/real_map.h"

#include "support/check.h"
#include "support/fake_reader.h"

#include <float.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static long rays = 4000;

#define U families_uniform

/* ---- maps, in full and in double-double ---- */

static void split(real r, double *hi, double *lo)
{
    *hi = real_double(r);
    *lo = real_double(real_sub(r, real_of(*hi)));
}

/* The map that two parts can hold, and its exact inverse rounded to two parts. */
static void round_map(real_map *f, pov_affine *out)
{
    int i, j;

    for (i = 0; i < 3; i++) {
        for (j = 0; j < 4; j++) {
            split(f->m[i][j], &out->m[i][j], &out->m_lo[i][j]);
            f->m[i][j] = real_of2(out->m[i][j], out->m_lo[i][j]);
        }
    }
    real_map_invert(f);
    for (i = 0; i < 3; i++) {
        real moved = real_of(0.0);

        for (j = 0; j < 3; j++) {
            split(f->inverse[i][j], &out->inv[i][j], &out->inv_lo[i][j]);
            moved = real_sub(moved, real_mul(f->inverse[i][j], f->m[j][3]));
        }
        split(moved, &out->inv[i][3], &out->inv_lo[i][3]);
    }
}

/* A rotation in 512 bits, from a quaternion. */
static void turn(real_map *f)
{
    const real one = real_of(1.0), two = real_of(2.0);
    const real w = real_of(U() - 0.5), x = real_of(U() - 0.5), y = real_of(U() - 0.5), z = real_of(U() - 0.5);
    const real s = real_div(two, real_add(real_add(real_mul(w, w), real_mul(x, x)),
                                          real_add(real_mul(y, y), real_mul(z, z))));
    const real q[4] = { x, y, z, w };
    int i;

    for (i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;

        f->m[i][i] = real_sub(one, real_mul(s, real_add(real_mul(q[j], q[j]), real_mul(q[k], q[k]))));
        f->m[i][j] = real_mul(s, real_sub(real_mul(q[i], q[j]), real_mul(q[k], q[3])));
        f->m[i][k] = real_mul(s, real_add(real_mul(q[i], q[k]), real_mul(q[j], q[3])));
    }
}

/* A map that the kind can absorb: a rotation, or a permutation of the axes; a scaling; a translation of up to 1e9
 * sizes. */
static void make_map(kind k, real_map *f, pov_affine *out)
{
    const int shift = (int)(3.0 * U()), stretches = k == BOX || (k != SPHERE && U() < 0.5);
    const double scale = pow(10.0, 24.0 * U() - 12.0), far = pow(10.0, 9.0 * U());
    int i, j;

    if (k == BOX || U() < 0.2) {
        for (i = 0; i < 3; i++) {
            for (j = 0; j < 3; j++)
                f->m[i][j] = real_of(j == (i + shift) % 3 ? (U() < 0.5 ? 1.0 : -1.0) : 0.0);
        }
    } else {
        turn(f);
    }
    for (j = 0; j < 3; j++) {
        const real factor = real_of(stretches ? scale * pow(10.0, 2.0 * U() - 1.0) : scale);

        for (i = 0; i < 3; i++)
            f->m[i][j] = real_mul(f->m[i][j], factor);
    }
    for (i = 0; i < 3; i++)
        f->m[i][3] = real_of(scale * far * (2.0 * U() - 1.0));
    round_map(f, out);
}

static real3 mapped(const real_map *f, pov_vec3 v, bool point)
{
    const real x = real_of(v.x), y = real_of(v.y), z = real_of(v.z);
    real r[3];
    int i;

    for (i = 0; i < 3; i++) {
        r[i] = real_add(real_add(real_mul(f->m[i][0], x), real_mul(f->m[i][1], y)), real_mul(f->m[i][2], z));
        if (point)
            r[i] = real_add(r[i], f->m[i][3]);
    }
    return real3_of(r[0], r[1], r[2]);
}

static void split3(real3 v, pov_vec3 *hi, pov_vec3 *lo)
{
    split(v.x, &hi->x, &lo->x);
    split(v.y, &hi->y, &lo->y);
    split(v.z, &hi->z, &lo->z);
}

static real3 whole(pov_vec3 hi, pov_vec3 lo)
{
    return real3_of(real_of2(hi.x, lo.x), real_of2(hi.y, lo.y), real_of2(hi.z, lo.z));
}

/* ---- asking ---- */

/* The ray in the world, in double-double; and that very ray back in the shape's space, exactly. */
static pov_ray world_ray(const real_map *f, const pov_ray *own, real3 *org, real3 *dir)
{
    real_map copy = *f;
    pov_ray ray = *own;

    split3(mapped(f, own->org, true), &ray.org, &ray.org_lo);
    split3(mapped(f, own->dir, false), &ray.dir, &ray.dir_lo);
    *org = real_times(copy.inverse, real3_sub(whole(ray.org, ray.org_lo), real3_of(f->m[0][3], f->m[1][3], f->m[2][3])));
    *dir = real_times(copy.inverse, whole(ray.dir, ray.dir_lo));
    return ray;
}

/* How fast a ray leaves the surface that it crosses. */
static double rise_of(const probe *p, const exact_crossing *e)
{
    return fabs(e->normal[0] * p->ray.dir.x + e->normal[1] * p->ray.dir.y + e->normal[2] * p->ray.dir.z);
}

/* The accuracy of a coordinate in two parts, 1e9 sizes away. */
static double finest(const probe *p) { return 0x1p-70 * p->size; }

/* Nearer to a flat face no start is on one side of it. */
static bool is_on_face(const probe *p, const exact_crossing *e)
{
    return p->kind == BOX && fabs(real_double(e->t)) * rise_of(p, e) < finest(p);
}

static bool in_range(const exact_result *e, const probe *p)
{
    int i;

    for (i = 0; i < e->count; i++) {
        const double t = fabs(real_double(e->at[i].t)) * pov_dot(pov_unit(p->ray.dir), p->ray.dir);
        if (!(t < 1e9 * p->size && t > 1e-13 * p->size) || is_on_face(p, &e->at[i]))
            return false;
    }
    return true;
}

static double ulps_off(real exact, double t)
{
    const double near = fabs(real_double(exact));
    return fabs(real_double(real_sub(exact, real_of(t)))) / (nextafter(near, HUGE_VAL) - near);
}

/* Within the limit; or off the surface by no more than coordinates can hold, which the angle of a graze makes more along
 * the ray. */
static bool is_near(const probe *p, const exact_crossing *e, const pov_crossing *c, double limit)
{
    const double off = fabs(real_double(real_sub(e->t, real_of2(c->t, c->t_lo))));

    return ulps_off(e->t, c->t) <= limit || off * rise_of(p, e) < finest(p);
}

/* The exact normal goes by the transposed inverse. */
static double normal_off(const real_map *f, const exact_crossing *e, pov_vec3 found)
{
    const real n[3] = { real_of(e->normal[0]), real_of(e->normal[1]), real_of(e->normal[2]) };
    real r[3], length;
    int i;

    for (i = 0; i < 3; i++)
        r[i] = real_add(real_add(real_mul(f->inverse[0][i], n[0]), real_mul(f->inverse[1][i], n[1])),
                        real_mul(f->inverse[2][i], n[2]));
    length = real_sqrt(real3_dot(real3_of(r[0], r[1], r[2]), real3_of(r[0], r[1], r[2])));
    return fmax(fabs(found.x - real_double(real_div(r[0], length))),
                fmax(fabs(found.y - real_double(real_div(r[1], length))),
                     fabs(found.z - real_double(real_div(r[2], length)))));
}

static bool agrees(const shape_class *shape, const void *self, const real_map *f, const pov_ray *ray,
                   const probe *p, const exact_result *e, double limit)
{
    pov_crossing at[8];
    pov_hits hits = { .tmax = HUGE_VAL, .want = POV_WANT_ALL, .capacity = 8, .at = at };
    uint32_t i, n = 0;
    int j;

    shape->intersect(self, ray, &hits);
    for (j = 0; j < e->count; j++)
        n += real_sign(e->at[j].t) > 0;
    if (hits.count != n)
        return false;
    if (n == 2 && at[1].t < at[0].t) {
        const pov_crossing first = at[1];

        at[1] = at[0];
        at[0] = first;
    }
    for (j = 0, i = 0; j < e->count; j++) {
        pov_vec3 normal;

        if (real_sign(e->at[j].t) <= 0)
            continue;
        if (!is_near(p, &e->at[j], &at[i], limit))
            return false;
        shape->normal(self, ray, &at[i++], &normal);
        /* Two parts of a coordinate 1e9 sizes away are not fine enough for the neighbourhood of an apex. */
        if (e->at[j].clearance > 1e-6 * p->size && !(normal_off(f, &e->at[j], normal) <= 1e-13))
            return false;
    }
    return true;
}

/* How many of the probes of a family a kind gets wrong once mapped. */
static long count_wrong(kind k, const family *source, long *taken)
{
    const shape_class *shape = fake_reader_shape(probe_keyword(k));
    pov_reader *in = fake_reader_create();
    void *self = fake_reader_memory(in, shape->instance_size);
    long i, wrong = 0;

    for (i = 0; i < rays; i++) {
        real_map f;
        exact_result e;
        pov_affine map;
        pov_ray ray;
        real3 org, dir;
        probe p;

        real_reset();
        memset(&p, 0, sizeof p);
        p.kind = k;
        source->make(&p, source->parameter);
        if (!probe_make(&p, shape, in, self))
            continue;
        make_map(k, &f, &map);
        if (!shape->absorb(self, &map))
            continue;
        ray = world_ray(&f, &p.ray, &org, &dir);
        probe_exact_line(&p, org, dir, &e);
        if (!in_range(&e, &p))
            continue;
        ++*taken;
        if (!agrees(shape, self, &f, &ray, &p, &e, k == BOX ? 4.0 : k == SPHERE || k == QUADRIC ? 16.0 : 32.0)) {
            char line[4096];

            probe_write(&p, line, sizeof line);
            if (wrong++ < 3)
                print_error("%s, mapped by <%a, %a, %a, ...>: %s\n", source->name, map.m[0][0], map.m[0][1], map.m[0][2],
                            line);
        }
    }
    fake_reader_destroy(in);
    return wrong;
}

static void an_absorbed_map_is_exact(void **unused)
{
    static const char *const names[] = { "distance", "grazing", "two_parts", "translation" };
    const family *f;
    size_t n;
    int k;

    (void)unused;
    families_seed(11);
    for (k = SPHERE; k <= QUADRIC; k++) {
        long taken = 0, wrong = 0;

        for (f = families; f->name; f++) {
            for (n = 0; n < sizeof names / sizeof *names; n++) {
                if (strcmp(names[n], f->name) == 0 && f->kinds & (1u << k) && f->parameter <= 1e6)
                    wrong += count_wrong((kind)k, f, &taken);
            }
        }
        assert_true(taken > rays);
        if (wrong)
            print_error("%s: %ld of %ld\n", probe_keyword((kind)k), wrong, taken);
        assert_int_equal(wrong, 0);
    }
    real_free_all();
}

/* A long shape is scaled down and translated far: its axis must not be rounded to the precision of the place it is
 * moved to. */
static void a_box_holds_what_was_made_small_and_moved(void **unused)
{
    static const char *const texts[] = { "<0,0,0>, <0,1073741824,0>, 1", "<0,0,0>, 1, <0,1073741824,0>, 0.5" };
    pov_reader *in = fake_reader_create();
    int i, j, k;

    (void)unused;
    for (i = 0; i < 2; i++)
        for (j = 0; j < 40; j++) {
            const shape_class *shape = fake_reader_shape(i == 0 ? "cylinder" : "cone");
            void *self = fake_reader_memory(in, shape->instance_size);
            const double scale = (1.0 + 0.025 * j) / 1073741824.0, far = 1e6 / (1.0 + j);
            pov_affine map;
            pov_box box;

            memset(&map, 0, sizeof map);
            for (k = 0; k < 3; k++) {
                map.m[k][k] = scale;
                map.m[k][3] = far;
                map.inv[k][k] = 1.0 / scale;
                map.inv[k][3] = -far / scale;
            }
            fake_reader_clear(in);
            fake_reader_text(in, texts[i]);
            assert_true(fake_reader_parse_into(in, shape, self));
            assert_true(shape->absorb(self, &map) && shape->bounds(self, &box));
            assert_true(box.lo.y <= far && box.lo.y > far - 1e-8);
            assert_true(box.hi.y >= far + (1.0 + 0.025 * j) && box.hi.y < far + (1.0 + 0.025 * j) + 1e-8);
        }
    fake_reader_destroy(in);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(an_absorbed_map_is_exact),
                                        cmocka_unit_test(a_box_holds_what_was_made_small_and_moved) };

    if (argc > 1)
        rays = strtol(argv[1], NULL, 10);
    return cmocka_run_group_tests(tests, NULL, NULL);
}

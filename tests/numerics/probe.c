#include "numerics/probe.h"

#include "support/fake_reader.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const keywords[KINDS] = { "sphere", "box", "cone", "cylinder", "quadric", "polygon", "triangle",
                                             "mesh", "smooth_triangle", "torus", "plane", "disc" };
/* How many numbers stand in each place: v a vector, n a number. */
static const char *const forms[KINDS] = { "vn", "vv", "vnvn", "vvn", "vvvn", "n", "", "", "", "nn", "vn", "vvnn" };

const char *probe_keyword(kind k) { return keywords[k]; }

static void feed_vector(pov_reader *in, const double *v)
{
    fake_reader_word(in, "<");
    fake_reader_number(in, v[0]);
    fake_reader_number(in, v[1]);
    fake_reader_number(in, v[2]);
    fake_reader_word(in, ">");
}

/* Across two sides, so long that it does not vanish. */
void probe_flat_normal(const probe *p, double normal[3])
{
    const double *v = p->number;
    const pov_vec3 a = pov_unit(pov_vec3_of(v[4] - v[1], v[5] - v[2], v[6] - v[3]));
    const pov_vec3 b = pov_unit(pov_vec3_of(v[7] - v[1], v[8] - v[2], v[9] - v[3]));
    const pov_vec3 n = pov_cross_product(a, b);

    normal[0] = n.x, normal[1] = n.y, normal[2] = n.z;
}

static void feed_triangle(pov_reader *in, const probe *p)
{
    double normal[3];
    int i;

    probe_flat_normal(p, normal);
    if (p->kind == MESH) {
        fake_reader_word(in, "triangle");
        fake_reader_word(in, "{");
    }
    for (i = 1; i < 10; i += 3) {
        feed_vector(in, p->number + i);
        if (p->kind == SMOOTH_TRIANGLE)
            feed_vector(in, normal);
    }
    if (p->kind == MESH)
        fake_reader_word(in, "}");
}

bool probe_make(const probe *p, const shape_class *shape, pov_reader *in, void *self)
{
    const char *form = forms[p->kind];
    int at = 0;

    fake_reader_clear(in);
    for (; *form; form++) {
        if (*form == 'n') {
            fake_reader_number(in, p->number[at]);
        } else {
            feed_vector(in, p->number + at);
            at += 2;
        }
        at++;
    }
    for (; p->kind == POLYGON && at < p->count; at += 3)
        feed_vector(in, p->number + at);
    if (kind_has_corners(p->kind) && p->kind != POLYGON)
        feed_triangle(in, p);
    if (p->open)
        fake_reader_word(in, "open");
    return fake_reader_parse_into(in, shape, self);
}

/* By what the i-th number is multiplied if lengths are by `power`. */
static double factor_of(kind k, int i, double power)
{
    if (k == QUADRIC)
        return i < 6 ? 1.0 / (power * power) : i < 9 ? 1.0 / power : 1.0;
    if ((k == PLANE && i < 3) || (k == DISC && i >= 3 && i < 6) || (kind_has_corners(k) && i == 0))
        return 1.0;
    return power;
}

void probe_scale(probe *p, double power)
{
    int i;

    for (i = 0; i < p->count; i++)
        p->number[i] *= factor_of(p->kind, i, power);
    p->ray.org = pov_scale(p->ray.org, power);
    p->ray.org_lo = pov_scale(p->ray.org_lo, power);
    p->size *= power;
}

static int put(char *line, size_t size, int at, double value)
{
    return at < 0 || (size_t)at >= size ? -1 : at + snprintf(line + at, size - (size_t)at, " %a", value);
}

static int put3(char *line, size_t size, int at, pov_vec3 v)
{
    return put(line, size, put(line, size, put(line, size, at, v.x), v.y), v.z);
}

void probe_write(const probe *p, char *line, size_t size)
{
    int at = snprintf(line, size, "%s %d %d", keywords[p->kind], p->open, p->count), i;

    for (i = 0; i < p->count; i++)
        at = put(line, size, at, p->number[i]);
    at = put(line, size, at, p->size);
    at = put3(line, size, at, p->ray.org);
    at = put3(line, size, at, p->ray.org_lo);
    at = put3(line, size, at, p->ray.dir);
    put3(line, size, at, p->ray.dir_lo);
}

static double take(const char **line, bool *good)
{
    char *end;
    double value = strtod(*line, &end);

    *good = *good && end != *line;
    *line = end;
    return value;
}

static pov_vec3 take3(const char **line, bool *good)
{
    pov_vec3 v;

    v.x = take(line, good);
    v.y = take(line, good);
    v.z = take(line, good);
    return v;
}

bool probe_read(probe *p, const char *line)
{
    char word[16];
    int used, open, i;
    bool good = true;

    memset(p, 0, sizeof *p);
    if (sscanf(line, "%15s %d %d%n", word, &open, &p->count, &used) != 3)
        return false;
    while (p->kind < KINDS && strcmp(word, keywords[p->kind]) != 0)
        p->kind++;
    if (p->kind == KINDS || p->count < 0 || p->count > PROBE_NUMBERS)
        return false;
    p->open = open != 0;
    line += used;
    for (i = 0; i < p->count; i++)
        p->number[i] = take(&line, &good);
    p->size = take(&line, &good);
    p->ray.org = take3(&line, &good);
    p->ray.org_lo = take3(&line, &good);
    p->ray.dir = take3(&line, &good);
    p->ray.dir_lo = take3(&line, &good);
    p->ray.origin_surface = POV_NO_OWNER;
    return good;
}

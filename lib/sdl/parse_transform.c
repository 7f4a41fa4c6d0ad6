#include "sdl/parse.h"
#include "sdl/report.h"
#include "sdl/value.h"

static void append(pov_reader *in, const transform **list, transform_kind kind, const double *numbers)
{
    const transform *longer;

    if (in->failed || transform_changes_nothing(kind, numbers))
        return;
    longer = transform_append(&in->model->maps, *list, kind, numbers);
    if (longer)
        *list = longer;
    else
        report_memory(in);
}

static void mend_scale(pov_reader *in, double *v)
{
    bool mended = false;
    int i;

    for (i = 0; i < 3; i++) {
        if (v[i] == 0.0) {
            v[i] = 1.0;
            mended = true;
        }
    }
    if (mended)
        report_warn(in, &in->value, "a scale of 0 counts as 1");
}

/* A map that flattens space has no way back from a ray. */
bool parse_append_matrix(pov_reader *in, const transform **list, const double m[12])
{
    const transform *alone = NULL;
    pov_affine map;

    append(in, &alone, TRANSFORM_MATRIX, m);
    if (in->failed || !transform_compose(alone, &map))
        return false;
    append(in, list, TRANSFORM_MATRIX, m);
    return true;
}

/* A coordinate that no other gives anything to is kept, as by a scale of 1. */
static void mend_columns(pov_reader *in, double *m)
{
    int i;

    for (i = 0; i < 3 && !in->failed; i++)
        if (m[i] == 0.0 && m[3 + i] == 0.0 && m[6 + i] == 0.0) {
            m[4 * i] = 1.0;
            report_warn(in, &in->value, "a scale of 0 counts as 1");
        }
}

static void append_matrix(pov_reader *in, const transform **list)
{
    double m[VALUE_LIST_MAX];

    value_list(in, "\"<\" and 12 numbers for a matrix", 12, 12, m);
    mend_columns(in, m);
    if (!parse_append_matrix(in, list, m) && !in->failed)
        report_fail(in, &in->value, POV_E_SYNTAX, "the matrix has no inverse");
}

static void append_vector(pov_reader *in, const transform **list, keyword_id keyword)
{
    pov_vec3 vector = value_vector(in);
    double v[3];

    v[0] = vector.x;
    v[1] = vector.y;
    v[2] = vector.z;
    if (keyword == KEYWORD_SCALE && !in->failed)
        mend_scale(in, v);
    append(in, list,
           keyword == KEYWORD_SCALE    ? TRANSFORM_SCALE
           : keyword == KEYWORD_ROTATE ? TRANSFORM_ROTATE
                                       : TRANSFORM_TRANSLATE,
           v);
}

/* ---- lists of them ---- */

/* Of a list those behind `since`, from the first to the last. */
static const transform **gather(pov_reader *in, const transform *list, const transform *since, size_t *count)
{
    const transform *t, **all;
    size_t n = 0;

    for (t = list; t != since; t = t->before)
        n++;
    all = env_alloc(in->model->env, n + 1, sizeof *all);
    if (!all)
        report_memory(in);
    *count = all ? n : 0;
    for (t = list; t != since && all; t = t->before)
        all[--n] = t;
    return all;
}

void parse_append_transforms(pov_reader *in, const transform **list, const transform *more, const transform *since)
{
    const transform **all;
    size_t i, count;

    if (!since && (!*list || !more)) {
        *list = more ? more : *list;
        return;
    }
    all = gather(in, more, since, &count);
    for (i = 0; i < count; i++)
        append(in, list, all[i]->kind, all[i]->v);
    env_free(in->model->env, all);
}

uint32_t parse_count_transforms(const transform *list)
{
    uint32_t count = 0;

    for (; list; list = list->before)
        count++;
    return count;
}

const transform *parse_last_transforms(pov_reader *in, const transform *list, size_t count)
{
    const transform *out = NULL;
    size_t i, all_count;
    const transform **all = gather(in, list, NULL, &all_count);

    for (i = all_count - (count < all_count ? count : all_count); i < all_count; i++)
        append(in, &out, all[i]->kind, all[i]->v);
    env_free(in->model->env, all);
    return out;
}

static void invert_matrix(pov_reader *in, const transform **list, const transform *t)
{
    const transform *alone = NULL;
    pov_affine map;
    double m[12];
    int i;

    append(in, &alone, TRANSFORM_MATRIX, t->v);
    if (in->failed || !transform_compose(alone, &map))
        return;
    for (i = 0; i < 12; i++)
        m[i] = map.inv[i % 3][i / 3];
    append(in, list, TRANSFORM_MATRIX, m);
}

static void invert_rotation(pov_reader *in, const transform **list, const double *v)
{
    int i, j;

    for (i = 2; i >= 0; i--) {
        double degrees[3];

        for (j = 0; j < 3; j++)
            degrees[j] = j == i ? -v[j] : 0.0;
        append(in, list, TRANSFORM_ROTATE, degrees);
    }
}

static void invert_one(pov_reader *in, const transform **list, const transform *t)
{
    double v[3];
    int i;

    for (i = 0; i < 3 && t->kind != TRANSFORM_MATRIX; i++)
        v[i] = t->kind == TRANSFORM_SCALE ? 1.0 / t->v[i] : -t->v[i];
    if (t->kind == TRANSFORM_MATRIX)
        invert_matrix(in, list, t);
    else if (t->kind == TRANSFORM_ROTATE)
        invert_rotation(in, list, t->v);
    else
        append(in, list, t->kind, v);
}

/* The last is undone first. */
const transform *parse_invert_transforms(pov_reader *in, const transform *list)
{
    const transform *inverse = NULL;

    for (; list; list = list->before)
        invert_one(in, &inverse, list);
    return inverse;
}

void parse_append_translation(pov_reader *in, const transform **list, pov_vec3 by)
{
    const double numbers[3] = { by.x, by.y, by.z };

    append(in, list, TRANSFORM_TRANSLATE, numbers);
}

/* ---- transform { } ---- */

typedef struct transform_parsed { const transform *map; bool is_inverse; } transform_parsed;

static void read_move(pov_reader *in, void *self, keyword_id keyword)
{
    parse_transform(in, &((transform_parsed *)self)->map, keyword);
}

static void read_inverse(pov_reader *in, void *self, keyword_id keyword)
{
    (void)in;
    (void)keyword;
    ((transform_parsed *)self)->is_inverse = true;
}

static void take_transform(pov_reader *in, void *self, const value *v)
{
    parse_append_transforms(in, &((transform_parsed *)self)->map, v->as.part, NULL);
}

static const transform *read_block(pov_reader *in)
{
    static const item items[] = { PARSE_MOVES(read_move), { KEYWORD_INVERSE, read_inverse } };
    static const item_list list = { "a transformation", ITEMS(items), NULL, NULL, NULL, VALUE_TRANSFORM, take_transform };
    transform_parsed t = { NULL, false };
    value v;

    if (items_read_named(in, VALUE_TRANSFORM, &v))
        return in->failed ? NULL : v.as.part;
    items_block(in, &list, &t);
    return t.is_inverse ? parse_invert_transforms(in, t.map) : t.map;
}

value parse_transform_value(pov_reader *in)
{
    return value_of_part(VALUE_TRANSFORM, read_block(in));
}

void parse_transform(pov_reader *in, const transform **list, keyword_id keyword)
{
    if (keyword == KEYWORD_TRANSFORM)
        parse_append_transforms(in, list, read_block(in), NULL);
    else if (keyword == KEYWORD_MATRIX)
        append_matrix(in, list);
    else
        append_vector(in, list, keyword);
}

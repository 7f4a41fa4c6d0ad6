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
static void append_matrix(pov_reader *in, const transform **list)
{
    double m[VALUE_LIST_MAX];
    const transform *alone = NULL;
    pov_affine map;
    bool is_list = in->token.kind == '<';

    value_list(in, "a matrix", 12, 12, m);
    if (!is_list)
        report_fail(in, &in->value, POV_E_SYNTAX, "expected \"<\" and 12 numbers for a matrix");
    append(in, &alone, TRANSFORM_MATRIX, m);
    if (!in->failed && !transform_compose(alone, &map))
        report_fail(in, &in->value, POV_E_SYNTAX, "the matrix has no inverse");
    append(in, list, TRANSFORM_MATRIX, m);
}

void parse_transform(pov_reader *in, const transform **list, word_id word)
{
    pov_vec3 vector;
    double v[3];

    if (word == WORD_MATRIX) {
        append_matrix(in, list);
        return;
    }
    vector = value_vector(in);
    v[0] = vector.x;
    v[1] = vector.y;
    v[2] = vector.z;
    if (word == WORD_SCALE && !in->failed)
        mend_scale(in, v);
    append(in, list,
           word == WORD_SCALE    ? TRANSFORM_SCALE
           : word == WORD_ROTATE ? TRANSFORM_ROTATE
                                 : TRANSFORM_TRANSLATE,
           v);
}

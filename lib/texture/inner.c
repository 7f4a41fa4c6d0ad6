#include "texture/inner.h"

#include "texture/image_sample.h"
#include "texture/points.h"

#include <math.h>

/* ---- object ---- */

static pov_vec3 to_own(const double m[3][4], pov_vec3 p)
{
    return pov_vec3_of(m[0][0] * p.x + m[0][1] * p.y + m[0][2] * p.z + m[0][3],
                       m[1][0] * p.x + m[1][1] * p.y + m[1][2] * p.z + m[1][3],
                       m[2][0] * p.x + m[2][1] * p.y + m[2][2] * p.z + m[2][3]);
}

static bool group_holds(const solid_part *s, pov_vec3 point)
{
    const bool is_sum = s->op == NODE_UNION || s->op == NODE_MERGE;

    for (const solid_part *member = s->first; member; member = member->next) {
        const bool wanted = is_sum || (s->op == NODE_DIFFERENCE && member != s->first);

        /* A sum has what one member has; others lose what one member lacks, or has too much. */
        if (solid_holds(member, point) == wanted)
            return is_sum;
    }
    return !is_sum && s->first;
}

bool solid_holds(const solid_part *s, pov_vec3 point)
{
    const pov_vec3 zero = pov_vec3_of(0.0, 0.0, 0.0);
    bool holds;

    if (s->has_map)
        point = to_own(s->map, point);
    holds = s->inside ? s->inside(s->self, point, zero) : group_holds(s, point);
    return holds != s->is_inverse;
}

static void evaluate_object(const pattern_input *in, double *value)
{
    const object_pattern *self = in->of->self;

    for (uint32_t i = 0; i < in->n; i++)
        value[i] = solid_holds(self->solid, lanes_at(in->at, i)) ? 1.0 : 0.0;
}

const pattern_class pattern_object = {
    .keyword = "object",
    .count = 2,
    .list = { { .color = { 0.0f, 0.0f, 1.0f } }, { .color = { 0.0f, 1.0f, 0.0f } } },
    .self_size = sizeof(object_pattern),
    .evaluate = evaluate_object,
};

/* ---- pigment_pattern ---- */

/* What is clear beyond an image that does not repeat has no brightness; on uv coordinates it is white, as measured. */
static void find_edges(const pattern_input *in, const pattern *of, const texture_points *points, double *value)
{
    image_place places[LANES_MAX];
    vec_lanes at;

    points_place(in->model, of, points, in->n, &at, NULL);
    image_places(of->self, &at, in->n, places);
    for (uint32_t i = 0; i < in->n; i++)
        value[i] = places[i].is_outside ? 0.0 : value[i];
}

static void evaluate_pigment(const pattern_input *in, double *value)
{
    const pigment_pattern *self = in->of->self;
    const pattern *own = self->pigment->pattern;
    pigment pigments[LANES_MAX];
    texture_points points;

    points_begin(in, &points);
    pigment_eval(in->model, self->pigment, &points, in->n, pigments);
    for (uint32_t i = 0; i < in->n; i++) {
        const colour c = pigments[i].color;

        value[i] = 0.297 * (double)c.r + 0.589 * (double)c.g + 0.114 * (double)c.b;
    }
    if (own && own->class == &pattern_image_map && !own->uv)
        find_edges(in, own, &points, value);
}

static const pigment_node *pigment_of(const void *self) { return ((const pigment_pattern *)self)->pigment; }

const pattern_class pattern_pigment_pattern = {
    .keyword = "pigment_pattern",
    .self_size = sizeof(pigment_pattern),
    .inner = pigment_of,
    .evaluate = evaluate_pigment,
};

/* ---- function ---- */

/* What is above 1 repeats with a period of 1, as in gradients; what is below 0 is left to the wave. */
static void evaluate_function(const pattern_input *in, double *value)
{
    const function_pattern *self = in->of->self;
    function_memo own;

    own.count = 0;
    self->values(self->self, in->at, in->n, in->memo ? in->memo : &own, value);
    for (uint32_t i = 0; i < in->n; i++)
        value[i] = value[i] > 1.0 ? value[i] - floor(value[i]) : value[i];
}

const pattern_class pattern_function = {
    .keyword = "function",
    .self_size = sizeof(function_pattern),
    .evaluate = evaluate_function,
};

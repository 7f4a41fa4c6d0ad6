#include "shade/subsurface.h"

#include "base/elementary.h"
#include "shade/reflectance.h"
#include "shade/transmittance.h"

/* The dipole of Jensen, Marschner, Levoy, Hanrahan: A practical model for subsurface light transport, SIGGRAPH 2001. */

/* ---- the profile ---- */

/* One channel: distances of the poles from the surface, the attenuation between them, and the reduced albedo. norm: what
 * makes what each pole gives to the plane a density; share: the first pole's part of both. */
typedef struct channel { double height[2], fades, albedo, norm[2], share; } channel;
typedef struct below { channel of[3]; double ior; } below;

static const double pi = 3.14159265358979323846;

/* The second pole lies so many mean free paths above the surface. Light that meets the surface from below is not turned back by the profile,
 * whatever the ior: so it is in POV-Ray, by what faces of many sizes give in even light. */
static const double image_height = 7.0 / 3.0;

double subsurface_reflected(double albedo)
{
    const double root = sqrt(3.0 * (1.0 - albedo));

    return 0.5 * albedo * (elementary_exp(-root) + elementary_exp(-image_height * root));
}

double subsurface_albedo(double reflected)
{
    double lo = 0.0, hi = 1.0;

    if (!(reflected < 1.0))
        return 1.0;
    for (int i = 0; i < 32; i++) {
        const double middle = 0.5 * (lo + hi);

        if (subsurface_reflected(middle) < reflected)
            lo = middle;
        else
            hi = middle;
    }
    return 0.5 * (lo + hi);
}

/* scatters: the mean way to a place where light is scattered, if none is absorbed on it. */
static channel channel_of(double scatters, double reflected)
{
    const double albedo = subsurface_albedo(reflected), length = scatters * pov_max(albedo, 0x1p-10), fades = sqrt(3.0 * (1.0 - albedo)) / length;
    const double image = length * image_height, real_left = elementary_exp(-fades * length);
    const double image_left = elementary_exp(-fades * image);
    const channel out = { { length, image }, fades, albedo, { 0.5 / (pi * real_left), 0.5 / (pi * image_left) },
                          real_left / (real_left + image_left) };

    return out;
}

/* Light goes no way at all in a channel that is not translucent: a thousandth of the others counts as none. */
static double path_of(float translucency, double scale) { return pov_max((double)translucency, 0x1p-10) * scale; }

double subsurface_ior(const shading *scene, const surface *s)
{
    return dielectric_interior(scene->model, world_solid(scene->world, s->at->object))->ior;
}

static below below_of(const shading *scene, const surface *s)
{
    const appearance *a = s->appearance;
    const double scale = 1.0 / scene->model->subsurface.mm_per_unit;
    const colour mean = a->finish->translucency, by = colour_scale(a->pigment, a->below_weight);
    const below out = { { channel_of(path_of(mean.r, scale), (double)by.r),
                           channel_of(path_of(mean.g, scale), (double)by.g),
                           channel_of(path_of(mean.b, scale), (double)by.b) }, subsurface_ior(scene, s) };

    return out;
}

colour subsurface_unscattered(const shading *scene, const surface *s, double length)
{
    const below in = below_of(scene, s);
    double left[3];

    for (int c = 0; c < 3; c++)
        left[c] = elementary_exp(-length / in.of[c].height[0]);
    return colour_scale(colour_of((float)left[0], (float)left[1], (float)left[2]), s->appearance->opacity);
}

static double pole(double height, double fades, double square)
{
    const double d = sqrt(square + height * height);

    return height * (1.0 + fades * d) * elementary_exp(-fades * d) / (d * d * d);
}

/* Light that leaves per area at this squared distance from where it enters. */
static double profile(const channel *c, double square)
{
    return c->albedo / (4.0 * pi) * (pole(c->height[0], c->fades, square) + pole(c->height[1], c->fades, square));
}

/* ---- points of the surface ---- */

/* Where light may enter: lines through the neighbourhood of a point, along its normal and across. */
enum { AXES = 3, PROBES = 32, CROSSINGS = 8, PURPOSE = 0x5355 };
static const double probes_of[AXES] = { 16.0, 8.0, 8.0 };

typedef struct search {
    shade_context *context;
    const surface *from;
    below in;
    pov_vec3 axes[AXES];
    colour sum;
} search;

/* Channels that are alike are drawn as one. */
static int channels_of(const below *m)
{
    const channel *c = m->of;

    return c[0].height[0] == c[1].height[0] && c[0].height[0] == c[2].height[0] && c[0].fades == c[1].fades &&
           c[0].fades == c[2].fades ? 1 : 3;
}

/* The density of the distances that are drawn: for each channel alike, what its poles give to the plane. */
static double disc_density(const below *m, double square)
{
    const int count = channels_of(m);
    double sum = 0.0;

    for (int c = 0; c < count; c++) {
        const channel *of = &m->of[c];

        sum += of->share * of->norm[0] * pole(of->height[0], of->fades, square) +
               (1.0 - of->share) * of->norm[1] * pole(of->height[1], of->fades, square);
    }
    return sum / count;
}

/* What is drawn beyond this distance. */
static double beyond_disc(const below *m, double square)
{
    const int count = channels_of(m);
    double sum = 0.0;

    for (int c = 0; c < count; c++)
        for (int k = 0; k < 2; k++) {
            const channel *of = &m->of[c];
            const double h = of->height[k], d = sqrt(square + h * h);

            sum += (k ? 1.0 - of->share : of->share) * h / d * elementary_exp(-of->fades * (d - h));
        }
    return sum / count;
}

/* The distance beyond which `rest` is drawn, by Newton's steps for the logarithm, and halving where these leave what is
 * known. */
static double draw_radius(const below *m, double rest)
{
    double lo = 0.0, hi = m->of[0].height[1] / rest, r;

    for (int c = 1; c < 3; c++)
        hi = pov_max(hi, m->of[c].height[1] / rest);
    r = pov_min(hi, m->of[0].height[0]);
    for (int i = 0; i < 40; i++) {
        const double is = beyond_disc(m, r * r), slope = 2.0 * pi * r * disc_density(m, r * r);
        double next;

        if (is > rest)
            lo = r;
        else
            hi = r;
        next = r + elementary_log(is / rest) * is / slope;
        if (fabs(next - r) <= 0x1p-24 * r)
            break;
        r = next > lo && next < hi ? next : 0.5 * (lo + hi);
    }
    return r;
}

/* How densely points around `to` with this normal are drawn, by all axes together. */
static double density(const search *s, pov_vec3 to, pov_vec3 normal)
{
    double sum = 0.0;

    for (int k = 0; k < AXES; k++) {
        const double along = pov_dot(to, s->axes[k]);

        sum += probes_of[k] * disc_density(&s->in, pov_max(pov_dot(to, to) - along * along, 0.0)) *
               fabs(pov_dot(normal, s->axes[k]));
    }
    return sum;
}

/* ---- light that enters ---- */

static double entering(double ior, double cosine) { return 1.0 - reflectance_fresnel(cosine, ior); }

/* The cosine behind the surface. */
static double cosine_below(double ior, double cosine)
{
    return sqrt(pov_max(1.0 - (1.0 - cosine * cosine) / (ior * ior), 0.0));
}

/* What light at a point is wanted for: all that enters; or, where `out` is not 0, the share of it that is scattered once
 * below a flat surface and leaves at this cosine below it. */
typedef struct wanted { double ior, out; } wanted;

/* Light that is scattered once fades on both ways. By what POV-Ray shows it fades on the way out twice: with the ratio g of the
 * cosines below, out over in, it is 1/((1 + g) (2 + g)), where 1/(1 + g) would be right (docs/light.md). */
static double share_of(const wanted *for_what, double cosine)
{
    const double enters = cosine * entering(for_what->ior, cosine), in = cosine_below(for_what->ior, cosine), out = for_what->out;

    return out > 0.0 ? enters * 0.25 * in * in / ((in + out) * (2.0 * in + out)) : enters;
}

/* Of one light, at a point with this outward normal. */
static colour light_from(shade_context *c, const scene_light *from, const hit *at, const wanted *for_what)
{
    const light_origin origin = light_own_origin(from->light);
    const segment_end end = { 1.0, from->class->parallel ? NULL : &origin, 0 };
    vec_lanes point, low;
    const light_points points = { &point, &low, 1 };
    colour through = colour_of(1.0f, 1.0f, 1.0f);
    pov_ray ray = { .org = at->point, .org_lo = at->point_lo };
    const pov_ray *rays = &ray;
    const path none = { .hue = PATH_WHITE }, *path_at = &none;
    light_lanes in;
    double cosine;

    for (uint32_t i = 0; i < lanes_whole(1); i++) {
        lanes_put(&point, i, at->point);
        lanes_put(&low, i, at->point_lo);
    }
    from->class->incident(from->light, &origin, &points, &in);
    ray.dir = lanes_at(&in.dir, 0);
    cosine = pov_dot(at->normal, pov_unit(ray.dir));
    if (!(cosine > 0.0))
        return colour_of(0.0f, 0.0f, 0.0f);
    world_set_origin(&ray, at, 0);
    world_origin_leave(&ray, at->outside == at->entering, cosine, 1.0);   /* the normal is the solid's */
    c->counts.shadow++;
    if (c->scene->plan->shadows && !(from->light->flags & LIGHT_SHADOWLESS) &&
        !transmittance_find(c, &rays, &path_at, 1, end, &through))
        return colour_of(0.0f, 0.0f, 0.0f);
    through = colour_mul(through, in.uniform ? in.color : colour_of(in.red[0], in.green[0], in.blue[0]));
    return colour_scale(through, (float)share_of(for_what, cosine));
}

static colour light_at(shade_context *c, const hit *at, const wanted *for_what)
{
    const shading *scene = c->scene;
    colour sum = colour_of(0.0f, 0.0f, 0.0f);

    for (size_t k = 0; k < scene->light_count; k++)
        if (scene->model->light_groups.count == 0 || model_is_lit_by(scene->model, at->object, scene->lights[k].light))
            sum = colour_add(sum, light_from(c, &scene->lights[k], at, for_what));
    return sum;
}

static void add_point(search *s, const hit *at)
{
    const wanted all = { s->in.ior, 0.0 };
    const pov_vec3 to = pov_sub(at->point, s->from->at->point);
    const double square = pov_dot(to, to), per = 1.0 / density(s, to, at->normal);
    const colour by = colour_of((float)(profile(&s->in.of[0], square) * per), (float)(profile(&s->in.of[1], square) * per),
                                (float)(profile(&s->in.of[2], square) * per));

    if (per < HUGE_VAL)
        s->sum = colour_add(s->sum, colour_mul(by, light_at(s->context, at, &all)));
}

/* All crossings of a line with the solid. */
static void follow_line(search *s, pov_ray ray)
{
    const world *w = s->context->scene->world;
    const uint32_t solid = world_solid(w, s->from->at->object);
    const pov_ray *rays = &ray;
    hit h;

    for (int i = 0; i < CROSSINGS && query_nearest(w, s->context->context, &rays, 1, HUGE_VAL, &h); i++) {
        world_surface(w, &ray, &h);
        if (world_solid(w, h.object) == solid)
            add_point(s, &h);
        ray.org = h.point;
        ray.org_lo = h.point_lo;
        world_origin_transmit(&ray, &h, fabs(pov_dot(ray.dir, h.normal)));
    }
}

/* Lines begin so many times the distance drawn before the point: what lies further is lit by as good as nothing. */
static const double before = 64.0;

static void probe(search *s, int k, sequence_point at)
{
    const double r = draw_radius(&s->in, pov_max(1.0 - at.x, 0x1p-60)), angle = 2.0 * pi * at.y;
    const int axis = k < 16 ? 0 : k < 24 ? 1 : 2;
    const pov_vec3 a = s->axes[axis], u = s->axes[(axis + 1) % AXES], v = s->axes[(axis + 2) % AXES];
    const pov_vec3 side = pov_add(pov_scale(u, r * elementary_cos(angle)), pov_scale(v, r * elementary_sin(angle)));
    pov_ray ray = { .origin_surface = POV_NO_OWNER };

    ray.org = pov_add(s->from->at->point, pov_add(side, pov_scale(a, before * (r + s->in.of[0].height[0]))));
    ray.dir = pov_scale(a, -1.0);
    follow_line(s, ray);
}

/* ---- surfaces ---- */

static void find_axes(pov_vec3 normal, pov_vec3 out[AXES])
{
    const pov_vec3 from = fabs(normal.x) < 0.5 ? pov_vec3_of(1, 0, 0) : pov_vec3_of(0, 1, 0);

    out[0] = normal;
    out[1] = pov_unit(pov_cross_product(normal, from));
    out[2] = pov_cross_product(normal, out[1]);
}

/* For a surface that is flat and evenly lit around. */
static colour scattered_once(const search *s, double cosine)
{
    const wanted once = { s->in.ior, cosine_below(s->in.ior, cosine) };
    const channel *of = s->in.of;

    return colour_mul(colour_of((float)of[0].albedo, (float)of[1].albedo, (float)of[2].albedo),
                      light_at(s->context, s->from->at, &once));
}

static void light_surface(shade_context *c, surfaces *on, uint32_t i)
{
    const geometry *g = &on->geometry;
    const surface *s = &on->at[i];
    const sample_id *id = &c->samples[s->from->lane];
    search f = { .context = c, .from = s, .in = below_of(c->scene, s) };
    double out;

    find_axes(lanes_at(&g->to.normal, i), f.axes);
    for (int k = 0; k < PROBES && !c->failed; k++)
        probe(&f, k, random_point(id, (uint32_t)k, PROBES, PURPOSE + s->from->branch));
    f.sum = colour_add(f.sum, scattered_once(&f, fabs(g->cosine[i])));
    out = entering(f.in.ior, fabs(g->cosine[i]));
    colour_lane_add(&on->lit, i, colour_scale(f.sum, (float)out));
    c->failed = c->failed || query_context_failed(c->context);
}

void subsurface_add(shade_context *c, const finishes *lit, surfaces *on)
{
    for (uint32_t k = 0; k < lit->count && !c->failed; k++)
        if (on->at[lit->lit[k]].appearance->below_weight != 0.0f)
            light_surface(c, on, lit->lit[k]);
}

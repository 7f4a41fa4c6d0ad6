#include "sdl/parse_warp.h"

#include "sdl/expression.h"
#include "sdl/report.h"
#include "sdl/value.h"

/* ---- turbulence ---- */

void parse_octaves(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    ((turbulence *)self)->octaves = turbulence_octaves(value_number(in));
}

void parse_lambda(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    ((turbulence *)self)->lambda = value_float(in);
}

void parse_omega(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    ((turbulence *)self)->omega = value_float(in);
}

static void read_turbulence(pov_reader *in, warp *w, block *b)
{
    static const item items[] = { PARSE_OCTAVES };
    static const item_list list = { "an item of the turbulence", ITEMS(items), NULL, NULL, NULL, VALUE_NOTHING, NULL };

    w->as.turbulence = turbulence_default();
    w->as.turbulence.amount = value_vector(in);
    items_close(in, b, &list, &w->as.turbulence);
}

/* ---- repeat ---- */

static void read_flip(pov_reader *in, void *self, keyword_id keyword)
{
    const pov_vec3 v = value_vector(in);
    warp *w = self;

    (void)keyword;
    w->as.repeat.flip[0] = v.x != 0.0;
    w->as.repeat.flip[1] = v.y != 0.0;
    w->as.repeat.flip[2] = v.z != 0.0;
}

static void read_offset(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    ((warp *)self)->as.repeat.offset = value_vector(in);
}

/* POV-Ray keeps the width as a float. */
static void read_axis(pov_reader *in, warp *w)
{
    const pov_vec3 v = value_vector(in);
    const double width[3] = { v.x, v.y, v.z };
    int axes = 0;

    for (int i = 0; i < 3; i++)
        if (width[i] != 0.0) {
            w->as.repeat.axis = i;
            w->as.repeat.width = (double)(float)width[i];
            axes++;
        }
    if (!in->failed && axes != 1)
        report_fail(in, &in->value, POV_E_SYNTAX, "\"repeat\" needs a vector along one axis");
}

static void read_repeat(pov_reader *in, warp *w, block *b)
{
    static const item items[] = { { KEYWORD_FLIP, read_flip }, { KEYWORD_OFFSET, read_offset } };
    static const item_list list = { "an item of the repeat", ITEMS(items), NULL, NULL, NULL, VALUE_NOTHING, NULL };

    read_axis(in, w);
    items_close(in, b, &list, w);
}

/* ---- black_hole ---- */

static void read_strength(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    ((warp *)self)->as.black_hole.strength = value_number(in);
}

static void read_falloff(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    ((warp *)self)->as.black_hole.falloff = value_number(in);
}

static void read_inverse(pov_reader *in, void *self, keyword_id keyword)
{
    (void)in;
    (void)keyword;
    ((warp *)self)->as.black_hole.is_inverse = true;
}

static void read_cells(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    ((warp *)self)->as.black_hole.repeat = value_vector(in);
}

static void read_hole_turbulence(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    ((warp *)self)->as.black_hole.turbulence = value_vector(in);
}

static void read_black_hole(pov_reader *in, warp *w, block *b)
{
    static const item items[] = { { KEYWORD_STRENGTH, read_strength }, { KEYWORD_FALLOFF, read_falloff },
                                  { KEYWORD_INVERSE, read_inverse },   { KEYWORD_REPEAT, read_cells },
                                  { KEYWORD_TURBULENCE, read_hole_turbulence } };
    static const item_list list = { "an item of the black_hole", ITEMS(items), NULL, NULL, NULL, VALUE_NOTHING, NULL };
    warp_black_hole *hole = &w->as.black_hole;

    hole->strength = 1.0;
    hole->falloff = 2.0;
    hole->center = value_vector(in);
    state_accept(in, ',');
    hole->radius = value_number(in);
    items_close(in, b, &list, w);
}

/* ---- mappings ---- */

static void read_orientation(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    ((warp *)self)->as.mapping.orientation = pov_unit(value_vector(in));
}

static void read_dist_exp(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    ((warp *)self)->as.mapping.dist_exp = value_number(in);
}

static void read_major_radius(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    ((warp *)self)->as.mapping.major_radius = value_number(in);
}

#define MAPPING_ITEMS { KEYWORD_ORIENTATION, read_orientation }, { KEYWORD_DIST_EXP, read_dist_exp }

static void read_round(pov_reader *in, warp *w, block *b)
{
    static const item items[] = { MAPPING_ITEMS, { KEYWORD_MAJOR_RADIUS, read_major_radius } };
    static const item_list toroidal = { "an item of the warp", ITEMS(items), NULL, NULL, NULL, VALUE_NOTHING, NULL };
    static const item_list others = { "an item of the warp", items, 2, NULL, NULL, NULL, VALUE_NOTHING, NULL };

    items_close(in, b, w->kind == WARP_TOROIDAL ? &toroidal : &others, w);
}

/* `planar`, or `planar <orientation>, distance`. */
static void read_planar(pov_reader *in, warp *w, block *b)
{
    static const item_list list = { "the end of the warp", NULL, 0, NULL, NULL, NULL, VALUE_NOTHING, NULL };

    if (w->kind == WARP_PLANAR && value_follows(in)) {
        w->as.mapping.orientation = pov_unit(value_vector(in));
        state_accept(in, ',');
        w->as.mapping.distance = value_number(in);
    }
    items_close(in, b, &list, w);
}

/* ---- all of them ---- */

typedef struct warp_row {
    keyword_id keyword;
    warp_kind kind;
    void (*read)(pov_reader *in, warp *w, block *b);   /* to the end of the block */
} warp_row;

static const warp_row rows[] = {
    { KEYWORD_REPEAT, WARP_REPEAT, read_repeat },
    { KEYWORD_BLACK_HOLE, WARP_BLACK_HOLE, read_black_hole },
    { KEYWORD_TURBULENCE, WARP_TURBULENCE, read_turbulence },
    { KEYWORD_CYLINDRICAL, WARP_CYLINDRICAL, read_round },
    { KEYWORD_SPHERICAL, WARP_SPHERICAL, read_round },
    { KEYWORD_TOROIDAL, WARP_TOROIDAL, read_round },
    { KEYWORD_PLANAR, WARP_PLANAR, read_planar },
    { KEYWORD_CUBIC, WARP_CUBIC, read_planar },
};
enum { ROWS = sizeof rows / sizeof rows[0] };

static void refuse(pov_reader *in)
{
    guess g;

    report_guess_start(&g, in);
    for (size_t i = 0; i < ROWS; i++)
        report_guess_try(&g, token_keyword_name(rows[i].keyword));
    report_misplaced(in, "a kind of warp", &g);
}

static void read_kind(pov_reader *in, warp *w, block *b)
{
    const keyword_id keyword = state_keyword(in);
    size_t i = 0;

    while (i < ROWS && rows[i].keyword != keyword)
        i++;
    if (i == ROWS) {
        refuse(in);
        in->block = b->outer;
        return;
    }
    w->kind = rows[i].kind;
    if (w->kind >= WARP_CYLINDRICAL) {
        w->as.mapping.orientation = pov_vec3_of(0.0, 0.0, 1.0);
        w->as.mapping.major_radius = 1.0;
    }
    state_advance(in);
    rows[i].read(in, w, b);
}

/* Points are moved by the inverse. */
static void keep_moves(pov_reader *in, const transform *moves, warp *w)
{
    pov_affine map;

    if (in->failed || !moves)
        return;
    if (!transform_compose(moves, &map))
        report_fail(in, &in->last, POV_E_SYNTAX, "the texture is moved beyond what a double holds");
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 4; k++)
            w->map[i][k] = map.inv[i][k];
    w->has_map = true;
}

const warp *parse_warp(pov_reader *in, const transform *moves, const warp *list)
{
    warp *w = state_alloc(in, sizeof *w, sizeof(double));
    block b;

    if (!w)
        return NULL;
    w->next = list;
    keep_moves(in, moves, w);
    items_open(in, &b);
    read_kind(in, w, &b);
    return in->failed ? NULL : w;
}

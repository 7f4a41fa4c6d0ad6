/* text { ttf "font" | internal n, "string", depth, offset }: glyphs in the plane of x and y, swept along z from 0 to depth.
 *
 * The em of the font is 1 high. Outlines are taken as the font has them, unhinted; each glyph is a sweep of its own. */
#include "common/boxed.h"
#include "common/simd.h"
#include "common/swept.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

/* Boxes of glyphs that are tested side by side, by axis. */
enum { SIDE = POV_BLOCK_MAX };
typedef struct glyph_boxes { double lo[3][SIDE], hi[3][SIDE]; } glyph_boxes;

typedef struct text {
    uint32_t count;              /* glyphs that have an outline */
    common_swept *glyph;
    glyph_boxes *boxes;
    common_boxed boxed;
    uint32_t pieces;             /* of all glyphs */
    pov_box blanks;              /* where the pen stands at glyphs without an outline: they count for the box; lo above hi: none */
} text;

/* ---- the font ---- */

typedef struct reading {
    const pov_host *host;
    pov_reader *in;
    text *out;
    FT_Library library;
    FT_Face face;
    const unsigned char *rest;   /* of the string */
    double depth;
    pov_vec3 pen, offset;
    double em;
    common_outline *outline;     /* the one being made */
    double at[2];
} reading;

static const char *font_name(const pov_host *host, pov_reader *in)
{
    static const char *const internal[] = { "povlogo.ttf", "timrom.ttf", "cyrvetic.ttf", "crystal.ttf" };

    if (!host->accept(in, "internal")) {
        host->accept(in, "ttf");
        return host->string(in);
    }
    {
        const double n = host->number(in);

        return internal[n >= 0.0 && n < 4.0 ? (int)n : 1];
    }
}

static bool open_font(reading *r, const char *name)
{
    size_t bytes;
    const void *data = r->host->file(r->in, name, &bytes);

    if (!data)
        return false;
    if (FT_Init_FreeType(&r->library) != 0) {
        r->library = NULL;
        r->host->fail(r->in, "no memory for fonts");
        return false;
    }
    if (FT_New_Memory_Face(r->library, data, (FT_Long)bytes, 0, &r->face) != 0 || !FT_IS_SCALABLE(r->face)) {
        r->host->fail(r->in, "%.100s is not a font with outlines", name);
        return false;
    }
    if (!r->face->charmap && r->face->num_charmaps > 0 && FT_Select_Charmap(r->face, FT_ENCODING_MS_SYMBOL) != 0)
        FT_Set_Charmap(r->face, r->face->charmaps[0]);
    r->em = 1.0 / (double)r->face->units_per_EM;
    return true;
}

static void close_font(reading *r)
{
    if (r->face)
        FT_Done_Face(r->face);
    if (r->library)
        FT_Done_FreeType(r->library);
}

/* ---- outlines ---- */

static double x_of(const reading *r, const FT_Vector *v) { return (double)v->x * r->em + r->pen.x; }
static double y_of(const reading *r, const FT_Vector *v) { return (double)v->y * r->em + r->pen.y; }

static int add(reading *r, common_piece *c)
{
    c->x[0] = r->at[0];
    c->y[0] = r->at[1];
    r->at[0] = c->x[c->degree];
    r->at[1] = c->y[c->degree];
    return common_outline_add(r->outline, r->host, r->in, c) ? 0 : 1;
}

static int move_to(const FT_Vector *to, void *user)
{
    reading *r = user;

    r->at[0] = x_of(r, to);
    r->at[1] = y_of(r, to);
    return 0;
}

static int line_to(const FT_Vector *to, void *user)
{
    reading *r = user;
    common_piece c = { 1, { 0.0, x_of(r, to) }, { 0.0, y_of(r, to) } };

    return add(r, &c);
}

static int conic_to(const FT_Vector *a, const FT_Vector *to, void *user)
{
    reading *r = user;
    common_piece c = { 2, { 0.0, x_of(r, a), x_of(r, to) }, { 0.0, y_of(r, a), y_of(r, to) } };

    return add(r, &c);
}

static int cubic_to(const FT_Vector *a, const FT_Vector *b, const FT_Vector *to, void *user)
{
    reading *r = user;
    common_piece c = { 3, { 0.0, x_of(r, a), x_of(r, b), x_of(r, to) }, { 0.0, y_of(r, a), y_of(r, b), y_of(r, to) } };

    return add(r, &c);
}

/* ---- the string ---- */

/* The next character of UTF-8; a byte that begins none is one of Latin-1. */
static uint32_t next_character(reading *r)
{
    const unsigned char *s = r->rest;
    const uint32_t more = s[0] >= 0xf0 && s[0] < 0xf8 ? 3 : s[0] >= 0xe0 ? 2 : s[0] >= 0xc0 ? 1 : 0;
    uint32_t code = s[0] & (0x7fu >> (more + (more > 0)));

    for (uint32_t i = 1; i <= more; i++) {
        if ((s[i] & 0xc0) != 0x80 || s[0] >= 0xf8) {
            r->rest++;
            return s[0];
        }
        code = code << 6 | (s[i] & 0x3f);
    }
    r->rest += more + 1;
    return more > 0 || s[0] < 0x80 ? code : s[0];
}

/* Fonts of symbols have theirs from 0xf000 on. */
static FT_UInt glyph_of(const reading *r, uint32_t code)
{
    const FT_UInt index = FT_Get_Char_Index(r->face, code);

    return index != 0 || code > 0xff ? index : FT_Get_Char_Index(r->face, 0xf000 + code);
}

static void note_blank(reading *r)
{
    pov_box *b = &r->out->blanks;

    b->lo = pov_vec3_of(pov_min(b->lo.x, r->pen.x), pov_min(b->lo.y, r->pen.y), pov_min(0.0, r->depth));
    b->hi = pov_vec3_of(pov_max(b->hi.x, r->pen.x), pov_max(b->hi.y, r->pen.y), pov_max(0.0, r->depth));
}

static void take_outline(reading *r)
{
    static const FT_Outline_Funcs functions = { move_to, line_to, conic_to, cubic_to, 0, 0 };
    common_swept *g = &r->out->glyph[r->out->count];

    memset(g, 0, sizeof *g);
    g->axis = 2;
    g->lo = pov_two_of(pov_min(0.0, r->depth), 0.0);
    g->hi = pov_two_of(pov_max(0.0, r->depth), 0.0);
    r->outline = &g->outline;
    FT_Outline_Decompose(&r->face->glyph->outline, &functions, r);
    if (g->outline.count == 0) {
        note_blank(r);
        return;
    }
    g->first = 2 * r->out->count + r->out->pieces;
    r->out->pieces += g->outline.count;
    r->out->count++;
}

static void set_line(reading *r, const char *string)
{
    FT_UInt before = 0;
    bool is_first = true;

    r->rest = (const unsigned char *)string;
    r->out->glyph = r->host->alloc(r->in, (strlen(string) + 1) * sizeof *r->out->glyph);
    while (r->out->glyph && *r->rest != '\0') {
        const FT_UInt index = glyph_of(r, next_character(r));
        FT_Vector kern = { 0, 0 };

        if (FT_Load_Glyph(r->face, index, FT_LOAD_NO_SCALE) != 0)
            continue;
        if (before != 0 && FT_Get_Kerning(r->face, before, index, FT_KERNING_UNSCALED, &kern) == 0)
            r->pen.x += (double)kern.x * r->em;
        if (is_first)            /* the line begins at the edge of its first glyph */
            r->pen.x = -(double)r->face->glyph->metrics.horiBearingX * r->em;
        take_outline(r);
        r->pen.x += r->offset.x + (double)r->face->glyph->metrics.horiAdvance * r->em;
        r->pen.y += r->offset.y;
        before = index;
        is_first = false;
    }
}

/* ---- in space ---- */

static void put_box(glyph_boxes *b, uint32_t lane, pov_vec3 lo, pov_vec3 hi)
{
    b->lo[0][lane] = lo.x;
    b->lo[1][lane] = lo.y;
    b->lo[2][lane] = lo.z;
    b->hi[0][lane] = hi.x;
    b->hi[1][lane] = hi.y;
    b->hi[2][lane] = hi.z;
}

/* Lanes past the end hold the last one again. */
static void pack_boxes(text *t, const pov_host *host, pov_reader *in)
{
    const uint32_t blocks = (t->count + SIDE - 1) / SIDE;

    t->boxes = blocks > 0 ? host->alloc(in, blocks * sizeof *t->boxes) : NULL;
    for (uint32_t i = 0; t->boxes && i < blocks * SIDE; i++) {
        const common_swept *g = &t->glyph[i < t->count ? i : t->count - 1];

        put_box(&t->boxes[i / SIDE], i % SIDE, g->least, g->most);
    }
}

static void widen(common_boxed *b, pov_vec3 lo, pov_vec3 hi)
{
    b->lo = pov_vec3_of(pov_min(b->lo.x, lo.x), pov_min(b->lo.y, lo.y), pov_min(b->lo.z, lo.z));
    b->hi = pov_vec3_of(pov_max(b->hi.x, hi.x), pov_max(b->hi.y, hi.y), pov_max(b->hi.z, hi.z));
}

static void place(text *t, const pov_host *host, pov_reader *in)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    pov_vec3 lo = { HUGE_VAL, HUGE_VAL, HUGE_VAL }, hi = { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL }, a, b, middle;
    double at[2];

    for (uint32_t i = 0; i < t->count; i++) {
        common_outline_bound(&t->glyph[i].outline);
        common_swept_bounds(&t->glyph[i], &a, &b);
        lo = pov_vec3_of(pov_min(lo.x, a.x), pov_min(lo.y, a.y), pov_min(lo.z, a.z));
        hi = pov_vec3_of(pov_max(hi.x, b.x), pov_max(hi.y, b.y), pov_max(hi.z, b.z));
    }
    middle = t->count > 0 ? pov_scale(pov_add(lo, hi), 0.5) : zero;
    t->boxed.scale = t->count > 0 ? pov_inverse_power(pov_largest(pov_sub(hi, lo))) : 1.0;
    t->boxed.anchor = pov_two3_of(middle, zero);
    t->boxed.lo = pov_vec3_of(HUGE_VAL, HUGE_VAL, HUGE_VAL);
    t->boxed.hi = pov_scale(t->boxed.lo, -1.0);
    at[0] = middle.x;
    at[1] = middle.y;
    for (uint32_t i = 0; i < t->count; i++) {
        common_outline_place(&t->glyph[i].outline, at, t->boxed.scale);
        common_outline_pack(&t->glyph[i].outline, host, in);
        t->glyph[i].lo = pov_two_scale(pov_two_sum(t->glyph[i].lo.hi, -middle.z), t->boxed.scale);
        t->glyph[i].hi = pov_two_scale(pov_two_sum(t->glyph[i].hi.hi, -middle.z), t->boxed.scale);
        common_swept_close(&t->glyph[i]);
        widen(&t->boxed, t->glyph[i].least, t->glyph[i].most);
    }
    pack_boxes(t, host, in);
}

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    reading r;
    const char *string;

    memset(&r, 0, sizeof r);
    r.host = host;
    r.in = in;
    r.out = self;
    r.out->blanks.lo = pov_vec3_of(HUGE_VAL, HUGE_VAL, HUGE_VAL);
    r.out->blanks.hi = pov_vec3_of(-HUGE_VAL, -HUGE_VAL, -HUGE_VAL);
    if (open_font(&r, font_name(host, in))) {
        host->accept(in, ",");
        string = host->string(in);
        host->accept(in, ",");
        r.depth = host->number(in);
        host->accept(in, ",");
        host->vector(in, &r.offset);
        set_line(&r, string);
    }
    close_font(&r);
    place(self, host, in);
}

static bool bounds(const void *self, pov_box *out)
{
    const text *t = self;
    const pov_vec3 anchor = pov_two3_hi(t->boxed.anchor);
    const double back = common_inverse(t->boxed.scale);
    pov_vec3 a, b;

    *out = t->blanks;
    if (t->count == 0 && !(out->lo.x <= out->hi.x))
        out->lo = out->hi = anchor;
    for (uint32_t i = 0; i < t->count; i++) {
        common_swept_bounds(&t->glyph[i], &a, &b);
        a = pov_add(pov_scale(a, back), anchor);
        b = pov_add(pov_scale(b, back), anchor);
        out->lo = pov_vec3_of(pov_min(out->lo.x, common_below(a.x)), pov_min(out->lo.y, common_below(a.y)), pov_min(out->lo.z, common_below(a.z)));
        out->hi = pov_vec3_of(pov_max(out->hi.x, common_above(b.x)), pov_max(out->hi.y, common_above(b.y)), pov_max(out->hi.z, common_above(b.z)));
    }
    return true;
}

/* ---- rays ---- */

static size_t scratch(const void *self) { return 3 * ((const text *)self)->pieces * sizeof(common_cross) + 1; }

/* Of a line from `from` along d, where it is within all boxes' slabs of an axis, as in common_clip_axis(). */
COMMON_INLINE void clip(double from, double d, const double *restrict lo, const double *restrict hi, double margin, double *restrict in,
                        double *restrict out)
{
    COMMON_LOOP
    for (uint32_t i = 0; i < SIDE; i++) {
        const double a = (lo[i] - margin - from) / d, b = (hi[i] + margin - from) / d;

        in[i] = common_greater(common_lesser(a, b), in[i]);
        out[i] = common_lesser(common_greater(a, b), out[i]);
    }
}

/* Glyphs of a block whose boxes a ray comes near, as bits: others common_swept_intersect() would leave out one by one. */
COMMON_CLONES static uint32_t reached(const glyph_boxes *restrict b, const common_ray *restrict k, double tmax)
{
    const pov_vec3 f = pov_two3_hi(k->f), d = k->d;
    const double margin = 0x1p-40 + 0x1p-48 * pov_largest(f), unit = k->unit;
    const int64_t bit[SIDE] = { 1, 2, 4, 8, 16, 32, 64, 128 };
    double in[SIDE], out[SIDE];
    int64_t bits = 0;

    COMMON_LOOP
    for (uint32_t i = 0; i < SIDE; i++) {
        in[i] = -HUGE_VAL;
        out[i] = HUGE_VAL;
    }
    clip(f.x, d.x, b->lo[0], b->hi[0], margin, in, out);
    clip(f.y, d.y, b->lo[1], b->hi[1], margin, in, out);
    clip(f.z, d.z, b->lo[2], b->hi[2], margin, in, out);
    COMMON_LOOP
    for (uint32_t i = 0; i < SIDE; i++)
        bits |= ((in[i] <= out[i]) & (out[i] >= 0.0) & (in[i] * unit <= tmax)) ? bit[i] : 0;
    return (uint32_t)bits;
}

/* Of the glyphs from `first` on. A test of all costs as much as that of two alone. */
static uint32_t reached_from(const text *t, uint32_t first, const common_ray *k, double tmax)
{
    const uint32_t most = t->count - first < SIDE ? t->count - first : SIDE, all = (1u << most) - 1;

    return most > 2 ? all & reached(&t->boxes[first / SIDE], k, tmax) : all;
}

static void cross(const void *self, const pov_ray *ray, const common_entry *e, pov_hits *hits)
{
    const text *t = self;

    for (uint32_t first = 0; first < t->count; first += SIDE)
        for (uint32_t left = reached_from(t, first, &e->k, hits->tmax); left; left &= left - 1)
            if (!common_swept_intersect(&t->glyph[first + common_first_lane(left)], ray, &e->k, hits->scratch, hits))
                return;
}

/* The box of what counts of rays side by side, in their space. */
typedef struct extent { pov_vec3 lo, hi; } extent;

static extent extent_of(const common_beams *l)
{
    double lo[3], hi[3];

    for (int k = 0; k < 3; k++) {
        lo[k] = HUGE_VAL;
        hi[k] = -HUGE_VAL;
        for (uint32_t i = 0; i < COMMON_BEAMS; i++) {
            const double a = l->org[k][i], b = l->to[i] > 0.0 ? a + l->to[i] * l->dir[k][i] : a, off = 2.0 * l->off[i];

            lo[k] = common_lesser(common_lesser(a, b) - off, lo[k]);
            hi[k] = common_greater(common_greater(a, b) + off, hi[k]);
        }
    }
    return (extent){ pov_vec3_of(lo[0], lo[1], lo[2]), pov_vec3_of(hi[0], hi[1], hi[2]) };
}

static bool overlaps(const extent *e, const common_swept *g)
{
    return e->lo.x <= g->most.x && e->hi.x >= g->least.x && e->lo.y <= g->most.y && e->hi.y >= g->least.y && e->lo.z <= g->most.z && e->hi.z >= g->least.z;
}

/* A glyph that is neither passed nor hit for certain may be hit before all others. */
static void look(const void *self, const common_beams *restrict l, common_verdicts *restrict out)
{
    const text *t = self;
    const extent e = extent_of(l);

    for (uint32_t i = 0; i < COMMON_BEAMS; i++) {
        out->passed[i] = 1.0;
        out->hit[i] = 0.0;
        out->lo[i] = out->hi[i] = HUGE_VAL;
    }
    for (uint32_t g = 0; g < t->count; g++) {
        common_verdicts of;

        if (!overlaps(&e, &t->glyph[g]))
            continue;
        common_swept_look(&t->glyph[g], l, &of);
        for (uint32_t i = 0; i < COMMON_BEAMS; i++) {
            const bool hit = of.hit[i] > 0.0, passed = of.passed[i] > 0.0;

            out->passed[i] = passed ? out->passed[i] : 0.0;
            out->hit[i] = hit ? 1.0 : out->hit[i];
            out->lo[i] = passed ? out->lo[i] : common_lesser(hit ? of.lo[i] : -HUGE_VAL, out->lo[i]);
            out->hi[i] = hit ? common_lesser(of.hi[i], out->hi[i]) : out->hi[i];
        }
    }
}

static uint32_t narrow(const void *self, const pov_own_map *map, uint32_t owner, const pov_rays *rays, pov_candidate *io, uint32_t n)
{
    return common_narrow(&((const text *)self)->boxed, look, self, map, owner, rays, io, n);
}

COMMON_NARROW_CLASS(text, cross, NULL, false, narrow)

static bool inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    const text *t = self;
    const pov_two3 p = common_offset(point, point_lo, t->boxed.anchor, t->boxed.scale);

    for (uint32_t i = 0; i < t->count; i++)
        if (common_swept_inside(&t->glyph[i], p))
            return true;
    return false;
}

static const common_swept *glyph_at(const text *t, const pov_crossing *at)
{
    uint32_t i = t->count - 1;

    while (i > 0 && t->glyph[i].first > at->mark.feature)
        i--;
    return &t->glyph[i];
}

static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    common_swept_normal(glyph_at(self, at), ray->dir, &at->mark, out);
}

static bool reversed(const void *self, const pov_ray *ray, const pov_crossing *at)
{
    return common_swept_reversed(glyph_at(self, at), ray->dir, &at->mark);
}

static const pov_shape_class text_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_SOLID,
    .keyword = "text",
    .instance_size = sizeof(text),
    .parse = parse,
    .bounds = bounds,
    .intersect = intersect,
    .normal = normal,
    .inside = inside,
    .scratch = scratch,
    .extension = extension,
    .reversed = reversed,
};

static const pov_shape_class *const shapes[] = { &text_class, NULL };

POV_PLUGIN(text) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "text",
    .version = "1",
    .shapes = shapes,
};

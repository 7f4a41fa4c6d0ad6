#include "numerics/font.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

enum { POINTS = 48, CONTOURS = 2, EM = 1024, TABLES = 7, DIRECTORY = 12 + 16 * TABLES };

/* A point of a contour; one that is not on it is the middle one of a curve. */
typedef struct point { int x, y; bool on; } point;
typedef struct glyph { int points, contours, last[CONTOURS]; point at[POINTS]; } glyph;

/* ---- the outline ---- */

/* A star about a centre: points on it, with curves between some of them. */
static void draw_contour(glyph *g, double (*draw)(void))
{
    const int corners = 3 + (int)(6.0 * draw()), x = (int)(600.0 * draw()) - 300, y = (int)(600.0 * draw()) - 300;

    for (int i = 0; i < 2 * corners; i++) {
        const double angle = 3.141592653589793 * (i + 0.5 * draw()) / corners, radius = 50.0 + 400.0 * draw();
        const point p = { x + (int)(radius * cos(angle)), y + (int)(radius * sin(angle)), i % 2 == 0 };

        if (p.on || draw() < 0.7)
            g->at[g->points++] = p;
    }
    g->last[g->contours++] = g->points - 1;
}

static void put_piece(font *f, double left, point a, point b, point c)
{
    double *p = f->piece[f->pieces++];

    p[0] = (a.x - left) / EM;
    p[1] = (double)a.y / EM;
    p[2] = (b.x - left) / EM;
    p[3] = (double)b.y / EM;
    p[4] = (c.x - left) / EM;
    p[5] = (double)c.y / EM;
    if (!b.on)
        return;
    p[2] = 0.5 * (p[0] + p[4]);      /* exact */
    p[3] = 0.5 * (p[1] + p[5]);
}

static void find_pieces(font *f, const glyph *g, int left)
{
    f->pieces = 0;
    for (int k = 0, first = 0; k < g->contours; first = g->last[k++] + 1) {
        const int n = g->last[k] - first + 1;

        for (int i = 0; i < n; i++) {
            const point *at = g->at + first, a = at[i], b = at[(i + 1) % n];

            if (a.on)
                put_piece(f, left, a, b, b.on ? b : at[(i + 2) % n]);
        }
    }
}

/* ---- the file ---- */

static void put16(font *f, int value)
{
    f->bytes[f->size++] = (unsigned char)((unsigned)value >> 8);
    f->bytes[f->size++] = (unsigned char)value;
}

static void put32(font *f, uint32_t value)
{
    put16(f, (int)(value >> 16));
    put16(f, (int)(value & 0xffff));
}

static void put_box(font *f, const int box[4])
{
    for (int i = 0; i < 4; i++)
        put16(f, box[i]);
}

static void begin_table(font *f, int which, const char *name)
{
    unsigned char *entry = f->bytes + 12 + 16 * which;

    f->size = (f->size + 3) / 4 * 4;
    memcpy(entry, name, 4);
    entry[10] = (unsigned char)(f->size >> 8);
    entry[11] = (unsigned char)f->size;
}

static void end_table(font *f, int which)
{
    unsigned char *entry = f->bytes + 12 + 16 * which;
    const size_t length = f->size - ((size_t)entry[10] << 8 | entry[11]);

    entry[14] = (unsigned char)(length >> 8);
    entry[15] = (unsigned char)length;
}

/* Every letter is glyph 0. */
static void put_cmap(font *f)
{
    put16(f, 0), put16(f, 1), put16(f, 1), put16(f, 0), put32(f, 12);
    put16(f, 0), put16(f, 262), put16(f, 0);
    memset(f->bytes + f->size, 0, 256);
    f->size += 256;
}

static void put_glyf(font *f, const glyph *g, const int box[4])
{
    put16(f, g->contours);
    put_box(f, box);
    for (int i = 0; i < g->contours; i++)
        put16(f, g->last[i]);
    put16(f, 0);
    for (int i = 0; i < g->points; i++)
        f->bytes[f->size++] = g->at[i].on;
    for (int i = 0; i < g->points; i++)
        put16(f, g->at[i].x - (i > 0 ? g->at[i - 1].x : 0));
    for (int i = 0; i < g->points; i++)
        put16(f, g->at[i].y - (i > 0 ? g->at[i - 1].y : 0));
}

static void put_head(font *f, const int box[4])
{
    put32(f, 0x10000), put32(f, 0x10000), put32(f, 0), put32(f, 0x5f0f3cf5), put16(f, 0), put16(f, EM);
    put32(f, 0), put32(f, 0), put32(f, 0), put32(f, 0);
    put_box(f, box);
    put16(f, 0), put16(f, 8), put16(f, 2), put16(f, 1), put16(f, 0);
}

static void put_hhea(font *f)
{
    put32(f, 0x10000), put16(f, EM), put16(f, -EM), put16(f, 0), put16(f, EM);
    for (int i = 0; i < 11; i++)
        put16(f, 0);
    put16(f, 1);
}

static void put_maxp(font *f)
{
    put32(f, 0x10000), put16(f, 1), put16(f, POINTS), put16(f, CONTOURS), put16(f, 0), put16(f, 0), put16(f, 2);
    for (int i = 0; i < 8; i++)
        put16(f, 0);
}

static void find_box(const glyph *g, int box[4])
{
    box[0] = box[2] = g->at[0].x;
    box[1] = box[3] = g->at[0].y;
    for (int i = 1; i < g->points; i++) {
        box[0] = g->at[i].x < box[0] ? g->at[i].x : box[0];
        box[1] = g->at[i].y < box[1] ? g->at[i].y : box[1];
        box[2] = g->at[i].x > box[2] ? g->at[i].x : box[2];
        box[3] = g->at[i].y > box[3] ? g->at[i].y : box[3];
    }
}

void font_make(font *f, double (*draw)(void))
{
    static const char *const names[TABLES] = { "cmap", "glyf", "head", "hhea", "hmtx", "loca", "maxp" };
    glyph g = { 0, 0, { 0 }, { { 0, 0, false } } };
    uint32_t length = 0;
    int box[4];

    memset(f->bytes, 0, sizeof f->bytes);
    f->size = 0;
    draw_contour(&g, draw);
    if (draw() < 0.5)
        draw_contour(&g, draw);
    find_box(&g, box);
    put32(f, 0x10000), put16(f, TABLES), put16(f, 64), put16(f, 2), put16(f, 48);
    f->size = DIRECTORY;
    for (int i = 0; i < TABLES; i++) {
        begin_table(f, i, names[i]);
        switch (i) {
        case 0: put_cmap(f); break;
        case 1: length = (uint32_t)f->size, put_glyf(f, &g, box), length = (uint32_t)f->size - length; break;
        case 2: put_head(f, box); break;
        case 3: put_hhea(f); break;
        case 4: put16(f, EM), put16(f, box[0]); break;
        case 5: put32(f, 0), put32(f, length); break;
        default: put_maxp(f); break;
        }
        end_table(f, i);
    }
    find_pieces(f, &g, box[0]);
}

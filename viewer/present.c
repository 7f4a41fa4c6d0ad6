#include "present.h"

#include "gl.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* OpenGL 1.2 names that older headers lack. */
enum { BGRA = 0x80E1, UNSIGNED_INT_8_8_8_8_REV = 0x8367, CLAMP_TO_EDGE = 0x812F };

typedef struct image { GLuint texture; int width, height, x, y; bool shown; } image;

struct present {
    gl gl;
    image picture, reference, panels[PRESENT_PANELS];
};

static void make_image(const gl *g, image *i)
{
    g->gen_textures(1, &i->texture);
    g->bind_texture(GL_TEXTURE_2D, i->texture);
    g->tex_parameter(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    g->tex_parameter(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    g->tex_parameter(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, CLAMP_TO_EDGE);
    g->tex_parameter(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, CLAMP_TO_EDGE);
}

pov_status present_create(present **out, surface *s, pov_error *err)
{
    present *p = calloc(1, sizeof *p);
    const char *missing;

    if (!p || !gl_fetch(&p->gl, s->get_proc, &missing)) {
        err->status = p ? POV_E_UNSUPPORTED : POV_E_MEMORY;
        snprintf(err->message, sizeof err->message, p ? "the display's OpenGL has no %s" : "%s",
                 p ? missing : "no memory to draw with");
        free(p);
        return err->status;
    }
    make_image(&p->gl, &p->picture);
    make_image(&p->gl, &p->reference);
    for (int i = 0; i < PRESENT_PANELS; i++)
        make_image(&p->gl, &p->panels[i]);
    p->gl.tex_env(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    p->gl.pixel_store(GL_UNPACK_ALIGNMENT, 4);
    p->gl.pixel_store(GL_PACK_ALIGNMENT, 4);
    /* Colours are premultiplied. */
    p->gl.blend_func(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    *out = p;
    return POV_OK;
}

void present_destroy(present *p)
{
    if (!p)
        return;
    p->gl.delete_textures(1, &p->picture.texture);
    p->gl.delete_textures(1, &p->reference.texture);
    for (int i = 0; i < PRESENT_PANELS; i++)
        p->gl.delete_textures(1, &p->panels[i].texture);
    free(p);
}

/* Upload pixels to a texture: rows of one of the same size, or all. */
static void load(const gl *g, image *i, const void *pixels, int width, int height, int first, int last, GLenum format,
                 GLenum type)
{
    g->bind_texture(GL_TEXTURE_2D, i->texture);
    if (i->width != width || i->height != height) {
        g->tex_image(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, format, type, pixels);
        i->width = width;
        i->height = height;
    } else {
        g->tex_sub_image(GL_TEXTURE_2D, 0, 0, first, width, last - first + 1, format, type,
                         (const char *)pixels + (size_t)first * (size_t)width * 4);
    }
    i->shown = true;
}

bool present_nothing(present *p, int width, int height)
{
    uint8_t *nothing = calloc((size_t)width * (size_t)height, 4);

    if (nothing)
        present_picture(p, nothing, width, height, 0, height - 1);
    free(nothing);
    return nothing != NULL;
}

void present_picture(present *p, const uint8_t *pixels, int width, int height, int first, int last)
{
    load(&p->gl, &p->picture, pixels, width, height, first, last, GL_RGBA, GL_UNSIGNED_BYTE);
}

void present_reference(present *p, const uint8_t *pixels, int width, int height, int first, int last)
{
    load(&p->gl, &p->reference, pixels, width, height, first, last, GL_RGBA, GL_UNSIGNED_BYTE);
}

void present_set_panel(present *p, int index, const present_panel *panel)
{
    image *i = &p->panels[index];

    i->shown = false;
    if (!panel->pixels)
        return;
    load(&p->gl, i, panel->pixels, panel->width, panel->height, 0, panel->height - 1, BGRA, UNSIGNED_INT_8_8_8_8_REV);
    i->x = panel->x;
    i->y = panel->y;
}

/* The left part of an image that would be so wide. */
static void draw_part(const gl *g, const image *i, float left, float top, float width, float height, float part)
{
    g->bind_texture(GL_TEXTURE_2D, i->texture);
    g->begin(GL_QUADS);
    g->tex_coord(0.0f, 0.0f);
    g->vertex(left, top);
    g->tex_coord(part, 0.0f);
    g->vertex(left + part * width, top);
    g->tex_coord(part, 1.0f);
    g->vertex(left + part * width, top + height);
    g->tex_coord(0.0f, 1.0f);
    g->vertex(left, top + height);
    g->end();
}

static void draw(const gl *g, const image *i, float left, float top, float width, float height)
{
    draw_part(g, i, left, top, width, height, 1.0f);
}

/* The picture covers everything; missing pixels are black. */
static void draw_picture(const present *p, const present_look *look, int width, int height)
{
    const double factor = zoom_is_on(look->zoom) ? look->zoom->factor : 1.0;
    double left, top, part;

    zoom_to_window(look->zoom, 0.0, 0.0, &left, &top);
    draw(&p->gl, &p->picture, (float)left, (float)top, (float)(factor * width), (float)(factor * height));
    part = (look->reference_right - left) / (factor * width);
    if (p->reference.shown && look->reference_right > 0.0)
        draw_part(&p->gl, &p->reference, (float)left, (float)top, (float)(factor * width), (float)(factor * height),
                  (float)(part < 1.0 ? part : 1.0));
}

void present_draw(present *p, const present_look *look, int width, int height)
{
    const gl *g = &p->gl;

    g->viewport(0, 0, width, height);
    g->matrix_mode(GL_PROJECTION);
    g->load_identity();
    g->ortho(0.0, width, height, 0.0, -1.0, 1.0);
    g->matrix_mode(GL_MODELVIEW);
    g->load_identity();
    g->enable(GL_TEXTURE_2D);
    draw_picture(p, look, width, height);
    g->enable(GL_BLEND);
    for (int i = 0; i < PRESENT_PANELS; i++) {
        const image *panel = &p->panels[i];

        if (panel->shown)
            draw(g, panel, (float)panel->x, (float)panel->y, (float)panel->width, (float)panel->height);
    }
    g->disable(GL_BLEND);
    g->disable(GL_TEXTURE_2D);
}

/* OpenGL's lowest row is its first. */
static void turn_over(uint8_t *pixels, size_t stride, int height)
{
    for (int y = 0; y < height / 2; y++) {
        uint8_t *a = pixels + (size_t)y * stride, *b = pixels + (size_t)(height - 1 - y) * stride;

        for (size_t i = 0; i < stride; i++) {
            uint8_t keep = a[i];

            a[i] = b[i];
            b[i] = keep;
        }
    }
}

void present_read(present *p, int width, int height, uint8_t *out)
{
    p->gl.read_pixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, out);
    turn_over(out, (size_t)width * 4, height);
}

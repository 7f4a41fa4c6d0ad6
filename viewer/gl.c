#include "gl.h"

#include <string.h>

typedef struct name { const char *call; size_t place; } name;

static const name names[] = {
    { "glBegin", offsetof(gl, begin) },
    { "glBindTexture", offsetof(gl, bind_texture) },
    { "glBlendFunc", offsetof(gl, blend_func) },
    { "glDeleteTextures", offsetof(gl, delete_textures) },
    { "glDisable", offsetof(gl, disable) },
    { "glEnable", offsetof(gl, enable) },
    { "glEnd", offsetof(gl, end) },
    { "glGenTextures", offsetof(gl, gen_textures) },
    { "glLoadIdentity", offsetof(gl, load_identity) },
    { "glMatrixMode", offsetof(gl, matrix_mode) },
    { "glOrtho", offsetof(gl, ortho) },
    { "glPixelStorei", offsetof(gl, pixel_store) },
    { "glReadPixels", offsetof(gl, read_pixels) },
    { "glTexCoord2f", offsetof(gl, tex_coord) },
    { "glTexEnvi", offsetof(gl, tex_env) },
    { "glTexImage2D", offsetof(gl, tex_image) },
    { "glTexParameteri", offsetof(gl, tex_parameter) },
    { "glTexSubImage2D", offsetof(gl, tex_sub_image) },
    { "glVertex2f", offsetof(gl, vertex) },
    { "glViewport", offsetof(gl, viewport) },
};

bool gl_fetch(gl *g, surface_call (*get_proc)(const char *name), const char **missing)
{
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        surface_call call = get_proc(names[i].call);

        if (!call) {
            *missing = names[i].call;
            return false;
        }
        /* All pointers to functions are of one form in POSIX, whatever they point to. */
        memcpy((char *)g + names[i].place, &call, sizeof call);
    }
    return true;
}

/* gl.h - the few OpenGL 2.1 calls that the viewer draws with, each fetched from the surface. */
#ifndef VIEWER_GL_H
#define VIEWER_GL_H

#include "surface.h"

#include <GL/gl.h>

typedef struct gl {
    void (*begin)(GLenum mode);
    void (*bind_texture)(GLenum target, GLuint texture);
    void (*blend_func)(GLenum source, GLenum destination);
    void (*delete_textures)(GLsizei count, const GLuint *textures);
    void (*disable)(GLenum capability);
    void (*enable)(GLenum capability);
    void (*end)(void);
    void (*gen_textures)(GLsizei count, GLuint *textures);
    void (*load_identity)(void);
    void (*matrix_mode)(GLenum mode);
    void (*ortho)(GLdouble left, GLdouble right, GLdouble bottom, GLdouble top, GLdouble near, GLdouble far);
    void (*pixel_store)(GLenum name, GLint value);
    void (*read_pixels)(GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type, void *out);
    void (*tex_coord)(GLfloat s, GLfloat t);
    void (*tex_env)(GLenum target, GLenum name, GLint value);
    void (*tex_image)(GLenum target, GLint level, GLint internal, GLsizei width, GLsizei height, GLint border,
                      GLenum format, GLenum type, const void *pixels);
    void (*tex_parameter)(GLenum target, GLenum name, GLint value);
    void (*tex_sub_image)(GLenum target, GLint level, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format,
                          GLenum type, const void *pixels);
    void (*vertex)(GLfloat x, GLfloat y);
    void (*viewport)(GLint x, GLint y, GLsizei width, GLsizei height);
} gl;

/* False: `missing` names a call that the surface's OpenGL lacks. */
bool gl_fetch(gl *g, surface_call (*get_proc)(const char *name), const char **missing);

#endif

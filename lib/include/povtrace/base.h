/* povtrace/base.h - shared by all other headers: export marks, version, status codes, messages, and the two hooks
 * (memory, log) that a program may supply. */
#ifndef POVTRACE_BASE_H
#define POVTRACE_BASE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
#define POV_EXTERN extern "C"
#else
#define POV_EXTERN
#endif

#if defined(__GNUC__)
#define POV_EXPORT POV_EXTERN __attribute__((visibility("default")))
#define POV_PRINTF(f, a) __attribute__((format(printf, f, a)))
#else
#define POV_EXPORT POV_EXTERN
#define POV_PRINTF(f, a)
#endif
#define POV_API POV_EXPORT

#define POVTRACE_VERSION_MAJOR 0
#define POVTRACE_VERSION_MINOR 1
#define POVTRACE_VERSION_PATCH 0

/* Version of the library this program runs against. Any thread. */
POV_API void pov_version(int *major, int *minor, int *patch);
/* The processors that this copy of the library was compiled for: "baseline", or "x86-64-v3" or "x86-64-v4" if the
 * system's loader chose that copy. All give the same bits. Any thread. */
POV_API const char *pov_built_for(void);

/* Zero is success; every failure is negative. */
typedef enum pov_status {
    POV_OK = 0,
    POV_E_ARGUMENT = -1,    /* the caller broke a documented rule */
    POV_E_MEMORY = -2,
    POV_E_IO = -3,
    POV_E_SYNTAX = -4,      /* the scene text is wrong; see file, line, column */
    POV_E_UNSUPPORTED = -5, /* valid scene language that this version lacks */
    POV_E_PLUGIN = -6,      /* no plugin, or one built for another ABI */
    POV_E_CANCELLED = -7
} pov_status;

/* A short name such as "syntax"; never NULL. Any thread. */
POV_API const char *pov_status_name(pov_status status);

/* An error or a log message, with its place. Calls fill the caller's pov_error only when they fail; NULL is allowed
 * wherever one is taken. */
typedef struct pov_error {
    pov_status status;
    int line, column;       /* 1-based, the column in bytes; 0: no place */
    int caret;              /* offset of the error into the excerpt */
    char file[256];
    char message[512];      /* one line, no newline at its end */
    char excerpt[256];      /* the line of scene text, or the part of it around the caret; may be empty */
    char hint[64];          /* the word that was probably meant; may be empty */
} pov_error;

/* resize(user, NULL, n) allocates, resize(user, p, 0) frees and returns NULL. Any thread. */
typedef struct pov_allocator {
    void *(*resize)(void *user, void *block, size_t bytes);
    void *user;
} pov_allocator;

/* SCENE: text that the scene itself writes, without a line's end of its own. STACK: where an error, which follows, was
 * called from. ERROR: an error of a scene behind which reading went on, to find others. If there is any, all errors are
 * logged, and the first one is returned, too. */
typedef enum pov_log_level {
    POV_LOG_DEBUG, POV_LOG_INFO, POV_LOG_WARN, POV_LOG_SCENE, POV_LOG_STACK, POV_LOG_ERROR
} pov_log_level;
/* The note is valid during the call only; its status is POV_OK, but for ERROR. Any thread that calls the library. */
typedef void pov_log_fn(void *user, pov_log_level level, const pov_error *note);

/* As text: file, line and column, the message, the hint, and below them the excerpt with a caret under the place. Writes at
 * most `size` bytes, the last of them 0; returns the length of the whole text. Any thread. */
POV_API size_t pov_error_format(const pov_error *err, char *out, size_t size);

/* `size` is the first member of every struct that a caller fills or receives and
 * that may grow: `pov_render_desc d = POV_INIT(d);`. Zero in any other member
 * means "the default". */
#ifdef __cplusplus
struct pov_sized {
    template <class T> operator T() const { T all = T(); all.size = sizeof all; return all; }
};
#define POV_INIT(var) pov_sized()
#else
#define POV_INIT(var) { .size = sizeof(var) }
#endif

/* Does the other side's struct contain this member? */
#define POV_HAS(ptr, type, member) \
    ((ptr)->size >= offsetof(type, member) + sizeof((ptr)->member))

/* Encoding of linear values as integers: as they are, or by the sRGB curve. */
typedef enum pov_transfer { POV_TRANSFER_LINEAR, POV_TRANSFER_SRGB } pov_transfer;

#endif

#include "support/fake_reader.h"

#include "support/scenes.h"

#include <ctype.h>
#include <dlfcn.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct token { bool is_number; double value; char word[24]; } token;
typedef struct block { struct block *next; } block;

struct pov_reader {
    token *tokens;
    size_t count, capacity, at;
    block *blocks;
    bool failed;
    int warnings;
    char message[256];
    const uint16_t *heights;
    uint32_t width, height;
    const void *file;
    size_t file_bytes;
};

/* ---- feeding ---- */

pov_reader *fake_reader_create(void) { return calloc(1, sizeof(pov_reader)); }

void fake_reader_destroy(pov_reader *in)
{
    block *b = in->blocks;

    while (b) {
        block *next = b->next;
        free(b);
        b = next;
    }
    free(in->tokens);
    free(in);
}

void fake_reader_clear(pov_reader *in)
{
    in->count = in->at = 0;
    in->failed = false;
    in->warnings = 0;
    in->message[0] = '\0';
}

static token *append(pov_reader *in)
{
    if (in->count == in->capacity) {
        in->capacity = in->capacity ? 2 * in->capacity : 64;
        in->tokens = realloc(in->tokens, in->capacity * sizeof *in->tokens);
        if (!in->tokens)
            abort();
    }
    memset(&in->tokens[in->count], 0, sizeof(token));
    return &in->tokens[in->count++];
}

void fake_reader_number(pov_reader *in, double value)
{
    token *t = append(in);

    t->is_number = true;
    t->value = value;
}

void fake_reader_word(pov_reader *in, const char *word)
{
    snprintf(append(in)->word, sizeof in->tokens->word, "%s", word);
}

void fake_reader_text(pov_reader *in, const char *text)
{
    while (*text) {
        char word[24] = "", *end;
        double value = strtod(text, &end);
        size_t n = 0;

        if (isspace((unsigned char)*text)) {
            text++;
        } else if (end != text && !isalpha((unsigned char)*text)) {
            fake_reader_number(in, value);
            text = end;
        } else {
            do
                word[n++] = *text++;
            while (isalpha((unsigned char)word[0]) && (isalnum((unsigned char)*text) || *text == '_') &&
                   n < sizeof word - 1);
            fake_reader_word(in, word);
        }
    }
}

void fake_reader_heights(pov_reader *in, const uint16_t *heights, uint32_t width, uint32_t height)
{
    in->heights = heights;
    in->width = width;
    in->height = height;
}

void fake_reader_file(pov_reader *in, const void *file, size_t bytes)
{
    in->file = file;
    in->file_bytes = bytes;
}

void fake_reader_print(const pov_reader *in, char *out, size_t size)
{
    size_t used = 0;
    bool close = true;

    out[0] = '\0';
    for (size_t i = 0; i < in->count && used < size; i++) {
        const token *t = &in->tokens[i];
        const char *gap = close || t->word[0] == ',' || t->word[0] == '>' ? "" : " ";

        used += (size_t)(t->is_number ? snprintf(out + used, size - used, "%s%.17g", gap, t->value)
                                      : snprintf(out + used, size - used, "%s%s", gap, t->word));
        close = t->word[0] == '<';
    }
}

/* ---- the host ---- */

static void complain(pov_reader *in, const char *format, va_list values)
{
    if (!in->failed)
        vsnprintf(in->message, sizeof in->message, format, values);
    in->failed = true;
}

static void host_fail(pov_reader *in, const char *format, ...)
{
    va_list values;

    va_start(values, format);
    complain(in, format, values);
    va_end(values);
}

static void host_warn(pov_reader *in, const char *format, ...)
{
    (void)format;
    in->warnings += !in->failed;
}

void *fake_reader_memory(pov_reader *in, size_t bytes)
{
    block *b = calloc(1, sizeof *b + 64 + bytes);
    char *start = (char *)(b + 1);

    if (!b)
        abort();
    b->next = in->blocks;
    in->blocks = b;
    return start + (64 - (uintptr_t)start % 64) % 64;
}

static void *host_alloc(pov_reader *in, size_t bytes)
{
    return in->failed || bytes > (size_t)1 << 30 ? NULL : fake_reader_memory(in, bytes);
}

static bool is_word(pov_reader *in, const char *word)
{
    return !in->failed && in->at < in->count && !in->tokens[in->at].is_number
           && strcmp(in->tokens[in->at].word, word) == 0;
}

static bool host_accept(pov_reader *in, const char *word)
{
    if (!is_word(in, word))
        return false;
    in->at++;
    return true;
}

static void host_expect(pov_reader *in, const char *word)
{
    if (!host_accept(in, word))
        host_fail(in, "expected \"%s\"", word);
}

static double host_number(pov_reader *in)
{
    if (in->failed)
        return 0.0;
    if (in->at < in->count && in->tokens[in->at].is_number)
        return in->tokens[in->at++].value;
    host_fail(in, "expected a number");
    return 0.0;
}

static void host_vector(pov_reader *in, pov_vec3 *out)
{
    *out = pov_vec3_of(0.0, 0.0, 0.0);
    if (!is_word(in, "<")) {
        out->x = out->y = out->z = host_number(in);
        return;
    }
    host_accept(in, "<");
    out->x = host_number(in);
    host_accept(in, ",");
    out->y = host_number(in);
    host_accept(in, ",");
    out->z = host_number(in);
    host_expect(in, ">");
    if (in->failed)
        *out = pov_vec3_of(0.0, 0.0, 0.0);
}

static bool host_more(pov_reader *in)
{
    return !in->failed && in->at < in->count && (in->tokens[in->at].is_number || is_word(in, "<"));
}

static void host_vector_of(pov_reader *in, double *out, int n)
{
    for (int i = 0; i < n; i++)
        out[i] = 0.0;
    if (!is_word(in, "<")) {
        out[0] = host_number(in);
        for (int i = 1; i < n; i++)
            out[i] = out[0];
        return;
    }
    host_accept(in, "<");
    for (int i = 0; i < n; i++) {
        if (i > 0)
            host_accept(in, ",");
        out[i] = host_number(in);
    }
    host_expect(in, ">");
}

static bool host_more_numbers(pov_reader *in)
{
    return !in->failed && in->at < in->count && in->tokens[in->at].is_number;
}

static void *host_resize(pov_reader *in, void *memory, size_t bytes)
{
    void *bigger = in->failed || bytes == 0 ? NULL : realloc(memory, bytes);

    if (!bigger)
        free(memory);
    return bigger;
}

static uint32_t host_texture(pov_reader *in)
{
    double number;

    host_expect(in, "texture");
    host_expect(in, "{");
    number = host_number(in);
    host_expect(in, "}");
    return number > 0.0;
}

static bool host_boolean(pov_reader *in) { return host_number(in) != 0.0; }

/* A string is a word here. */
static const char *host_string(pov_reader *in)
{
    if (in->failed || in->at == in->count || in->tokens[in->at].is_number) {
        host_fail(in, "expected a string");
        return "";
    }
    return in->tokens[in->at++].word;
}

/* There is one file, if any, whatever its name. */
static const void *host_file(pov_reader *in, const char *name, size_t *bytes)
{
    *bytes = in->file_bytes;
    if (!in->file)
        host_fail(in, "there is no file \"%.100s\"", name);
    return in->failed ? NULL : in->file;
}

/* ---- a hierarchy that leaves nothing out ---- */

typedef struct all_items { pov_hierarchy service; uint32_t count; } all_items;

static bool visit_all(const pov_hierarchy *self, const pov_ray *ray, const pov_hits *hits,
                      bool (*visit)(void *user, uint32_t first, uint32_t count), void *user)
{
    const all_items *all = (const all_items *)(const void *)self;

    (void)ray;
    (void)hits;
    return visit(user, 0, all->count);
}

static bool visit_each(const pov_hierarchy *self, bool (*visit)(void *user, uint32_t first, uint32_t count), void *user)
{
    return visit_all(self, NULL, NULL, visit, user);
}

static void visit_rays(const pov_hierarchy *self, const pov_ray *const *rays, uint32_t n, double *limit, bool nearest,
                       pov_visit_rays *visit, void *user)
{
    uint64_t lowered = 0;

    (void)rays;
    (void)limit;
    (void)nearest;
    visit(user, 0, ((const all_items *)(const void *)self)->count, ~(uint64_t)0 >> (64 - n), &lowered);
}

static const pov_hierarchy *host_hierarchy_in_order(pov_reader *in, uint32_t n,
                                                    void (*box)(void *user, uint32_t which, pov_box *out), void *user,
                                                    uint32_t *order)
{
    all_items *all = in->failed ? NULL : fake_reader_memory(in, sizeof *all);

    (void)box;
    (void)user;
    if (!all)
        return NULL;
    for (uint32_t i = 0; i < n; i++)
        order[i] = n - 1 - i;
    all->service.visit_ranges = visit_all;
    all->service.each_range = visit_each;
    all->service.visit_rays = visit_rays;
    all->count = n;
    return &all->service;
}

static bool visit_items(const pov_hierarchy *self, const pov_ray *ray, const pov_hits *hits,
                        bool (*visit)(void *user, uint32_t item), void *user)
{
    const all_items *all = (const all_items *)(const void *)self;

    (void)ray;
    (void)hits;
    for (uint32_t i = 0; i < all->count; i++)
        if (!visit(user, i))
            return false;
    return true;
}

static const pov_hierarchy *host_hierarchy(pov_reader *in, const pov_box *boxes, uint32_t n)
{
    all_items *all = in->failed ? NULL : fake_reader_memory(in, sizeof *all);

    (void)boxes;
    if (!all)
        return NULL;
    all->service.visit = visit_items;
    all->count = n;
    return &all->service;
}

/* There is one image, if any. */
static const uint16_t *host_heights(pov_reader *in, uint32_t *width, uint32_t *height)
{
    *width = in->width;
    *height = in->height;
    if (!in->heights)
        host_fail(in, "expected an image");
    return in->failed ? NULL : in->heights;
}

/* ---- instances ---- */

enum { LOADED_MAX = 32 };        /* plugins that one test program loads */

bool fake_reader_parse_into(pov_reader *in, const shape_class *shape, void *self)
{
    /* Services that only later primitives ask for are missing. */
    static const pov_host host = { .abi = POV_PLUGIN_ABI, .size = sizeof(pov_host), .alloc = host_alloc, .number = host_number,
                                   .vector = host_vector, .accept = host_accept, .expect = host_expect, .more = host_more,
                                   .fail = host_fail, .warn = host_warn, .vector_of = host_vector_of,
                                   .boolean = host_boolean, .string = host_string, .file = host_file,
                                   .hierarchy = host_hierarchy, .heights = host_heights,
                                   .resize = host_resize, .hierarchy_in_order = host_hierarchy_in_order,
                                   .texture = host_texture, .next_is = is_word, .more_numbers = host_more_numbers };

    const bool is_prepared = shape->prepare != NULL;
    void *text = is_prepared ? fake_reader_memory(in, shape->parsed_size) : self;

    memset(self, 0, shape->instance_size);
    in->at = 0;
    shape->parse(text, &host, in);
    if (is_prepared)
        shape->prepare(self, text);
    if (!in->failed && in->at < in->count)
        host_fail(in, "something is left over");
    return !in->failed;
}

void *fake_reader_parse(pov_reader *in, const shape_class *shape)
{
    void *self = fake_reader_memory(in, shape->instance_size);

    return fake_reader_parse_into(in, shape, self) ? self : NULL;
}

const char *fake_reader_message(const pov_reader *in) { return in->message; }
int fake_reader_warnings(const pov_reader *in) { return in->warnings; }

const shape_class *fake_reader_load(const char *path)
{
    static shape_class loaded[LOADED_MAX];
    static const pov_shape_class *from[LOADED_MAX];
    void *file = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    const pov_plugin *plugin = file ? dlsym(file, POV_PLUGIN_SYMBOL) : NULL;
    const pov_shape_class *shape = plugin && plugin->shapes ? plugin->shapes[0] : NULL;
    int i;

    if (!plugin)
        fprintf(stderr, "%s\n", dlerror());
    for (i = 0; shape && i < LOADED_MAX; i++) {
        if (from[i] == shape)
            return &loaded[i];
        if (!from[i]) {
            shape_class_fill(&loaded[i], from[i] = shape);
            return &loaded[i];
        }
    }
    return NULL;
}

const shape_class *fake_reader_shape(const char *keyword)
{
    char path[1024];

    snprintf(path, sizeof path, "%s/%s.so", TEST_PRIMITIVES, keyword);
    return fake_reader_load(path);
}

#include "sdl/host.h"

#include "base/file.h"
#include "base/hash.h"
#include "base/str.h"
#include "sdl/expression.h"
#include "sdl/image_heights.h"
#include "sdl/host_parts.h"
#include "sdl/include.h"
#include "sdl/limit.h"
#include "sdl/parse.h"
#include "sdl/reader.h"
#include "sdl/report.h"
#include "sdl/text.h"
#include "sdl/value.h"

#include <string.h>

enum { ALIGNMENT = 16 };

static void *alloc(pov_reader *in, size_t bytes)
{
    return state_alloc(in, bytes, ALIGNMENT);
}

static double number(pov_reader *in)
{
    return value_number(in);
}

static void vector(pov_reader *in, pov_vec3 *out)
{
    *out = in->has_faces ? value_vector_of_face(in) : value_vector(in);
}

static bool is_punct(const char *word)
{
    return word[0] != '\0' && word[1] == '\0' && !strchr("abcdefghijklmnopqrstuvwxyz_", word[0]);
}

static bool is_next(const pov_reader *in, const char *word)
{
    const token *t = &in->token;

    if (is_punct(word))
        return t->kind == (unsigned char)word[0];
    return t->kind == TOKEN_WORD && strcmp(t->symbol->name, word) == 0;
}

static bool accept(pov_reader *in, const char *word)
{
    if (is_next(in, word)) {
        in->plugin_braces += word[0] == '{';
        in->plugin_braces -= word[0] == '}';
        state_advance(in);
        return true;
    }
    if (in->token.kind == TOKEN_WORD && in->tried_count < TRIED_MAX && !is_punct(word))
        str_copy(in->tried[in->tried_count++], TRIED_LENGTH, word);
    return false;
}

static void expect(pov_reader *in, const char *word)
{
    char wanted[REPORT_QUOTE + 2] = "\"";
    guess g;

    if (accept(in, word))
        return;
    report_guess_start(&g, in);
    str_copy(wanted + 1, REPORT_QUOTE - 1, word);
    strcat(wanted, "\"");
    report_expected_guess(in, wanted, &g);
}

static bool next_is(pov_reader *in, const char *word) { return !in->failed && is_next(in, word); }

static bool more_numbers(pov_reader *in)
{
    const value *named = in->token.kind == TOKEN_WORD ? scope_value(in->token.symbol) : NULL;

    return value_follows(in) && in->token.kind != '<' && !(named && named->kind != VALUE_NUMBER);
}

static bool more(pov_reader *in)
{
    return value_follows(in);
}

static void fail(pov_reader *in, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    report_failv(in, &in->value, POV_E_SYNTAX, format, args);
    va_end(args);
}

static void warn(pov_reader *in, const char *format, ...)
{
    va_list args;

    /* After an error what was read is made up, and warnings of it would be too. */
    if (in->failed)
        return;
    va_start(args, format);
    report_warnv(in, &in->value, format, args);
    va_end(args);
}

static void vector_of(pov_reader *in, double *out, int n)
{
    value_components(in, n, n, out);
}

static void color(pov_reader *in, double rgbft[5])
{
    value_colour_components(in, true, rgbft);
}

static bool boolean(pov_reader *in) { return expression_is_true(value_number(in)); }

static const char *string_kept(pov_reader *in)
{
    const string *s = value_text(in);
    char *copy = s ? state_alloc(in, s->length + 1, 1) : NULL;

    if (!copy)
        return "";
    memcpy(copy, s->text, s->length + 1);
    return copy;
}

/* The bytes go to the scene's memory, so that plugins need not give them back. Old scenes name fonts without their ending. */
static const void *file(pov_reader *in, const char *name, size_t *bytes)
{
    static const char *const endings[] = { "", ".ttf", NULL };
    string *s = in->failed ? NULL : text_copy(in, name, strlen(name));
    char path[INCLUDE_PATH_MAX], *text = NULL;
    void *copy = NULL;
    pov_error err;

    *bytes = 0;
    if (!s)
        return NULL;
    if (!include_find_with(in, s, endings, path))
        include_not_found(in, s, endings);
    else if (limit_read_file(in, path, &text, bytes, &err) < 0)
        report_fail(in, &in->value, err.status, "%.200s: %.200s", path, err.message);
    else
        copy = state_alloc(in, *bytes + 1, ALIGNMENT);
    if (copy) {
        memcpy(copy, text, *bytes);
        in->sources.hash = hash_bytes(in->sources.hash, text, *bytes);
    }
    env_free(in->model->env, text);
    return copy;
}

static void *resize(pov_reader *in, void *memory, size_t bytes)
{
    void *bigger = in->failed || bytes == 0 ? NULL : env_resize(in->model->env, memory, bytes, 1);

    if (bigger)
        return bigger;
    env_free(in->model->env, memory);
    if (bytes > 0)
        report_memory(in);
    return NULL;
}

static const pov_hierarchy *hierarchy_in_order(pov_reader *in, uint32_t n,
                                               void (*box)(void *user, uint32_t which, pov_box *out), void *user,
                                               uint32_t *order)
{
    const pov_hierarchy *made = NULL;

    if (in->failed || !in->options || !in->options->hierarchy)
        return NULL;
    made = in->options->hierarchy(in->model, in->options->threads, n, box, user, order);
    if (!made)
        report_memory(in);
    return made;
}

static void box_at(void *user, uint32_t which, pov_box *out) { *out = ((const pov_box *)user)[which]; }

static const pov_hierarchy *hierarchy(pov_reader *in, const pov_box *boxes, uint32_t n)
{
    return hierarchy_in_order(in, n, box_at, (void *)(uintptr_t)boxes, NULL);
}

static uint32_t part_texture(pov_reader *in)
{
    expect(in, "texture");
    return in->failed ? 0 : parse_part_texture(in);
}

const pov_host host_functions = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_host),
    .alloc = alloc,
    .number = number,
    .vector = vector,
    .accept = accept,
    .expect = expect,
    .more = more,
    .fail = fail,
    .warn = warn,
    .vector_of = vector_of,
    .color = color,
    .boolean = boolean,
    .string = string_kept,
    .file = file,
    .hierarchy = hierarchy,
    .heights = image_heights_read,
    .resize = resize,
    .hierarchy_in_order = hierarchy_in_order,
    .texture = part_texture,
    .next_is = next_is,
    .more_numbers = more_numbers,
    .function = host_function,
    .transform = host_transform,
    .component_texture = parse_component_texture,
    .function_bounds = host_function_bounds,
};

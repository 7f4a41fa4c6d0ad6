/* A plugin asks for numbers and vectors in the order in which a text has them. That is the order of the columns. */
#include "sdl/host_arrays.h"

#include "sdl/frame.h"
#include "sdl/host.h"
#include "sdl/parse.h"
#include "sdl/report.h"

#include <stdio.h>
#include <string.h>

static const place nowhere;

static void refuse(pov_reader *in)
{
    report_fail(in, &nowhere, POV_E_UNSUPPORTED, "the plugin of \"%s\" reads what arrays do not give", in->rows->part->word);
}

/* The next numbers of the object; NULL: there are none left, and the reader has failed. */
static const double *next(pov_reader *in, int width)
{
    array_rows *r = in->rows;
    const build_column *c = &r->part->columns[r->column];

    if (in->failed)
        return NULL;
    if (r->column < BUILD_COLUMNS_MAX && c->width == width) {
        r->column++;
        return c->at + r->row * c->stride;
    }
    refuse(in);
    return NULL;
}

static double number(pov_reader *in)
{
    const double *at = next(in, 1);

    return at ? *at : 0.0;
}

static void vector(pov_reader *in, pov_vec3 *out)
{
    const double *at = next(in, 3);

    *out = at ? pov_vec3_of(at[0], at[1], at[2]) : pov_vec3_of(0.0, 0.0, 0.0);
}

/* Commas may stand anywhere, words nowhere. */
static bool accept(pov_reader *in, const char *word) { return !in->failed && word[0] == ','; }

static bool more(pov_reader *in)
{
    const array_rows *r = in->rows;

    return !in->failed && r->column < BUILD_COLUMNS_MAX && r->part->columns[r->column].width > 0;
}

static bool more_numbers(pov_reader *in) { return more(in) && in->rows->part->columns[in->rows->column].width == 1; }

/* ---- messages: which object it is ---- */

typedef struct message { char text[400]; } message;

static void fill(message *m, const pov_reader *in, const char *format, va_list args)
{
    const array_rows *r = in->rows;
    const int length = snprintf(m->text, sizeof m->text, "%s %zu of %zu: ", r->part->word, r->row, r->part->count);

    vsnprintf(m->text + length, sizeof m->text - (size_t)length, format, args);
}

static void fail(pov_reader *in, const char *format, ...) POV_PRINTF(2, 3);
static void fail(pov_reader *in, const char *format, ...)
{
    va_list args;
    message m;

    va_start(args, format);
    fill(&m, in, format, args);
    va_end(args);
    report_fail(in, &nowhere, POV_E_ARGUMENT, "%s", m.text);
}

static void warn(pov_reader *in, const char *format, ...) POV_PRINTF(2, 3);
static void warn(pov_reader *in, const char *format, ...)
{
    va_list args;
    message m;

    va_start(args, format);
    fill(&m, in, format, args);
    va_end(args);
    report_warn(in, &nowhere, "%s", m.text);
}

/* ---- lists, in the order in which a text has them ---- */

static bool accept_list(pov_reader *in, const char *word)
{
    array_rows *r = in->rows;
    const build_list *l = r->part->lists + r->column;

    if (in->failed || word[0] == ',')
        return !in->failed;
    if (r->list || (size_t)r->column == r->part->list_count || strcmp(l->word, word) != 0)
        return false;
    r->list = l;
    r->item = 0;
    r->is_counted = l->is_bare;
    r->behind = 0;
    r->column++;
    return true;
}

static void expect_brace(pov_reader *in, const char *word)
{
    array_rows *r = in->rows;

    if (in->failed)
        return;
    if (!r->list || (word[0] == '}') != r->is_counted || (word[0] == '}' && r->item < r->list->count))
        refuse(in);
    if (word[0] == '}')
        r->list = NULL;
}

void host_begin_material(pov_reader *in, const build_material *m)
{
    frame_begin_text(in, m ? m->text : "", m ? m->length : 0, "(material)");
    if (!in->failed)
        state_advance(in);
}

/* A material that a text would have in texture { }. */
static uint32_t texture_of_list(pov_reader *in)
{
    array_rows *r = in->rows;

    if (!in->failed && (!r->list || !r->list->textures || r->item >= r->list->count))
        refuse(in);
    if (in->failed)
        return 0;
    host_begin_material(in, parts_material(r->all, r->list->textures[r->item++]));
    return in->failed ? 0 : parse_part_content(in, TOKEN_END);
}

/* Behind the last item. */
static double place_of_material(array_rows *r)
{
    const build_list *l = r->list;
    const uint32_t *numbers = l->materials + (size_t)l->width * (r->item - 1);

    return (double)l->places[numbers[l->width - r->behind--]];
}

static double number_of_list(pov_reader *in)
{
    array_rows *r = in->rows;

    if (!in->failed && r->list && r->behind > 0)
        return place_of_material(r);
    if (!in->failed && (!r->list || r->is_counted))
        refuse(in);
    if (in->failed)
        return 0.0;
    r->is_counted = true;
    return (double)r->list->count;
}

static bool more_items(pov_reader *in)
{
    const array_rows *r = in->rows;

    return !in->failed && r->list && r->is_counted && r->item < r->list->count;
}

static void take_item(pov_reader *in, double *out, int width)
{
    array_rows *r = in->rows;
    const build_list *l = r->list;
    const build_column *c = &l->vectors;

    if (!more_items(in) || l->textures || (c->at ? c->width : 3) != width) {
        refuse(in);
        memset(out, 0, (size_t)width * sizeof *out);
        return;
    }
    for (int i = 0; i < width; i++)
        out[i] = c->at ? c->at[r->item * c->stride + (size_t)i] : l->indices[3 * r->item + (size_t)i];
    r->behind = l->materials && l->materials[(size_t)l->width * r->item] > 0 ? l->width : 0;
    r->item++;
    if (l->is_bare)
        r->list = NULL;
}

static void vector_of_list(pov_reader *in, pov_vec3 *out)
{
    double v[3];

    take_item(in, v, 3);
    *out = pov_vec3_of(v[0], v[1], v[2]);
}

static bool none_is_next(pov_reader *in, const char *word)
{
    (void)in;
    (void)word;
    return false;
}

static bool more_behind(pov_reader *in) { return !in->failed && in->rows->list && in->rows->behind > 0; }

pov_host host_lists(void)
{
    pov_host h = host_arrays();

    h.number = number_of_list;
    h.vector = vector_of_list;
    h.vector_of = take_item;
    h.accept = accept_list;
    h.expect = expect_brace;
    h.next_is = none_is_next;
    h.more = more_items;
    h.more_numbers = more_behind;
    h.texture = texture_of_list;
    return h;
}

/* ---- columns ---- */

/* Another plugin of the keyword may ask for more than numbers. What arrays cannot give is an error. */
pov_host host_arrays(void)
{
    pov_host h = host_functions;

    h.number = number;
    h.vector = vector;
    h.accept = h.next_is = accept;
    h.more = more;
    h.more_numbers = more_numbers;
    h.fail = fail;
    h.warn = warn;
    return h;
}

/* A plugin asks for numbers and vectors in the order in which a text has them. That is the order of the columns. */
#include "sdl/host_arrays.h"

#include "sdl/host.h"
#include "sdl/report.h"

#include <stdio.h>

static const place nowhere;

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
    report_fail(in, &nowhere, POV_E_UNSUPPORTED, "the plugin of \"%s\" reads what arrays do not give", r->part->word);
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

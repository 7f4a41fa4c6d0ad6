#include "sdl/intrinsic.h"

#include "sdl/calc.h"
#include "sdl/expression.h"
#include "sdl/include.h"
#include "sdl/lex.h"
#include "sdl/number.h"
#include "sdl/report.h"
#include "sdl/text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { NUMBER_BUFFER = 1536, DATE_BUFFER = 512, DIGITS_MAX = 1000, LAST_CHARACTER = 65535, FIRST_YEAR = 1400, LAST_YEAR = 9999 };

static void comma(pov_reader *in)
{
    state_accept(in, ',');
}

/* The caller lets go of it. NULL: the reader has failed. */
static string *read_string(pov_reader *in)
{
    return expression_to_string(in, expression_read(in));
}

static string *only_string(pov_reader *in)
{
    string *s;

    state_open(in, '(');
    s = read_string(in);
    state_close(in, ')');
    return s;
}

static void give(pov_reader *in, value *out, string *s)
{
    if (!s)
        return;
    out->kind = VALUE_STRING;
    out->as.shared = &s->head;
    (void)in;
}

static void let_go(pov_reader *in, string *s)
{
    if (s)
        value_unshare(&in->heap, &s->head);
}

/* ---- numbers of strings ---- */

static void read_strlen(pov_reader *in, const intrinsic *row, value *out)
{
    string *s = only_string(in);

    (void)row;
    out->as.v[0] = s ? (double)text_characters(s) : 0.0;
    let_go(in, s);
}

static void read_asc(pov_reader *in, const intrinsic *row, value *out)
{
    string *s = only_string(in);
    int bytes;

    (void)row;
    out->as.v[0] = s ? (double)text_character(s->text, &bytes) : 0.0;
    let_go(in, s);
}

/* Behind the digits, the point and the exponent of a number. */
static const char *number_end(const char *at)
{
    static const char digits[] = "0123456789";
    const char *exponent;

    at += strspn(at, digits);
    if (*at == '.')
        at += 1 + strspn(at + 1, digits);
    if (*at != 'e' && *at != 'E')
        return at;
    exponent = at + 1 + (at[1] == '-' || at[1] == '+');
    return exponent + strspn(exponent, digits) > exponent ? exponent + strspn(exponent, digits) : at;
}

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* As strtod() has it in the C locale. */
static double to_number(const char *text)
{
    const char *at = text + strspn(text, " \t\n\r\v\f"), *after;
    const bool is_negative = *at == '-', has_sign = is_negative || *at == '+';
    double number = 0.0;

    at += has_sign;
    if (at[0] == '0' && (at[1] == 'x' || at[1] == 'X'))
        number = strtod(at, NULL);
    else if (is_digit(at[0]) || (at[0] == '.' && is_digit(at[1])))
        number_read(at, number_end(at), &after, &number);
    else if (*at == 'i' || *at == 'I' || *at == 'n' || *at == 'N')
        number = strtod(at, NULL);
    return is_negative && number != 0.0 ? -number : number;
}

static void read_val(pov_reader *in, const intrinsic *row, value *out)
{
    string *s = only_string(in);

    (void)row;
    out->as.v[0] = s ? to_number(s->text) : 0.0;
    let_go(in, s);
}

static void read_strcmp(pov_reader *in, const intrinsic *row, value *out)
{
    string *a, *b;

    (void)row;
    state_open(in, '(');
    a = read_string(in);
    comma(in);
    b = read_string(in);
    state_close(in, ')');
    out->as.v[0] = a && b ? text_compare(a, b) : 0.0;
    let_go(in, a);
    let_go(in, b);
}

static void read_file_exists(pov_reader *in, const intrinsic *row, value *out)
{
    string *s = only_string(in);

    (void)row;
    out->as.v[0] = s && include_exists(in, s);
    let_go(in, s);
}

/* ---- strings ---- */

static void read_str(pov_reader *in, const intrinsic *row, value *out)
{
    char buffer[NUMBER_BUFFER];
    int32_t width, digits;
    double number;
    int n;

    (void)row;
    state_open(in, '(');
    number = expression_number(in);
    comma(in);
    width = expression_integer(expression_number(in));
    comma(in);
    digits = expression_integer(expression_number(in));
    state_close(in, ')');
    if (in->failed)
        return;
    n = text_number_of_a_line(buffer, sizeof buffer, number, width, digits < DIGITS_MAX ? digits : DIGITS_MAX);
    give(in, out, text_copy(in, buffer, (size_t)n));
}

/* Most strings need no other room. */
typedef struct builder {
    char *items;                 /* NULL: in `first` */
    size_t count, capacity;
    char first[128];
} builder;

static void begin(builder *b)
{
    b->items = NULL;
    b->count = 0;
    b->capacity = sizeof b->first;
}

static bool add(pov_reader *in, builder *b, const char *text, size_t length)
{
    if (b->capacity - b->count < length) {
        const size_t capacity = 2 * b->capacity + length;
        char *items = env_resize(in->model->env, b->items, capacity, 1);

        if (!items) {
            report_memory(in);
            return false;
        }
        if (!b->items)
            memcpy(items, b->first, b->count);
        b->items = items;
        b->capacity = capacity;
    }
    if (length > 0)
        memcpy((b->items ? b->items : b->first) + b->count, text, length);
    b->count += length;
    return true;
}

static void conclude(pov_reader *in, builder *b, value *out)
{
    give(in, out, text_copy(in, b->items ? b->items : b->first, b->count));
    env_free(in->model->env, b->items);
}

static void read_vstr(pov_reader *in, const intrinsic *row, value *out)
{
    builder b;
    char buffer[NUMBER_BUFFER];
    int32_t size, width, digits;
    string *between;
    value v;
    int i, n;

    (void)row;
    begin(&b);
    state_open(in, '(');
    size = expression_integer(expression_number(in));
    comma(in);
    v = expression_read(in);
    comma(in);
    between = read_string(in);
    comma(in);
    width = expression_integer(expression_number(in));
    comma(in);
    digits = expression_integer(expression_number(in));
    state_close(in, ')');
    if (!in->failed && v.kind != VALUE_NUMBER && v.kind != VALUE_VECTOR)
        report_fail(in, &in->value, POV_E_SYNTAX, "expected a vector, found %s", value_name(&v));
    if (!in->failed && (width < -DIGITS_MAX || width > DIGITS_MAX || digits > DIGITS_MAX))
        report_fail(in, &in->value, POV_E_SYNTAX, "a number is not written in more than %d characters", DIGITS_MAX);
    size = size < 2 ? 2 : size > 5 ? 5 : size;
    for (i = 0; i < size && !in->failed; i++) {
        n = text_number(buffer, sizeof buffer, v.as.v[i], width, digits);
        if (i > 0)
            add(in, &b, between->text, between->length);
        add(in, &b, buffer, (size_t)n);
    }
    if (value_is_shared(&v))
        value_drop(&in->heap, &v);
    let_go(in, between);
    conclude(in, &b, out);
}

static bool is_plain(const place *literal)
{
    for (uint32_t i = 1; i + 1 < literal->length; i++)
        if (literal->start[i] == '\\' || literal->start[i] == '\0' || (unsigned char)literal->start[i] >= 0x80)
            return false;
    return true;
}

/* Of kept tokens a literal that is an argument by itself is joined as it stands: no string is made of it. */
static bool add_literal(pov_reader *in, builder *b)
{
    if (in->token.kind != TOKEN_STRING || !calc_is_argument(in) || !is_plain(&in->token.at) ||
        !add(in, b, in->token.at.start + 1, in->token.at.length - 2))
        return false;
    state_advance(in);
    return true;
}

static void read_concat(pov_reader *in, const intrinsic *row, value *out)
{
    builder b;
    bool has_comma;
    string *s;

    (void)row;
    begin(&b);
    state_open(in, '(');
    do {
        s = add_literal(in, &b) ? NULL : read_string(in);
        if (s)
            add(in, &b, s->text, s->length);
        let_go(in, s);
        has_comma = state_accept(in, ',');
    } while ((has_comma || in->token.kind != ')') && !in->failed);
    state_close(in, ')');
    conclude(in, &b, out);
}

static void read_chr(pov_reader *in, const intrinsic *row, value *out)
{
    char buffer[4];
    int32_t code;

    (void)row;
    state_open(in, '(');
    code = expression_integer(expression_full_number(in));
    state_close(in, ')');
    if (!in->failed && (code < 0 || code > LAST_CHARACTER))
        report_fail(in, &in->value, POV_E_SYNTAX, "a character has a number from 0 to %d", LAST_CHARACTER);
    else
        give(in, out, text_copy(in, buffer, code == 0 ? 0 : lex_put_character(buffer, (unsigned)code)));
}

/* The byte at which a character starts. */
static size_t byte_of(const string *s, int32_t character)
{
    size_t at = 0;
    int bytes;

    for (; character > 0 && at < s->length; character--, at += (size_t)bytes)
        text_character(s->text + at, &bytes);
    return at;
}

static void read_substr(pov_reader *in, const intrinsic *row, value *out)
{
    int32_t start, length;
    size_t first, last;
    string *s;

    (void)row;
    state_open(in, '(');
    s = read_string(in);
    comma(in);
    start = expression_integer(expression_number(in));
    comma(in);
    length = expression_integer(expression_number(in));
    state_close(in, ')');
    if (s && !in->failed &&
        (start < 0 || length < 0 || (double)start + (double)length - 1.0 > (double)text_characters(s)))
        report_fail(in, &in->value, POV_E_SYNTAX, "the string has only %zu characters", text_characters(s));
    if (s && !in->failed) {
        first = byte_of(s, start - 1);
        last = start == 0 ? 0 : byte_of(s, start - 1 + length);
        give(in, out, text_copy(in, s->text + first, last - first));
    }
    let_go(in, s);
}

static void read_case(pov_reader *in, const intrinsic *row, value *out)
{
    string *s = only_string(in), *copy = s ? text_copy(in, s->text, s->length) : NULL;
    const char first = row->v[0] != 0.0 ? 'a' : 'A';
    size_t i;

    for (i = 0; copy && i < copy->length; i++)
        if (copy->text[i] >= first && copy->text[i] <= first + 25)
            copy->text[i] ^= 0x20;
    let_go(in, s);
    give(in, out, copy);
}

/* The moment so many days behind the beginning of the year 2000, in UTC, to the nearest second. False: in no year that is
 * written. */
static bool to_date(double days, struct tm *out)
{
    const double seconds = floor(days * 86400.0 + 0.5) + 946684800.0;
    time_t moment;

    if (!(fabs(seconds) < 1e12))
        return false;
    moment = (time_t)seconds;
    return gmtime_r(&moment, out) && out->tm_year + 1900 >= FIRST_YEAR && out->tm_year + 1900 <= LAST_YEAR;
}

static void write_date(pov_reader *in, double days, const char *format, value *out)
{
    char buffer[DATE_BUFFER];
    struct tm date;
    size_t length;

    if (format[0] == '\0') {
        report_fail(in, &in->value, POV_E_SYNTAX, "the format of a date must not be empty");
        return;
    }
    if (!to_date(days, &date)) {
        report_fail(in, &in->value, POV_E_SYNTAX, "a date lies in the years %d to %d", FIRST_YEAR, LAST_YEAR);
        return;
    }
    length = strftime(buffer, sizeof buffer, format, &date);
    if (length == 0)
        report_fail(in, &in->value, POV_E_SYNTAX, "a date has from 1 to %d characters", DATE_BUFFER - 1);
    else
        give(in, out, text_copy(in, buffer, length));
}

/* The words of the format are those of strftime(). */
static void read_datetime(pov_reader *in, const intrinsic *row, value *out)
{
    string *format = NULL;
    double days;

    (void)row;
    state_open(in, '(');
    days = expression_number(in);
    comma(in);
    if (in->token.kind != ')')
        format = read_string(in);
    state_close(in, ')');
    if (!in->failed)
        write_date(in, days, format ? format->text : "%Y-%m-%d %H:%M:%SZ", out);
    let_go(in, format);
}

#define READ(name, read) { name, read, NULL, NULL, { 0 }, 0, INTRINSIC_OTHER }

static const intrinsic rows[] = {
    READ("strlen", read_strlen), READ("asc", read_asc), READ("val", read_val), READ("strcmp", read_strcmp),
    READ("file_exists", read_file_exists), READ("str", read_str), READ("vstr", read_vstr),
    READ("concat", read_concat), READ("chr", read_chr), READ("substr", read_substr),
    READ("datetime", read_datetime),
    { "strupr", read_case, NULL, NULL, { 1.0 }, 0, INTRINSIC_OTHER }, { "strlwr", read_case, NULL, NULL, { 0.0 }, 0, INTRINSIC_OTHER },
};

intrinsic_list intrinsic_string_rows(void)
{
    intrinsic_list list = { rows, sizeof rows / sizeof rows[0] };

    return list;
}

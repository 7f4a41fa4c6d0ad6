#include "sdl/text.h"

#include "sdl/lex.h"
#include "sdl/report.h"

#include <povtrace/exact.h>

#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

string *text_create(pov_reader *in, size_t length)
{
    string *s = NULL;

    if (in->failed)
        return NULL;
    if (length > in->limits.string)
        report_fail(in, &in->value, POV_E_SYNTAX, "a string of more than %zu bytes", in->limits.string);
    else
        s = value_share(&in->heap, VALUE_STRING, sizeof *s + length + 1);
    if (!s)
        report_memory(in);
    else
        s->length = length;
    return s;
}

string *text_copy(pov_reader *in, const char *text, size_t length)
{
    string *s = text_create(in, length);

    if (s)
        memcpy(s->text, text, length);
    return s;
}

static value value_of(pov_reader *in, string *s)
{
    value v = value_of_number(0.0);

    if (s && !in->failed) {
        v.kind = VALUE_STRING;
        v.as.shared = &s->head;
    }
    return v;
}

/* ---- UTF-8 ---- */

unsigned text_character(const char *at, int *bytes)
{
    const unsigned char *c = (const unsigned char *)at;

    *bytes = 1;
    if (c[0] < 0xC2 || c[0] > 0xF4 || (c[1] & 0xC0) != 0x80)
        return c[0];
    *bytes = 2;
    if (c[0] < 0xE0)
        return (unsigned)(c[0] & 0x1F) << 6 | (c[1] & 0x3F);
    if ((c[2] & 0xC0) != 0x80)
        return *bytes = 1, c[0];
    *bytes = 3;
    if (c[0] < 0xF0)
        return (unsigned)(c[0] & 0x0F) << 12 | (unsigned)(c[1] & 0x3F) << 6 | (c[2] & 0x3F);
    if ((c[3] & 0xC0) != 0x80)
        return *bytes = 1, c[0];
    *bytes = 4;
    return (unsigned)(c[0] & 0x07) << 18 | (unsigned)(c[1] & 0x3F) << 12 | (unsigned)(c[2] & 0x3F) << 6 | (c[3] & 0x3F);
}

size_t text_characters(const string *s)
{
    size_t i = 0, n = 0;
    int bytes;

    for (; i < s->length; i += (size_t)bytes, n++)
        text_character(s->text + i, &bytes);
    return n;
}

int text_compare(const string *a, const string *b)
{
    size_t i = 0;
    int bytes;

    while (i < a->length && i < b->length && a->text[i] == b->text[i])
        i++;
    while (i > 0 && ((unsigned char)a->text[i] & 0xC0) == 0x80)
        i--;
    return (int)text_character(a->text + i, &bytes) - (int)text_character(b->text + i, &bytes);
}

/* ---- literals ---- */

static bool is_utf8(const char *text, size_t length)
{
    size_t i;
    int bytes = 1;

    for (i = 0; i < length; i += (size_t)bytes) {
        text_character(text + i, &bytes);
        if (bytes == 1 && (unsigned char)text[i] >= 0x80)
            return false;
    }
    return true;
}

static string *from_latin1(pov_reader *in, const char *text, size_t length)
{
    string *s = text_create(in, 2 * length);
    size_t i, n = 0;

    for (i = 0; s && i < length; i++)
        n += lex_put_character(s->text + n, (unsigned char)text[i]);
    if (s)
        s->length = n;
    return s;
}

static string *decode(pov_reader *in, string *s)
{
    string *decoded;

    if (!s || is_utf8(s->text, s->length))
        return s;
    decoded = from_latin1(in, s->text, s->length);
    value_unshare(&in->heap, &s->head);
    return decoded;
}

value text_literal(pov_reader *in)
{
    string *s = text_create(in, in->token.at.length);
    const char *bad = NULL;

    if (s) {
        s->length = lex_unescape(&in->token.at, s->text, &bad);
        s->text[s->length] = '\0';
        s->length = strlen(s->text);                /* character 0 ends a string */
    }
    if (bad) {
        place at = in->token.at;

        at.column += (int)(bad - at.start);
        at.start = bad;
        at.length = 2;
        report_fail(in, &at, POV_E_SYNTAX, "there is no such escape in strings");
        value_unshare(&in->heap, &s->head);
        s = NULL;
    }
    return value_of(in, decode(in, s));
}

value text_raw(pov_reader *in)
{
    return value_of(in, decode(in, text_copy(in, in->token.at.start + 1, in->token.at.length - 2)));
}

/* ---- numbers ---- */

/* The locale's decimal point becomes a point. */
static int mend_point(char *out, int n)
{
    const char *point = localeconv()->decimal_point;
    char *at = point[0] != '.' && point[0] != '\0' ? strstr(out, point) : NULL;

    if (!at)
        return n;
    memmove(at + 1, at + strlen(point), strlen(at + strlen(point)) + 1);
    at[0] = '.';
    return n - ((int)strlen(point) - 1);
}

/* Of |number| * 10^digits the nearest integer, of two the even one, as printf rounds: the product is exact, and where
 * it is an integer with a fraction that doubles hold, so is what is left. False: it is too large. */
static bool nearest(double number, int digits, uint64_t *out)
{
    static const double powers[] = { 1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15 };
    pov_two scaled;
    double beyond;

    if (digits >= (int)(sizeof powers / sizeof powers[0]) || !(number <= 1e15) || (number < 1e-200 && number != 0.0))
        return false;
    scaled = pov_two_product(number, powers[digits]);
    if (!(scaled.hi < 1e15))
        return false;
    *out = (uint64_t)scaled.hi;
    beyond = scaled.hi - (double)*out - 0.5;
    if (beyond > -scaled.lo || (beyond == -scaled.lo && (*out & 1) == 1))
        ++*out;
    return true;
}

/* The digits of an integer before `end`, a point in front of the last so many of them. */
static char *put_digits(char *end, uint64_t n, int digits)
{
    int i;

    for (i = 0; n > 0 || i <= digits; i++, n /= 10) {
        if (i == digits && digits > 0)
            *--end = '.';
        *--end = (char)('0' + n % 10);
    }
    return end;
}

/* What printf would make of it, as long as it is short. 0: it is not. */
static int short_number(char *out, size_t size, double number, int width, int digits)
{
    enum { LONGEST = 40 };
    char text[LONGEST], *at;
    const bool is_negative = signbit(number) != 0;
    const int wanted = width < 0 ? -width : width;
    uint64_t n;
    int length, total;

    if (wanted >= LONGEST || !nearest(fabs(number), digits, &n))
        return 0;
    at = put_digits(text + LONGEST, n, digits);
    length = (int)(text + LONGEST - at);
    total = length + is_negative < wanted ? wanted : length + is_negative;
    if ((size_t)total + 1 > size)
        return 0;
    memset(out, width < 0 ? '0' : ' ', (size_t)total);
    if (is_negative)
        out[width < 0 ? 0 : total - length - 1] = '-';
    memcpy(out + total - length, at, (size_t)length);
    out[total] = '\0';
    return total;
}

int text_number(char *out, size_t size, double number, int width, int digits)
{
    int length;

    if (digits < 0)
        digits = 6;
    length = short_number(out, size, number, width, digits);
    if (length > 0)
        return length;
    if (width < 0)
        return mend_point(out, snprintf(out, size, "%0*.*f", -width, digits, number));
    return mend_point(out, snprintf(out, size, "%*.*f", width, digits, number));
}

int text_number_of_a_line(char *out, size_t size, double number, int width, int digits)
{
    enum { LINE = 254 };
    const int wanted = width < 0 ? -width : width;
    int length = LINE + 1;

    if (width >= -LINE && width <= LINE) {
        if (digits <= LINE)
            length = text_number(out, size, number, width, digits);
        if (length > LINE)
            length = mend_point(out, snprintf(out, size, width < 0 ? "%0*.*g" : "%*.*g", wanted, digits, number));
    }
    return length > LINE ? snprintf(out, size, "<invalid>") : length;
}

int text_general(char *out, size_t size, double number)
{
    return mend_point(out, snprintf(out, size, "%g", number));
}

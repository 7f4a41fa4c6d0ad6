#include "text.h"

#include <stdint.h>
#include <string.h>

/* The next character; *length is its number of bytes. An invalid byte is one character of value 0. */
static uint32_t next_character(const char *text, int *length)
{
    const unsigned char *s = (const unsigned char *)text;
    static const uint32_t least[] = { 0, 0, 0x80, 0x800, 0x10000 };
    int bytes = s[0] < 0x80 ? 1 : s[0] >= 0xc2 && s[0] < 0xe0 ? 2 : (s[0] & 0xf0) == 0xe0 ? 3
              : s[0] >= 0xf0 && s[0] < 0xf5 ? 4 : 0;
    uint32_t value = bytes == 1 ? s[0] : s[0] & (0x7fu >> bytes);

    *length = 1;
    if (bytes == 0)
        return 0;
    for (int i = 1; i < bytes; i++) {
        if ((s[i] & 0xc0) != 0x80)
            return 0;
        value = value << 6 | (s[i] & 0x3fu);
    }
    if (value < least[bytes] || value > 0x10ffff || (value >= 0xd800 && value < 0xe000))
        return 0;
    *length = bytes;
    return value;
}

/* Controls of both sets would reach the terminal as commands; direction marks would reorder what is shown. */
static int is_control(uint32_t c)
{
    return (c < 0x20 && c != '\t') || (c >= 0x7f && c < 0xa0) || (c >= 0x202a && c <= 0x202e)
        || (c >= 0x2066 && c <= 0x2069);
}

typedef struct range { uint32_t first, last; } range;

static int is_among(uint32_t c, const range *ranges, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        if (c >= ranges[i].first && c <= ranges[i].last)
            return 1;
    }
    return 0;
}

/* Columns a terminal gives to a character, after the common part of Unicode's tables. */
static int columns(uint32_t c)
{
    static const range none[] = {
        { 0x300, 0x36f }, { 0x483, 0x489 }, { 0x591, 0x5bd }, { 0x610, 0x61a }, { 0x64b, 0x65f },
        { 0x1ab0, 0x1aff }, { 0x1dc0, 0x1dff }, { 0x200b, 0x200f }, { 0x20d0, 0x20ff }, { 0xfe00, 0xfe0f },
        { 0xfe20, 0xfe2f }, { 0xfeff, 0xfeff },
    };
    static const range two[] = {
        { 0x1100, 0x115f }, { 0x2e80, 0x303e }, { 0x3041, 0xa4cf }, { 0xac00, 0xd7a3 }, { 0xf900, 0xfaff },
        { 0xfe30, 0xfe6f }, { 0xff00, 0xff60 }, { 0xffe0, 0xffe6 }, { 0x1f300, 0x1f64f },
        { 0x1f680, 0x1f6ff }, { 0x1f900, 0x1f9ff }, { 0x20000, 0x3fffd },
    };

    if (c < 0x300)
        return 1;
    if (is_among(c, none, sizeof none / sizeof none[0]))
        return 0;
    return is_among(c, two, sizeof two / sizeof two[0]) ? 2 : 1;
}

void text_printable(const char *line, char *out, size_t size)
{
    size_t used = 0;
    int length;

    for (; *line; line += length) {
        uint32_t c = next_character(line, &length);

        if (used + (size_t)length + 1 > size)
            break;
        if (is_control(c)) {
            out[used++] = '?';
        } else {
            memcpy(out + used, line, (size_t)length);
            used += (size_t)length;
        }
    }
    out[used] = '\0';
}

void text_indent(const char *line, int bytes, char *out, size_t size)
{
    size_t used = 0;
    int length;

    for (int at = 0; at < bytes && line[at]; at += length) {
        uint32_t c = next_character(line + at, &length);
        int wide = is_control(c) ? 1 : columns(c);

        if (used + 3 > size)
            break;
        while (wide-- > 0)
            out[used++] = c == '\t' ? '\t' : ' ';
    }
    out[used] = '\0';
}

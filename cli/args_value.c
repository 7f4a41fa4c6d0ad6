/* Values of options. */
#include "args_read.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool args_refuse(args *a, const char *format, ...)
{
    va_list list;

    va_start(list, format);
    vsnprintf(a->problem, sizeof a->problem, format, list);
    va_end(list);
    return false;
}

int args_digits(const char *text, const char *end, int limit)
{
    int value = 0;

    if (text == end || *text == '\0')
        return -1;
    for (; text != end && *text; text++) {
        if (*text < '0' || *text > '9')
            return -1;
        if (value > (limit - (*text - '0')) / 10)
            return -1;
        value = 10 * value + (*text - '0');
    }
    return value;
}

bool args_whole(args *a, const char *what, const char *text, int least, int most, int *out)
{
    int value = args_digits(text, NULL, most);

    if (value < least)
        return args_refuse(a, "%s must be a whole number from %d to %d, not \"%s\"", what, least, most, text);
    *out = value;
    return true;
}

bool args_word(args *a, const char *what, const char *text, const char *const *words, int *out)
{
    char list[128] = "";

    for (int i = 0; words[i]; i++) {
        if (strcmp(text, words[i]) == 0) {
            *out = i;
            return true;
        }
        snprintf(list + strlen(list), sizeof list - strlen(list), "%s%s",
                 i == 0 ? "" : words[i + 1] ? ", " : " or ", words[i]);
    }
    return args_refuse(a, "%s must be %s, not \"%s\"", what, list, text);
}

bool args_choice(args *a, const char *what, const char *text, const int *choices, const char *list,
                        int *out)
{
    int value = args_digits(text, NULL, 1000);

    for (; *choices >= 0; choices++) {
        if (value == *choices) {
            *out = value;
            return true;
        }
    }
    return args_refuse(a, "%s must be %s, not \"%s\"", what, list, text);
}

/* A positive decimal number. strtod() alone would accept blanks, signs, hexadecimals, "inf" and "nan" too. */
bool args_positive(args *a, const char *what, const char *text, double *out)
{
    char *end = NULL;

    *out = 0.0;
    if (text[strspn(text, "0123456789.eE+-")] == '\0' && (*text == '.' || (*text >= '0' && *text <= '9')))
        *out = strtod(text, &end);
    if (!end || *end != '\0' || !(*out > 0.0) || !(*out <= 1e9))
        return args_refuse(a, "%s must be a number above 0, not \"%s\"", what, text);
    return true;
}

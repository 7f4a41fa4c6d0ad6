/* The pictures of an animation: --frames and --clock. */
#include "args_read.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_FRAMES = 9999999 };

bool args_frames(args *a, const char *text)
{
    const char *dots = strstr(text, "..");
    frames *f = &a->frames;

    f->from = dots ? args_digits(text, dots, MOST_FRAMES) : -1;
    f->to = dots ? args_digits(dots + 2, NULL, MOST_FRAMES) : -1;
    if (f->from < 0 || f->to < f->from)
        return args_refuse(a, "--frames wants the first and the last frame, such as 1..100, not \"%s\"", text);
    f->asked = true;
    f->step = 1;
    f->first = f->from;
    f->last = f->to;
    if (!a->has_clock)
        f->last_clock = 1.0;
    return true;
}

bool args_clock(args *a, const char *text)
{
    char *end;

    a->has_clock = true;
    a->frames.first_clock = strtod(text, &end);
    if (end != text && *end == ',') {
        text = end + 1;
        a->frames.last_clock = strtod(text, &end);
        if (end != text && *end == '\0')
            return true;
    }
    return args_refuse(a, "--clock wants its values at the first and the last frame, such as 0,1, not \"%s\"", text);
}

/* What has no place for them. */
bool args_check_frames(args *a)
{
    if (!a->frames.asked)
        return !a->has_clock || args_refuse(a, "--clock is that of --frames");
    if (a->check || a->explain || a->merge || a->parts > 0 || a->tev)
        return args_refuse(a, "--frames goes with none of --check, --explain, --part, --merge and --tev");
    return true;
}

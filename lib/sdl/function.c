#include "sdl/function.h"

#include "sdl/report.h"
#include "sdl/unsupported.h"

value function_read(pov_reader *in)
{
    value v = value_of_number(0.0);

    unsupported_note(in, &in->last, KEYWORD_FUNCTION, "\"function\"");
    unsupported_skip_block(in);
    return v;
}

value function_call(pov_reader *in, value callee)
{
    (void)in;
    return callee;
}

#include "sdl/message.h"

#include "sdl/directive.h"
#include "sdl/expression.h"
#include "sdl/report.h"

#include <string.h>

void message_run(pov_reader *in, const place *at)
{
    const keyword_id keyword = in->token.symbol->id;
    string *text;

    directive_step(in);
    in->wanted = "a string";
    text = expression_to_string(in, expression_read(in));
    if (!text)
        return;
    if (keyword == KEYWORD_ERROR)
        report_fail(in, at, POV_E_SYNTAX, "the scene says: %s", text->text);
    else if (keyword == KEYWORD_WARNING)
        report_warn(in, at, "the scene says: %s", text->text);
    else
        report_text(in, text->text, text->length);
    value_unshare(&in->heap, &text->head);
}

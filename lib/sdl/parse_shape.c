/* Classes of shapes by their words. */
#include "sdl/parse.h"

#include "sdl/reader.h"
#include "sdl/report.h"

#include <string.h>

const shape_class *parse_shape_class(pov_reader *in, symbol *word)
{
    pov_error error;

    if (!word->shape && registry_shape(in->plugins, word->name, &word->shape, &error) < 0)
        report_pass_on(in, &in->token.at, &error);
    return word->shape;
}

void parse_share_shape(pov_reader *in, symbol *word, leaf_node *o)
{
    const size_t bytes = parse_shape_size(o->shape);

    if (word->last && memcmp(word->last, o->instance, bytes) == 0 &&
        arena_give_back(&in->model->memory, o->instance, bytes))
        o->instance = word->last;
    word->last = o->instance;
}

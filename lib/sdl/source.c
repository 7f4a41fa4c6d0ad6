#include "sdl/source.h"

#include "base/hash.h"

#include <string.h>

void source_init(source_stack *s, const env *e)
{
    s->env = e;
    s->top = NULL;
    s->all = NULL;
    s->hash = 0;
}

void source_free(source_stack *s)
{
    source *text, *older;

    for (text = s->all; text; text = older) {
        older = text->older;
        env_free(s->env, text);
    }
    source_init(s, s->env);
}

bool source_push(source_stack *s, const char *text, size_t length, const char *name)
{
    static const char mark[] = "\xEF\xBB\xBF";
    source *added = env_alloc(s->env, 1, sizeof *added);

    if (!added)
        return false;
    added->name = name;
    added->text = text;
    added->end = text + length;
    if (length >= 3 && memcmp(text, mark, 3) == 0)
        added->text += 3;
    added->at = added->text;
    added->line_start = added->text;
    added->line = 1;
    added->below = s->top;
    added->older = s->all;
    s->top = added;
    s->all = added;
    s->hash = hash_bytes(s->hash, text, length);
    return true;
}

bool source_pop(source_stack *s)
{
    if (!s->top || !s->top->below)
        return false;
    s->top = s->top->below;
    return true;
}

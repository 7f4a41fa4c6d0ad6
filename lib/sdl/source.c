#include "sdl/source.h"

#include "base/hash.h"

#include <string.h>

void source_init(source_list *s, const env *e)
{
    s->env = e;
    s->all = NULL;
    s->hash = 0;
}

void source_free(source_list *s)
{
    source *text, *older;

    for (text = s->all; text; text = older) {
        older = text->older;
        env_free(s->env, text->owned);
        env_free(s->env, text);
    }
    source_init(s, s->env);
}

source *source_add(source_list *s, const char *text, size_t length, const char *name)
{
    static const char mark[] = "\xEF\xBB\xBF";
    source *added = env_alloc(s->env, 1, sizeof *added);

    if (!added)
        return NULL;
    added->name = name;
    added->text = text;
    added->end = text + length;
    if (length >= 3 && memcmp(text, mark, 3) == 0)
        added->text += 3;
    added->at = added->text;
    added->line_start = added->text;
    added->line = 1;
    added->older = s->all;
    s->all = added;
    s->hash = hash_bytes(s->hash, text, length);
    return added;
}

#include "sdl/token_buffer.h"

#include "base/vec.h"

token_buffer *token_buffer_create(token_buffer_list *list)
{
    token_buffer *b = env_alloc(list->env, 1, sizeof *b);

    if (!b)
        return NULL;
    b->uses = 1;
    b->met.kind = REPLAY_MET;
    b->none.kind = REPLAY_NONE;
    b->next = list->first;
    if (b->next)
        b->next->previous = b;
    list->first = b;
    return b;
}

bool token_buffer_add(token_buffer_list *list, token_buffer *b, const token *t)
{
    return VEC_PUSH(list->env, b, *t);
}

replay **token_buffer_begin_replay(token_buffer_list *list, token_buffer *b, size_t index)
{
    b->replays = env_alloc(list->env, b->count, sizeof *b->replays);
    return b->replays ? &b->replays[index] : NULL;
}

void *token_buffer_keep(token_buffer_list *list, token_buffer *b, size_t bytes)
{
    replay *kept = env_alloc(list->env, 1, bytes);

    if (kept) {
        kept->next = b->compiled;
        b->compiled = kept;
    }
    return kept;
}

static void free_replays(token_buffer_list *list, token_buffer *b)
{
    replay *at = b->compiled, *next;

    for (; at; at = next) {
        next = at->next;
        env_free(list->env, at);
    }
    env_free(list->env, b->replays);
}

void token_buffer_release(token_buffer_list *list, token_buffer *b)
{
    if (--b->uses > 0)
        return;
    if (b->previous)
        b->previous->next = b->next;
    else
        list->first = b->next;
    if (b->next)
        b->next->previous = b->previous;
    free_replays(list, b);
    env_free(list->env, b->items);
    env_free(list->env, b);
}

void token_buffer_free_all(token_buffer_list *list)
{
    while (list->first) {
        list->first->uses = 1;
        token_buffer_release(list, list->first);
    }
}

#include "sdl/items.h"

#include "sdl/report.h"

#include <stdio.h>

void items_open(pov_reader *in, block *b)
{
    b->keyword = in->last;
    b->brace = in->token.at;
    state_expect(in, '{');
    b->outer = in->block;
    in->block = b;
}

bool items_try(pov_reader *in, const item_list *list, void *self)
{
    word_id word = state_word(in);
    size_t i;

    if (word == WORD_OTHER)
        return false;
    for (i = 0; i < list->count; i++) {
        if (list->items[i].word == word) {
            state_advance(in);
            list->items[i].read(in, self, word);
            return true;
        }
    }
    return false;
}

static void refuse(pov_reader *in, const item_list *list)
{
    char wanted[128];
    guess g;
    size_t i;

    report_guess_start(&g, in);
    for (i = 0; i < list->count; i++)
        report_guess_try(&g, token_word_name(list->items[i].word));
    snprintf(wanted, sizeof wanted, "%s or \"}\"", list->wanted);
    report_misplaced(in, wanted, &g);
}

void items_close(pov_reader *in, block *b, const item_list *list, void *self)
{
    while (!in->failed && in->token.kind != '}')
        if (!items_try(in, list, self))
            refuse(in, list);
    in->block = b->outer;
    state_accept(in, '}');
}

void items_block(pov_reader *in, const item_list *list, void *self)
{
    block b;

    items_open(in, &b);
    items_close(in, &b, list, self);
}

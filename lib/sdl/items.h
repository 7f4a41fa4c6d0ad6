/* items.h - blocks of the language as tables: which words may stand between two braces, and who reads each.
 * */
#ifndef SDL_ITEMS_H
#define SDL_ITEMS_H

#include "sdl/state.h"

typedef struct item {
    keyword_id keyword;
    void (*read)(pov_reader *in, void *self, keyword_id keyword);   /* the word has been taken */
} item;

typedef struct item_list {
    const char *wanted;          /* what an item is, for messages: `a modifier of the camera` */
    const item *items;
    size_t count;
    /* Words that belong here and change nothing, and those of features to come; each list ends with KEYWORD_OTHER, or
     * is NULL. Values and a block may stand behind them. */
    const keyword_id *quiet, *quiet_too, *coming;
    value_kind takes;            /* a name of this kind stands for what was read before; VALUE_NOTHING: none does */
    void (*take)(pov_reader *in, void *self, const value *v);
} item_list;

#define ITEMS(items) items, sizeof(items) / sizeof(items)[0]

/* The word was taken: its '{'. The block must live until items_close(). */
void items_open(pov_reader *in, block *b);
/* Items up to the '}', which is taken. */
void items_close(pov_reader *in, block *b, const item_list *list, void *self);
/* Items up to the punctuation, which is not taken. */
void items_until(pov_reader *in, int end, const item_list *list, void *self);
bool items_name_follows(const pov_reader *in, value_kind kind);
/* A name, or an element of an array, that leads to a part of the scene of that kind, if one is next. */
bool items_read_named(pov_reader *in, value_kind kind, value *out);
/* What stands next is no item of the list. */
void items_refuse(pov_reader *in, const item_list *list);
/* A whole block, where nothing but items stands between the braces. */
void items_block(pov_reader *in, const item_list *list, void *self);
/* Read one item if its word is next. */
bool items_try(pov_reader *in, const item_list *list, void *self);

#endif

/* items.h - blocks of the language as tables: which words may stand between two braces, and who reads each.
 * */
#ifndef SDL_ITEMS_H
#define SDL_ITEMS_H

#include "sdl/state.h"

typedef struct item {
    word_id word;
    void (*read)(pov_reader *in, void *self, word_id word);   /* the word has been taken */
} item;

typedef struct item_list {
    const char *wanted;          /* what an item is, for messages: `a modifier of the camera` */
    const item *items;
    size_t count;
} item_list;

#define ITEM_LIST(wanted, items) { wanted, items, sizeof(items) / sizeof(items)[0] }

/* The word was taken: its '{'. The block must live until items_close(). */
void items_open(pov_reader *in, block *b);
/* Items up to the '}', which is taken. */
void items_close(pov_reader *in, block *b, const item_list *list, void *self);
/* Both, where nothing but items stands between the braces. */
void items_block(pov_reader *in, const item_list *list, void *self);
/* Read one item if its word is next. */
bool items_try(pov_reader *in, const item_list *list, void *self);

#endif

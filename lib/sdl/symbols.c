#include "sdl/symbols.h"

#include <string.h>

static uint32_t hash_of(const char *text, uint32_t length)
{
    uint32_t i, hash = SYMBOLS_HASH_START;

    for (i = 0; i < length; i++)
        hash = symbols_hash(hash, (unsigned char)text[i]);
    return hash;
}

/* The slot that holds the word, or the empty one where it belongs. */
static symbol **slot_of(const symbols *s, const char *text, uint32_t length, uint32_t hash)
{
    size_t i = hash & (s->capacity - 1);

    while (s->slots[i] && (s->slots[i]->hash != hash || s->slots[i]->length != length ||
                           memcmp(s->slots[i]->name, text, length) != 0))
        i = (i + 1) & (s->capacity - 1);
    return &s->slots[i];
}

static bool grow(symbols *s, size_t capacity)
{
    symbols bigger = *s;
    size_t i;

    bigger.slots = env_alloc(s->env, capacity, sizeof *bigger.slots);
    if (!bigger.slots)
        return false;
    bigger.capacity = capacity;
    for (i = 0; i < s->capacity; i++)
        if (s->slots[i])
            *slot_of(&bigger, s->slots[i]->name, s->slots[i]->length, s->slots[i]->hash) = s->slots[i];
    env_free(s->env, s->slots);
    *s = bigger;
    return true;
}

static void put(symbols *s, symbol *word)
{
    *slot_of(s, word->name, word->length, word->hash) = word;
    s->count++;
}

bool symbols_init(symbols *s, const env *e)
{
    size_t i, count = 0, capacity = 64;
    const char *name;
    word_id id;
    uint32_t flags;

    memset(s, 0, sizeof *s);
    s->env = e;
    while (token_word(count, &id, &flags))
        count++;
    while (capacity < 2 * count + 64)
        capacity *= 2;
    s->words = env_alloc(e, count, sizeof *s->words);
    if (!s->words || !grow(s, capacity))
        return false;
    for (i = 0; i < count; i++) {
        symbol *word = &s->words[i];

        name = token_word(i, &id, &flags);
        word->name = name;
        word->length = (uint32_t)strlen(name);
        word->hash = hash_of(name, word->length);
        word->id = id;
        word->flags = flags;
        put(s, word);
    }
    return true;
}

void symbols_free(symbols *s)
{
    env_free(s->env, s->words);
    env_free(s->env, s->slots);
}

symbol *symbols_find(const symbols *s, const char *text, uint32_t length, uint32_t hash)
{
    return *slot_of(s, text, length, hash);
}

symbol *symbols_add(symbols *s, arena *memory, const char *text, uint32_t length)
{
    uint32_t hash = hash_of(text, length);
    symbol *word = symbols_find(s, text, length, hash);

    if (word)
        return word;
    if (2 * (s->count + 1) > s->capacity && !grow(s, 2 * s->capacity))
        return NULL;
    word = arena_alloc(memory, sizeof *word, sizeof(void *));
    if (!word)
        return NULL;
    word->name = arena_text(memory, text, length);
    if (!word->name)
        return NULL;
    word->length = length;
    word->hash = hash;
    put(s, word);
    return word;
}

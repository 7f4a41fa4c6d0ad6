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

static void fill(symbol *word, const char *name, keyword_id id)
{
    word->name = name;
    word->length = (uint32_t)strlen(name);
    word->hash = hash_of(name, word->length);
    word->id = id;
    word->flags = token_keyword_flags(id);
    word->directive = -1;
}

bool symbols_init(symbols *s, const env *e)
{
    size_t i, capacity = 64;

    memset(s, 0, sizeof *s);
    s->env = e;
    arena_init(&s->memory, e);
    while (capacity < 2 * KEYWORDS + 64)
        capacity *= 2;
    s->keywords = env_alloc(e, KEYWORDS, sizeof *s->keywords);
    if (!s->keywords || !grow(s, capacity))
        return false;
    for (i = KEYWORD_OTHER + 1; i < KEYWORDS; i++) {
        fill(&s->keywords[i], token_keyword_name((keyword_id)i), (keyword_id)i);
        put(s, &s->keywords[i]);
    }
    return true;
}

void symbols_free(symbols *s)
{
    env_free(s->env, s->keywords);
    env_free(s->env, s->slots);
    arena_free(&s->memory);
}

symbol *symbols_find(const symbols *s, const char *text, uint32_t length, uint32_t hash)
{
    return *slot_of(s, text, length, hash);
}

symbol *symbols_named(const symbols *s, const char *name)
{
    uint32_t length = (uint32_t)strlen(name);

    return symbols_find(s, name, length, hash_of(name, length));
}

symbol *symbols_add(symbols *s, const char *text, uint32_t length, uint32_t hash)
{
    symbol *word = symbols_find(s, text, length, hash);

    if (word)
        return word;
    if (2 * (s->count + 1) > s->capacity && !grow(s, 2 * s->capacity))
        return NULL;
    word = arena_alloc(&s->memory, sizeof *word, sizeof(void *));
    if (!word)
        return NULL;
    word->name = arena_text(&s->memory, text, length);
    if (!word->name)
        return NULL;
    word->length = length;
    word->hash = hash;
    word->directive = -1;
    put(s, word);
    return word;
}

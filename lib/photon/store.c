#include "photon/store.h"

#include <string.h>

enum {
    CHUNK = 1024,                /* emissions: a few milliseconds */
    FIRST_EMISSIONS = 1 << 16,   /* of a map of the first level, of all aims together */
    LEAST_EMISSIONS = 1 << 8,    /* of an aim, unless there are so many aims that these are too many */
    MOST_EMISSIONS = 1 << 20,    /* of all aims together */
    FIRST_NEAREST = 80           /* photons that a disc of the first level reaches */
};

/* A map that is being made, or is made. The store's lock guards it until it is done. */
typedef struct making {
    photon_catch *lists;         /* by chunk */
    size_t claimed, traced, chunk_count;
    bool begun, done, failed;
    photon_maps maps;
} making;

struct photon_seed {
    photon_seed *next;
    uint32_t seed, users;
    making maps[PHOTON_MAPS];
};

struct photon_store {
    const env *env;
    const photon_aims *aims;
    mutex lock;
    condition changed;
    photon_seed *seeds;
};

uint32_t photon_store_number(uint32_t sample)
{
    const uint32_t half = sample & 1, turn = sample / 2 + 1;
    uint32_t level = 0;

    while (level + 1 < PHOTON_LEVELS && turn >> (level + 1))
        level++;
    return PHOTON_HALVES * level + half;
}

static uint32_t level_of(uint32_t number) { return number / PHOTON_HALVES; }

uint32_t photon_store_emissions(const photon_aims *aims, uint32_t number)
{
    const uint64_t n = aims->count > 0 ? aims->count : 1, first = FIRST_EMISSIONS / n;
    const uint64_t each = (first > LEAST_EMISSIONS ? first : LEAST_EMISSIONS) << level_of(number), most = MOST_EMISSIONS / n;

    return (uint32_t)(each < most ? each : most > 1 ? most : 1);
}

/* More photons and smaller discs: both the number of photons of a disc and the number of discs of a map grow. The second
 * half's discs hold half as many as the first's: they blur the less what is not smooth. */
static uint32_t nearest_of(uint32_t number)
{
    static const uint32_t by_level[PHOTON_LEVELS] = { FIRST_NEAREST, 100, 126, 160, 200 };
    const uint32_t n = by_level[level_of(number)];

    return number % PHOTON_HALVES == 0 ? n : n / 2;
}

static photon_kernel kernel_of(uint32_t number) { return number % PHOTON_HALVES == 0 ? PHOTON_SMOOTH : PHOTON_SHARP; }

photon_store *photon_store_create(const env *e, const photon_aims *aims)
{
    photon_store *s = env_alloc(e, 1, sizeof *s);

    if (!s)
        return NULL;
    s->env = e;
    s->aims = aims;
    if (!mutex_init(&s->lock)) {
        env_free(e, s);
        return NULL;
    }
    if (!condition_init(&s->changed)) {
        mutex_destroy(&s->lock);
        env_free(e, s);
        return NULL;
    }
    return s;
}

static void free_lists(const photon_store *s, making *m)
{
    for (size_t i = 0; m->lists && i < m->chunk_count; i++)
        for (int k = 0; k < PHOTON_PLACES; k++)
            env_free(s->env, m->lists[i].of[k].items);
    env_free(s->env, m->lists);
    m->lists = NULL;
}

/* Those that nobody holds, or all. */
static void free_seeds(photon_store *s, bool all)
{
    for (photon_seed **at = &s->seeds, *p; (p = *at) != NULL;) {
        if (p->users > 0 && !all) {
            at = &p->next;
            continue;
        }
        *at = p->next;
        for (int i = 0; i < PHOTON_MAPS; i++) {
            free_lists(s, &p->maps[i]);
            for (int k = 0; k < PHOTON_PLACES; k++)
                photon_map_free(&p->maps[i].maps.of[k], s->env);
        }
        env_free(s->env, p);
    }
}

void photon_store_destroy(photon_store *s)
{
    if (!s)
        return;
    free_seeds(s, true);
    condition_destroy(&s->changed);
    mutex_destroy(&s->lock);
    env_free(s->env, s);
}

/* The lock is held. */
static photon_seed *find_seed(photon_store *s, uint32_t seed)
{
    photon_seed *p = s->seeds;

    while (p && p->seed != seed)
        p = p->next;
    if (p)
        return p;
    free_seeds(s, false);
    p = env_alloc(s->env, 1, sizeof *p);
    if (!p)
        return NULL;
    p->seed = seed;
    p->next = s->seeds;
    s->seeds = p;
    return p;
}

photon_seed *photon_store_hold(photon_store *s, uint32_t seed)
{
    photon_seed *p;

    mutex_lock(&s->lock);
    p = find_seed(s, seed);
    if (p)
        p->users++;
    mutex_unlock(&s->lock);
    return p;
}

void photon_store_let_go(photon_store *s, photon_seed *of)
{
    mutex_lock(&s->lock);
    of->users--;
    mutex_unlock(&s->lock);
}

/* ---- making a map ---- */

static size_t chunks_of_aim(const photon_store *s, uint32_t number)
{
    return (photon_store_emissions(s->aims, number) + CHUNK - 1) / CHUNK;
}

static photon_chunk chunk_at(const photon_store *s, const photon_seed *of, uint32_t number, size_t i)
{
    const size_t each = chunks_of_aim(s, number);
    const uint32_t total = photon_store_emissions(s->aims, number), first = (uint32_t)(i % each) * CHUNK;
    const photon_chunk c = { &s->aims->items[i / each], of->seed, number, first, total - first < CHUNK ? total - first : CHUNK, total };

    return c;
}

/* The lock is held. */
static void begin(photon_store *s, photon_seed *of, uint32_t number)
{
    making *m = &of->maps[number];

    m->begun = true;
    m->chunk_count = s->aims->count * chunks_of_aim(s, number);
    m->lists = env_alloc(s->env, m->chunk_count, sizeof *m->lists);
    m->failed = !m->lists && m->chunk_count > 0;
}

/* All photons of a place in the order of the chunks. */
static photon *join(const photon_store *s, const making *m, int place, uint32_t *count)
{
    size_t n = 0, at = 0;
    photon *all;

    for (size_t i = 0; i < m->chunk_count; i++)
        n += m->lists[i].of[place].count;
    all = env_resize(s->env, NULL, n > 0 ? n : 1, sizeof *all);
    for (size_t i = 0; all && i < m->chunk_count; i++) {
        const photon_list *some = &m->lists[i].of[place];

        if (some->count > 0)
            memcpy(all + at, some->items, some->count * sizeof *all);
        at += some->count;
    }
    *count = (uint32_t)n;
    return all;
}

/* The last chunk was traced; the lock is not held, and nobody else is at work on the map. */
static bool complete(photon_store *s, making *m, uint32_t number)
{
    bool made = true;

    for (int k = 0; k < PHOTON_PLACES && made; k++) {
        uint32_t count;
        photon *all = join(s, m, k, &count);

        made = all && photon_map_make(&m->maps.of[k], s->env, all, count, nearest_of(number), kernel_of(number));
    }
    free_lists(s, m);
    return made;
}

/* Trace the next chunk, and complete the map after the last. The lock is held, but not meanwhile. */
static void help(photon_store *s, photon_seed *of, uint32_t number, photon_trace *trace, void *user)
{
    making *m = &of->maps[number];
    const size_t i = m->claimed++;
    bool traced, last;

    mutex_unlock(&s->lock);
    {
        const photon_chunk chunk = chunk_at(s, of, number, i);

        traced = trace(user, &chunk, &m->lists[i]);
    }
    mutex_lock(&s->lock);
    m->failed = m->failed || !traced;
    last = ++m->traced == m->chunk_count;
    if (last && !m->failed) {
        mutex_unlock(&s->lock);
        traced = complete(s, m, number);
        mutex_lock(&s->lock);
        m->failed = !traced;
        m->done = traced;
    }
    if (last || m->failed)
        condition_wake_all(&s->changed);
}

const photon_maps *photon_store_take(photon_store *s, photon_seed *of, uint32_t number, photon_trace *trace, photon_wanted *wanted,
                                     void *user)
{
    making *m = &of->maps[number];
    const photon_maps *out;

    mutex_lock(&s->lock);
    if (!m->begun)
        begin(s, of, number);
    if (m->chunk_count == 0)
        m->done = !m->failed;
    while (!m->done && !m->failed && (m->claimed == m->chunk_count || wanted(user))) {
        if (m->claimed < m->chunk_count)
            help(s, of, number, trace, user);
        else
            condition_wait(&s->changed, &s->lock);
    }
    out = m->done ? &m->maps : NULL;
    mutex_unlock(&s->lock);
    return out;
}

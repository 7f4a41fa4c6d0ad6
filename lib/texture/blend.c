#include "texture/blend.h"

#include "base/lane_mask.h"

/* Values of lists are whole, unless a wave form shaped them. */
static void find_members(blending *b, uint32_t count, const double *value, uint32_t n)
{
    const double last = (double)(count - 1);

    for (uint32_t i = 0; i < n; i++) {
        const double within = value[i] > 0.0 ? value[i] < last ? value[i] : last : 0.0;

        b->low[i] = (uint32_t)within;
        b->between[i] = within - (double)b->low[i];
    }
}

/* Where value lies, of which i is the first entry that is large enough. Beyond the last entry i is that one. */
static inline void put_between(blending *b, uint32_t count, double value, uint32_t i, uint32_t lane)
{
    bool is_between;

    if (!(value < (double)b->values[count - 1]))
        i = count - 1;
    is_between = i > 0 && value < (double)b->values[i];
    b->low[lane] = is_between ? i - 1 : i;
    b->between[lane] = is_between ? (value - (double)b->values[i - 1]) /
                                        ((double)b->values[i] - (double)b->values[i - 1]) : 0.0;
}

/* Values of maps need not rise: the first that is large enough counts, unless the last one is passed. */
static void find_between(blending *b, uint32_t count, const double *value, uint32_t n)
{
    for (uint32_t lane = 0; lane < n; lane++) {
        uint32_t i = 0;

        while (i + 1 < count && value[lane] > (double)b->values[i])
            i++;
        put_between(b, count, value[lane], i, lane);
    }
}

static bool rises(const float *values, uint32_t count)
{
    int32_t all = -1;

    for (uint32_t k = 1; k < count; k++)
        all &= values[k - 1] <= values[k] ? -1 : 0;
    return all != 0;
}

/* Where they rise, half of the entries are left out at a time, without branches: lanes would not take them alike. */
#if defined(__AVX512F__) && defined(__GNUC__)
static void search_rising(const float *values, uint32_t count, const double *value, uint32_t n, int64_t *entry)
{
    for (uint32_t lane = 0; lane < n; lane += 8) {
        const __m512d own = _mm512_loadu_pd(value + lane);
        __m512i i = _mm512_setzero_si512();

        for (uint32_t left = count - 1; left > 0;) {
            const uint32_t half = (left + 1) / 2;
            const __m512d at = _mm512_cvtps_pd(_mm512_i64gather_ps(i, values + half - 1, sizeof *values));

            i = _mm512_mask_add_epi64(i, _mm512_cmp_pd_mask(own, at, _CMP_GT_OQ), i, _mm512_set1_epi64(half));
            left -= half;
        }
        _mm512_storeu_si512(entry + lane, i);
    }
}
#else
static void search_rising(const float *values, uint32_t count, const double *value, uint32_t n, int64_t *entry)
{
    for (uint32_t lane = 0; lane < n; lane++) {
        uint32_t i = 0;

        for (uint32_t left = count - 1; left > 0;) {
            const uint32_t half = (left + 1) / 2;

            i += value[lane] > (double)values[i + half - 1] ? half : 0;
            left -= half;
        }
        entry[lane] = i;
    }
}
#endif

static void find_rising(blending *b, uint32_t count, const double *value, uint32_t n)
{
    SIMD_ALIGNED int64_t entry[LANES_MAX];

    search_rising(b->values, count, value, n, entry);
    for (uint32_t lane = 0; lane < n; lane++)
        put_between(b, count, value[lane], (uint32_t)entry[lane], lane);
}

/* Each entry of a short map is held against all of them, from the last one down. */
enum { MAP_SHORT = 16 };

SIMD_CLONES static void find_short(const float *restrict values, uint32_t count, const double *restrict value, uint32_t n,
                                   blending *restrict b)
{
    SIMD_ALIGNED double upper[LANES_MAX], lower[LANES_MAX];
    SIMD_ALIGNED int64_t entry[LANES_MAX];
    const double last = (double)values[count - 1];

    for (uint32_t i = 0; i < n; i++) {
        entry[i] = count - 1;
        upper[i] = last;
        lower[i] = (double)values[count > 1 ? count - 2 : 0];
    }
    for (uint32_t k = count - 1; k-- > 0;) {
        const double at = (double)values[k], before = (double)values[k > 0 ? k - 1 : 0];

        for (uint32_t i = 0; i < n; i++) {
            const bool is_first = !(value[i] > at) & (value[i] < last);

            entry[i] = is_first ? (int64_t)k : entry[i];
            upper[i] = is_first ? at : upper[i];
            lower[i] = is_first ? before : lower[i];
        }
    }
    for (uint32_t i = 0; i < n; i++) {
        const bool is_between = (entry[i] > 0) & (value[i] < upper[i]);
        const double between = (value[i] - lower[i]) / (upper[i] - lower[i]);

        b->low[i] = (uint32_t)(is_between ? entry[i] - 1 : entry[i]);
        b->between[i] = is_between ? between : 0.0;
    }
}

static void sum_weights(blending *b, uint32_t count)
{
    b->total = 0.0f;
    for (uint32_t i = 0; i < count; i++)
        b->total += b->values[i];
    if (b->total == 0.0f)
        b->total = 1.0f;         /* they show nothing, as in POV-Ray */
}

void blend_find(blending *b, blend kind, const float *values, uint32_t count, const double *value, uint32_t n)
{
    b->kind = kind;
    b->values = values;
    b->n = n;
    b->present = ~(uint64_t)0;
    if (kind == BLEND_AVERAGE) {
        sum_weights(b, count);
        return;
    }
    if (kind == BLEND_MAP && count <= MAP_SHORT) {
        find_short(values, count, value, lanes_whole(n), b);
        return;
    }
    if (kind == BLEND_LIST)
        find_members(b, count, value, n);
    else if (rises(values, count))
        find_rising(b, count, value, n);
    else
        find_between(b, count, value, n);
}

void blend_mark(blending *b)
{
    if (b->kind != BLEND_MAP && b->kind != BLEND_LIST)
        return;
    b->present = 0;
    for (uint32_t i = 0; i < b->n; i++) {
        b->present |= (uint64_t)1 << (b->low[i] & 63);
        if (b->between[i] != 0.0)
            b->present |= (uint64_t)1 << ((b->low[i] + 1) & 63);
    }
}

void blend_find_parts(blending *b, const texture_part *parts, uint32_t count, uint32_t n)
{
    b->kind = BLEND_PARTS;
    b->parts = parts;
    b->last = count - 1;
    b->n = n;
    b->present = ~(uint64_t)0;
}

static float share_of_part(const blending *b, uint32_t member, const texture_part *p)
{
    float share = p->count == 0 && member == b->last ? 1.0f : 0.0f;

    for (uint32_t i = 0; i < p->count; i++)
        share += (p->which[i] < b->last ? p->which[i] : b->last) == member ? p->share[i] : 0.0f;
    return share;
}

/* Shares of lanes side by side, and whether they have any. */
SIMD_CLONES SIMD_NOINLINE static void find_shares(const blending *restrict b, uint32_t member, uint32_t n, float *restrict share,
                                                  uint32_t *restrict any)
{
    for (uint32_t i = 0; i < n; i++) {
        const float lower = (float)(1.0 - b->between[i]), upper = (float)b->between[i];
        const float own = b->low[i] == member ? lower : b->low[i] + 1 == member ? upper : 0.0f;

        share[i] = own;
        any[i] = own != 0.0f;
    }
}

/* Of a map or a list. */
static uint32_t find_lanes(const blending *b, uint32_t member, uint8_t *lane, float *share)
{
    SIMD_ALIGNED float own[LANES_MAX];
    SIMD_ALIGNED uint32_t any[LANES_MAX];
    uint32_t count;

    find_shares(b, member, lanes_whole(b->n), own, any);
    count = lane_mask_list(lane_mask_of(any, b->n), lane);
    for (uint32_t k = 0; k < count; k++)
        share[k] = own[lane[k]];
    return count;
}

/* Of an average all lanes have as much. */
static uint32_t find_average(const blending *b, uint32_t member, uint8_t *lane, float *share)
{
    const float own = b->values[member] / b->total;

    for (uint32_t i = 0; i < b->n; i++) {
        share[i] = own;
        lane[i] = (uint8_t)i;
    }
    return own != 0.0f ? b->n : 0;
}

uint32_t blend_lanes(const blending *b, uint32_t member, uint8_t *lane, float *share)
{
    uint32_t count = 0;

    if (!(b->present >> (member & 63) & 1))
        return 0;
    if (b->kind == BLEND_MAP || b->kind == BLEND_LIST)
        return find_lanes(b, member, lane, share);
    if (b->kind == BLEND_AVERAGE)
        return find_average(b, member, lane, share);
    for (uint32_t i = 0; i < b->n; i++) {
        share[count] = share_of_part(b, member, &b->parts[i]);
        lane[count] = (uint8_t)i;
        count += share[count] != 0.0f;
    }
    return count;
}

#include "render/sample.h"

#include "base/mix.h"
#include "base/sequence.h"

static uint64_t key_of(uint32_t seed, int x, int y, int half)
{
    const uint64_t key = mix_bits((uint64_t)(uint32_t)half << 60 ^ (uint64_t)(uint32_t)y << 30 ^ (uint64_t)(uint32_t)x);

    return mix_bits(key + (uint64_t)seed * 0x9e3779b97f4a7c15u);
}

sample sample_at(uint32_t seed, int x, int y, int half, uint32_t index)
{
    const sequence_point p = sequence_at(index, key_of(seed, x, y, half));
    const sample s = { p.x, p.y };

    return s;
}

sample sample_on_lens(uint32_t seed, int x, int y, int half, uint32_t index)
{
    const uint64_t key = mix_bits(key_of(seed, x, y, half) + 0xd1342543de82ef95u);
    const sequence_point p = sequence_at(sequence_shuffle(index, (uint32_t)(key >> 13)), mix_bits(key));
    const sample s = { p.x, p.y };

    return s;
}

#include "render/sample.h"

#include "base/mix.h"
#include "base/sequence.h"

sample sample_at(uint32_t seed, int x, int y, int half, uint32_t index)
{
    const uint64_t key = mix_bits((uint64_t)(uint32_t)half << 60 ^ (uint64_t)(uint32_t)y << 30 ^ (uint64_t)(uint32_t)x);
    const sequence_point p = sequence_at(index, mix_bits(key + (uint64_t)seed * 0x9e3779b97f4a7c15u));
    const sample s = { p.x, p.y };

    return s;
}

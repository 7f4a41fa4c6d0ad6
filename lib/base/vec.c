#include "base/vec.h"

bool vec_reserve(const env *e, void **items, size_t *capacity, size_t count, size_t bytes)
{
    size_t wanted = *capacity < 8 ? 8 : *capacity * 2;
    void *grown;

    if (count < *capacity)
        return true;
    if (wanted < *capacity)
        return false;
    grown = env_resize(e, *items, wanted, bytes);
    if (!grown)
        return false;
    *items = grown;
    *capacity = wanted;
    return true;
}

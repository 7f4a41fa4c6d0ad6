/* hierarchy.h - a bounding volume hierarchy as a service for plugins: over the items of one shape. */
#ifndef BVH_HIERARCHY_H
#define BVH_HIERARCHY_H

#include "bvh/bvh.h"

#include <povtrace/plugin.h>

typedef struct hierarchy hierarchy;

/* The items of one. box is called from several threads; boxes are finite, within +-1e150. order: NULL, or which item
 * each became, so that the items of a leaf follow one another. */
typedef struct hierarchy_items {
    uint32_t count;              /* at least one; in order, at most 2^27 */
    void (*box)(void *user, uint32_t item, pov_box *out);
    void *user;
    uint32_t *order;
    int threads;
} hierarchy_items;

/* NULL: no memory. */
hierarchy *hierarchy_create(const env *e, const hierarchy_items *items);
void hierarchy_destroy(hierarchy *h);
/* The part that plugins use. */
const pov_hierarchy *hierarchy_service(const hierarchy *h);

#endif

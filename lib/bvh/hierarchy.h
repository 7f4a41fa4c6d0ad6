/* hierarchy.h - a bounding volume hierarchy as a service for plugins: over the items of one shape. */
#ifndef BVH_HIERARCHY_H
#define BVH_HIERARCHY_H

#include "bvh/bvh.h"

#include <povtrace/plugin.h>

typedef struct hierarchy hierarchy;

/* Make one over n boxes, n at least one; finite, within +-1e150. NULL: no memory. */
hierarchy *hierarchy_create(const env *e, const pov_box *boxes, uint32_t n);
void hierarchy_destroy(hierarchy *h);
/* The part that plugins use. */
const pov_hierarchy *hierarchy_service(const hierarchy *h);

#endif

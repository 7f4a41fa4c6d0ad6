#include "api/explain.h"

#include "base/err.h"
#include "base/vec.h"

#include <stdio.h>
#include <string.h>

typedef struct plugin_rows {
    plan *plan;
    const model *model;
    pov_status status;
    pov_error *err;
} plugin_rows;

static pov_status add_plugin(plugin_rows *r, const char *keyword, bool used, const char *reason)
{
    char subject[96];

    snprintf(subject, sizeof subject, "plugin %s", keyword);
    return plan_add(r->plan, r->err, used, subject, used ? "loaded" : "not loaded", "%s", reason);
}

static pov_status add_class(plugin_rows *r, const shape_class *shape, size_t objects)
{
    const bool certified = shape->flags & POV_SHAPE_CERTIFIED;
    char reason[96];

    snprintf(reason, sizeof reason, "objects: %zu%s", objects,
             certified ? "" : "; its distances are not certified: as right as its own arithmetic");
    return add_plugin(r, shape->keyword, true, reason);
}

static bool has_row(const plan *p, const char *keyword)
{
    size_t i;

    for (i = 0; i < p->rows.count; i++)
        if (strncmp(p->rows.items[i].subject, "plugin ", 7) == 0 && strcmp(p->rows.items[i].subject + 7, keyword) == 0)
            return true;
    return false;
}

static void visit_keyword(void *user, const char *keyword)
{
    plugin_rows *r = user;

    if (r->status == POV_OK && !has_row(r->plan, keyword))
        r->status = add_plugin(r, keyword, false, "the scene does not name it");
}

/* A folder lists its files in any order. */
static void sort_rows(plan_row *rows, size_t count)
{
    size_t i, j;

    for (i = 1; i < count; i++) {
        plan_row row = rows[i];
        for (j = i; j > 0 && strcmp(rows[j - 1].subject, row.subject) > 0; j--)
            rows[j] = rows[j - 1];
        rows[j] = row;
    }
}

/* The number of objects of each class, in the order in which the scene first names them. */
typedef struct class_tally { const shape_class *shape; size_t objects; } class_tally;
typedef struct tally { class_tally *items; size_t count, capacity; } tally;

static bool count_classes(const model *m, tally *t)
{
    size_t i, k;

    for (i = 0; i < m->leaves.count; i++) {
        const class_tally one = { m->leaves.items[i].shape, 1 };
        for (k = 0; k < t->count && t->items[k].shape != one.shape; k++)
            continue;
        if (k < t->count)
            t->items[k].objects++;
        else if (!VEC_PUSH(m->env, t, one))
            return false;
    }
    return true;
}

pov_status explain_plugins(plan *p, const model *m, const registry *plugins, pov_error *err)
{
    plugin_rows r = { p, m, POV_OK, err };
    tally t = { NULL, 0, 0 };
    size_t i, n;

    if (!count_classes(m, &t))
        r.status = err_memory(err);
    for (i = 0; r.status == POV_OK && i < t.count; i++)
        r.status = add_class(&r, t.items[i].shape, t.items[i].objects);
    env_free(m->env, t.items);
    n = p->rows.count;
    if (r.status == POV_OK && plugins)
        registry_each_keyword(plugins, "primitives", visit_keyword, &r);
    if (p->rows.count > n)
        sort_rows(p->rows.items + n, p->rows.count - n);
    return r.status;
}

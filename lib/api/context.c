#include "api/adapt.h"
#include "api/handles.h"

void context_retain(pov_context *context)
{
    mutex_lock(&context->lock);
    context->users++;
    mutex_unlock(&context->lock);
}

void context_release(pov_context *context)
{
    env e = context->env;
    bool last;

    mutex_lock(&context->lock);
    last = --context->users == 0;
    mutex_unlock(&context->lock);
    if (!last)
        return;
    registry_destroy(context->plugins);
    mutex_destroy(&context->lock);
    env_free(&e, context);
}

pov_status pov_context_create(pov_context **out, const pov_context_desc *desc, pov_error *err)
{
    pov_context_desc d;
    pov_context *context;
    pov_status status;
    env e;

    if (!out)
        return err_set(err, POV_E_ARGUMENT, "no place was given for the context");
    *out = NULL;
    status = adapt_in(&d, sizeof d, desc, "the context's description", err);
    if (status < 0)
        return status;
    env_init(&e, &d.allocator, d.log, d.log_user);
    context = env_alloc(&e, 1, sizeof *context);
    if (!context)
        return err_memory(err);
    context->env = e;
    context->users = 1;
    context->plugins = registry_create(&context->env, d.plugin_path, err);
    if (context->plugins && mutex_init(&context->lock)) {
        *out = context;
        return POV_OK;
    }
    registry_destroy(context->plugins);
    env_free(&e, context);
    return POV_E_MEMORY;
}

void pov_context_destroy(pov_context *context)
{
    if (context)
        context_release(context);
}

pov_status pov_context_add_plugin(pov_context *context, const pov_plugin *plugin, pov_error *err)
{
    if (!context)
        return err_set(err, POV_E_ARGUMENT, "no context was given");
    return registry_add(context->plugins, plugin, err);
}

bool pov_context_get_plugin(pov_context *context, size_t index, const char **name, const char **path)
{
    const char *n, *p;

    if (!context || !registry_get(context->plugins, index, &n, &p))
        return false;
    if (name)
        *name = n;
    if (path)
        *path = p;
    return true;
}

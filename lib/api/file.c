#include "api/handles.h"
#include "base/err.h"
#include "base/file.h"

#include <povtrace/image.h>

static pov_status write_all(file_writer *w, const env *e, const char *path, const void *bytes, size_t count, pov_error *err)
{
    pov_status status = file_writer_open(w, e, path, err);

    if (status < 0)
        return status;
    file_writer_put(w, bytes, count);
    return file_writer_commit(w, err);
}

pov_status pov_file_write(pov_context *context, const char *path, const void *bytes, size_t count, pov_error *err)
{
    file_writer *w;
    pov_status status;

    if (!context || !path || (!bytes && count > 0))
        return err_set(err, POV_E_ARGUMENT, "to write a file takes a context, a path and its bytes");
    w = env_alloc(&context->env, 1, sizeof *w);
    status = w ? write_all(w, &context->env, path, bytes, count, err) : err_memory(err);
    env_free(&context->env, w);
    return status;
}

pov_status pov_file_check(pov_context *context, const char *path, pov_error *err)
{
    if (!context || !path)
        return err_set(err, POV_E_ARGUMENT, "to try a file takes a context and a path");
    return file_writer_try(&context->env, path, err);
}

/* What stands around the calls of README.md: the fragment leaves out declarations, includes and cleaning up. */
#include <povtrace/povtrace.h>

#include <stdio.h>

int main(void)
{
    pov_context *context = NULL;
    pov_scene *scene = NULL;
    pov_job *job = NULL;
    pov_error err = { 0 };
    bool complete;

#include "block.c"

    complete = err.status == POV_OK && job && pov_job_wait(job, 0.0) == POV_JOB_DONE;
    if (!complete)
        fprintf(stderr, "%s\n", err.message);
    pov_job_destroy(job);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
    return !complete;
}

#include "render/job_state.h"

#include "base/clock.h"

#include <string.h>

pov_job_state job_wait(pov_job *job, double seconds)
{
    const double for_ever = 1e9;
    double until = clock_seconds() + fmin(fmax(seconds, 0.0), for_ever);
    pov_job_state state;

    mutex_lock(&job->lock);
    job->waiting++;
    while (job->state == POV_JOB_RUNNING && !job->news)
        if (!condition_wait_until(&job->changed, &job->lock, until))
            break;
    job->waiting--;
    job->news = false;
    state = job->state;
    mutex_unlock(&job->lock);
    return state;
}

bool job_take(pov_job *job, pov_rect *changed)
{
    bool found;

    mutex_lock(&job->lock);
    found = job->dirty_count > 0;
    if (found) {
        while (!job->dirty[job->dirty_next])
            job->dirty_next = (job->dirty_next + 1) % job->tiles.count;
        job->dirty[job->dirty_next] = false;
        job->dirty_count--;
        *changed = tiles_rect(&job->tiles, job->dirty_next);
    }
    mutex_unlock(&job->lock);
    return found;
}

static pov_rect meet(pov_rect a, pov_rect b)
{
    int right = a.x + a.width < b.x + b.width ? a.x + a.width : b.x + b.width;
    int bottom = a.y + a.height < b.y + b.height ? a.y + a.height : b.y + b.height;
    pov_rect r = { a.x > b.x ? a.x : b.x, a.y > b.y ? a.y : b.y, 0, 0 };

    r.width = right > r.x ? right - r.x : 0;
    r.height = bottom > r.y ? bottom - r.y : 0;
    return r;
}

/* Copy what a rectangle has of one tile. The lock is held for a row at a time: to convert takes longer than
 * to copy. */
static void read_tile(pov_job *job, size_t tile, pov_rect rect, pov_pixels format, unsigned char *dst, size_t stride)
{
    pov_rect part = meet(tiles_rect(&job->tiles, tile), rect);
    size_t pixel_bytes = format == POV_PIXELS_DISPLAY8 ? 4 : 4 * sizeof(float);
    unsigned char bytes[4 * TILE_EDGE_MAX];
    float row[4 * TILE_EDGE_MAX];

    for (int y = 0; y < part.height; y++) {
        unsigned char *to = dst + (size_t)(part.y + y - rect.y) * stride + (size_t)(part.x - rect.x) * pixel_bytes;

        mutex_lock(&job->lock);
        frame_row(&job->frame, tile, part.x, part.y + y, part.width, row);
        mutex_unlock(&job->lock);
        if (format == POV_PIXELS_DISPLAY8) {
            encoding_display(&job->encoding, row, bytes, part.width);
            memcpy(to, bytes, pixel_bytes * (size_t)part.width);
        } else {
            encoding_linear(&job->encoding, row, part.width);
            memcpy(to, row, pixel_bytes * (size_t)part.width);
        }
    }
}

/* What of the rectangle lies outside the picture is not written. */
void job_read(pov_job *job, pov_rect rect, pov_pixels format, void *dst, size_t stride)
{
    const tiles *t = &job->tiles;
    pov_rect all = { 0, 0, t->width, t->height }, part;

    if (!dst || rect.x > t->width || rect.y > t->height || rect.width < 1 || rect.height < 1)
        return;
    part = meet(all, rect);
    if (part.width == 0 || part.height == 0)
        return;
    for (int row = part.y / t->edge; row <= (part.y + part.height - 1) / t->edge; row++)
        for (int column = part.x / t->edge; column <= (part.x + part.width - 1) / t->edge; column++)
            read_tile(job, (size_t)row * (size_t)t->columns + (size_t)column, rect, format, dst, stride);
}

void job_restart(pov_job *job, const pov_camera *camera)
{
    pov_counts none = { 0 };

    mutex_lock(&job->lock);
    job->generation++;
    if (camera)
        job->camera = *camera;
    frame_clear(&job->frame);
    memset(job->dirty, 0, job->tiles.count * sizeof *job->dirty);
    job->dirty_count = job->claimed = job->committed = job->done_pixels = 0;
    job->counts = none;
    job->error.status = POV_OK;
    if (job->thread_count > 0 || job->state == POV_JOB_RUNNING)
        job_begin(job);
    else
        job->state = POV_JOB_IDLE;
    condition_wake_all(&job->changed);
    mutex_unlock(&job->lock);
}

void job_pause(pov_job *job, bool paused)
{
    mutex_lock(&job->lock);
    job->paused = paused;
    condition_wake_all(&job->changed);
    mutex_unlock(&job->lock);
}

void job_cancel(pov_job *job)
{
    mutex_lock(&job->lock);
    if (job->state == POV_JOB_IDLE || job->state == POV_JOB_RUNNING)
        job_end(job, POV_JOB_CANCELLED);
    mutex_unlock(&job->lock);
}

void job_get_progress(pov_job *job, pov_progress *out)
{
    size_t pass;

    mutex_lock(&job->lock);
    pass = job->claimed / job->tiles.count + 1;
    out->passes = job->frame.passes;
    out->pass = pass < (size_t)out->passes ? (int)pass : out->passes;
    out->fraction = (double)job->done_pixels / (double)job->all_pixels;
    out->threads = job->thread_count > 0 ? job->thread_count : 1;
    out->counts = job->counts;
    out->seconds = 0.0;
    if (job->started > 0.0)
        out->seconds = (job->ended > 0.0 ? job->ended : clock_seconds()) - job->started;
    mutex_unlock(&job->lock);
}

pov_status job_get_error(pov_job *job, pov_error *err)
{
    pov_status status = POV_OK;

    mutex_lock(&job->lock);
    if (job->state == POV_JOB_FAILED) {
        status = job->error.status;
        if (err)
            *err = job->error;
    }
    mutex_unlock(&job->lock);
    return status;
}

#include "render/job_state.h"

#include "base/clock.h"
#include "render/maps.h"

#include <string.h>

pov_job_state job_wait(pov_job *job, double seconds)
{
    const double for_ever = 1e9;
    double until = clock_seconds() + pov_min(pov_max(seconds, 0.0), for_ever);
    pov_job_state state;

    mutex_lock(&job->lock);
    job->waiting++;
    while (job->state == POV_JOB_RUNNING && !job->news) {
        double end = job->settings.time_limit > 0.0 ? job->started + job->settings.time_limit : until;

        if (!condition_wait_until(&job->changed, &job->lock, pov_min(until, end)) && !passes_expire(job) &&
            clock_seconds() >= until)
            break;
    }
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

/* Value of a pixel in a map of the cells. The lock is held. */
static float map_value(const cells *c, int x, int y, pov_pixels format)
{
    size_t number = group_of(c->columns, x, y), cell = number / GROUPS;
    pov_rect r = cells_rect(c, x / CELL_EDGE, y / CELL_EDGE);
    double pixels = (double)r.width * r.height;

    if (format == POV_PIXELS_SAMPLES)
        return (float)cells_count(c, x, y);
    if (format == POV_PIXELS_TIME)
        return c->seconds ? (float)(c->seconds[cell] / pixels) : -1.0f;
    if (cells_count(c, x, y) < 2)
        return -1.0f;
    return (float)sqrt((c->shown[GROUPS * cell].square + c->shown[GROUPS * cell + 1].square) / pixels);
}

static void read_map(pov_job *job, pov_rect part, pov_pixels format, unsigned char *dst, size_t stride)
{
    float row[TILE_EDGE_MAX];

    for (int y = 0; y < part.height; y++) {
        mutex_lock(&job->lock);
        for (int x = 0; x < part.width; x++)
            row[x] = map_value(&job->cells, part.x + x, part.y + y, format);
        mutex_unlock(&job->lock);
        memcpy(dst + (size_t)y * stride, row, sizeof *row * (size_t)part.width);
    }
}

/* Convert the pixels that stand for a row, and copy each to all columns that it stands for; `offset` is the first
 * column's position in the tile. */
static void put_row(const pov_job *job, pov_pixels format, float *row, int offset, int step, int width, unsigned char *to)
{
    int count = (offset + width - 1) / step - offset / step + 1;
    unsigned char bytes[4 * TILE_EDGE_MAX];

    if (format == POV_PIXELS_DISPLAY8) {
        encoding_display(&job->encoding, row, bytes, count);
        for (int i = 0; i < width; i++)
            memcpy(to + 4 * i, bytes + 4 * ((offset + i) / step - offset / step), 4);
    } else {
        encoding_linear(&job->encoding, row, count);
        if (step == 1)
            memcpy(to, row, 16 * (size_t)width);
        for (int i = 0; step > 1 && i < width; i++)
            memcpy(to + 16 * i, row + 4 * ((offset + i) / step - offset / step), 16);
    }
}

/* Copy the intersection of a rectangle and a tile. The lock is held for a row at a time: converting takes longer than
 * copying. While a tile is coarse, rows between the lattice's rows are copies of the row above. */
static void read_tile(pov_job *job, size_t tile, pov_rect rect, pov_pixels format, unsigned char *dst, size_t stride)
{
    pov_rect all = tiles_rect(&job->tiles, tile), part = meet(all, rect);
    size_t pixel_bytes = format == POV_PIXELS_LINEAR_FLOAT ? 4 * sizeof(float) : 4;
    float row[4 * TILE_EDGE_MAX];
    int above = 0;

    dst += (size_t)(part.y - rect.y) * stride + (size_t)(part.x - rect.x) * pixel_bytes;
    if (format != POV_PIXELS_DISPLAY8 && format != POV_PIXELS_LINEAR_FLOAT) {
        read_map(job, part, format, dst, stride);
        return;
    }
    for (int y = 0; y < part.height; y++, dst += stride) {
        int step;

        mutex_lock(&job->lock);
        step = framebuffer_row(&job->framebuffer, tile, part.x, part.y + y, part.width, row);
        mutex_unlock(&job->lock);
        if (step == above && (part.y + y - all.y) % step != 0)
            memcpy(dst, dst - stride, pixel_bytes * (size_t)part.width);
        else
            put_row(job, format, row, part.x - all.x, step, part.width, dst);
        above = step;
    }
}

/* Of the camera of this moment. Tracing holds no lock. */
static void trace_map(pov_job *job, pov_rect part, pov_pixels format, void *dst, size_t stride)
{
    pov_camera camera;

    mutex_lock(&job->lock);
    camera = job->camera;
    mutex_unlock(&job->lock);
    maps_read(job->scene, &job->settings, &camera, part, format, dst, stride);
}

/* Pixels outside the picture are not written. */
void job_read(pov_job *job, pov_rect rect, pov_pixels format, void *dst, size_t stride)
{
    const tiles *t = &job->tiles;
    pov_rect all = { 0, 0, t->width, t->height }, part;

    if (!dst || rect.x > t->width || rect.y > t->height || rect.width < 1 || rect.height < 1)
        return;
    part = meet(all, rect);
    if (part.width == 0 || part.height == 0)
        return;
    if (maps_has(format)) {
        dst = (unsigned char *)dst + (size_t)(part.y - rect.y) * stride + (size_t)(part.x - rect.x) * maps_bytes(format);
        trace_map(job, part, format, dst, stride);
        return;
    }
    for (int row = part.y / t->edge; row <= (part.y + part.height - 1) / t->edge; row++)
        for (int column = part.x / t->edge; column <= (part.x + part.width - 1) / t->edge; column++)
            read_tile(job, (size_t)row * (size_t)t->columns + (size_t)column, rect, format, dst, stride);
}

void job_restart(pov_job *job, const pov_camera *camera)
{
    if (!job->scene)
        return;
    mutex_lock(&job->lock);
    job->generation++;
    if (camera)
        job->camera = *camera;
    framebuffer_clear(&job->framebuffer);
    memset(job->dirty, 0, job->tiles.count * sizeof *job->dirty);
    job->dirty_count = 0;
    passes_begin(job);
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
    if (job->state == POV_JOB_IDLE || job->state == POV_JOB_RUNNING) {
        passes_stop(job, POV_STOP_USER);
        job_end(job, POV_JOB_CANCELLED);
    }
    mutex_unlock(&job->lock);
}

/* Passes of more samples are not counted in advance. The lock is held. */
static void count_passes(const pov_job *job, pov_progress *out)
{
    int lattices = job->framebuffer.passes, pass = job->tiles.own > 0 ? (int)(job->claimed / job->tiles.own) + 1 : 1;

    out->passes = lattices;
    out->pass = pass < lattices ? pass : lattices;
    if (job->refining) {
        out->pass = (int)job->rows.count + 1;
        if (job->state != POV_JOB_RUNNING)
            out->pass--;
        out->passes = out->pass;
    }
}

void job_get_progress(pov_job *job, pov_progress *out)
{
    const pov_pass *last;

    mutex_lock(&job->lock);
    count_passes(job, out);
    out->fraction = passes_fraction(job);
    out->seconds_left = passes_left(job);
    last = job->rows.count > 0 ? &job->rows.items[job->rows.count - 1] : NULL;
    out->spp_mean = last ? last->spp_mean : 0.0;
    out->est_rmse = last ? last->est_rmse : -1.0;
    out->stop = job->stop;
    out->width = job->tiles.width;
    out->height = job->tiles.height;
    out->round = job->round;
    out->threads = job->thread_count > 0 ? job->thread_count : 1;
    out->counts = job->counts;
    out->seconds = 0.0;
    if (job->started > 0.0)
        out->seconds = (job->ended > 0.0 ? job->ended : clock_seconds()) - job->started;
    mutex_unlock(&job->lock);
}

const char *job_note(const pov_job *job)
{
    return job->note;
}

bool job_get_pass(pov_job *job, size_t index, pov_pass *out)
{
    bool there;

    mutex_lock(&job->lock);
    there = index < job->rows.count;
    if (there)
        *out = job->rows.items[index];
    mutex_unlock(&job->lock);
    return there;
}

bool job_get_class(pov_job *job, size_t index, pov_class_counts *out)
{
    out->keyword = job->scene && index < WORLD_CLASSES ? world_class(job->scene->world, index) : NULL;
    if (!out->keyword)
        return false;
    mutex_lock(&job->lock);
    out->asked = job->classes.of[index].asked;
    out->escalated = job->classes.of[index].escalated;
    mutex_unlock(&job->lock);
    return true;
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

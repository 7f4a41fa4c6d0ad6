#include "render/job_state.h"

#include "base/clock.h"
#include "base/vec.h"
#include "render/budget.h"
#include "render/estimate.h"
#include "render/meter.h"

#include <math.h>
#include <string.h>

void passes_begin(pov_job *job)
{
    pov_counts none = { 0 };

    job->due = job->tiles.own * (size_t)job->framebuffer.passes;
    job->earlier = 0.0;
    job->claimed = job->committed = 0;
    job->done_pixels = 0;
    memset(job->lattices, 0, sizeof job->lattices);
    job->lattices_ended = 0;
    job->refining = false;
    job->rows.count = 0;
    job->last_is_partial = false;
    job->stop = POV_STOP_NONE;
    job->cpu = 0.0;
    job->counts = none;
    memset(&job->classes, 0, sizeof job->classes);
    cells_clear(&job->cells);
}

void passes_skip(pov_job *job)
{
    size_t all = job->tiles.own;

    while (!job->refining && job->claimed < job->due &&
           (job->framebuffer.done[job->tiles.order[job->claimed % all]] >> job->claimed / all & 1u))
        job->claimed++;
}

void passes_claim(pov_job *job, worker *w)
{
    claim *c = &w->claim;
    size_t all = job->tiles.own, number = job->claimed++;

    c->generation = job->generation;
    c->camera = job->camera;
    c->refining = job->refining;
    c->pass = job->refining ? job->framebuffer.passes : (int)(number / all);
    c->tile = job->refining ? job->queue[number] : job->tiles.order[number % all];
    c->rect = tiles_rect(&job->tiles, c->tile);
    if (c->refining)
        cells_take(&job->cells, c->rect, w->refinement);
    else
        c->lattice = framebuffer_lattice(&job->framebuffer, c->pass);
    passes_skip(job);
}

/* ---- the end of a pass ---- */

static pov_pass begin_row(const pov_job *job)
{
    pov_pass row = POV_INIT(row);

    row.pass = (int)job->rows.count + 1;
    row.threads = job->thread_count > 0 ? job->thread_count : 1;
    row.wall_s = clock_seconds() - job->started;
    row.cpu_s = job->cpu;
    row.counts = job->counts;
    return row;
}

/* The row of the present picture. */
static bool note(pov_job *job)
{
    pov_pass row = begin_row(job);

    estimate_row(&job->cells, &job->settings, job->scratch, &row);
    if (!job->refining || job->settings.parts > 0)
        row.spp_mean = (double)job->done_pixels / (double)job->all_pixels;
    return VEC_PUSH(job->env, &job->rows, row);
}

/* The row of a coarse picture: its error is unknown. */
static bool note_lattice(pov_job *job, int pass)
{
    pov_pass row = begin_row(job);
    pov_counts none = { 0 };
    size_t pixels = 0;

    row.counts = none;
    for (int i = 0; i <= pass; i++) {
        counts_add(&row.counts, &job->lattices[i].counts);
        pixels += lattice_pixels(framebuffer_lattice(&job->framebuffer, i), job->tiles.width, job->tiles.height);
    }
    row.spp_mean = (double)pixels / (double)job->all_pixels;
    row.spp_max = 1;
    row.est_rmse = row.est_ci95_lo = row.est_ci95_hi = row.est_p99_tile = row.ref_rmse = row.ref_max = -1.0;
    return VEC_PUSH(job->env, &job->rows, row);
}

/* A tile of a pass of first samples is committed. The last of these passes ends like those of more samples, in
 * passes_end(). */
static void count_lattice(pov_job *job, int pass, const pov_counts *fresh)
{
    job->lattices[pass].tiles++;
    counts_add(&job->lattices[pass].counts, fresh);
    while (job->lattices_ended + 1 < job->framebuffer.passes &&
           job->lattices[job->lattices_ended].tiles == job->tiles.own)
        if (!note_lattice(job, job->lattices_ended++))
            job_fail_memory(job);
}

/* An estimate of zero is no estimate: then the upper end of its band is used. */
static bool has_error(const settings *s, const pov_pass *now)
{
    return now->est_rmse == 0.0 ? now->est_ci95_hi <= s->target_error : now->est_rmse > 0.0 && now->est_rmse <= estimate_asked(s, now);
}

static pov_stop reason_to_end(const pov_job *job, const pov_pass *now)
{
    const settings *s = &job->settings;

    if (s->target_error > 0.0 && now->spp_mean >= budget_least(&job->cells) && has_error(s, now))
        return POV_STOP_ERROR;
    return now->spp_mean >= s->samples ? POV_STOP_SAMPLES : POV_STOP_NONE;
}

static bool has_due_cells(const pov_job *job, size_t tile)
{
    cell_range r = cells_of(tiles_rect(&job->tiles, tile));

    for (int y = r.row; y < r.row + r.rows; y++) {
        const size_t first = GROUPS * ((size_t)y * (size_t)job->cells.columns + (size_t)r.column);

        for (size_t i = first; i < first + GROUPS * (size_t)r.columns; i++)
            if (cells_are_due(&job->cells, i))
                return true;
    }
    return false;
}

/* From the groups' targets: the tiles that have work, from the middle outwards. */
void passes_queue(pov_job *job)
{
    job->refining = true;
    job->due = job->claimed = job->committed = 0;
    for (size_t i = 0; i < job->tiles.own; i++)
        if (has_due_cells(job, job->tiles.order[i]))
            job->queue[job->due++] = job->tiles.order[i];
}

/* The next pass of the whole picture. A joined picture ends there: its parts go on. */
static void decide(pov_job *job, const pov_pass *now)
{
    job->stop = reason_to_end(job, now);
    if (job->stop == POV_STOP_NONE && !budget_next(&job->cells, &job->settings, now, job->scratch))
        job->stop = POV_STOP_SAMPLES;
    if (job->stop == POV_STOP_NONE && !job->scene)
        job->stop = POV_STOP_PART;
    if (job->stop == POV_STOP_NONE)
        passes_queue(job);
}

/* The next pass of a part: what the round asks for, or in the first round what needs no other part. */
static void decide_part(pov_job *job, const pov_pass *now)
{
    bool more = job->wanted != NULL;

    for (size_t i = 0; more && i < GROUPS * job->cells.count; i++) {
        group *at = &job->cells.groups[i];

        at->target = at->count > job->wanted[i] ? at->count : job->wanted[i];
        for (size_t k = 0; job->wanted_singles && k < sizeof job->wanted_singles->gets; k++)
            if (job->cells.singles[i].gets[k] < job->wanted_singles[i].gets[k])
                job->cells.singles[i].gets[k] = job->wanted_singles[i].gets[k];
    }
    if (more || budget_blind(&job->cells, &job->settings, now))
        passes_queue(job);
    if (job->committed == job->due)
        job->stop = POV_STOP_PART;
}

void passes_end(pov_job *job)
{
    const pov_pass *now;

    if (!note(job)) {
        job_fail_memory(job);
        return;
    }
    now = &job->rows.items[job->rows.count - 1];
    if (job->settings.parts > 0)
        decide_part(job, now);
    else
        decide(job, now);
    if (job->stop != POV_STOP_NONE)
        job_end(job, POV_JOB_DONE);
    else
        condition_wake_all(&job->changed);
}

void passes_resume(pov_job *job)
{
    if (job->committed == job->due)
        passes_end(job);
}

/* ---- commit ---- */

static bool mark_dirty(pov_job *job, size_t tile)
{
    if (job->dirty[tile])
        return false;
    job->dirty[tile] = true;
    return job->dirty_count++ == 0;
}

/* Called before the claimed groups replace the old ones. */
static size_t samples_more(const pov_job *job, const claim *c)
{
    cell_range r = cells_of(c->rect);
    size_t sum = 0;

    for (int y = r.row; y < r.row + r.rows; y++) {
        size_t first = GROUPS * ((size_t)y * (size_t)job->cells.columns + (size_t)r.column);

        for (size_t i = first; i < first + GROUPS * (size_t)r.columns; i++)
            sum += cells_samples_due(&job->cells, i) - cells_samples(&job->cells, i);
    }
    return sum;
}

bool passes_commit(pov_job *job, worker *w, const pov_counts *fresh, const class_counts *classes)
{
    const claim *c = &w->claim;
    bool first = mark_dirty(job, c->tile);

    counts_add(&job->counts, fresh);
    for (int i = 0; i < WORLD_CLASSES; i++) {
        job->classes.of[i].asked += classes->of[i].asked;
        job->classes.of[i].escalated += classes->of[i].escalated;
    }
    if (w->meter)
        cells_spend(&job->cells, c->rect, w->meter->spent);
    if (c->refining) {
        job->done_pixels += samples_more(job, c);
        cells_put(&job->cells, c->rect, w->refinement);
        framebuffer_replace(&job->framebuffer, c->tile, w->pixels);
    } else {
        job->done_pixels += lattice_pixels(c->lattice, c->rect.width, c->rect.height);
        framebuffer_put(&job->framebuffer, c->tile, c->pass, w->pixels);
        if (framebuffer_has(&job->framebuffer, c->tile))
            cells_first(&job->cells, c->rect, &job->framebuffer, &job->encoding);
        count_lattice(job, c->pass, fresh);
    }
    if (++job->committed == job->due) {
        passes_end(job);
        return true;
    }
    if (first) {
        job->news = true;
        if (job->waiting > 0)
            condition_wake_all(&job->changed);
    }
    return first;
}

/* ---- an early end ---- */

void passes_stop(pov_job *job, pov_stop why)
{
    job->stop = why;
    /* Without memory only the last row is missing, not the picture. */
    if (job->state == POV_JOB_RUNNING && (job->committed > 0 || job->rows.count == 0))
        job->last_is_partial = note(job);
}

bool passes_expire(pov_job *job)
{
    if (job->state != POV_JOB_RUNNING || !(job->settings.time_limit > 0.0) ||
        clock_seconds() - job->started < job->earlier + job->settings.time_limit)
        return false;
    passes_stop(job, POV_STOP_TIME);
    job_end(job, POV_JOB_DONE);
    return true;
}

/* ---- how long it will take ---- */

/* Samples that the pixels of a tile shall have after this round. */
static double wanted_of_tile(const pov_job *job, size_t tile)
{
    const cell_range r = cells_of(tiles_rect(&job->tiles, tile));
    double sum = 0.0;

    for (int y = r.row; y < r.row + r.rows; y++) {
        const size_t first = GROUPS * ((size_t)y * (size_t)job->cells.columns + (size_t)r.column);

        for (size_t i = first; i < first + GROUPS * (size_t)r.columns; i++)
            sum += job->wanted_singles ? (double)singles_sum(job->wanted_singles[i].gets) : (double)cells_pixels(&job->cells, i) * job->wanted[i];
    }
    return sum;
}

static bool shows_error(const pov_pass *row) { return row->est_rmse > 0.0 && row->wall_s > 0.0; }

/* Seconds from the start until the error asked for, on the line through the logarithms of time and error of the last
 * pass and of the latest one of half its time or less. Below zero: no two passes know their error yet. */
static double time_of_error(const pov_job *job)
{
    const double least_slope = -2.0, most_slope = -0.25;
    const pov_pass *last = NULL, *first = NULL;

    for (size_t i = job->rows.count; i-- > 0 && !(first && first->wall_s <= 0.5 * last->wall_s);) {
        const pov_pass *row = &job->rows.items[i];

        if (!shows_error(row))
            break;
        if (!last)
            last = row;
        else if (row->wall_s < last->wall_s)
            first = row;
    }
    if (!first)
        return -1.0;
    return last->wall_s * pow(estimate_asked(&job->settings, last) / last->est_rmse,
                              1.0 / pov_min(most_slope, pov_max(least_slope, log(last->est_rmse / first->est_rmse) /
                                                                           log(last->wall_s / first->wall_s))));
}

/* Seconds from the start until all samples are in, at the pace so far. Below zero: too few are. */
static double time_of_samples(const pov_job *job, double now)
{
    const double all = (double)job->all_pixels * job->settings.samples, few = 0.02;
    const double done = (double)job->done_pixels / (job->settings.sampling ? (double)job->all_pixels : all);

    return done < (job->settings.sampling ? 1.0 : few) ? -1.0 : now * all / (double)job->done_pixels;
}

/* Fraction of the samples of this round that a part has. */
static double fraction_of_part(const pov_job *job)
{
    const double all = (double)job->all_pixels * budget_blind_end(&job->cells, &job->settings);
    double wanted = 0.0;

    if (job->state == POV_JOB_DONE)
        return 1.0;
    for (size_t i = 0; job->wanted && i < job->tiles.own; i++)
        wanted += wanted_of_tile(job, job->tiles.order[i]);
    if (job->wanted)
        return wanted > 0.0 ? (double)job->done_pixels / wanted : 0.0;
    return (double)job->done_pixels / all;
}

double passes_left(const pov_job *job)
{
    const settings *s = &job->settings;
    const double now = clock_seconds() - job->started;
    double until;

    if (job->state != POV_JOB_RUNNING)
        return job->state == POV_JOB_DONE ? 0.0 : -1.0;
    if (s->parts > 0)
        return job->done_pixels > 0 ? now / fraction_of_part(job) - now : -1.0;
    until = s->target_error > 0.0 ? time_of_error(job) : time_of_samples(job, now);
    if (s->target_error > 0.0 && until >= 0.0)
        until = pov_min(until, pov_max(time_of_samples(job, now), now));
    if (s->time_limit > 0.0 && (until >= 0.0 || !(s->target_error > 0.0)))
        until = until < 0.0 ? job->earlier + s->time_limit : pov_min(until, job->earlier + s->time_limit);
    return until < 0.0 ? -1.0 : pov_max(until - now, 0.0);
}

double passes_fraction(const pov_job *job)
{
    const settings *s = &job->settings;
    const double done = (double)job->done_pixels / ((double)job->all_pixels * s->samples), most = 0.999;
    double now, left;

    if (s->parts > 0)
        return fraction_of_part(job);
    if (!s->sampling)
        return done;
    if (job->state == POV_JOB_DONE && (job->rows.count > 0 || job->stop != POV_STOP_TIME) && job->done_pixels >= job->all_pixels)
        return 1.0;
    if (job->state != POV_JOB_RUNNING || passes_left(job) < 0.0)
        return pov_min(done, most);
    now = clock_seconds() - job->started;
    left = passes_left(job);
    return now + left > 0.0 ? pov_min(now / (now + left), most) : 0.0;
}

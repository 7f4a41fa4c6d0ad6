#include "progress.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

/* Seconds of the job. A bar that would disappear at once is not drawn. */
static const double first_bar = 0.3, every_bar = 0.1, every_line = 10.0, every_json = 0.5;

/* A terminal too narrow for a bar gets the numbers. */
enum { BAR_LEAST = 4 };

void progress_init(progress *p, const args *a)
{
    memset(p, 0, sizeof *p);
    p->mode = a->quiet ? ARGS_PROGRESS_NONE : a->progress;
    if (p->mode == ARGS_PROGRESS_AUTO) {
        p->mode = ARGS_PROGRESS_BAR;
        p->lines = !messages_on_terminal();
    }
}

pov_progress progress_over_all(const progress *p, const pov_progress *now)
{
    pov_progress all = *now;

    if (p->frames == 0)
        return all;
    all.fraction = p->done + 1 < p->frames || now->fraction < 1.0 ? (p->done + now->fraction) / p->frames : 1.0;
    all.seconds = p->before + now->seconds;
    all.seconds_left = all.fraction > 0.0 ? all.seconds * (1.0 - all.fraction) / all.fraction : -1.0;
    return all;
}

bool progress_due(const progress *p, double seconds)
{
    seconds += p->before;
    switch (p->mode) {
    case ARGS_PROGRESS_JSON:
        return seconds - p->shown >= every_json;
    case ARGS_PROGRESS_BAR:
        return seconds - p->shown >= (p->lines ? every_line : p->drawn ? every_bar : first_bar);
    default:
        return false;
    }
}

void progress_percent(double fraction, char *out, size_t size)
{
    double tenths = floor(fraction * 1000.0);

    if (!(fraction < 1.0))
        snprintf(out, size, "100");
    else
        snprintf(out, size, "%.1f", (tenths > 0.0 ? tenths : 0.0) / 10.0);
}

void progress_duration(double seconds, char *out, size_t size)
{
    long whole = seconds < 0.0 ? 0 : seconds > 3.6e8 ? 360000000 : (long)ceil(seconds);

    if (whole < 60)
        snprintf(out, size, "%ld s", whole);
    else if (whole < 3600)
        snprintf(out, size, "%ld:%02ld", whole / 60, whole % 60);
    else
        snprintf(out, size, "%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
}

uint64_t progress_rays(const pov_counts *c)
{
    return c->camera + c->shadow + c->reflected + c->transmitted;
}

static int screen_columns(void)
{
    struct winsize size;

    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
        return size.ws_col;
    return 80;
}

/* The fields of a line, in its order. */
typedef struct fields { char percent[24], quality[64], rays[32], left[48]; } fields;

static void fill_in(fields *f, const pov_progress *now)
{
    char percent[16], left[32];

    memset(f, 0, sizeof *f);
    progress_percent(now->fraction, percent, sizeof percent);
    snprintf(f->percent, sizeof f->percent, "%5s %%", percent);
    if (now->est_rmse >= 0.0 && now->spp_mean > 1.0)
        snprintf(f->quality, sizeof f->quality, "  %.0f spp  error %.2g", now->spp_mean, now->est_rmse);
    if (now->seconds > 0.0)
        snprintf(f->rays, sizeof f->rays, "  %.1f M rays/s", (double)progress_rays(&now->counts) / now->seconds * 1e-6);
    if (now->seconds_left >= 0.0) {
        progress_duration(now->seconds_left, left, sizeof left);
        snprintf(f->left, sizeof f->left, "  ETA %s", left);
    }
}

size_t progress_text(const pov_progress *now, int columns, char *out, size_t size)
{
    fields f;
    char *const least_first[] = { f.rays, f.quality, f.left };
    size_t width;

    fill_in(&f, now);
    for (int i = 0;; i++) {
        width = strlen(f.percent) + strlen(f.quality) + strlen(f.rays) + strlen(f.left);
        if (i == 3 || (long)width < columns)
            break;
        least_first[i][0] = '\0';
    }
    snprintf(out, size, "%s%s%s%s", f.percent, f.quality, f.rays, f.left);
    return width;
}

/* "frame 12 (3 of 100) ", in front of all else; nothing of a single picture. */
static void label(const progress *p, char *out, size_t size)
{
    out[0] = '\0';
    if (p->frames > 0)
        snprintf(out, size, "frame %d (%d of %d) ", p->frame, p->done + 1, p->frames);
}

static void draw_bar(const progress *p, const pov_progress *now)
{
    char text[224], bar[64], frame[64];
    int columns = screen_columns();
    int room, full;

    label(p, frame, sizeof frame);
    columns -= (int)strlen(frame);
    room = columns - (int)progress_text(now, columns, text, sizeof text) - 4;
    room = room > 40 ? 40 : room < 0 ? 0 : room;
    full = (int)(now->fraction * room);
    memset(bar, ' ', sizeof bar);
    memset(bar, '#', (size_t)(full < 0 ? 0 : full > room ? room : full));
    if (room >= BAR_LEAST)
        fprintf(stderr, "\r%s[%.*s] %s\033[K", frame, room, bar, text);
    else
        fprintf(stderr, "\r%.*s\033[K", columns > 1 ? columns - 1 : 0, text);
    fflush(stderr);
}

static void write_line(const progress *p, const pov_progress *now)
{
    char percent[16], spent[32], left[32] = "", frame[64];

    label(p, frame, sizeof frame);
    progress_percent(now->fraction, percent, sizeof percent);
    progress_duration(now->seconds, spent, sizeof spent);
    if (now->seconds_left >= 0.0)
        progress_duration(now->seconds_left, left, sizeof left);
    fprintf(stderr, "povc: %s%s %% after %s%s%s%s\n", frame, percent, spent, left[0] ? ", about " : "", left, left[0] ? " to go" : "");
}

static void write_json(const progress *p, const pov_progress *now)
{
    char percent[16];

    progress_percent(now->fraction, percent, sizeof percent);
    fprintf(stderr, "{\"percent\":%s,\"fraction\":%.6f,\"seconds\":%.3f,", percent,
            floor(now->fraction * 1e6) * 1e-6, now->seconds);
    fprintf(stderr, "\"pass\":%d,\"passes\":%d,\"threads\":%d,\"rays\":%llu", now->pass, now->passes,
            now->threads, (unsigned long long)progress_rays(&now->counts));
    if (now->spp_mean > 0.0)
        fprintf(stderr, ",\"spp\":%.6g", now->spp_mean);
    if (now->spp_mean > 0.0 && now->est_rmse >= 0.0)
        fprintf(stderr, ",\"error\":%.6g", now->est_rmse);
    if (now->seconds_left >= 0.0)
        fprintf(stderr, ",\"eta\":%.3f", now->seconds_left);
    if (p->frames > 0)
        fprintf(stderr, ",\"frame\":%d,\"frames_done\":%d,\"frames\":%d", p->frame, p->done, p->frames);
    fprintf(stderr, "}\n");
    fflush(stderr);
}

void progress_show(progress *p, const pov_progress *frame)
{
    const pov_progress now = progress_over_all(p, frame);

    p->shown = now.seconds;
    if (p->mode == ARGS_PROGRESS_JSON) {
        write_json(p, &now);
    } else if (p->mode == ARGS_PROGRESS_BAR && p->lines) {
        write_line(p, &now);
    } else if (p->mode == ARGS_PROGRESS_BAR) {
        draw_bar(p, &now);
        p->drawn = true;
    }
}

void progress_end(progress *p, const pov_progress *frame)
{
    const pov_progress now = progress_over_all(p, frame);

    if (p->mode == ARGS_PROGRESS_JSON)
        write_json(p, &now);
    p->before += p->frames > 0 ? frame->seconds : 0.0;
    if (p->drawn) {
        fprintf(stderr, "\r\033[K");
        fflush(stderr);
    }
    p->drawn = false;
}

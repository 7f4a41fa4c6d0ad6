#include "stats.h"
#include "progress.h"
#include "report.h"

#include <sys/resource.h>

static void count(FILE *to, const char *name, uint64_t value, const char *unit)
{
    fprintf(to, "%s: %llu%s%s\n", name, (unsigned long long)value, *unit ? " " : "", unit);
}

static void seconds(FILE *to, const char *name, double value)
{
    fprintf(to, "%s: %.6f s\n", name, value);
}

/* Linux's count for this program alone: the general count begins with the size of the parent process. 0: unknown. */
static uint64_t high_water(void)
{
    FILE *status = fopen("/proc/self/status", "r");
    unsigned long long kib = 0;
    char line[256];

    while (status && fgets(line, sizeof line, status))
        if (sscanf(line, "VmHWM: %llu", &kib) == 1)
            break;
    if (status)
        fclose(status);
    return kib;
}

/* Kernels count in KiB, except macOS, which counts in bytes. */
static void print_memory(FILE *to)
{
    struct rusage usage;
    uint64_t kib = high_water();

    if (kib > 0) {
        count(to, "memory_peak", kib, "KiB");
        return;
    }
    if (getrusage(RUSAGE_SELF, &usage) != 0)
        return;
#ifdef __APPLE__
    usage.ru_maxrss /= 1024;
#endif
    count(to, "memory_peak", (uint64_t)usage.ru_maxrss, "KiB");
}

static void print_plugins(FILE *to, pov_context *context)
{
    const char *name, *path;
    size_t i;

    fprintf(to, "plugins:");
    for (i = 0; pov_context_get_plugin(context, i, &name, &path); i++)
        fprintf(to, "%s%s", i == 0 ? " " : ",", name);
    fprintf(to, "\n");
    count(to, "plugins_loaded", i, "");
}

static void print_scene(FILE *to, const stats *s, const pov_scene_info *info)
{
    fprintf(to, "dialect: %s\n", info->dialect == POV_DIALECT_COURSE ? "course" : "povray");
    count(to, "objects", info->objects, "");
    count(to, "objects_infinite", info->infinite_objects, "");
    count(to, "lights", info->lights, "");
    count(to, "materials", info->materials, "");
    count(to, "max_trace_level", (uint64_t)info->max_trace_level, "");
    count(to, "warnings", s->warnings, "");
    seconds(to, "parse", info->parse_seconds);
    seconds(to, "build", info->build_seconds);
}

static void print_counts(FILE *to, const pov_counts *c)
{
    count(to, "rays_camera", c->camera, "rays");
    count(to, "rays_shadow", c->shadow, "rays");
    count(to, "rays_reflected", c->reflected, "rays");
    count(to, "rays_transmitted", c->transmitted, "rays");
    count(to, "rays_total", progress_rays(c), "rays");
    count(to, "culled_light_behind", c->shadow_behind, "rays");
    count(to, "culled_light_idle", c->shadow_idle, "rays");
    count(to, "cut_by_depth", c->cut_depth, "rays");
    count(to, "cut_by_weight", c->cut_weight, "rays");
    count(to, "inner_reflections", c->inner_reflections, "rays");
    count(to, "escalated", c->escalated, "intersections");
}

/* Queries of each class of primitives, and those that double-double arithmetic had to decide. */
static void print_classes(FILE *to, pov_job *job)
{
    pov_class_counts c = POV_INIT(c);
    char name[128];

    for (size_t i = 0; pov_job_get_class(job, i, &c); i++) {
        snprintf(name, sizeof name, "%s_tested", c.keyword);
        count(to, name, c.asked, "intersections");
        snprintf(name, sizeof name, "%s_escalated", c.keyword);
        count(to, name, c.escalated, "intersections");
    }
}

static void print_render(FILE *to, const stats *s)
{
    const args *a = s->args;
    pov_pass last = POV_INIT(last);
    uint64_t width = (uint64_t)(a->crop.width ? a->crop.width : a->width);
    uint64_t height = (uint64_t)(a->crop.width ? a->crop.height : a->height);

    seconds(to, "trace", s->progress->seconds);
    seconds(to, "trace_cpu", report_last_pass(s->job, &last) ? last.cpu_s : 0.0);
    seconds(to, "write", s->write_seconds);
    count(to, "pixels", width * height, "pixels");
    fprintf(to, "samples: %.6g per_pixel\n", s->progress->spp_mean);
    if (s->progress->est_rmse >= 0.0)
        fprintf(to, "estimated_error: %.6g rms\n", s->progress->est_rmse);
    count(to, "threads", (uint64_t)s->progress->threads, "");
    print_counts(to, &s->progress->counts);
    print_classes(to, s->job);
}

void stats_print(FILE *to, const stats *s)
{
    pov_scene_info info = POV_INIT(info);

    pov_scene_get_info(s->scene, &info);
    print_scene(to, s, &info);
    if (s->progress)
        print_render(to, s);
    print_plugins(to, s->context);
    fprintf(to, "built_for: %s\n", pov_built_for());
    print_memory(to);
}

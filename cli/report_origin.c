/* What a reader needs to repeat a run. */
#include "report_origin.h"

#include <povtrace/povtrace.h>

#include <stdio.h>
#include <string.h>
#include <time.h>

static void find_processor(char *out, size_t size)
{
    FILE *in = fopen("/proc/cpuinfo", "r");
    char line[256];

    snprintf(out, size, "not known");
    while (in && fgets(line, sizeof line, in)) {
        const char *colon = strchr(line, ':');

        if (!colon || (strncmp(line, "model name", 10) != 0 && strncmp(line, "Model", 5) != 0))
            continue;
        snprintf(out, size, "%s", colon + 1 + strspn(colon + 1, " \t"));
        out[strcspn(out, "\n")] = '\0';
        break;
    }
    if (in)
        fclose(in);
}

static const char *sampling_of(const args *a)
{
    if (a->sampling == ARGS_SAMPLING_UNIFORM)
        return "uniform";
    if (a->sampling == ARGS_SAMPLING_ADAPTIVE)
        return "adaptive";
    return a->error > 0.0 || a->time > 0.0 ? "auto: adaptive" : "auto: uniform";
}

void report_find_origin(const report *r, report_origin *out)
{
    const time_t now = time(NULL);
    struct tm utc;
    int major, minor, patch;

    memset(out, 0, sizeof *out);
    if (gmtime_r(&now, &utc))
        strftime(out->date, sizeof out->date, "%Y-%m-%dT%H:%M:%SZ", &utc);
    find_processor(out->processor, sizeof out->processor);
    pov_version(&major, &minor, &patch);
    snprintf(out->version, sizeof out->version, "%d.%d.%d", major, minor, patch);
    out->command = r->args->command;
    out->sampling = sampling_of(r->args);
    out->seed = r->args->seed;
}

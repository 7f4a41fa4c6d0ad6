/* povc - render a scene to an image file. */
#include "args.h"
#include "frames_run.h"
#include "messages.h"
#include "povray.h"
#include "povray_run.h"
#include "run.h"
#include "signals.h"
#include "usage.h"

#include <stdio.h>
#include <string.h>

enum { EXIT_COMPLETE = 0, EXIT_ERROR = 1, EXIT_USAGE = 2, EXIT_SHORT = 3, EXIT_ROUND = 4 };

/* A failed write of a report is an error like any other: a full disk behind "povc --stats > file". */
static int finish(const messages *m, int code)
{
    pov_error err = { 0 };

    if (fflush(stdout) == 0 && !ferror(stdout))
        return code;
    snprintf(err.message, sizeof err.message, "cannot write to standard output");
    messages_error(m, &err);
    return code == EXIT_COMPLETE ? EXIT_ERROR : code;
}

static int refuse(const messages *m, const args *a)
{
    pov_error err = { 0 };

    snprintf(err.message, sizeof err.message, "%s", a->problem);
    messages_error(m, &err);
    fprintf(stderr, "Try \"povc --help\".\n");
    return EXIT_USAGE;
}

int main(int argc, char **argv)
{
    pov_error err = { 0 };
    messages m;
    args a;
    args_verdict verdict;
    int code = EXIT_COMPLETE;
    run_end end = RUN_COMPLETE;

    if (povray_is_asked(argc, argv))
        return povray_run(argc, argv);
    verdict = args_parse(&a, argc, argv);
    messages_init(&m, &a);
    if (verdict == ARGS_WRONG)
        return refuse(&m, &a);
    messages_notes(&m, &a);
    if (verdict == ARGS_HELP) {
        usage_print_help();
    } else if (verdict == ARGS_VERSION) {
        usage_print_version();
    } else if (frames_run(&a, &m, &end, &err) < 0) {
        messages_error(&m, &err);
        code = err.status == POV_E_ARGUMENT ? EXIT_USAGE : EXIT_ERROR;
    } else if (end != RUN_COMPLETE) {
        code = end == RUN_SHORT ? EXIT_SHORT : EXIT_ROUND;
    }
    code = finish(&m, code);
    if (signals_end_asked())
        signals_end_by(signals_end_asked());
    return code;
}

#include "signals.h"

#include <signal.h>
#include <stddef.h>
#include <stdlib.h>

static volatile sig_atomic_t end_by, write_now;

static void on_end(int signal)
{
    end_by = signal;
}

static void on_write(int signal)
{
    (void)signal;
    write_now = 1;
}

static void watch(int signal, void (*handler)(int), int flags)
{
    struct sigaction action, before;

    if (sigaction(signal, NULL, &before) == 0 && before.sa_handler == SIG_IGN)
        return;
    action.sa_handler = handler;
    action.sa_flags = flags;
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, NULL);
}

void signals_watch(void)
{
    /* One-shot handlers: the system's default action for the second such signal ends the program. Calls are not
     * restarted, because open() would wait for a pipe's reader for ever; reading and writing continue by themselves. */
    watch(SIGINT, on_end, (int)SA_RESETHAND);
    watch(SIGTERM, on_end, (int)SA_RESETHAND);
    watch(SIGHUP, on_end, (int)SA_RESETHAND);
    watch(SIGUSR1, on_write, SA_RESTART);
}

int signals_end_asked(void)
{
    return end_by;
}

bool signals_write_asked(void)
{
    bool asked = write_now != 0;

    write_now = 0;
    return asked;
}

void signals_end_by(int signal)
{
    struct sigaction action;

    action.sa_handler = SIG_DFL;
    action.sa_flags = 0;
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, NULL);
    raise(signal);
    exit(128 + signal);
}

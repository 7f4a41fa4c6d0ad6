#!/usr/bin/env python3
"""Run a program with signals as a terminal would have them, and act on it.

drive.py ACTIONS -- PROGRAM ARGS...   ACTIONS, done in order:
  wait:SECONDS     let it run
  INT TERM HUP USR1 KILL   send that signal
  ignore:SIGNAL    before the start: the program inherits it ignored
  file:PATH        wait until PATH is there and not empty
  gone:PATH        remove PATH
  running          fail unless the program still runs
Prints the exit status as a shell shows it (128 + signal) and ends with 0; with 1 if an action failed, or if the program
did not end within 20 seconds of the last one.
"""
import os
import signal
import subprocess
import sys
import time

LIMIT = 20.0


def fail(program, text):
    program.kill()
    program.wait()
    print("drive: " + text)
    sys.exit(1)


def wait_for(program, path):
    end = time.monotonic() + LIMIT
    while not (os.path.exists(path) and os.path.getsize(path) > 0):
        if program.poll() is not None:
            fail(program, "ended with %d before %s was there" % (program.returncode, path))
        if time.monotonic() > end:
            fail(program, path + " never came")
        time.sleep(0.005)


def act(program, action):
    word, _, value = action.partition(":")
    if word == "wait":
        time.sleep(float(value))
    elif word == "file":
        wait_for(program, value)
    elif word == "gone":
        os.remove(value)
    elif word == "running":
        if program.poll() is not None:
            fail(program, "ended with %d too early" % program.returncode)
    else:
        program.send_signal(getattr(signal, "SIG" + word))


def main():
    split = sys.argv.index("--")
    actions, command = sys.argv[1:split], sys.argv[split + 1:]
    ignored = [a[7:] for a in actions if a.startswith("ignore:")]

    def prepare():
        for name in ("INT", "TERM", "HUP", "USR1", "PIPE"):
            how = signal.SIG_IGN if name in ignored else signal.SIG_DFL
            signal.signal(getattr(signal, "SIG" + name), how)

    program = subprocess.Popen(command, preexec_fn=prepare)
    for action in actions:
        if not action.startswith("ignore:"):
            act(program, action)
    try:
        status = program.wait(LIMIT)
    except subprocess.TimeoutExpired:
        fail(program, "did not end within %g s" % LIMIT)
    print(128 - status if status < 0 else status)


main()

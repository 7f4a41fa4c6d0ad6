"""Cuts scenes off before their tokens and gives the rest to povc: cuts.py POVC SCENES_FOLDER EVERY.

A rest that is a scene by itself renders; any other ends in exit status 1 with a place, and nothing on standard output.
EVERY: 1 cuts before every token, n before each n-th."""
import glob
import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

TOKEN = re.compile(rb"[A-Za-z_]\w*|[0-9.]+(?:[eE][-+]?\d+)?|[^\s\w]")
PLACE = re.compile(rb"<stdin>:\d+:\d+: error: ")


def complaint(povc, name, text):
    command = [povc, "-", "8", "6", "-", "--format", "ppm", "-q", "-t", "1"]
    try:
        run = subprocess.run(command, input=text, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=30)
    except subprocess.TimeoutExpired:
        return "%s cut at byte %d: it hangs" % (name, len(text))
    if run.returncode == 0 or (run.returncode == 1 and PLACE.search(run.stderr) and not run.stdout):
        return None
    return "%s cut at byte %d: exit status %d: %r" % (name, len(text), run.returncode, run.stderr[:200])


def main():
    povc, folder, every = sys.argv[1], sys.argv[2], int(sys.argv[3])
    cuts = []
    for path in sorted(glob.glob(os.path.join(folder, "*.pov"))):
        with open(path, "rb") as scene:
            text = scene.read()
        cuts += [(os.path.basename(path), text[:m.start()]) for m in TOKEN.finditer(text)]
    cuts = cuts[::every]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        wrong = [w for w in pool.map(lambda cut: complaint(povc, *cut), cuts) if w]
    print("\n".join(wrong[:20]))
    print("%d cuts, %d wrong" % (len(cuts), len(wrong)))
    sys.exit(bool(wrong) or not cuts)


main()

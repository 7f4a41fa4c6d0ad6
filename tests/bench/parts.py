#!/usr/bin/env python3
"""What Dask adds to a picture in parts: parts.py POVC SCENE [PARTS]. Times one process with one thread, then a cluster of
this machine with 1 and 2 workers that is already there, at 64 samples a pixel. What a part costs beyond its start and load
is told by 1 sample: of seconds of tracing, a busy machine's noise alone is more. Needs distributed (PyPI)."""
import logging
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from distributed import Client, LocalCluster

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / 'bindings' / 'python'))
from povtrace.cluster import Render  # noqa: E402

SIZE, ROUNDS, MANY, ONE = (320, 240), 5, ['--spp', '64'], ['--spp', '1']


def timed(function):
    start = time.monotonic()
    function()
    return time.monotonic() - start


def povc_seconds(povc, scene, size, words, to):
    run = [povc, str(scene), *map(str, size), str(to), '-q', '-t', '1', *words]
    return min(timed(lambda: subprocess.run(run, check=True)) for _ in range(ROUNDS))


def cluster_seconds(client, povc, scene, words, parts, to):
    def render():
        with Render(client, scene, SIZE, words, povc=povc, quiet=True) as r:
            assert r.picture(to, parts) == 0
    render()                                         # the workers import what they need
    return min(timed(render) for _ in range(ROUNDS))


def main():
    povc, scene, parts = str(Path(sys.argv[1]).resolve()), Path(sys.argv[2]), int((sys.argv[3:] or [24])[0])
    logging.disable(logging.WARNING)
    with tempfile.TemporaryDirectory() as folder:
        one, out = Path(folder, 'one.png'), Path(folder, 'out.png')
        load = povc_seconds(povc, scene, (1, 1), [], one)
        quick = povc_seconds(povc, scene, SIZE, ONE, one) - load
        whole = povc_seconds(povc, scene, SIZE, MANY, one)
        print(f'one process, one thread: {whole:.2f} s; of which start and load {1000 * load:.0f} ms')
        for workers in (1, 2):
            with LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=':0') as cluster, \
                    Client(cluster) as client:
                added = (cluster_seconds(client, povc, scene, ONE, parts, out) * workers - quick) / parts - load
                seconds = cluster_seconds(client, povc, scene, MANY, parts, out)
            assert one.read_bytes() == out.read_bytes(), 'the pictures differ'
            print(f'{workers} workers, {parts} parts: {seconds:.2f} s; {1000 * added:.0f} ms a part beyond its start and load')


if __name__ == '__main__':
    main()

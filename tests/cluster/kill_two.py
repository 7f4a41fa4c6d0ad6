"""A picture in 24 parts on four processes of Dask, two of which are killed in the middle.
Usage: kill_two.py POVC SCENE WIDTH HEIGHT OUTPUT [povc's options]"""
import logging
import os
import signal
import sys
import threading
import time
from pathlib import Path

from distributed import Client, LocalCluster

from povtrace.cluster import Render

PARTS, BEFORE = 24, 3


def kill_two(output, pids, killed):
    while len(list(output.parent.glob(output.name + '.part-*'))) < BEFORE:
        time.sleep(0.01)
    for pid in pids[:2]:
        os.kill(pid, signal.SIGKILL)
    killed.append(len(list(output.parent.glob(output.name + '.part-*'))))


def main():
    povc, scene, width, height, output, *words = sys.argv[1:]
    output = Path(output)
    logging.disable(logging.WARNING)
    with LocalCluster(n_workers=4, threads_per_worker=1, dashboard_address=':0') as cluster, Client(cluster) as client:
        killed = []
        killer = threading.Thread(target=kill_two, args=(output, list(client.run(os.getpid).values()), killed))
        killer.start()
        with Render(client, Path(scene), (int(width), int(height)), words, povc=povc) as render:
            status = render.picture(output, PARTS)
        killer.join()
    assert killed[0] < PARTS, f'all {PARTS} parts were done before two workers were killed'
    print(f'{killed[0]} of {PARTS} parts were done when two of four workers were killed')
    return status


if __name__ == '__main__':
    sys.exit(main())

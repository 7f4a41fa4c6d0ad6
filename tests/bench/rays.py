#!/usr/bin/env python3
"""Rays a second of Scene.trace on one core: rays.py SCENE... Camera rays of the scene, row by row and in blocks of 8x8, and
rays in random directions from random points that these hit. Needs numpy and cffi; POVTRACE_LIBRARY names the library."""
import sys
import time
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / 'bindings' / 'python'))
import povtrace  # noqa: E402

WIDTH, HEIGHT, BLOCK, ROUNDS = 1600, 1200, 8, 3


def camera_rays(scene):
    camera = scene.camera
    u, v = np.meshgrid((np.arange(WIDTH) + .5) / WIDTH - .5, .5 - (np.arange(HEIGHT) + .5) / HEIGHT)
    return camera.location, camera.direction + u[..., None] * camera.right + v[..., None] * camera.up


def in_blocks(rays):
    shape = (HEIGHT // BLOCK, BLOCK, WIDTH // BLOCK, BLOCK, 3)
    return rays.reshape(shape).transpose(0, 2, 1, 3, 4).reshape(-1, 3)


def scattered(scene, location, rays):
    random = np.random.default_rng(1)
    hits = scene.trace(location, rays)
    points = random.permutation((hits.point + 1e-9 * hits.normal)[hits.object >= 0])
    return points, random.normal(size=points.shape)


def rate(scene, origins, directions):
    """Millions of rays in a second of the processor."""
    best = np.inf
    for _ in range(ROUNDS):
        start = time.process_time()
        scene.trace(origins, directions)
        best = min(best, time.process_time() - start)
    return len(directions) / best / 1e6


def main():
    print('| scene | rows | blocks of 8x8 | scattered |')
    print('|---|---|---|---|')
    for name in sys.argv[1:]:
        scene = povtrace.Scene(Path(name))
        location, rays = camera_rays(scene)
        rays = rays.reshape(-1, 3)
        rates = (rate(scene, location, rays), rate(scene, location, in_blocks(rays)), rate(scene, *scattered(scene, location, rays)))
        print(f'| {Path(name).stem} | ' + ' | '.join(f'{r:.1f}' for r in rates) + ' |')


if __name__ == '__main__':
    main()

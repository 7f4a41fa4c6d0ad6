#!/usr/bin/env python3
"""Scenes from arrays against the text that says the same: time and memory, each in a process of its own.

arrays.py [COUNT]: COUNT spheres, and a mesh of so many triangles. Prints a table for docs/python.md. Needs numpy and cffi;
POVTRACE_LIBRARY names the library.
"""
import json
import subprocess
import sys
import time
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / 'bindings' / 'python'))
import povtrace  # noqa: E402

LOOK = 'pigment { rgb <.9, .3, .2> }'
ROUNDS = 3


def spheres(n):
    random = np.random.default_rng(1)
    return random.uniform(-100, 100, (n, 3)), random.uniform(.1, .5, n)


def colours(n):
    return np.random.default_rng(2).uniform(0, 1, (n, 3))


def heights(n):
    """About n triangles over a square of corners."""
    edge = round((n / 2) ** .5) + 1
    x, z = np.meshgrid(np.linspace(-1, 1, edge), np.linspace(-1, 1, edge), indexing='ij')
    first = (np.arange(edge - 1)[:, None] * edge + np.arange(edge - 1)).ravel().astype(np.uint32)
    faces = np.concatenate([np.stack([first, first + 1, first + edge], 1), np.stack([first + 1, first + edge + 1, first + edge], 1)])
    return np.stack([x, .1 * np.sin(9 * x) * np.cos(7 * z), z], 2).reshape(-1, 3), faces


def vectors(array, form='<%r,%r,%r>'):
    return ','.join(form % tuple(v) for v in array.tolist())


def text_of(what, n):
    if what == 'spheres':
        at, radii = spheres(n)
        return ''.join('sphere{<%r,%r,%r>,%r %s}\n' % (*p, r, LOOK) for p, r in zip(at.tolist(), radii.tolist()))
    if what == 'colours':
        at, radii = spheres(n)
        return ''.join('sphere{<%r,%r,%r>,%r %s pigment{rgb<%r,%r,%r>}}\n' % (*p, r, LOOK, *c)
                       for p, r, c in zip(at.tolist(), radii.tolist(), colours(n).tolist()))
    corners, faces = heights(n)
    return (f'mesh2 {{ vertex_vectors {{ {len(corners)}, {vectors(corners)} }}'
            f'face_indices {{ {len(faces)}, {vectors(faces, "<%d,%d,%d>")} }} {LOOK} }}')


def builder_of(what, n):
    builder = povtrace.Builder()
    if what == 'spheres':
        return builder.spheres(*spheres(n), LOOK)
    if what == 'colours':
        return builder.spheres(*spheres(n), LOOK, colors=colours(n))
    return builder.mesh(*heights(n), LOOK)


def memory(name):
    """MB, by the kernel: VmRSS now, VmHWM the most since it was last cleared."""
    for line in Path('/proc/self/status').read_text().splitlines():
        if line.startswith(name):
            return int(line.split()[1]) / 1024


def measure(what, form, n):
    """In a process of its own: the text is one that it reads from a file, as programs do."""
    start = time.process_time()
    source = builder_of(what, n) if form == 'arrays' else Path(sys.argv[4])
    Path('/proc/self/clear_refs').write_text('5')
    before = memory('VmRSS')
    scene = povtrace.Scene(source, threads=1)
    read, compiled = scene.seconds
    print(json.dumps({'read': read, 'compile': compiled, 'peak': memory('VmHWM') - before, 'objects': len(scene),
                      'whole': time.process_time() - start}))


def best(words):
    rows = [json.loads(subprocess.run([sys.executable, __file__, *words], check=True, capture_output=True, text=True).stdout)
            for _ in range(ROUNDS)]
    return min(rows, key=lambda row: row['read'])


def main():
    n = int(float(sys.argv[1])) if len(sys.argv) > 1 else 1000000
    file = Path('arrays.pov')
    print('| scene | read, s | compile, s | memory, MB |')
    print('|---|---|---|---|')
    for what, name in (('spheres', 'spheres'), ('colours', 'spheres, a colour each'), ('mesh', 'a mesh')):
        file.write_text('#version 3.7; global_settings { assumed_gamma 1 }\n' + text_of(what, n))
        for form in ('text', 'arrays'):
            row = best([what, form, str(n), str(file)])
            print(f'| {name}: {form} | {row["read"]:.3f} | {row["compile"]:.2f} | {row["peak"]:.0f} |', flush=True)
    file.unlink()


if __name__ == '__main__':
    if len(sys.argv) > 2:
        measure(sys.argv[1], sys.argv[2], int(sys.argv[3]))
    else:
        main()

#!/usr/bin/env python3
"""Do scenes look the same when all that is in them is scaled, or moved far away, together with camera and lights?

    python3 tests/compare/scaled.py --povc build/bin/povc FOLDER [--only NAME]

Each scene of the folder is drawn as it is and then scaled by 1e-6, 1e6 and 1e-100, and moved by 1e7. Held is that at most 0.5 % of the
pixels differ by more than 2/255.
"""

import argparse
import os
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import probes

CHANGES = {'scaled by 1e-6': 'scale 1e-6', 'scaled by 1e6': 'scale 1e6', 'scaled by 1e-100': 'scale 1e-100',
           'moved by 1e7': 'translate <1e7, 1e7, -1e7>'}
STILL = {'global_settings', 'background', 'sky_sphere', 'fog', 'rainbow', 'default'}
TOKEN = re.compile(r'"(?:\\.|[^"\\])*"|//[^\n]*|/\*.*?\*/|#\s*\w+|\w+|[{}]|\s+|.', re.S)
WIDTH, HEIGHT = 80, 60


def changed(text, change):
    """The scene with the change at the end of each block that stands by itself."""
    out, depth, block, declared = [], 0, '', False
    for token in TOKEN.findall(text):
        if token == '}':
            depth -= 1
            if depth == 0:
                if block not in STILL and not declared:
                    out.append(' ' + change + ' ')
                declared = False
        elif token == '{':
            depth += 1
        elif depth == 0 and token.startswith('#'):
            declared = token.lstrip('# ') in ('declare', 'local', 'default')
        elif depth == 0 and token == ';':
            declared = False
        elif depth == 0 and re.fullmatch(r'[a-z_0-9]+', token):
            block = token
        out.append(token)
    return ''.join(out)


def draw(options, name, text, work):
    scene, picture = os.path.join(work, name + '.pov'), os.path.join(work, name + '.png')
    Path(scene).write_text(text, encoding='utf-8')
    command = [options.povc, scene, '+W%d' % WIDTH, '+H%d' % HEIGHT, '-A', '+FN16', '-D', '+WT1', '+O' + picture,
               '+L' + str(options.folder)]
    subprocess.run(command, cwd=options.folder, check=True, capture_output=True, timeout=120)
    return probes.samples(picture)[2]


def check(options, scene, work):
    """The changes that are seen, each with the share of pixels."""
    text = scene.read_text(encoding='utf-8')
    try:
        plain = draw(options, scene.stem, text, work)
        found = []
        for number, (name, change) in enumerate(CHANGES.items()):
            other = draw(options, '%s-%d' % (scene.stem, number), changed(text, change), work)
            off = sum(max(abs(a - b) for a, b in zip(p, q)) > probes.SHAPES_OFF for p, q in zip(plain, other))
            if 100.0 * off > probes.SHAPES_SHARE * len(plain):
                found.append('%s: %.2f %% differ' % (name, 100.0 * off / len(plain)))
        return found
    except (subprocess.SubprocessError, OSError) as failure:
        said = getattr(failure, 'stderr', None) or str(failure).encode()
        return [said.decode('utf-8', 'replace').splitlines()[0]]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('folder', type=Path)
    parser.add_argument('--povc', default='build/bin/povc')
    parser.add_argument('--only', default='', help='scenes whose name holds this')
    options = parser.parse_args()
    options.povc, options.folder = os.path.abspath(options.povc), options.folder.resolve()
    scenes = [s for s in sorted(options.folder.glob('*.pov')) if options.only in s.stem]
    with tempfile.TemporaryDirectory() as work, ThreadPoolExecutor(2) as pool:
        results = list(pool.map(lambda s: check(options, s, work), scenes))
    for scene, found in zip(scenes, results):
        for words in found:
            print('off %s, %s' % (scene.name, words))
    print('%d of %d scenes pass' % (sum(not f for f in results), len(scenes)))
    return 0 if scenes and not any(results) else 1


if __name__ == '__main__':
    sys.exit(main())

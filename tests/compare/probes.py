#!/usr/bin/env python3
"""A folder of probe scenes, each with a picture that POV-Ray made of it: which of them povc draws alike.

The folder holds manifest.csv with the columns scene, reference, options, random, tolerance_65535 and edge_pixels_pct,
or scene, feature and reference for shapes, whose pictures stand beside them. A scene passes when at most
edge_pixels_pct of its pixels are off by more than tolerance_65535 of 65535; a random one when the means are not. Shapes
may be off by 2/255 in 0.5 % of the pixels.

A folder with noise.csv (scene, rms_65535, mean_65535) holds scenes whose pictures are noisy, here or there. Those pass by
the means over 8x8 pixels: each may be off by the noise and 1 % of its own value.
"""
import argparse
import csv
import os
import struct
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent / 'corpus'))
import png

SHAPES_OFF, SHAPES_SHARE = 2 * 257, 0.5
BLOCK, BLOCK_SHARE = 8, 0.01


def samples(path):
    """Width, height, and the colours of a PNG file as numbers of 16 bits, with its alpha if it has some."""
    width, height, bits, colour, raw = png.unpack(path)
    size, count = bits // 8, {0: 1, 2: 3, 4: 2, 6: 4}[colour]
    step, out = size * count, []
    above = bytearray(width * step)
    for y in range(height):
        start = y * (width * step + 1)
        above = png.unfilter(raw[start], bytearray(raw[start + 1:start + 1 + width * step]), above, step)
        row = struct.unpack('>%d%s' % (width * count, 'H' if size == 2 else 'B'), above)
        row = row if size == 2 else [257 * v for v in row]
        for x in range(0, width * count, count):
            out.append(tuple(row[x:x + count]) if count > 2 else (row[x],) * 3)
    return width, height, out


def noise_of(folder):
    """By scene, how far a mean over some pixels of the reference may be off."""
    if not (folder / 'noise.csv').exists():
        return {}
    with open(folder / 'noise.csv', encoding='utf-8') as file:
        return {row['scene']: float(row['rms_65535']) + float(row['mean_65535']) for row in csv.DictReader(file)}


def rows_of(folder):
    noise = noise_of(folder)
    with open(folder / 'manifest.csv', encoding='utf-8') as file:
        for row in csv.DictReader(file, skipinitialspace=True):
            scene = row['scene'] if row['scene'].endswith('.pov') else row['scene'] + '.pov'
            if 'tolerance_65535' in row:
                yield {'scene': scene, 'reference': row['reference'], 'options': row['options'].split(),
                       'random': row['random'] == 'yes', 'off': float(row['tolerance_65535']),
                       'share': float(row['edge_pixels_pct']), 'noise': noise.get(scene)}
            else:
                yield {'scene': scene, 'reference': scene[:-4] + '.png', 'options': ['File_Gamma=1.0'], 'random': False,
                       'off': SHAPES_OFF, 'share': SHAPES_SHARE, 'noise': None}


def draw(povc, folder, row, width, height, picture):
    """What was said, or None if it was drawn."""
    command = [povc, row['scene'], '+W%d' % width, '+H%d' % height, '-A', '+FN16', '-D', '+WT1', '+O' + picture]
    try:
        done = subprocess.run(command + row['options'], cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, timeout=120, check=False)
    except subprocess.TimeoutExpired:
        return 'out of time', []
    said = done.stderr.decode('utf-8', 'replace').splitlines()
    missing = [line for line in said if 'not supported yet' in line]
    errors = [line for line in said if 'error: ' in line]
    return (errors or said or ['status %d' % done.returncode])[0] if done.returncode else None, missing


def blocks_of(width, height, picture):
    """The means of each channel over blocks of pixels, values above 1 cut."""
    for top in range(0, height, BLOCK):
        for left in range(0, width, BLOCK):
            some = [picture[y * width + x] for y in range(top, min(top + BLOCK, height))
                    for x in range(left, min(left + BLOCK, width))]
            for k in range(3):
                yield sum(min(p[k], 65535) for p in some) / len(some)


def judge_blocks(row, width, height, ours, theirs):
    """The same by the means over blocks."""
    rounding = 1.0
    off = [(abs(a - b), rounding + row['noise'] + BLOCK_SHARE * b)
           for a, b in zip(blocks_of(width, height, ours), blocks_of(width, height, theirs))]
    bad = sum(o > allowed for o, allowed in off)
    worst = max(o / allowed for o, allowed in off)
    return bad == 0, '%d of %d means over blocks off, the worst by %.2f of what is allowed' % (bad, len(off), worst)


def judge(row, width, height, ours, theirs):
    """Does it pass, and how far it is off, in words."""
    if row['noise'] is not None:
        return judge_blocks(row, width, height, ours, theirs)
    if row['random']:
        count = len(theirs)
        means = [abs(sum(min(p[k], 65535) for p in ours) - sum(p[k] for p in theirs)) / count for k in range(3)]
        return max(means) <= row['off'], 'means off by %.1f of %g' % (max(means), row['off'])
    if len(ours[0]) != len(theirs[0]):
        return False, '%d channels for %d' % (len(ours[0]), len(theirs[0]))
    worst = [max(abs(a - b) for a, b in zip(p, q)) for p, q in zip(ours, theirs)]
    share = 100.0 * sum(w > row['off'] for w in worst) / len(worst)
    return share <= row['share'], '%.2f %% off by more than %g, the largest by %d' % (share, row['off'], max(worst))


def check(options, row, work):
    folder = options.folder
    width, height, theirs = samples(folder / row['reference'])
    picture = os.path.join(work, row['scene'][:-4] + '.png')
    failure, missing = draw(options.povc, folder, row, width, height, picture)
    if failure:
        return False, failure
    passes, words = judge(row, width, height, samples(picture)[2], theirs)
    if missing:
        words += '; ' + missing[0].split('warning: ')[-1]
    return passes, words


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('folder', type=Path)
    parser.add_argument('--povc', default='build/bin/povc')
    parser.add_argument('--only', default='', help='scenes whose name holds this')
    parser.add_argument('--keep', help='a folder for the pictures')
    parser.add_argument('--all', action='store_true', help='a line for each scene, not only for those that fail')
    options = parser.parse_args()
    options.povc = os.path.abspath(options.povc)
    rows = [row for row in rows_of(options.folder) if options.only in row['scene']]
    passed = 0
    with tempfile.TemporaryDirectory() as work, ThreadPoolExecutor(2) as pool:
        if options.keep:
            os.makedirs(options.keep, exist_ok=True)
            work = os.path.abspath(options.keep)
        for row, (passes, words) in zip(rows, pool.map(lambda r: check(options, r, work), rows)):
            passed += passes
            if options.all or not passes:
                print('%s %s: %s' % ('ok' if passes else 'off', row['scene'], words))
    print('%d of %d scenes pass' % (passed, len(rows)))
    return passed < len(rows)


if __name__ == '__main__':
    sys.exit(main())

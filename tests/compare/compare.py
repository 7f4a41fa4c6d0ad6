#!/usr/bin/env python3
"""Holds povc's pictures against POV-Ray's, scene by scene; README.md in this folder says how and why."""
import argparse
import csv
import hashlib
import os
import statistics
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

try:
    import numpy
except ImportError:
    # A python of one's own in front of the path often lacks numpy where the system's python has it.
    SYSTEM = '/usr/bin/python3'
    if os.path.exists(SYSTEM) and os.path.realpath(sys.executable) != os.path.realpath(SYSTEM):
        os.execv(SYSTEM, [SYSTEM] + sys.argv)
    sys.exit('compare: numpy is needed (Debian: python3-numpy)')

sys.dont_write_bytecode = True
import equivalent
import images

ROOT = Path(__file__).resolve().parents[2]
TOLERANCE = 2.0 / 255.0
SCENE_LIMIT = 0.3
MEDIAN_LIMIT = 0.05
COLUMNS = ('scene', 'dialect', 'off_percent', 'rms', 'max', 'worst_x', 'worst_y', 'held')


class RenderError(Exception):
    """One of the two programs did not draw the scene."""


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--povc', default='build/bin/povc', help='the program to hold against POV-Ray')
    parser.add_argument('--povray', default='povray', help='POV-Ray 3.7')
    parser.add_argument('--size', default='320x240', help='of the pictures')
    parser.add_argument('--csv', help='also write the table to this file')
    parser.add_argument('--work', default='build/compare',
                        help='where pictures go; POV-Ray\'s are kept for the next run')
    parser.add_argument('--jobs', type=int, default=2, help='scenes at once')
    parser.add_argument('--difference', action='store_true',
                        help='also write SCENE.difference.ppm, eight times enlarged')
    parser.add_argument('scenes', nargs='*', help='default: all of scenes/test and scenes/gallery')
    options = parser.parse_args()
    options.width, options.height = (int(part) for part in options.size.split('x'))
    return options


def all_scenes():
    return [scene for folder in ('scenes/test', 'scenes/gallery')
            for scene in sorted((ROOT / folder).glob('*.pov'))]


def run(command, what):
    """Runs a program; what it said is the reason if it failed."""
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, errors='replace')
    if result.returncode != 0:
        said = result.stdout.splitlines()
        reasons = [line.strip() for line in said if 'rror' in line] or said[-1:] or [f'exit {result.returncode}']
        raise RenderError(f'{what}: {reasons[0]}')


def scene_text(scene):
    """The scene's text as bytes would be read: UTF-8, and Latin-1 where it is not that."""
    data = scene.read_bytes()
    try:
        return data.decode('utf-8-sig')
    except UnicodeDecodeError:
        return data.decode('latin-1')


def povray_source(scene):
    """What POV-Ray is given for a scene: written by hand, the scene itself, or its equivalent."""
    by_hand = Path(__file__).parent / 'povray' / scene.name
    text = scene_text(scene)
    if by_hand.exists():
        return by_hand.read_bytes()
    if equivalent.dialect(text) == 'povray':
        return scene.read_bytes()
    return equivalent.povray_text(text).encode()


def render_povray(scene, options):
    """POV-Ray's picture of what the scene means, kept under a name made from the text."""
    given = povray_source(scene)
    key = hashlib.sha256(given + options.size.encode()).hexdigest()[:12]
    picture = Path(options.work) / f'{scene.parent.name}-{scene.stem}-{key}.png'
    if not picture.exists():
        source = picture.with_suffix('.pov')
        source.write_bytes(given)
        part = picture.with_suffix('.part.png')
        run([options.povray, f'+I{source}', f'+L{scene.resolve().parent}', f'+O{part}', f'+W{options.width}', f'+H{options.height}',
             '-A', '-D', '-V', '+FN16', '+WT2', 'File_Gamma=1.0'], 'povray')
        part.rename(picture)
    return images.read_png(picture)


def render_povc(scene, options):
    picture = Path(options.work) / f'{scene.parent.name}-{scene.stem}.pfm'
    run([options.povc, str(scene), str(options.width), str(options.height), str(picture)], 'povc')
    return stored(images.read_pfm(picture))


def stored(picture):
    """A PFM's values as POV-Ray stores them: clamped."""
    value = numpy.clip(picture, 0.0, 1.0)
    # What is no number is as wrong as can be, whatever stands in the other picture.
    value[~numpy.isfinite(picture)] = 2.0
    return value


def compare(scene, options):
    """One row of the table."""
    row = {'scene': f'{scene.parent.name}/{scene.stem}', 'dialect': equivalent.dialect(scene_text(scene))}
    try:
        theirs, ours = render_povray(scene, options), render_povc(scene, options)
        if theirs.shape != ours.shape:
            raise RenderError(f'pictures of different sizes, {theirs.shape} and {ours.shape}')
    except (RenderError, images.PictureError, OSError, ValueError) as error:
        return dict(row, held=False, error=str(error))
    difference = numpy.abs(theirs - ours).max(axis=2)
    worst = numpy.unravel_index(difference.argmax(), difference.shape)
    off = 100.0 * numpy.mean(difference > TOLERANCE)
    if options.difference:
        path = Path(options.work) / f'{scene.parent.name}-{scene.stem}.difference.ppm'
        write_ppm(path, 8.0 * (theirs - ours) + 0.5)
    rms = float(numpy.sqrt(numpy.mean((theirs - ours) ** 2)))
    return dict(row, off_percent=off, rms=rms, max=float(difference.max()), worst_x=int(worst[1]),
                worst_y=int(worst[0]), held=off <= SCENE_LIMIT)


def write_ppm(path, values):
    data = (numpy.clip(values, 0.0, 1.0) * 255.0 + 0.5).astype(numpy.uint8)
    path.write_bytes(b'P6\n%d %d\n255\n' % (data.shape[1], data.shape[0]) + data.tobytes())


def table_line(row):
    name = f'{row["scene"]:<34} {row["dialect"]:<7}'
    if 'error' in row:
        return f'{name} FAILED   {row["error"]}'
    return (f'{name} {row["off_percent"]:8.4f} {row["rms"]:10.6f} {row["max"]:9.5f}  '
            f'{row["worst_x"]:4d},{row["worst_y"]:<4d} {"" if row["held"] else "OVER"}').rstrip()


def write_csv(path, rows):
    with open(path, 'w', newline='') as file:
        writer = csv.DictWriter(file, COLUMNS + ('error',), restval='')
        writer.writeheader()
        writer.writerows(rows)


def verdict(rows):
    """The last line, and whether all limits hold."""
    off = [row['off_percent'] for row in rows if 'error' not in row]
    over = [row['scene'] for row in rows if not row['held']]
    median = statistics.median(off) if off else 100.0
    held = bool(rows) and not over and median < MEDIAN_LIMIT
    text = (f'{len(rows)} scenes, median {median:.4f} % off by more than 2/255 (limit {MEDIAN_LIMIT} %), '
            f'largest {max(off, default=100.0):.4f} % (limit {SCENE_LIMIT} %): '
            f'{"held" if held else "NOT HELD"}')
    return text + (f'; over or failed: {", ".join(over)}' if over else ''), held


def main():
    options = arguments()
    Path(options.work).mkdir(parents=True, exist_ok=True)
    scenes = [Path(scene) for scene in options.scenes] or all_scenes()
    print(f'{"scene":<34} {"dialect":<7} {"off %":>8} {"rms":>10} {"max":>9}  worst at')
    rows = []
    with ThreadPoolExecutor(max_workers=options.jobs) as pool:
        for row in pool.map(lambda scene: compare(scene, options), scenes):
            print(table_line(row), flush=True)
            rows.append(row)
    if options.csv:
        write_csv(options.csv, rows)
    text, held = verdict(rows)
    print(text)
    return 0 if held else 1


if __name__ == '__main__':
    sys.exit(main())

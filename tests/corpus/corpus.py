#!/usr/bin/env python3
"""The scenes that come with POV-Ray, drawn by povc and by POV-Ray: which are read, which match, and what the others lack.

Each scene is drawn small, with one thread and one sample a pixel. It matches when at most 1 % of the pixels are off by
more than 8/255; noisy ones when the means over 4 x 4 pixels are. POV-Ray's pictures are kept, so that a second run is
quick. Written are corpus.csv, corpus.html with the pictures side by side, and a ranked list of what is missing.
"""
import argparse
import collections
import csv
import html
import os
import re
import subprocess
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
import png

FOLDERS = ['/usr/share/doc/povray/examples', '/usr/share/povray-3.7/scenes', '/usr/local/share/povray-3.7/scenes']
OFF, SHARE, EDGE = 8, 0.01, 4


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--povc', default='build/bin/povc')
    parser.add_argument('--povray', default='povray')
    parser.add_argument('--scenes', help="folder of scenes (default: where POV-Ray's are installed)")
    parser.add_argument('--work', type=Path, default=Path('build/corpus'))
    parser.add_argument('--size', default='160x120')
    parser.add_argument('--timeout', type=float, default=120.0, help='seconds for each program and scene')
    parser.add_argument('--only', default='', help='scenes whose path holds this')
    parser.add_argument('--read-only', action='store_true', help='read the scenes, draw none')
    parser.add_argument('--top', type=int, default=25, help='rows of the ranked list')
    return parser.parse_args()


def all_scenes(options):
    folder = options.scenes or next((f for f in FOLDERS if Path(f).is_dir()), None)
    if not folder:
        sys.exit('corpus: no scenes are installed (Debian: povray-examples); --scenes names a folder')
    scenes = sorted(p for p in Path(folder).rglob('*.pov') if options.only in str(p))
    return Path(folder), scenes


def run(command, folder, seconds):
    """Exit status (None: out of time), seconds of wall time and what was said."""
    start = time.monotonic()
    try:
        done = subprocess.run(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, timeout=seconds, check=False)
        status, said = done.returncode, done.stderr.decode('utf-8', 'replace')
    except subprocess.TimeoutExpired as late:
        status, said = None, (late.stderr or b'').decode('utf-8', 'replace')
    return status, time.monotonic() - start, said


def frames_of(scene):
    """The settings beside a scene that is the frames of an animation, which has no frame 0: both programs draw the first."""
    ini = scene.with_suffix('.ini')
    return ini if ini.exists() and re.search(r'(?im)^\s*final_frame\s*=', ini.read_text('latin-1')) else None


def first_frame(ini, picture, size):
    """POV-Ray's own options, which both programs have."""
    width, height = size.split('x')
    return [ini.name, f'+I{ini.stem}.pov', f'+O{picture.resolve()}', f'+W{width}', f'+H{height}', '-A', '-D', '+FN8', '+WT1', '+SF1', '+EF1']


def take_frame(picture):
    """The number of the frame goes from the name."""
    for numbered in picture.parent.glob(f'{picture.stem}[0-9]*{picture.suffix}'):
        if numbered.stem[len(picture.stem):].isdigit():
            numbered.replace(picture)


def draw_ours(scene, picture, options):
    width, height = options.size.split('x')
    ini = frames_of(scene)
    if ini:
        size = '4x3' if options.read_only else options.size
        done = run([os.path.abspath(options.povc), *first_frame(ini, picture, size)], scene.parent, options.timeout)
        take_frame(picture)
        return done
    command = [os.path.abspath(options.povc), scene.name, '-t', '1', '--progress', 'none']
    if options.read_only:
        return run(command[:1] + ['--check', scene.name], scene.parent, options.timeout)
    return run(command[:2] + [width, height, str(picture.resolve())] + command[2:], scene.parent, options.timeout)


def draw_theirs(scene, picture, options):
    """Kept from an earlier run where it is newer than the scene; a note beside it holds status and time."""
    note = picture.with_suffix('.txt')
    if note.exists() and note.stat().st_mtime > scene.stat().st_mtime:
        status, seconds = note.read_text().split()
        return None if status == 'None' else int(status), float(seconds)
    width, height = options.size.split('x')
    include = ['+L' + str(scene.parent)] + ['+L' + f for f in ('/usr/share/povray-3.7/include', '/usr/share/povray/include') if Path(f).is_dir()]
    ini = frames_of(scene)
    command = first_frame(ini, picture, options.size) if ini else [f'+I{scene.name}', f'+O{picture.resolve()}',
                                                                   f'+W{width}', f'+H{height}', '-A', '-D', '+FN8', '+WT1']
    status, seconds, _ = run([options.povray, *command, '-GA', *include], scene.parent, options.timeout)
    if ini:
        take_frame(picture)
    note.write_text(f'{status} {seconds:.3f}\n')
    return status, seconds


def share_off(a, b, edge):
    """The part of the pixels, or of the means over squares, that differs by more than OFF/255."""
    if (a.width, a.height) != (b.width, b.height):
        return 1.0
    a, b = (a, b) if edge == 1 else (a.means(edge), b.means(edge))
    off = sum(max(abs(x - y) for x, y in zip(p, q)) > OFF for p, q in zip(a.pixels, b.pixels))
    return off / len(a.pixels)


def missing_of(said):
    """What povc says it does not draw yet, and the first error."""
    missing = {m.group(1) for m in re.finditer(r'warning: "([^"]+)"[^\n]* is not supported yet', said)}
    error = re.search(r'error: ([^\n]*)', said)
    return sorted(missing), error.group(1) if error else ''


def look_at(scene, folder, options):
    name = str(scene.relative_to(folder).with_suffix('')).replace('/', '-')
    ours, theirs = options.work / 'povc' / f'{name}.png', options.work / 'povray' / f'{name}.png'
    status, seconds, said = draw_ours(scene, ours, options)
    missing, error = missing_of(said)
    row = {'scene': str(scene.relative_to(folder)), 'name': name, 'status': status, 'seconds': seconds,
           'missing': missing, 'error': error if status != 0 else '', 'matches': False, 'off': None, 'theirs': None,
           'their_seconds': None}
    if options.read_only:
        return row
    row['theirs'], row['their_seconds'] = draw_theirs(scene, theirs, options)
    if status == 0 and row['theirs'] == 0 and theirs.exists():
        a, b = png.read(ours), png.read(theirs)
        row['off'] = share_off(a, b, 1)
        row['matches'] = row['off'] <= SHARE or share_off(a, b, EDGE) <= SHARE
    return row


def verdict(row):
    if row['status'] is None:
        return 'too slow'
    if row['status'] < 0:
        return 'CRASHED'
    if row['status'] != 0:
        return 'not read'
    return 'matches' if row['matches'] else 'differs' if row['off'] is not None else 'drawn'


def ranked(rows):
    """Features and errors, by how many scenes that do not match lack them."""
    lacking = collections.Counter()
    for row in rows:
        if not row['matches']:
            lacking.update(set(row['missing']) | ({'error: ' + row['error'][:70]} if row['error'] else set()))
    return lacking.most_common()


def write_csv(rows, path):
    with open(path, 'w', newline='') as file:
        out = csv.writer(file)
        out.writerow(['scene', 'verdict', 'off', 'povc_s', 'povray_s', 'missing', 'error'])
        for row in rows:
            out.writerow([row['scene'], verdict(row), '' if row['off'] is None else f'{row["off"]:.4f}',
                          f'{row["seconds"]:.3f}', '' if row['their_seconds'] is None else f'{row["their_seconds"]:.3f}',
                          ' '.join(row['missing']), row['error']])


def write_page(rows, path):
    style = 'body{font:14px sans-serif;margin:2em}td{padding:4px 10px;vertical-align:top}img{display:block}'
    with open(path, 'w') as out:
        out.write(f'<!DOCTYPE html><meta charset="utf-8"><title>corpus</title><style>{style}</style><table>\n')
        out.write('<tr><th>scene<th>povc<th>POV-Ray<th>verdict<th>missing\n')
        for row in sorted(rows, key=lambda r: (verdict(r), r['scene'])):
            note = html.escape(', '.join(row['missing']) + (' ' + row['error'] if row['error'] else ''))
            off = '' if row['off'] is None else f'<br>{100 * row["off"]:.1f} % off'
            out.write(f'<tr><td>{html.escape(row["scene"])}<td><img src="povc/{row["name"]}.png" alt="">'
                      f'<td><img src="povray/{row["name"]}.png" alt=""><td>{verdict(row)}{off}<td>{note}\n')
        out.write('</table>\n')


def main():
    options = arguments()
    folder, scenes = all_scenes(options)
    for sub in ('povc', 'povray'):
        (options.work / sub).mkdir(parents=True, exist_ok=True)
    rows = []
    for scene in scenes:
        rows.append(look_at(scene, folder, options))
        print(f'{verdict(rows[-1]):9} {rows[-1]["scene"]}', flush=True)
    write_csv(rows, options.work / 'corpus.csv')
    write_page(rows, options.work / 'corpus.html')
    print('\nMissing or wrong, by scenes that do not match:')
    for what, count in ranked(rows)[:options.top]:
        print(f'{count:5} {what}')
    counts = collections.Counter(verdict(row) for row in rows)
    print('\n' + ', '.join(f'{count} {what}' for what, count in counts.most_common()) + f' of {len(rows)}')
    return 1 if counts['CRASHED'] else 0


if __name__ == '__main__':
    sys.exit(main())

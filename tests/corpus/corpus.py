#!/usr/bin/env python3
"""The scenes that come with POV-Ray, drawn by povc and by POV-Ray: which are read, which match, and what the others lack.

Each scene is drawn small, with one thread and one sample a pixel. It matches when at most 1 % of the pixels are off by
more than 8/255; noisy ones when the means over 4 x 4 pixels are. With --refine, noisy ones that differ for no known cause
are drawn again, POV-Ray's with finer settings and ours with many samples, and match when at most 1 % of the means over
8 x 8 pixels are off by more than 3 %. POV-Ray's pictures are kept, so that a second run is quick. Written are corpus.csv,
corpus.html with the pictures side by side, a ranked list of what is missing and, where --page names it, docs/corpus.md.
Scenes whose difference has been traced to a cause stand in causes.csv.
"""
import argparse
import ast
import collections
import csv
import html
import os
import re
import shutil
import signal
import subprocess
import statistics
import sys
import tempfile
import threading
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
import png
from refined import refined

FOLDERS = ['/usr/share/doc/povray/examples', '/usr/share/povray-3.7/scenes', '/usr/local/share/povray-3.7/scenes']
OFF, SHARE, EDGE = 8, 0.01, 4
REFINED_OFF, REFINED_EDGE, REFINED_SAMPLES = 0.03 * 255, 8, 64


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--povc', default='build/bin/povc')
    parser.add_argument('--povray', default='povray')
    parser.add_argument('--scenes', help="folder of scenes (default: where POV-Ray's are installed)")
    parser.add_argument('--work', type=Path, default=Path('build/corpus'))
    parser.add_argument('--size', default='160x120')
    parser.add_argument('--timeout', type=float, default=120.0, help='seconds for each program and scene')
    parser.add_argument('--only', default='', help='scenes whose path holds this')
    parser.add_argument('--again', action='store_true', help='only the scenes that did not match last time')
    parser.add_argument('--measure', action='store_true', help="draw POV-Ray's again where times are not known")
    parser.add_argument('--page', type=Path, help='write the tables of docs/corpus.md there')
    parser.add_argument('--refine', action='store_true', help='draw noisy scenes that differ with finer settings; minutes each')
    parser.add_argument('--read-only', action='store_true', help='read the scenes, draw none')
    parser.add_argument('--top', type=int, default=25, help='rows of the ranked list')
    return parser.parse_args()


def all_scenes(options):
    folder = options.scenes or next((f for f in FOLDERS if Path(f).is_dir()), None)
    if not folder:
        sys.exit('corpus: no scenes are installed (Debian: povray-examples); --scenes names a folder')
    scenes = sorted(p for p in Path(folder).rglob('*.pov') if options.only in str(p))
    return Path(folder), scenes


GNU_TIME = shutil.which('time')


class Run:
    """One process: exit status (None: out of time), wall and processor seconds, most memory in KiB (None: not known), what was
    said. The system counts the memory of this script for a process that it starts; GNU time starts it from a small one."""

    def __init__(self, command, folder, seconds):
        start = time.monotonic()
        with tempfile.TemporaryFile() as said, tempfile.NamedTemporaryFile('r') as most:
            measured = [GNU_TIME, '-q', '-f', '%M', '-o', most.name, *command] if GNU_TIME else command
            process = subprocess.Popen(measured, cwd=folder, stdin=subprocess.DEVNULL, stdout=said, stderr=said,
                                       start_new_session=True)
            late = []
            timer = threading.Timer(seconds, lambda: (late.append(True), os.killpg(process.pid, signal.SIGKILL)))
            timer.start()
            _, status, used = os.wait4(process.pid, 0)
            timer.cancel()
            process.returncode = os.waitstatus_to_exitcode(status)
            said.seek(0)
            self.said = said.read().decode('utf-8', 'replace')
            self.memory = int(most.read() or 0) or None
        self.status = None if late else process.returncode
        self.wall = time.monotonic() - start
        self.cpu = used.ru_utime + used.ru_stime


def frames_of(scene):
    """The settings beside a scene that is the frames of an animation, which has no frame 0: both programs draw the first."""
    ini = scene.with_suffix('.ini')
    return ini if ini.exists() and re.search(r'(?im)^\s*final_frame\s*=', ini.read_text('latin-1')) else None


def first_frame(ini, picture, size):
    """POV-Ray's own options, which both programs have. Settings may name a scene that is elsewhere."""
    width, height = size.split('x')
    return [ini.name, f'+I{ini.with_suffix(".pov").name}', f'+O{picture.resolve()}', f'+W{width}', f'+H{height}', '-A', '-D', '+FN8', '+WT1', '+SF1', '+EF1']


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
        done = Run([os.path.abspath(options.povc), *first_frame(ini, picture, size)], scene.parent, options.timeout)
        take_frame(picture)
        return done
    command = [os.path.abspath(options.povc), scene.name, '-t', '1', '--progress', 'none', '--stats']
    if options.read_only:
        return Run(command[:1] + ['--check', scene.name], scene.parent, options.timeout)
    return Run(command[:2] + [width, height, str(picture.resolve())] + command[2:], scene.parent, options.timeout)


def draw_theirs(scene, picture, options):
    """Kept from an earlier run where it is newer than the scene; a note beside it holds status and measurements."""
    note = picture.with_suffix('.txt')
    if note.exists() and note.stat().st_mtime > scene.stat().st_mtime:
        kept = [ast.literal_eval(word) for word in note.read_text().split()]
        kept = (kept + [None] * 3)[:5]
        if kept[0] != 0 or None not in kept or not options.measure:
            return kept
    width, height = options.size.split('x')
    include = ['+L' + str(scene.parent)] + ['+L' + f for f in ('/usr/share/povray-3.7/include', '/usr/share/povray/include') if Path(f).is_dir()]
    ini = frames_of(scene)
    command = first_frame(ini, picture, options.size) if ini else [f'+I{scene.name}', f'+O{picture.resolve()}',
                                                                   f'+W{width}', f'+H{height}', '-A', '-D', '+FN8', '+WT1']
    done = Run([options.povray, *command, '-GD', '-GF', '-GR', '-GW', '+GS', *include], scene.parent, options.timeout)
    if ini:
        take_frame(picture)
    trace = re.search(r'Trace Time:.*?with\s+([0-9.]+) CPU-seconds', done.said, re.S)
    kept = [done.status, round(done.wall, 3), round(done.cpu, 3), done.memory, float(trace.group(1)) if trace else None]
    note.write_text(' '.join(map(str, kept)) + '\n')
    return kept


def draw_refined(scene, name, options):
    """Both programs' pictures, converged, or None. They are kept where they are newer than the scene."""
    ours, theirs = (options.work / f'refined-{program}' / f'{name}.png' for program in ('povc', 'povray'))
    width, height = options.size.split('x')
    for picture in (ours, theirs):
        picture.parent.mkdir(exist_ok=True)
    if not theirs.exists() or theirs.stat().st_mtime < scene.stat().st_mtime:
        with tempfile.NamedTemporaryFile('w', suffix='.pov', encoding='latin-1') as text:
            text.write(refined(scene.read_text('latin-1')))
            text.flush()
            Run([options.povray, f'+I{text.name}', f'+L{scene.parent}', f'+O{theirs.resolve()}', f'+W{width}', f'+H{height}', '-D', '+FN8',
                 'Antialias_Gamma=1', '+A0.0', '+AM1', '+R5', '-J', '-GA', '+WT1'], scene.parent, 10 * options.timeout)
    done = Run([os.path.abspath(options.povc), scene.name, width, height, str(ours.resolve()), '--spp', str(REFINED_SAMPLES),
                '--progress', 'none'], scene.parent, 10 * options.timeout)
    return (png.read(ours), png.read(theirs)) if done.status == 0 and theirs.exists() else None


def matches_refined(scene, name, options):
    pair = draw_refined(scene, name, options)
    return bool(pair) and share_off(*(p.light_means(REFINED_EDGE) for p in pair), 1, REFINED_OFF) <= SHARE


def share_off(a, b, edge, limit=OFF):
    """The part of the pixels, or of the means over squares, that differs by more than limit/255."""
    if (a.width, a.height) != (b.width, b.height):
        return 1.0
    a, b = (a, b) if edge == 1 else (a.means(edge), b.means(edge))
    off = sum(max(abs(x - y) for x, y in zip(p, q)) > limit for p, q in zip(a.pixels, b.pixels))
    return off / len(a.pixels)


# What makes noise, here or there. Other scenes match by their pixels alone.
NOISE = re.compile(rb'\b(jitter|crand|aperture|photons|radiosity|media|subsurface)\b')
# POV-Ray counts the time of these apart from that of tracing.
LIGHT_APART = re.compile(rb'\b(photons|radiosity)\b')


def is_noisy(scene):
    """By the words of the scene, and of what it includes from its own folder."""
    text = scene.read_bytes()
    for name in re.findall(rb'#include\s+"([^"]+)"', text):
        beside = scene.parent / name.decode('latin-1')
        text += beside.read_bytes() if beside.is_file() else b''
    return NOISE.search(re.sub(rb'//[^\n]*|/\*.*?\*/', b'', text, flags=re.S)) is not None


def missing_of(said):
    """What povc says it does not draw yet, and the first error."""
    missing = {m.group(1) for m in re.finditer(r'warning: "([^"]+)"[^\n]* is not supported yet', said)}
    error = re.search(r'error: ([^\n]*)', said)
    return sorted(missing), error.group(1).split('; searched')[0] if error else ''


def look_at(scene, folder, options):
    name = str(scene.relative_to(folder).with_suffix('')).replace('/', '-')
    ours, theirs = options.work / 'povc' / f'{name}.png', options.work / 'povray' / f'{name}.png'
    done = draw_ours(scene, ours, options)
    missing, error = missing_of(done.said)
    trace = re.search(r'^trace_cpu: ([0-9.]+) s', done.said, re.M)
    row = {'scene': str(scene.relative_to(folder)), 'name': name, 'status': done.status, 'seconds': done.wall, 'cpu': done.cpu,
           'memory': done.memory, 'trace': float(trace.group(1)) if trace else None, 'missing': missing,
           'error': error if done.status != 0 else '', 'matches': False, 'off': None, 'theirs': None, 'their_seconds': None,
           'their_cpu': None, 'their_memory': None, 'their_trace': None}
    if options.read_only:
        return row
    row.update(zip(('theirs', 'their_seconds', 'their_cpu', 'their_memory', 'their_trace'), draw_theirs(scene, theirs, options)))
    if LIGHT_APART.search(scene.read_bytes()):
        row['their_trace'] = None
    if done.status == 0 and row['theirs'] == 0 and theirs.exists():
        a, b = png.read(ours), png.read(theirs)
        row['off'] = share_off(a, b, 1)
        row['matches'] = row['off'] <= SHARE or (is_noisy(scene) and share_off(a, b, EDGE) <= SHARE)
        if not row['matches'] and options.refine and is_noisy(scene) and row['scene'] not in known_causes():
            row['matches'] = matches_refined(scene, name, options)
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


COLUMNS = {'scene': 'scene', 'verdict': 'verdict', 'off': 'off', 'seconds': 'povc_s', 'their_seconds': 'povray_s', 'missing': 'missing',
           'error': 'error', 'cpu': 'povc_cpu_s', 'their_cpu': 'povray_cpu_s', 'trace': 'povc_trace_s', 'their_trace': 'povray_trace_s',
           'memory': 'povc_KiB', 'their_memory': 'povray_KiB', 'name': 'name', 'status': 'status', 'theirs': 'povray_status',
           'matches': 'matches'}


def write_csv(rows, path):
    with open(path, 'w', newline='') as file:
        out = csv.writer(file)
        out.writerow(COLUMNS.values())
        for row in rows:
            out.writerow([verdict(row) if key == 'verdict' else row[key] for key in COLUMNS])


def last_rows(path):
    """The rows of the last run, by scene."""
    def value(text):
        try:
            return ast.literal_eval(text) if text else None
        except (SyntaxError, ValueError):
            return text
    if not path.exists():
        return {}
    with open(path, newline='') as file:
        rows = [{key: line[column] for key, column in COLUMNS.items() if column in line} for line in csv.DictReader(file)]
    texts = ('scene', 'name', 'error')
    return {row['scene']: {key: text if key in texts else value(text) for key, text in row.items()} for row in rows if 'matches' in row}


def known_causes():
    with open(Path(__file__).parent / 'causes.csv', newline='') as file:
        return {row['scene']: row for row in csv.DictReader(file)}


def number(x, form='.2f'):
    return format(x, form) if x is not None else ''


def write_tables(rows, path, options):
    """docs/corpus.md: counts, times and memory of what matches, and why the others do not."""
    causes = known_causes()
    counts = collections.Counter(verdict(row) for row in rows)
    pairs = [row for row in rows if row['matches'] and row['their_cpu'] and row['cpu']]
    of_programs = ''.join(path.read_text().partition('<!-- programs -->')[1:]) if path.exists() else ''   # programs.py writes it
    with open(path, 'w') as out:
        out.write('# The scenes that come with POV-Ray\n\n'
                  '`make corpus CORPUS_FLAGS="--refine --page docs/corpus.md"` draws them with povc and with POV-Ray 3.7 and writes this page. '
                  f'Pictures are {options.size}, with one thread and one sample a pixel. A scene matches when at most 1 % of the '
                  'pixels are off by more than 8/255, or, where it is noisy, of the means over 4 x 4 pixels. Where POV-Ray\'s own '
                  'samples of media, cache of radiosity or photons are coarser than that, both are drawn again until they have '
                  'converged (`--refine`, tests/corpus/refined.py): at most 1 % of the means over 8 x 8 pixels off by more than 3 %.\n\n')
        out.write('| | scenes |\n|---|---|\n' + ''.join(f'| {what} | {count} |\n' for what, count in counts.most_common()))
        out.write(f'| all | {len(rows)} |\n\n')
        if pairs:
            write_times(pairs, out)
        write_others([row for row in rows if not row['matches']], causes, out)
        out.write(f'\n{of_programs}' if of_programs else '')


def write_times(pairs, out):
    whole = sorted(row['their_seconds'] / row['seconds'] for row in pairs)
    cpu = [row['their_cpu'] / row['cpu'] for row in pairs]
    trace = [row['their_trace'] / row['trace'] for row in pairs if row['their_trace'] and row['trace']]
    known = [row for row in pairs if row['memory'] and row['their_memory']]
    less = sum(row['memory'] <= row['their_memory'] for row in known)
    slower = sorted((row for row in pairs if row['their_cpu'] < row['cpu']), key=lambda row: row['their_cpu'] / row['cpu'])
    out.write(f'## Times and memory\n\nOf the scenes that match, {len(pairs)} were measured with both programs. POV-Ray takes the following times as long as povc '
              '(on a machine that was not idle; processor time is the least disturbed):\n\n| | median | least |\n|---|---|---|\n')
    for what, values in (('whole process, wall time', whole), ('whole process, processor time', cpu), ('tracing, processor time', trace)):
        if values:
            out.write(f'| {what} | {statistics.median(values):.1f} | {min(values):.2f} |\n')
    out.write(f'\npovc takes at most the memory of POV-Ray in {less} of {len(known)}.')
    if slower:
        out.write(' Slower than POV-Ray by processor time:\n\n| scene | povc s | POV-Ray s |\n|---|---|---|\n')
        out.writelines(f'| {row["scene"]} | {number(row["cpu"])} | {number(row["their_cpu"])} |\n' for row in slower)
    out.write('\n')


def write_others(rows, causes, out):
    out.write('\n## What does not match, and why\n\n| scene | verdict | off | who is right | cause |\n|---|---|---|---|---|\n')
    for row in rows:
        known = causes.get(row['scene'], {'right': '', 'cause': ''})
        lacks = ', '.join(row['missing']) + (' not drawn yet' if row['missing'] else '') + (row['error'] or '')
        off = '' if row['off'] is None else f'{100 * row["off"]:.1f} %'
        cause = '; '.join(filter(None, [known['cause'], lacks])) or 'not traced to a cause yet'
        out.write(f'| {row["scene"]} | {verdict(row)} | {off} | {known["right"]} | {cause} |\n')


def write_page(rows, path):
    style = ('body{font:14px sans-serif;margin:2em}td{padding:4px 10px;vertical-align:top}img{display:block}'
             '.over{display:grid;filter:brightness(4);isolation:isolate}.over img{grid-area:1/1}'
             '.over img+img{mix-blend-mode:difference}')
    with open(path, 'w') as out:
        out.write(f'<!DOCTYPE html><meta charset="utf-8"><title>corpus</title><style>{style}</style><table>\n')
        out.write('<tr><th>scene<th>povc<th>POV-Ray<th>difference<th>verdict<th>missing\n')
        for row in sorted(rows, key=lambda r: (verdict(r), r['scene'])):
            note = html.escape(', '.join(row['missing']) + ' ' + (row['error'] or ''))
            off = '' if row['off'] is None else f'<br>{100 * row["off"]:.1f} % off'
            out.write(f'<tr><td>{html.escape(row["scene"])}<td><img src="povc/{row["name"]}.png" alt="">'
                      f'<td><img src="povray/{row["name"]}.png" alt=""><td><div class="over"><img src="povc/{row["name"]}.png" alt="">'
                      f'<img src="povray/{row["name"]}.png" alt=""></div><td>{verdict(row)}{off}<td>{note}\n')
        out.write('</table>\n')


def main():
    options = arguments()
    folder, scenes = all_scenes(options)
    for sub in ('povc', 'povray'):
        (options.work / sub).mkdir(parents=True, exist_ok=True)
    rows = []
    last = last_rows(options.work / 'corpus.csv') if options.again else {}
    for scene in scenes:
        before = last.get(str(scene.relative_to(folder)))
        if before and before['matches']:
            rows.append(before)
            continue
        rows.append(look_at(scene, folder, options))
        print(f'{verdict(rows[-1]):9} {rows[-1]["scene"]}', flush=True)
    write_csv(rows, options.work / 'corpus.csv')
    write_page(rows, options.work / 'corpus.html')
    if options.page:
        write_tables(rows, options.page, options)
    print('\nMissing or wrong, by scenes that do not match:')
    for what, count in ranked(rows)[:options.top]:
        print(f'{count:5} {what}')
    counts = collections.Counter(verdict(row) for row in rows)
    print('\n' + ', '.join(f'{count} {what}' for what, count in counts.most_common()) + f' of {len(rows)}')
    return 1 if counts['CRASHED'] else 0


if __name__ == '__main__':
    sys.exit(main())

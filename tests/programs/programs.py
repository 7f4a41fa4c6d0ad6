#!/usr/bin/env python3
"""Scenes as programs write them today, drawn by povc and by POV-Ray.

The programs are installed where they can be: ASE, PyMOL, VTK, vapory, fdray, plato, povplot and pypdb2pov from PyPI into a folder
of their own; Jmol, Open Babel, Inkscape, DRAWxtl, Voro++, polymake, Graphviz, OpenSceneGraph, GRASS, ESyS-Particle, Avogadro,
Blender and FreeCAD are used where the system has them (Debian: jmol xvfb openbabel inkscape drawxtl voro++ polymake graphviz
openscenegraph grass-core esys-particle libavogadro-dev blender freecad-python3). Then the calls by which ASE, vapory,
fdray, PyMOL, plato and povplot render are made with povc under the name `povray`, and tests/corpus/corpus.py compares the scenes.
Graphviz's differ: their mist lies behind transparent polygons too, and not in POV-Ray (docs/language.md, fog).

Mayavi, PyVista and ParaView write what VTK writes. RasMol, Gdis, Wings 3D, LeoCAD and Structure Synth write scenes by their
menus alone; OVITO, gmsh, Geomview, MeshLab and Assimp write none (any more).
"""
import argparse
import csv
import os
import signal
import statistics
import subprocess
import sys
import tempfile
import venv
from pathlib import Path

HERE = Path(__file__).parent
PACKAGES = {'ase': ['ase', 'scikit-image'], 'vapory': ['vapory'], 'pymol': ['pymol-open-source'], 'vtk': ['vtk'],
            'fdray': ['fdray'], 'plato': ['plato-draw'], 'povplot': ['povplot', 'jinja2<3.1', 'matplotlib<3.9'],
            'pypdb2pov': ['pypdb2pov']}
INSTALL_LIMIT, DRAW_LIMIT = 300, 1200   # seconds, of a busy machine
MARK = '<!-- programs -->'   # of corpus.py too, which leaves what stands behind it
CAUSES = {'graphviz': "Graphviz's mist lies behind transparent polygons too, and not in POV-Ray (language.md, fog)."}   # why scenes differ
RENDERING = ('ase', 'vapory', 'pymol', 'fdray', 'plato', 'povplot')


def run(command, seconds, path=None):
    """Whether the command succeeded, and what it said. What it started ends with it."""
    environment = dict(os.environ, PATH=f'{path}:{os.environ["PATH"]}') if path else None
    with tempfile.TemporaryFile() as said:
        process = subprocess.Popen(command, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=said,
                                   start_new_session=True)
        try:
            status = process.wait(seconds)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
            return False, f'it took longer than {seconds} s'
        said.seek(0)
        return status == 0, said.read().decode('utf-8', 'replace')[-2000:].strip()


def python_with_packages(folder):
    """The interpreter, and the programs that could be installed for it."""
    python = folder / 'bin' / 'python'
    if not python.exists():
        venv.create(folder, with_pip=True)
    there = []
    for name, packages in PACKAGES.items():
        print(f'programs: installing {name}', file=sys.stderr, flush=True)
        # Few of the modules are imported: compiling all of them takes minutes.
        ok, said = run([python, '-m', 'pip', 'install', '-q', '--no-compile', '--no-input', '--disable-pip-version-check', *packages],
                       INSTALL_LIMIT)
        if ok:
            there.append(name)
        else:
            print(f'programs: {name} could not be installed, its scenes are left out: {said}', file=sys.stderr, flush=True)
    return python, there


def write_scenes(python, names, scenes):
    """Returns the names that failed."""
    commands = {name: [python, HERE / f'with_{name}.py', scenes] for name in names}
    commands['others'] = ['sh', HERE / 'others.sh', scenes]
    failed = []
    for name, command in commands.items():
        ok, said = run(command, DRAW_LIMIT)
        print(f'{"ok" if ok else "not ok"} {name} writes its scenes', flush=True)
        if not ok or name == 'others':   # which says what it left out
            print(said, file=sys.stderr, flush=True)
        if not ok:
            failed.append(name)
    return failed


def render_by_name(python, names, work, povc):
    """Each program renders its scenes with povc, which it calls by the name povray. Returns the names that could not."""
    programs, folder = work / 'bin', work / 'rendered'
    for made in (programs, folder):
        made.mkdir(parents=True, exist_ok=True)
    link = programs / 'povray'
    if link.is_symlink():
        link.unlink()
    link.symlink_to(povc)
    failed = []
    for name in names:
        before = set(folder.glob('*.png'))
        for old in before:
            old.unlink()
        ok, said = run([python, HERE / f'with_{name}.py', folder, link], DRAW_LIMIT, programs)
        pictures = [p for p in folder.glob('*.png') if p.stat().st_size > 100]
        ok = ok and pictures
        print(f'{"ok" if ok else "not ok"} {name} renders {len(pictures)} pictures by the name povray', flush=True)
        if not ok:
            print(said, file=sys.stderr, flush=True)
            failed.append(name)
    return failed


def ratios(rows, theirs, ours):
    return [float(row[theirs]) / float(row[ours]) for row in rows if row[theirs] and row[ours] and float(row[ours]) > 0]


def table(rows):
    """A row for each program whose scenes were drawn, and one for all."""
    names = sorted({row['scene'].split('_')[0] for row in rows})
    lines = ['| program | scenes | match | whole process | tracing | least of tracing |', '|---|---|---|---|---|---|']
    for name in (*names, 'all'):
        some = [row for row in rows if name in ('all', row['scene'].split('_')[0])]
        match = [row for row in some if row['verdict'] == 'matches']
        whole, trace = ratios(match, 'povray_s', 'povc_s'), ratios(match, 'povray_trace_s', 'povc_trace_s')
        numbers = ''.join(f' {of(values):.1f} |' if values else ' |'
                          for of, values in ((statistics.median, whole), (statistics.median, trace), (min, trace)))
        lines.append(f'| {name} | {len(some)} | {len(match)} |{numbers}')
    differs = [row['scene'] for row in rows if row['verdict'] != 'matches']
    causes = [CAUSES[name] for name in sorted({scene.split('_')[0] for scene in differs}) if name in CAUSES]
    said = ' '.join([f'These do not match: {", ".join(differs)}.', *causes]) if differs else 'All match.'
    return '\n'.join(lines) + f'\n\n{said}\n'


def write_section(rows, path):
    """The part of docs/corpus.md that starts at the mark."""
    rest = path.read_text().partition(MARK)[0] if path.exists() else ''
    path.write_text(f'{rest.rstrip()}\n\n{MARK}\n## Scenes as programs write them\n\n'
                    '`make programs PROGRAMS_FLAGS="--page docs/corpus.md"` installs the programs where it can, has them write their scenes and '
                    'writes this table. Pictures are as above. POV-Ray takes so many times as long as povc, in the median of a '
                    'program\'s scenes that match (wall time of whole processes; processor time of tracing):\n\n' + table(rows))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--povc', type=Path, default=Path('build/bin/povc'))
    parser.add_argument('--work', type=Path, default=Path('build/programs'))
    parser.add_argument('--page', type=Path, help='write the table of docs/corpus.md there')
    options = parser.parse_args()
    povc, work = options.povc.resolve(), options.work.resolve()
    scenes = work / 'scenes'
    scenes.mkdir(parents=True, exist_ok=True)
    python, names = python_with_packages(work / 'venv')
    failed = write_scenes(python, names, scenes)
    failed += render_by_name(python, [n for n in RENDERING if n in names], work, povc)
    corpus = subprocess.run([sys.executable, HERE.parent / 'corpus' / 'corpus.py', '--povc', povc, '--scenes', scenes,
                             '--work', work], check=False)
    if options.page:
        with open(work / 'corpus.csv', newline='') as file:
            write_section(list(csv.DictReader(file)), options.page)
    return 1 if failed or corpus.returncode else 0


if __name__ == '__main__':
    sys.exit(main())

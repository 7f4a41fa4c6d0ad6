#!/usr/bin/env python3
"""Scenes as programs write them today, drawn by povc and by POV-Ray.

The programs are installed where they can be: ASE, PyMOL, VTK, vapory, fdray, plato, povplot and pypdb2pov from PyPI into a folder
of their own; Jmol, Open Babel, Inkscape, DRAWxtl, Voro++, polymake, Graphviz, OpenSceneGraph, GRASS, ESyS-Particle, Avogadro,
Blender and FreeCAD are used where the system has them (Debian: jmol xvfb openbabel inkscape drawxtl voro++ polymake graphviz
openscenegraph grass-core esys-particle libavogadro-dev blender freecad-python3). Then the calls by which ASE, vapory,
fdray, PyMOL, plato and povplot render are made with povc under the name `povray`, and tests/corpus/corpus.py compares the scenes.

Mayavi, PyVista and ParaView write what VTK writes. RasMol, Gdis, Wings 3D, LeoCAD and Structure Synth write scenes by their
menus alone; OVITO, gmsh, Geomview, MeshLab and Assimp write none (any more).
"""
import argparse
import os
import subprocess
import sys
import venv
from pathlib import Path

HERE = Path(__file__).parent
PACKAGES = {'ase': ['ase', 'scikit-image'], 'vapory': ['vapory'], 'pymol': ['pymol-open-source'], 'vtk': ['vtk'],
            'fdray': ['fdray'], 'plato': ['plato-draw'], 'povplot': ['povplot', 'jinja2<3.1', 'matplotlib<3.9'],
            'pypdb2pov': ['pypdb2pov']}
RENDERING = ('ase', 'vapory', 'pymol', 'fdray', 'plato', 'povplot')


def python_with_packages(folder):
    """The interpreter, and the programs that could be installed for it."""
    python = folder / 'bin' / 'python'
    if not python.exists():
        venv.create(folder, with_pip=True)
    there = []
    for name, packages in PACKAGES.items():
        done = subprocess.run([python, '-m', 'pip', 'install', '-q', '--disable-pip-version-check', *packages], check=False)
        if done.returncode == 0:
            there.append(name)
        else:
            print(f'programs: {name} could not be installed: its scenes are left out', file=sys.stderr)
    return python, there


def call(command, path=None):
    """Did it succeed?"""
    environment = dict(os.environ, PATH=f'{path}:{os.environ["PATH"]}') if path else None
    done = subprocess.run(command, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, check=False,
                          timeout=1200)
    if done.returncode:
        print(done.stderr.decode('utf-8', 'replace')[-2000:], file=sys.stderr)
    return done.returncode == 0


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
        ok = call([python, HERE / f'with_{name}.py', folder, link], programs)
        pictures = [p for p in folder.glob('*.png') if p.stat().st_size > 100]
        print(f'{"ok" if ok and pictures else "not ok"} {name} renders {len(pictures)} pictures by the name povray', flush=True)
        if not (ok and pictures):
            failed.append(name)
    return failed


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--povc', type=Path, default=Path('build/bin/povc'))
    parser.add_argument('--work', type=Path, default=Path('build/programs'))
    options = parser.parse_args()
    povc, work = options.povc.resolve(), options.work.resolve()
    scenes = work / 'scenes'
    scenes.mkdir(parents=True, exist_ok=True)
    python, names = python_with_packages(work / 'venv')
    for name in names:
        call([python, HERE / f'with_{name}.py', scenes])
    call(['sh', HERE / 'others.sh', scenes])
    failed = render_by_name(python, [n for n in RENDERING if n in names], work, povc)
    corpus = subprocess.run([sys.executable, HERE.parent / 'corpus' / 'corpus.py', '--povc', povc, '--scenes', scenes,
                             '--work', work], check=False)
    return 1 if failed or corpus.returncode else 0


if __name__ == '__main__':
    sys.exit(main())

"""Scenes as PyMOL writes them: sticks, spheres, cartoon, surface, transparency, labels.

Usage: with_pymol.py FOLDER [POVRAY]: with a program, `ray` of PyMOL calls it by its name `povray`.
"""
import os
import sys

import pymol2

VIEWS = {
    'sticks': lambda cmd: cmd.show_as('sticks'),
    'spheres': lambda cmd: cmd.show_as('spheres'),
    'surface': lambda cmd: cmd.show_as('surface'),
    'transparent': lambda cmd: (cmd.show('sticks'), cmd.show('surface'), cmd.set('transparency', .5)),
    'cartoon': lambda cmd: cmd.show_as('cartoon'),
    'mesh': lambda cmd: cmd.show_as('mesh'),
}

os.chdir(sys.argv[1])
for name, view in VIEWS.items():
    with pymol2.PyMOL() as session:
        cmd = session.cmd
        cmd.fab('AVLKDEWGHIKLS', 'peptide', ss=1)
        cmd.orient()
        cmd.viewport(160, 120)
        cmd.hide('everything')
        view(cmd)
        header, geometry = cmd.get_povray()
        with open(f'pymol_{name}.pov', 'w', encoding='utf-8') as file:
            file.write(header + geometry)
        if len(sys.argv) > 2 and name == 'sticks':
            cmd.ray(160, 120, renderer=1)
            cmd.png('pymol_ray.png', ray=0)

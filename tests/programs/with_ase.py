"""Scenes as ASE writes them: a slab, a molecule, a crystal with its cell, an isosurface, all texture styles.

Usage: with_ase.py FOLDER [POVRAY], the program that renders them.
"""
import os
import sys

import numpy as np
from ase import Atoms
from ase.build import add_adsorbate, bulk, fcc111, molecule
from ase.io.pov import get_bondpairs, write_pov

STYLES = ['simple', 'pale', 'intermediate', 'vmd', 'jmol', 'ase2', 'ase3', 'glass', 'glass2']


def save(name, atoms, isosurface=None, rotation='20x,30y', show_unit_cell=0, **settings):
    inputs = write_pov(f'{name}.pov', atoms, isosurface_data=isosurface, rotation=rotation,
                       show_unit_cell=show_unit_cell, povray_settings={'canvas_width': 200, **settings})
    if len(sys.argv) > 2:
        inputs.render(povray_executable=sys.argv[2])


def density():
    along = np.linspace(-2, 2, 24)
    x, y, z = np.meshgrid(along, along, along, indexing='ij')
    return np.exp(-((x - .6) ** 2 + y ** 2 + z ** 2)) + np.exp(-((x + .6) ** 2 + y ** 2 + z ** 2))


os.chdir(sys.argv[1])
slab = fcc111('Cu', (3, 3, 3), vacuum=8)
add_adsorbate(slab, molecule('CH3OH'), 2.2, 'ontop')
save('ase_slab', slab, rotation='-75x,20y')

ethanol = molecule('CH3CH2OH')
ethanol.center(vacuum=2)
save('ase_bonds', ethanol, bondatoms=get_bondpairs(ethanol, radius=1.1), bondlinewidth=.12, transparent=False)
for style in STYLES:
    save(f'ase_style_{style}', ethanol, textures=[style] * len(ethanol))
save('ase_fog', ethanol, depth_cueing=True, cue_density=.02, transparent=False)

salt = bulk('NaCl', 'rocksalt', a=5.64, cubic=True) * (2, 2, 1)
save('ase_cell', salt, rotation='10x,-20y', show_unit_cell=2, celllinewidth=.07, camera_type='perspective')

cloud = Atoms('H2', positions=[[1.4, 2, 2], [2.6, 2, 2]], cell=[4, 4, 4])
save('ase_isosurface', cloud, rotation='10x,25y', show_unit_cell=2,
     isosurface={'density_grid': density(), 'cut_off': .5})

"""A molecule from ASE: balls and sticks, by spheres and cylinders. Usage: molecule.py [NAME] [OUTPUT]"""
import sys

import numpy as np
import povtrace
from ase.build import molecule
from ase.data import covalent_radii
from ase.data.colors import jmol_colors

name, output = (sys.argv[1:] + ["C6H6", "molecule.png"][len(sys.argv) - 1:])[:2]
atoms = molecule(name)
place = atoms.positions - atoms.positions.mean(0)
radius = covalent_radii[atoms.numbers]
size = 1.2 * np.abs(place).max() + 1

i, j = np.triu_indices(len(atoms), 1)
is_bond = np.linalg.norm(place[i] - place[j], axis=1) < 1.2 * (radius[i] + radius[j])

builder = povtrace.Builder().background([1, 1, 1]).lights([-10, 15, -20])
builder.camera([0, 0, -20], [0, 0, 0], orthographic=2.66 * size)
builder.spheres(place, .5 * radius, "finish { phong .5 ambient .1 }", colors=jmol_colors[atoms.numbers])
builder.cylinders(place[i[is_bond]], place[j[is_bond]], .1, "pigment { rgb .7 } finish { phong .5 ambient .1 }")
scene = povtrace.Scene(builder)
scene.render(640, 480, spp=16).png(output)
print(f"{len(scene)} objects: {len(atoms)} atoms and {is_bond.sum()} bonds")

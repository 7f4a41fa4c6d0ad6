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


def vector(v):
    return "<%.6g, %.6g, %.6g>" % tuple(v)


lines = ["#version 3.7; global_settings { assumed_gamma 1 }", "background { rgb 1 }", "#default { finish { phong .5 ambient .1 } }"]
size = 1.2 * np.abs(place).max() + 1
lines.append(f"camera {{ orthographic location -20*z right {2.66 * size:.6g}*x up {2 * size:.6g}*y look_at 0 }}")
lines.append("light_source { <-10, 15, -20> rgb 1 }")
for p, n, r in zip(place, atoms.numbers, radius):
    lines.append(f"sphere {{ {vector(p)}, {.5 * r:.6g} pigment {{ rgb {vector(jmol_colors[n])} }} }}")
for i in range(len(atoms)):
    for j in range(i):
        if np.linalg.norm(place[i] - place[j]) < 1.2 * (radius[i] + radius[j]):
            lines.append(f"cylinder {{ {vector(place[i])}, {vector(place[j])}, .1 pigment {{ rgb .7 }} }}")
povtrace.Scene("\n".join(lines)).render(640, 480, spp=16).png(output)

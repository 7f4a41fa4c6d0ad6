"""Scenes as povplot writes them, which asks the program `povray` for a picture on standard output.

Usage: with_povplot.py FOLDER [ANY], to render them."""
import os
import shutil
import subprocess
import sys

import numpy as np
import povplot

os.chdir(sys.argv[1])
rows = 24
u, v = (a.ravel() for a in np.meshgrid(np.linspace(0, 2 * np.pi, rows), np.linspace(-1, 1, rows), indexing='ij'))
vertices = np.stack([np.cos(u) * (2 - v ** 2), np.sin(u) * (2 - v ** 2), 2 * v], axis=1)
corner = np.array([i * rows + j for i in range(rows - 1) for j in range(rows - 1)])
triangles = np.concatenate([np.stack([corner, corner + 1, corner + rows], axis=1),
                            np.stack([corner + 1, corner + rows + 1, corner + rows], axis=1)])
CAMERA = {'location': (5, 4, 3), 'sky': (0, 0, 1), 'look_at': (0, 0, 0), 'focal_point': (0, 0, 0)}


def keep(command, **_):
    """In the place of a run of POV-Ray: the scene is kept."""
    shutil.copy(next(word[2:] for word in command if word.startswith('+I')), f'{name}.pov')
    return subprocess.CompletedProcess(command, 0)


if len(sys.argv) <= 2:
    povplot.subprocess.run = keep
for name, more in (('povplot_plain', {}), ('povplot_smooth', {'normals': vertices * (1, 1, 0) + .001, 'cmap': 'plasma'})):
    povplot.render_tripcolor(f'{name}.png', size=(160, 120), vertices=vertices, triangles=triangles, values=np.sin(3 * u) * v,
                             camera=CAMERA, **more)

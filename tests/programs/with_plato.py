"""Scenes as plato-draw writes them: every primitive that it has for POV-Ray. Usage: with_plato.py FOLDER [ANY], to render them."""
import os
import sys

import numpy as np
import plato.draw.povray as p

os.chdir(sys.argv[1])
np.asscalar = lambda a: a.item()   # which plato calls, and NumPy has no more
PLACES = np.array([[-2, -1, 0], [0, 1, .5], [2, -.5, -.5]], dtype=float)
COLORS = np.array([[.8, .2, .1, 1], [.2, .6, .3, .7], [.2, .3, .9, 1]])
TURNS = np.array([[1, 0, 0, 0], [.9, .3, .3, .1], [.8, 0, .6, 0]], dtype=float)
TURNS /= np.linalg.norm(TURNS, axis=1)[:, None]
CUBE = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * .6
TETRAHEDRON = np.array([[1, 1, 1], [-1, -1, 1], [-1, 1, -1], [1, -1, -1]]) * .7
PRIMITIVES = {
    'spheres': p.Spheres(positions=PLACES, colors=COLORS, radii=np.array([.8, 1, .6])),
    'unions': p.SphereUnions(positions=PLACES, orientations=TURNS, colors=COLORS[:2], points=np.array([[-.4, 0, 0], [.5, .2, 0]]),
                             radii=np.array([.6, .4])),
    'polyhedra': p.ConvexPolyhedra(positions=PLACES, orientations=TURNS, colors=COLORS, vertices=CUBE),
    'outlines': p.ConvexPolyhedra(positions=PLACES, orientations=TURNS, colors=COLORS, vertices=TETRAHEDRON, outline=.05),
    'spheropolyhedra': p.ConvexSpheropolyhedra(positions=PLACES, orientations=TURNS, colors=COLORS, vertices=CUBE, radius=.3),
    'ellipsoids': p.Ellipsoids(positions=PLACES, orientations=TURNS, colors=COLORS, a=1, b=.5, c=.3),
    'lines': p.Lines(start_points=PLACES, end_points=PLACES[::-1] + [0, 0, 1], widths=np.array([.1, .2, .3]), colors=COLORS),
    'mesh': p.Mesh(vertices=TETRAHEDRON, indices=np.array([[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]),
                   colors=np.array([[1, 0, 0, 1], [0, 1, 0, 1], [0, 0, 1, 1], [1, 1, 0, 1]])),
    'box': p.Box(Lx=4, Ly=3, Lz=2, xy=.3, width=.1, color=(.2, .2, .2, 1)),
}
FEATURES = {'ambient_light': .25, 'directional_light': np.array([[.25, .5, -1], [-.4, -.1, -.4]]), 'antialiasing': .3}

for name, primitive in PRIMITIVES.items():
    scene = p.Scene([primitive], size=(8, 6), pixel_scale=20, rotation=[.8, .4, .4, .2], features=FEATURES)
    scene.save(f'plato_{name}.png' if len(sys.argv) > 2 else f'plato_{name}.pov')

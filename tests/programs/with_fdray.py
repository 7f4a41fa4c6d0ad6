"""Scenes as fdray writes them. Usage: with_fdray.py FOLDER [POVRAY], the program that renders them."""
import os
import sys

import fdray as f

os.chdir(sys.argv[1])
WHITE = f.Pigment(f.Color('white'))
PATH = [(-1, 0, 0), (-.5, .5, 0), (0, -.5, .3), (.5, .5, 0), (1, 0, 0)]
OBJECTS = {
    'difference': f.Box((-1, -1, -1), (1, 1, 1), f.Color('red')) - f.Sphere((1, 1, 1), 1, f.Color('blue')),
    'merge': f.Sphere((0, 0, 0), .7, f.Color('green', .5)) | f.Sphere((.5, 0, 0), .7, f.Color('gold', filter=.5)),
    'intersection': f.Sphere((0, 0, 0), .9, f.Color('red')) * f.Cube((0, 0, 0), 1.3, f.Color('gold')),
    'sweep': f.SphereSweep('cubic_spline', PATH, .15, f.Color('red')),
    'curve': f.Curve(PATH, .15, f.Color('blue')),
    'text': f.Text('Fd Ray', .2, f.Color('red')),
    'torus': f.Torus(.8, .2, f.Pigment('checker', f.Color('red'), f.Color('blue'))),
    'bumps': f.Sphere((0, 0, 0), .9, WHITE, f.Normal('bumps', .6, 'scale', .1), f.Finish(phong=.8, reflection=.2)),
    'glass': f.Sphere((0, 0, 0), .9, f.Color('white', filter=.8), f.Interior(ior=1.5, caustics=.5)),
    'normals': f.Sphere((0, 0, 0), .9, WHITE, f.Normal('gradient x', f.NormalMap((0, 'bumps 1'), (1, 'ripples 1')))),
    'slopes': f.Sphere((0, 0, 0), .9, WHITE,
                       f.Normal('gradient x', f.SlopeMap((0, (0, 1)), (.5, (1, 0)), (1, (0, -1))), 'scale', .2)),
}

for name, thing in OBJECTS.items():
    scene = f.Scene(f.Camera(30, 40, view_scale=3), f.LightSource(0, 'white'), f.Background('lightblue'), thing)
    if len(sys.argv) > 2:
        f.Renderer(160, 120).render(scene, f'fdray_{name}.png')
    else:
        with open(f'fdray_{name}.pov', 'w', encoding='utf-8') as file:
            file.write(scene.to_str(160, 120))

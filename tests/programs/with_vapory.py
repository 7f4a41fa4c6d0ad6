"""Scenes as vapory writes them. Usage: with_vapory.py FOLDER [POVRAY], the program that renders them."""
import os
import sys

import vapory as v

os.chdir(sys.argv[1])
SCENES = {
    'sphere': [v.LightSource([2, 4, -3], 'color', [1, 1, 1]),
             v.Background('color', [.2, .3, .5]),
             v.Sphere([0, 1, 2], 2, v.Texture(v.Pigment('color', [1, 0, 1]), v.Finish('phong', .8, 'reflection', .2)))],
    'csg': [v.LightSource([2, 4, -3], 'color', [1, 1, 1]),
            v.Difference(v.Box([-1, 0, 1], [1, 2, 3]), v.Sphere([0, 1, 1], .8),
                         v.Texture(v.Pigment('checker', 'color', [1, 1, 1], 'color', [.2, .2, .8], 'scale', .25))),
            v.Plane([0, 1, 0], -.5, v.Pigment('color', [.7, .7, .6]))],
    'wood': [v.LightSource([4, 5, -6], 'color', [1, 1, 1]),
             v.Box([-1.5, 0, 1], [1.5, 1.5, 3], v.Texture(v.Pigment('DMFWood4'), v.Finish('specular', .5)), 'rotate', [0, 30, 0])],
}

for name, objects in SCENES.items():
    scene = v.Scene(v.Camera('location', [0, 2, -3], 'look_at', [0, 1, 2]), objects,
                    included=['colors.inc', 'textures.inc', 'woods.inc'])
    with open(f'vapory_{name}.pov', 'w', encoding='utf-8') as file:
        file.write(str(scene))
    if len(sys.argv) > 2:
        v.config.POVRAY_BINARY = sys.argv[2]
        scene.render(f'vapory_{name}.png', width=160, height=120)

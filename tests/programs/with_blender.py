"""Scenes as Blender's add-on for POV-Ray writes them: materials, lights, skies, cameras, and each primitive of POV-Ray.

Usage: blender -b --python with_blender.py -- FOLDER
"""
import os
import sys

import addon_utils
import bpy

addon_utils.enable('render_povray', default_set=True)
from render_povray import render   # noqa: E402

os.chdir(sys.argv[-1])
scene = bpy.context.scene
scene.render.engine = 'POVRAY_RENDER'
scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = 160, 120, 100
scene.pov.radio_enable = False     # with its error_bound of 10 POV-Ray gathers light in 27 places of a picture
SLOW = ('addloft',)                # POV-Ray reads its macro for minutes


def save(name):
    bpy.context.view_layer.update()
    render.write_pov(os.path.abspath(f'blender_{name}.pov'), scene, lambda *words: None)


def material(name, colour, **settings):
    made = bpy.data.materials.new(name)
    made.diffuse_color = (*colour, 1)
    for key, value in settings.items():
        setattr(made.pov, key, value)
    return made


def clear():
    for thing in list(bpy.data.objects):
        if thing.type not in ('LIGHT', 'CAMERA'):
            bpy.data.objects.remove(thing)


def shapes():
    mesh = bpy.ops.mesh
    materials = [material('red', (.8, .1, .1)), material('glass', (.9, 1, .9), use_transparency=True, alpha=.2),
                 material('worn', (.2, .4, .9), diffuse_shader='MINNAERT'),
                 material('rough', (.9, .7, .2), diffuse_shader='OREN_NAYAR'),
                 material('glow', (.3, .8, .3), emit=.3)]
    for i, add in enumerate((mesh.primitive_uv_sphere_add, mesh.primitive_cone_add, mesh.primitive_monkey_add,
                             mesh.primitive_torus_add, mesh.primitive_ico_sphere_add)):
        add(location=((i % 3 - 1) * 2.6, i // 3 * 2.6 - 1, 0))
        bpy.context.object.data.materials.append(materials[i])
        if i % 2 == 0:
            bpy.ops.object.shade_smooth()
    mesh.primitive_plane_add(size=30, location=(0, 0, -1.2))
    bpy.context.object.data.materials.append(materials[0])


clear()
shapes()
save('materials')
light, lens = bpy.data.objects['Light'].data, scene.camera.data
for kind in ('SUN', 'SPOT', 'POINT'):
    light.type = kind
    save(f'light_{kind.lower()}')
scene.world.pov.use_sky_blend = True
save('sky')
lens.type = 'ORTHO'
save('orthographic')
lens.type = 'PERSP'
clear()
for word in (w for w in dir(bpy.ops.pov) if w.startswith('add') and w not in SLOW):
    try:
        getattr(bpy.ops.pov, word)()
    except RuntimeError as reason:
        print(f'programs: {word} of Blender is left out: {reason}', file=sys.stderr)
        continue
    save(word)
    clear()

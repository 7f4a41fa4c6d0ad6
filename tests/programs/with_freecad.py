"""Scenes as FreeCAD's Raytracing workbench writes them, in each of its templates.

Usage: freecadcmd with_freecad.py, with the folder in SCENES
"""
import os
from pathlib import Path

import FreeCAD
import Part
import Raytracing

V = FreeCAD.Vector
CAMERA = """#declare cam_location = <12, 10, -14>;
#declare cam_look_at = <0, 1, 0>;
#declare cam_sky = <0, 1, 0>;
#declare cam_angle = 40;
camera { location cam_location look_at cam_look_at sky cam_sky angle cam_angle right x*image_width/image_height }
"""
SHAPES = {
    'bored': Part.makeBox(4, 4, 4).cut(Part.makeCylinder(1.5, 5)).fuse(Part.makeSphere(1.5, V(4, 4, 4))),
    'torus': Part.makeTorus(4, 1.2).common(Part.makeBox(20, 20, 20, V(-10, 0, -10))),
    'ruled': Part.makeRuledSurface(Part.makeCircle(3), Part.makeCircle(1, V(0, 0, 4), V(.3, .2, 1))),
}
templates = Path(FreeCAD.getResourceDir()) / 'Mod' / 'Raytracing' / 'Templates'
for template in sorted(templates.glob('ProjectStd.pov')):
    for name, shape in SHAPES.items():
        part = Raytracing.getPartAsPovray(f'Part_{name}', shape, .8, .3, .2)
        text = CAMERA + template.read_text().replace('//RaytracingContent', part)
        Path(os.environ['SCENES'], f'freecad_{template.stem}_{name}.pov').write_text(text)

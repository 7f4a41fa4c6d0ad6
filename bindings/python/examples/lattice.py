"""A lattice of glass and metal, a material for each sphere. Usage: lattice.py [OUTPUT]"""
import sys

import numpy as np
import povtrace

N = 1
METAL = "pigment { rgb <.9, .6, .3> } finish { reflection .3 specular .6 }"
GLASS = "pigment { rgbt <.9, .95, 1, .9> } finish { reflection .1 specular .8 } interior { ior 1.3 }"

at = np.stack(np.meshgrid(*[np.arange(-N, N + 1)] * 3, indexing="ij"), 3).reshape(-1, 3)
builder = povtrace.Builder().text("global_settings { max_trace_level 8 }").background([.7, .8, .9]).lights([8, 10, -9])
builder.camera([5, 4, -7], [0, 0, 0], angle=36)
builder.spheres(at, .3, np.array([builder.material(METAL), builder.material(GLASS)])[at.sum(1) % 2])

scene = povtrace.Scene(builder)
picture = scene.render(480, 360, error=.01, time=20)
picture.png(sys.argv[1] if len(sys.argv) > 1 else "lattice.png")
print(f"{len(scene)} objects, {picture.samples:.1f} samples a pixel, estimated rms error {picture.error}")

"""Heights in an array as a mesh2, and its depth map by rays. Usage: heights.py [OUTPUT]"""
import sys

import numpy as np
import povtrace

N = 80
x, z = np.meshgrid(np.linspace(-1, 1, N), np.linspace(-1, 1, N), indexing="ij")
y = .3 * np.sin(5 * x) * np.cos(4 * z) * np.exp(-x * x - z * z)
points = ", ".join("<%.5g, %.5g, %.5g>" % p for p in zip(x.ravel(), y.ravel(), z.ravel()))
first = (np.arange(N - 1)[:, None] * N + np.arange(N - 1)).ravel()
faces = np.concatenate([np.stack([first, first + 1, first + N], 1), np.stack([first + 1, first + N + 1, first + N], 1)])
scene = povtrace.Scene(f"""
#version 3.7; global_settings {{ assumed_gamma 1 }}
camera {{ location <1.2, 1.6, -2.2> look_at <0, -.1, 0> angle 50 }}
light_source {{ <-3, 4, -2> rgb 1 }} background {{ rgb <.8, .9, 1> }}
mesh2 {{
    vertex_vectors {{ {N * N}, {points} }}
    face_indices {{ {len(faces)}, {", ".join("<%d, %d, %d>" % tuple(f) for f in faces)} }}
    pigment {{ gradient y color_map {{ [0 rgb <.2, .3, .6>] [1 rgb <.9, .8, .5>] }} scale .6 translate -.3*y }}
}}""")
scene.render(480, 360, spp=9).png(sys.argv[1] if len(sys.argv) > 1 else "heights.png")
u, v = np.meshgrid(np.linspace(-.9, .9, 50), np.linspace(-.9, .9, 50), indexing="ij")
down = scene.trace(np.stack([u.ravel(), np.full(u.size, 2.), v.ravel()], 1), [0, -1, 0])
want = .3 * np.sin(5 * u) * np.cos(4 * v) * np.exp(-u * u - v * v)
print(f"largest difference between the mesh and the function: {np.abs(2 - down.distance - want.ravel()).max():.2g}")

"""Heights in an array as a mesh, and its depth map by rays. Usage: heights.py [OUTPUT]"""
import sys

import numpy as np
import povtrace

N = 80


def height(x, z):
    return .3 * np.sin(5 * x) * np.cos(4 * z) * np.exp(-x * x - z * z)


x, z = np.meshgrid(np.linspace(-1, 1, N), np.linspace(-1, 1, N), indexing="ij")
corners = np.stack([x, height(x, z), z], 2).reshape(-1, 3)
first = (np.arange(N - 1)[:, None] * N + np.arange(N - 1)).ravel()
faces = np.concatenate([np.stack([first, first + 1, first + N], 1), np.stack([first + 1, first + N + 1, first + N], 1)])
slope = np.stack([(height(x + 1e-6, z) - height(x, z)) / 1e-6, (height(x, z + 1e-6) - height(x, z)) / 1e-6], 2).reshape(-1, 2)
normals = np.stack([-slope[:, 0], np.ones(N * N), -slope[:, 1]], 1)

builder = povtrace.Builder().background([.8, .9, 1]).lights([-3, 4, -2])
builder.camera([1.2, 1.6, -2.2], [0, -.1, 0], angle=50)
builder.mesh(corners, faces, """
    pigment { gradient y color_map { [0 rgb <.2, .3, .6>] [1 rgb <.9, .8, .5>] } scale .6 translate -.3*y }
    finish { specular .2 }""", normals=normals)
scene = povtrace.Scene(builder)
scene.render(480, 360, spp=9).png(sys.argv[1] if len(sys.argv) > 1 else "heights.png")

u, v = np.meshgrid(np.linspace(-.9, .9, 50), np.linspace(-.9, .9, 50), indexing="ij")
down = scene.trace(np.stack([u.ravel(), np.full(u.size, 2.), v.ravel()], 1), [0, -1, 0])
print(f"largest difference between the mesh and the function: {np.abs(2 - down.distance - height(u, v).ravel()).max():.2g}")

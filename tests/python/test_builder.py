"""Builders of the Python package: their scenes are bit-identical to those of their texts."""
import unittest

import numpy as np
import povtrace

HEAD = '#version 3.7;\nglobal_settings { assumed_gamma 1 }\n'
EYE = 'camera { location <0, 0, -5> look_at 0 } light_source { <3, 5, -9> rgb 1 }\n'


def vector(v):
    return '<' + ', '.join(repr(float(x)) for x in v) + '>'


class BuilderTest(unittest.TestCase):
    def setUp(self):
        self.random = np.random.default_rng(5)

    def check(self, builder, text):
        built, written = povtrace.Scene(builder).render(64, 48), povtrace.Scene(text).render(64, 48)
        np.testing.assert_array_equal(built.pixels, written.pixels)
        self.assertGreater(np.ptp(built.pixels[..., :3]), .1)

    def points(self, n=12, size=2.):
        return self.random.uniform(-size, size, (n, 3))

    def test_shapes_are_those_of_the_text(self):
        a, r = self.points(), self.random.uniform(.1, .4, 12)
        b = a + self.random.uniform(.2, .6, (12, 3))
        look = 'pigment { rgb <.9, .3, .2> } finish { phong .5 }'
        given = povtrace.Builder().text(EYE).spheres(a, r, look).cylinders(a, b, .1, look).cones(a, r, b, 0, look)
        given.boxes(a, b, look).triangles(np.stack([a, b, a + [0, 1, 0]], 1), None, look)
        lines = [HEAD, EYE]
        lines += [f'sphere {{ {vector(p)}, {s!r} {look} }}' for p, s in zip(a, r.tolist())]
        lines += [f'cylinder {{ {vector(p)}, {vector(q)}, .1 {look} }}' for p, q in zip(a, b)]
        lines += [f'cone {{ {vector(p)}, {s!r}, {vector(q)}, 0 {look} }}' for p, q, s in zip(a, b, r.tolist())]
        lines += [f'box {{ {vector(p)}, {vector(q)} {look} }}' for p, q in zip(a, b)]
        lines += [f'triangle {{ {vector(p)}, {vector(q)}, {vector(p + [0, 1, 0])} {look} }}' for p, q in zip(a, b)]
        self.check(given, '\n'.join(lines))
        scene = povtrace.Scene(given)
        self.assertEqual(len(scene), 60)
        self.assertTrue(all(s > 0 for s in scene.seconds))

    def test_each_object_has_its_own(self):
        a, paint = self.points(), self.random.uniform(0, 1, (12, 3))
        moves = np.concatenate([np.tile(np.eye(3), (12, 1, 1)) * [1, 1.4, .8], self.points(12, .3)[:, None]], 1)
        looks = ['finish { phong .8 }', 'finish { reflection .3 }'] * 6
        lines = [HEAD, EYE] + [f'sphere {{ {vector(p)}, .4 {k} pigment {{ rgb {vector(c)} }} matrix {vector(m.ravel())} }}'
                               for p, k, c, m in zip(a, looks, paint, moves)]
        self.check(povtrace.Builder().text(EYE).spheres(a, .4, looks, colors=paint, matrices=moves), '\n'.join(lines))
        b = povtrace.Builder().text(EYE)
        numbers = np.array([b.material(look) for look in looks])
        self.check(b.spheres(a, .4, numbers, colors=paint, matrices=moves), '\n'.join(lines))

    def test_a_matrix_moves_as_numpy_does(self):
        m = np.vstack([self.random.normal(size=(3, 3)), [[.5, .2, 0]]])
        at = povtrace.Scene(povtrace.Builder().spheres([1, 2, 3], 1e-6, matrices=m))
        middle = np.array([1, 2, 3]) @ m[:3] + m[3]
        self.assertAlmostEqual(at.trace(middle - [0, 0, 4], [0, 0, 1]).distance[0], 4, 4)

    def test_meshes_have_normals_and_uv(self):
        corners = np.array([[-1, -1, 0], [1, -1, .3], [1, 1, 0], [-1, 1, .4]])
        faces, normals = np.array([[0, 1, 2], [0, 2, 3]]), self.points(4) + [0, 0, -6]
        uv = np.array([[0, 0], [1, 0], [1, 1], [0, 1]])
        look = 'uv_mapping pigment { checker rgb 1 rgb x scale .2 }'
        text = (f'vertex_vectors {{ 4, {", ".join(map(vector, corners))} }} normal_vectors {{ 4, {", ".join(map(vector, normals))} }}'
                f'uv_vectors {{ 4, {", ".join(map(vector, uv))} }} face_indices {{ 2, <0, 1, 2>, <0, 2, 3> }}')
        turn = np.vstack([np.eye(3) * 1.5, [[.2, 0, 0]]])
        self.check(povtrace.Builder().text(EYE).mesh(corners, faces, look, normals=normals, uv=uv, matrix=turn),
                   f'{HEAD}{EYE} mesh2 {{ {text} {look} matrix {vector(turn.ravel())} }}')

    def test_faces_have_materials(self):
        corners, faces = np.array([[-1, -1, 0], [1, -1, .3], [1, 1, 0], [-1, 1, .4]]), [[0, 1, 2], [0, 2, 3]]
        paints = ['pigment { rgb x }', 'pigment { rgb <0, .5, 1> }']
        for numbers, behind in (([2, 1], ['1', '0']), ([[1, 2, 1], [2, 2, 1]], ['0, 1, 0', '1, 1, 0'])):
            b = povtrace.Builder().text(EYE)
            self.assertEqual([b.material(p) for p in paints], [1, 2])
            text = (f'vertex_vectors {{ 4, {", ".join(map(vector, corners))} }} texture_list {{ 2, texture {{ {paints[0]} }} texture'
                    f' {{ {paints[1]} }} }} face_indices {{ 2, <0, 1, 2>, {behind[0]}, <0, 2, 3>, {behind[1]} }}')
            self.check(b.mesh(corners, faces, face_materials=numbers), f'{HEAD}{EYE} mesh2 {{ {text} }}')
        self.assertRaises(ValueError, b.mesh, corners, faces, face_materials=[1])
        self.assertRaises(povtrace.PovError, b.mesh, corners, faces, face_materials=[1, 9])

    def test_rays_find_uv(self):
        corners, uv = np.array([[-1, -1, 0], [1, -1, 0], [-1, 1, 0]]), np.array([[0, 0], [1, 0], [0, .5]])
        scene = povtrace.Scene(povtrace.Builder().mesh(corners, [[0, 1, 2]], uv=uv))
        hits = scene.trace([[-1, -1, -2], [0, -.5, -2], [3, 3, -2]] + np.array([1e-9, 1e-9, 0]), [0, 0, 1], uv=True)
        np.testing.assert_allclose(hits.uv, [[0, 0], [.5, .125], [0, 0]], atol=1e-8)
        self.assertIsNone(scene.trace([0, 0, -2], [0, 0, 1]).uv)

    def test_lights_and_the_camera_are_values(self):
        shapes = 'sphere { 0, 1 pigment { rgb 1 } } plane { y, -1 pigment { checker rgb 1 rgb .3 } }'
        b = povtrace.Builder().text(shapes).lights([[3, 5, -4], [-2, 3, -1]], [[1, .5, 0], [0, .5, 1]], 'fade_distance 8 fade_power 2')
        b.camera([0, 1, -6], [0, 0, 0], angle=40)
        fade = 'fade_distance 8 fade_power 2'
        self.check(b, f'{HEAD}{shapes} light_source {{ <3, 5, -4>, rgb <1, .5, 0> {fade} }} light_source {{ <-2, 3, -1>,'
                      f'rgb <0, .5, 1> {fade} }}' + self.camera_text(b))
        camera = povtrace.Scene(b).camera
        self.assertEqual(camera.type, 'perspective')
        np.testing.assert_array_equal(camera.location, [0, 1, -6])
        self.assertAlmostEqual(np.linalg.norm(camera.right) / 2 / np.linalg.norm(camera.direction), np.tan(np.radians(20)))
        seen = povtrace.Scene(b.camera([0, 0, -6], [0, 0, 0], orthographic=4).background([0, 0, 1])).render(40, 30).pixels
        self.assertTrue((seen[0, :, 2] == 1).all())           # 3 high: 1.5 above the middle
        self.assertEqual(np.count_nonzero(seen[15, :, 2] != 1), 20)
        self.assertEqual(povtrace.Scene(b).camera.type, 'orthographic')

    @staticmethod
    def camera_text(_):
        forward = np.array([0, -1, 6]) / np.sqrt(37)
        reach = .5 * (4 / 3) / np.tan(np.radians(40) / 2)
        right = np.cross([0, 1, 0], forward) / np.linalg.norm(np.cross([0, 1, 0], forward))
        return (f'camera {{ location <0, 1, -6> direction {vector(reach * forward)} right {vector(4 / 3 * right)}'
                f'up {vector(np.cross(forward, right))} }}')

    def test_arrays_may_be_of_any_kind(self):
        wide = np.zeros((4, 6), np.float32)
        wide[:, ::2] = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
        scene = povtrace.Scene(povtrace.Builder().spheres(wide[:, ::2], np.full(4, .25, np.float16)).spheres(np.zeros((0, 3)), 1))
        self.assertEqual(len(scene), 4)
        np.testing.assert_array_equal(scene.trace([[1, 0, -1], [0, 1, -2]], [0, 0, 1]).distance, [.75, 1.75])

    def test_wrong_arrays_are_errors(self):
        b = povtrace.Builder()
        for wrong in (lambda: b.spheres([1, 2], 1), lambda: b.spheres(np.zeros((3, 3)), [1, 2]),
                      lambda: b.spheres(np.zeros((3, 3)), 1, ['', '']), lambda: b.spheres(np.zeros((2, 3)), 1, colors=np.zeros((3, 3))),
                      lambda: b.mesh(np.zeros((3, 3)), [[0, 1, 2.5]]), lambda: b.mesh(np.zeros((3, 3)), [[0, 1, -2]]),
                      lambda: b.lights([0, 0, 0], np.zeros((2, 3))), lambda: b.camera([0, 1, 0], [0, 0, 0])):
            self.assertRaises(ValueError, wrong)
        for wrong in (lambda: b.spheres([np.nan, 0, 0], 1), lambda: b.spheres([0, 0, 0], 1, 7),
                      lambda: b.spheres([0, 0, 0], 1, colors=[1, 2])):
            self.assertRaises(povtrace.PovError, wrong)
        b.mesh(np.zeros((3, 3)), [[0, 1, 9]])
        with self.assertRaises(povtrace.PovError) as caught:
            povtrace.Scene(b)
        self.assertIn('face 0 has a corner that is out of range', caught.exception.message)


if __name__ == '__main__':
    unittest.main()

"""The Python package: pictures to povc's bits, hits, errors with their place."""
import pathlib
import subprocess
import sys
import tempfile
import threading
import types
import unittest
import unittest.mock

import numpy as np
import povtrace

TEXT = '''camera { location <0, 0, -4> look_at 0 }
light_source { <-5, 8, -9> color rgb 1 }
sphere { 0, Size pigment { color rgb <.9, .3, .2> } }
'''
POVC = sys.argv.pop(1)


class SceneTest(unittest.TestCase):
    def setUp(self):
        self.scene = povtrace.Scene(TEXT, declare={'Size': 1})

    def test_picture_is_that_of_povc(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, 'scene.pov')
            path.write_text('#declare Size = 1;\n' + TEXT)
            subprocess.run([POVC, path, '64', '48', path.with_suffix('.png'), '-q'], check=True)
            for scene in (self.scene, povtrace.Scene(path)):
                self.assertEqual(scene.render(64, 48).png(), path.with_suffix('.png').read_bytes())

    def test_pixels_are_linear_floats(self):
        pixels = np.asarray(self.scene.render(64, 48, spp=4, threads=1))
        self.assertEqual((pixels.shape, pixels.dtype), ((48, 64, 4), np.float32))
        self.assertGreater(pixels[24, 32, 0], pixels[24, 32, 2])
        self.assertEqual(pixels[0, 0, 0], 0)

    def test_rays_hit_the_sphere_where_it_is(self):
        hits = self.scene.trace([0, 0, -4], [[0, 0, 1], [0, 0, 2], [0, 1, 0]])
        np.testing.assert_array_equal(hits.distance, [3, 1.5, np.inf])
        np.testing.assert_array_equal(hits.normal, [[0, 0, -1], [0, 0, -1], [0, 0, 0]])
        np.testing.assert_array_equal(hits.object, [0, 0, -1])

    def test_colours_of_rays_are_those_of_pixels(self):
        scene = povtrace.Scene(TEXT.replace('<0, 0, -4>', '<0, 0, -4> direction z right x up y'), declare={'Size': 1})
        pixels = scene.render(5, 5).pixels
        hits = scene.trace([0, 0, -4], [[0, 0, 1], [1, 0, 0]], color=True)
        np.testing.assert_array_equal(hits.color[0], pixels[2, 2, :3])
        np.testing.assert_array_equal(hits.point, [[0, 0, -1], [0, 0, 0]])
        self.assertEqual(len(scene.trace(np.zeros((0, 3)), [0, 0, 1]).distance), 0)

    def test_threads_trace_at_once(self):
        rays = np.random.default_rng(1).normal(size=(20000, 3))
        want, found = self.scene.trace([0, 0, -4], rays).distance, [None] * 4

        def work(i):
            found[i] = self.scene.trace([0, 0, -4], rays).distance
        workers = [threading.Thread(target=work, args=(i,)) for i in range(4)]
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()
        for one in found:
            np.testing.assert_array_equal(one, want)

    def test_pictures_grow_and_know_their_error(self):
        grown = []
        last = self.scene.render(400, 300, spp=64, grown=grown.append)
        self.assertTrue(all(p.pixels.shape == (300, 400, 4) for p in grown))
        self.assertEqual(last.samples, 64)
        self.assertGreater(last.error, 0)
        self.assertIsNone(self.scene.render(8, 8).error)

    def test_alpha_hides_the_background(self):
        pixels = self.scene.render(64, 48, alpha=True).pixels
        self.assertEqual((pixels[0, 0, 3], pixels[24, 32, 3]), (0, 1))

    def test_maps_tell_what_is_seen(self):
        text = TEXT.replace('look_at 0', 'orthographic right 4*x up 3*y')
        maps = povtrace.Scene(text, declare={'Size': 1}).render(
            41, 31, spp=4, maps=['depth', 'normal', 'position', 'object', 'albedo', 'alpha', 'certainty', 'samples', 'time']).maps
        self.assertEqual({name: m.shape for name, m in maps.items() if m.ndim == 2}, dict.fromkeys(
            ['depth', 'object', 'alpha', 'certainty', 'samples', 'time'], (31, 41)))
        self.assertAlmostEqual(maps['depth'][15, 20], 3)
        np.testing.assert_allclose(maps['normal'][15, 20], [0, 0, -1], atol=1e-6)
        np.testing.assert_allclose(maps['position'][15, 20], [0, 0, -1], atol=1e-6)
        np.testing.assert_allclose(maps['albedo'][15, 20], [.9, .3, .2], atol=1e-6)
        self.assertEqual((maps['object'][15, 20], maps['object'][0, 0]), (0, -1))
        self.assertEqual(maps['samples'][15, 20], 4)
        self.assertGreaterEqual(maps['time'].min(), 0)
        self.assertRaises(ValueError, self.scene.render, 8, 8, maps=['colour'])

    def test_loading_tells_how_far_it_is_and_may_be_ended(self):
        text, told = TEXT + '#for (I, 1, 20000) sphere { I, .1 } #end', []
        povtrace.Scene(text, declare={'Size': 1}, progress=told.append)
        self.assertGreater(len(told), 5)
        self.assertEqual((told, told[-1]), (sorted(told), 1))

        def stop(fraction):
            raise KeyboardInterrupt
        self.assertRaises(KeyboardInterrupt, povtrace.Scene, text, declare={'Size': 1}, progress=stop)

    def test_a_picture_grows_in_a_notebook(self):
        shown = []

        class Handle:
            update = staticmethod(lambda picture: shown.append(picture.png()))
        module = types.ModuleType('IPython.display')
        module.display = lambda display_id: Handle
        with unittest.mock.patch.dict(sys.modules, {'IPython': types.ModuleType('IPython'), 'IPython.display': module}):
            last = self.scene.show(400, 300, spp=64)
        self.assertEqual(shown[-1], last._repr_png_())
        self.assertTrue(all(png.startswith(b'\x89PNG') for png in shown))

    def test_an_error_has_its_place(self):
        with self.assertRaises(povtrace.PovError) as caught:
            povtrace.Scene('camera { }\nsphere { 0, 1 pigmet { rgb 1 } }')
        self.assertEqual((caught.exception.line, caught.exception.column), (2, 15))
        self.assertEqual(caught.exception.hint, 'pigment')

    def test_a_size_that_cannot_be_is_an_exception(self):
        with self.assertRaises(povtrace.PovError):
            self.scene.render(0, 48)

    def test_progress_may_end_the_job(self):
        def stop(fraction):
            raise KeyboardInterrupt
        with self.assertRaises(KeyboardInterrupt):
            self.scene.render(2000, 2000, spp=400, progress=stop)


if __name__ == '__main__':
    unittest.main()

"""The library from Python, by ctypes alone. Usage: client.py LIBPOVTRACE.SO"""
import ctypes as c
import sys


class Vec3(c.Structure):
    _fields_ = [("x", c.c_double), ("y", c.c_double), ("z", c.c_double)]


class Error(c.Structure):
    _fields_ = [("status", c.c_int), ("line", c.c_int), ("column", c.c_int), ("caret", c.c_int),
                ("file", c.c_char * 256), ("message", c.c_char * 512), ("excerpt", c.c_char * 256),
                ("hint", c.c_char * 64)]


class Hit(c.Structure):
    _fields_ = [("size", c.c_size_t), ("distance", c.c_double), ("point", Vec3), ("normal", Vec3),
                ("object", c.c_uint32), ("certain", c.c_bool)]


pov = c.CDLL(sys.argv[1])
pov.pov_status_name.restype = c.c_char_p
pov.pov_trace_hit.restype = c.c_bool
pov.pov_trace_hit.argtypes = [c.c_void_p, Vec3, Vec3, c.POINTER(Hit)]
pov.pov_scene_object_count.restype = c.c_size_t
for name in ("pov_scene_object_count", "pov_tracer_destroy", "pov_scene_destroy", "pov_context_destroy"):
    getattr(pov, name).argtypes = [c.c_void_p]

major, minor, patch = c.c_int(), c.c_int(), c.c_int()
pov.pov_version(c.byref(major), c.byref(minor), c.byref(patch))
print("libpovtrace %d.%d.%d" % (major.value, minor.value, patch.value))

error, context, scene, tracer = Error(), c.c_void_p(), c.c_void_p(), c.c_void_p()
assert pov.pov_context_create(c.byref(context), None, c.byref(error)) == 0, error.message


def load(text):
    return pov.pov_scene_load_text(c.byref(scene), context, text, c.c_size_t(len(text)), b"text", None, c.byref(error))


assert load(b"sphere { <0, 0, 5>, ") < 0 and error.line == 1 and error.message
assert pov.pov_status_name(error.status) == b"syntax", pov.pov_status_name(error.status)
assert load(b"sphere { <0, 0, 5>, 2 } sphere { <0, 0, 50>, 2 }") == 0, error.message
assert pov.pov_scene_object_count(scene) == 2
assert pov.pov_tracer_create(c.byref(tracer), scene, c.byref(error)) == 0, error.message
hit = Hit(size=c.sizeof(Hit))
assert pov.pov_trace_hit(tracer, Vec3(0, 0, 0), Vec3(0, 0, 1), c.byref(hit))
assert hit.distance == 3.0 and hit.object == 0 and (hit.normal.x, hit.normal.y, hit.normal.z) == (0, 0, -1)
pov.pov_tracer_destroy(tracer)
pov.pov_scene_destroy(scene)
pov.pov_context_destroy(context)
print("hit at", hit.distance)

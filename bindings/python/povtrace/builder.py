"""Scenes from arrays."""
from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._calls import _at, _call, _make, _sized
from ._library import ffi, lib

Material = Union[str, int, Sequence[Union[str, int]], NDArray[np.integer[Any]]]

PERSPECTIVE, ORTHOGRAPHIC = 0, 1   # pov_camera_type
HEADER = '#version 3.7;\nglobal_settings { assumed_gamma 1 }\n'


def _doubles(what: str, value: ArrayLike, *shape: int) -> NDArray[np.float64]:
    """As an array (n, *shape), without a copy if it is one."""
    array = np.ascontiguousarray(value, dtype=np.float64)
    if array.ndim == len(shape):
        array = array[None]
    if array.ndim != len(shape) + 1 or array.shape[1:] != shape:
        raise ValueError(f'{what}: expected an array of (n{"".join(f", {d}" for d in shape)}), got {np.shape(value)}')
    return array


def _whole(what: str, value: ArrayLike, *shape: int) -> NDArray[np.uint32]:
    array = np.asarray(value)
    if array.ndim != len(shape) + 1 or array.shape[1:] != shape or not np.issubdtype(array.dtype, np.integer):
        raise ValueError(f'{what}: expected whole numbers (n{"".join(f", {d}" for d in shape)}), got {array.dtype} {array.shape}')
    if array.size and (array.min() < 0 or array.max() > 0xffffffff):
        raise ValueError(f'{what}: a number is below 0 or above 2^32 - 1')
    return np.ascontiguousarray(array, dtype=np.uint32)


def _all(array: NDArray[np.float64], n: int) -> NDArray[np.float64]:
    """One stands for n."""
    return array if len(array) == n else np.ascontiguousarray(np.broadcast_to(array, (n, *array.shape[1:])))


class Builder:
    """A scene from arrays and text, in the order of the calls: povtrace.Scene(builder) reads it. Arrays of float64 without
    gaps are not copied: leave them as they are until then.

    Vectors are (n, 3), or (3,) for one; numbers (n,) or one for all. `material` is what stands behind the numbers of a shape
    in a text, 'pigment { rgb x } finish { phong 1 }'; a number that material() gave; or one of these for each object. colors
    is a color for each, (n, 3), (n, 4) or (n, 5) as rgb, rgbf and rgbft, in place of the pigment's. matrices, (n, 4, 3), move
    each by the rows of `matrix`: p' = p @ m[:3] + m[3].
    """

    def __init__(self, header: str = HEADER) -> None:
        self._context = _make(lib.pov_context_destroy, 'pov_context', lib.pov_context_create, ffi.NULL)
        self._builder = _make(lib.pov_builder_destroy, 'pov_builder', lib.pov_builder_create, self._context)
        self._arrays: list[NDArray[Any]] = []
        self._materials: dict[str, int] = {'': 0}
        if header:
            self.text(header)

    # ---- text ----

    def text(self, text: str) -> Builder:
        """Whole statements of the scene language; names that they declare are known to what follows."""
        data = text.encode()
        _call(lib.pov_builder_add_text, self._builder, data, len(data), ffi.NULL)
        return self

    def material(self, text: str) -> int:
        """The number of a material; equal texts have one."""
        if text not in self._materials:
            number = ffi.new('uint32_t *')
            _call(lib.pov_builder_material, self._builder, text.encode(), number)
            self._materials[text] = int(number[0])
        return self._materials[text]

    # ---- shapes ----

    def spheres(self, centres: ArrayLike, radii: ArrayLike, material: Material = '', *, colors: Optional[ArrayLike] = None,
                matrices: Optional[ArrayLike] = None) -> Builder:
        return self._add(lib.pov_builder_add_spheres, material, colors, matrices,
                         _doubles('centres', centres, 3), _doubles('radii', radii))

    def cylinders(self, bases: ArrayLike, tops: ArrayLike, radii: ArrayLike, material: Material = '', *,
                  colors: Optional[ArrayLike] = None, matrices: Optional[ArrayLike] = None) -> Builder:
        return self._add(lib.pov_builder_add_cylinders, material, colors, matrices,
                         _doubles('bases', bases, 3), _doubles('tops', tops, 3), _doubles('radii', radii))

    def cones(self, bases: ArrayLike, base_radii: ArrayLike, tops: ArrayLike, top_radii: ArrayLike, material: Material = '', *,
              colors: Optional[ArrayLike] = None, matrices: Optional[ArrayLike] = None) -> Builder:
        return self._add(lib.pov_builder_add_cones, material, colors, matrices,
                         _doubles('bases', bases, 3), _doubles('base_radii', base_radii),
                         _doubles('tops', tops, 3), _doubles('top_radii', top_radii))

    def boxes(self, corners: ArrayLike, opposite: ArrayLike, material: Material = '', *, colors: Optional[ArrayLike] = None,
              matrices: Optional[ArrayLike] = None) -> Builder:
        return self._add(lib.pov_builder_add_boxes, material, colors, matrices,
                         _doubles('corners', corners, 3), _doubles('opposite', opposite, 3))

    def triangles(self, corners: ArrayLike, normals: Optional[ArrayLike] = None, material: Material = '', *,
                  colors: Optional[ArrayLike] = None, matrices: Optional[ArrayLike] = None) -> Builder:
        """corners, and the normals at them: (n, 3, 3). Many that share corners and a material are faster as a mesh."""
        own = [] if normals is None else [_doubles('normals', normals, 3, 3)]
        return self._add(lib.pov_builder_add_triangles, material, colors, matrices,
                         _doubles('corners', corners, 3, 3), *own)

    def _add(self, call: Callable[..., int], material: Material, colors: Optional[ArrayLike],
             matrices: Optional[ArrayLike], *columns: NDArray[np.float64]) -> Builder:
        n = 0 if any(len(c) == 0 for c in columns) else max(len(c) for c in columns)
        number = self._each(n, material, colors, matrices)
        given = []
        for column in columns:
            if len(column) not in (1, n):
                raise ValueError(f'there are {n} objects and an array of {len(column)}')
            given.append(self._keep(_all(column, n) if n else column))
        if call is lib.pov_builder_add_triangles and len(given) == 1:
            given.append(ffi.NULL)
        _call(call, self._builder, n, *given, number)
        return self

    def _keep(self, array: NDArray[Any]) -> Any:
        """The library reads it when the scene is made."""
        self._arrays.append(array)
        kind = 'uint32_t' if array.dtype == np.uint32 else 'double' if array.ndim == 1 else 'pov_vec3'
        return _at(kind, array)

    def _each(self, n: int, material: Material, colors: Optional[ArrayLike], matrices: Optional[ArrayLike]) -> int:
        """Tell what differs from object to object; the material of all."""
        each = _sized('pov_each')
        number = 0
        if isinstance(material, str):
            number = self.material(material)
        elif isinstance(material, (int, np.integer)):
            number = int(material)
        else:
            numbers = material if isinstance(material, np.ndarray) else [self.material(m) if isinstance(m, str) else m for m in material]
            each.materials = self._keep(self._of(n, 'material', _whole('material', numbers)))
        if colors is not None:
            wide = np.ascontiguousarray(colors, dtype=np.float64)
            paint = _doubles('colors', wide, wide.shape[-1])
            paint = self._of(n, 'colors', _all(paint, n) if len(paint) == 1 else paint)
            each.channels = paint.shape[1]
            each.colours = ffi.cast('double *', self._keep(paint))
        if matrices is not None:
            each.matrices = ffi.cast('double *', self._keep(self._of(n, 'matrices', _doubles('matrices', matrices, 4, 3))))
        _call(lib.pov_builder_each, self._builder, each)
        return number

    @staticmethod
    def _of(n: int, what: str, array: NDArray[Any]) -> NDArray[Any]:
        if len(array) != n:
            raise ValueError(f'{what}: there are {len(array)} for {n} objects')
        return array

    # ---- meshes ----

    def mesh(self, corners: ArrayLike, faces: ArrayLike, material: Union[str, int] = '', *, normals: Optional[ArrayLike] = None,
             normal_faces: Optional[ArrayLike] = None, uv: Optional[ArrayLike] = None, uv_faces: Optional[ArrayLike] = None,
             inside: Optional[Sequence[float]] = None, matrix: Optional[ArrayLike] = None,
             face_materials: Optional[ArrayLike] = None) -> Builder:
        """Triangles over shared corners: corners (n, 3), faces (m, 3). normals and uv, (k, 3) and (k, 2), are those of the
        corners, or normal_faces and uv_faces, (m, 3), say which. inside: inside_vector, with which a closed mesh is a solid.
        face_materials: numbers of materials, (m,), or (m, 3) of the corners, blended between them; 0 is `material`."""
        parts = _sized('pov_mesh')
        self._put(parts, 'corner', _doubles('corners', corners, 3), 'corners')
        counted = _whole('faces', faces, 3)
        parts.faces, parts.face_count = self._keep(counted), len(counted)
        if normals is not None:
            self._put(parts, 'normal', _doubles('normals', normals, 3), 'normals')
        if uv is not None:
            self._put(parts, 'uv', _doubles('uv', uv, 2), 'uvs')
        for name, own in (('normal_faces', normal_faces), ('uv_faces', uv_faces)):
            if own is not None:
                setattr(parts, name, self._keep(self._of(len(counted), name, _whole(name, own, 3))))
        if face_materials is not None:
            own = _whole('face_materials', face_materials, *np.shape(face_materials)[1:])
            parts.face_materials = self._keep(self._of(len(counted), 'face_materials', own))
            parts.materials_a_face = own[0].size if len(own) else 1
        if inside is not None:
            parts.inside = tuple(float(x) for x in inside)
        number = self._each(1, material, None, matrix)
        _call(lib.pov_builder_add_mesh, self._builder, parts, number)
        return self

    def _put(self, parts: Any, count: str, array: NDArray[np.float64], name: str) -> None:
        setattr(parts, name, ffi.cast('double *' if name == 'uvs' else 'pov_vec3 *', self._keep(array)))
        setattr(parts, f'{count}_count', len(array))

    # ---- lights and the camera ----

    def lights(self, positions: ArrayLike, colors: ArrayLike = (1, 1, 1), modifiers: Material = '') -> Builder:
        """Light sources; modifiers is the text of them all: 'spotlight point_at 0 radius 20'."""
        places, paints = _doubles('positions', positions, 3), _doubles('colors', colors, 3)
        if not isinstance(modifiers, (str, int)):
            raise ValueError('modifiers: one text for all lights')
        number = self.material(modifiers) if isinstance(modifiers, str) else modifiers
        if len(paints) not in (1, len(places)):
            raise ValueError(f'colors: there are {len(paints)} for {len(places)} lights')
        _call(lib.pov_builder_add_lights, self._builder, len(places), self._keep(places), self._keep(_all(paints, len(places))),
              number)
        return self

    def camera(self, location: Sequence[float], look_at: Sequence[float], *, angle: float = 60.0,
               sky: Sequence[float] = (0, 1, 0), aspect: float = 4 / 3, orthographic: Optional[float] = None) -> Builder:
        """A camera: angle in degrees across the picture, or `orthographic`, the width of what is seen. aspect: width / height
        of the picture."""
        start, forward = np.array(location, dtype=float), np.subtract(look_at, location)
        side = np.cross(sky, forward)
        if not forward.any() or not side.any():
            raise ValueError('the camera looks nowhere, or along the sky')
        forward, side = forward / np.linalg.norm(forward), side / np.linalg.norm(side)
        width = aspect if orthographic is None else orthographic
        reach = 1.0 if orthographic is not None else 0.5 * width / math.tan(math.radians(angle) / 2)
        vectors = {'location': start, 'direction': reach * forward, 'right': width * side,
                   'up': width / aspect * np.cross(forward, side)}
        camera = _sized('pov_camera', type=PERSPECTIVE if orthographic is None else ORTHOGRAPHIC,
                        **{name: tuple(v) for name, v in vectors.items()})
        _call(lib.pov_builder_camera, self._builder, camera)
        return self

    def background(self, color: Sequence[float]) -> Builder:
        red, green, blue = (repr(float(c)) for c in color)
        return self.text(f'background {{ color rgb <{red}, {green}, {blue}> }}\n')

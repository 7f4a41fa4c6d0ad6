"""Scenes, their pictures and what rays hit in them."""
from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._calls import PovError, _at, _call, _make, _sized
from ._library import ffi, lib
from .builder import Builder

__all__ = ['Builder', 'Camera', 'Hits', 'Picture', 'PovError', 'Scene']

RUNNING = 1                      # pov_job_state
LINEAR_FLOAT = 1                 # pov_pixels
ADAPTIVE = 1                     # pov_sampling
CAMERAS = ('perspective', 'orthographic', 'fisheye', 'ultra_wide_angle', 'omnimax', 'panoramic', 'spherical', 'cylinder 1',
           'cylinder 2', 'cylinder 3', 'cylinder 4', 'mesh_camera')   # pov_camera_type
MAPS = {'error': (2, 1), 'samples': (3, 1), 'time': (4, 1), 'depth': (5, 1), 'normal': (6, 4), 'position': (7, 4), 'object': (8, 1),
        'albedo': (9, 4), 'alpha': (10, 1), 'certainty': (11, 1)}   # pov_pixels, and numbers a pixel
NOTHING = 0xffffffff             # the object of a miss


def _value(value: Union[float, str]) -> str:
    return f'"{value}"' if isinstance(value, str) else repr(float(value))


def _teller(progress: Optional[Callable[[float], Any]], raised: list[BaseException]) -> Any:
    """progress() for the library: false, if it raises."""
    if progress is None:
        return ffi.NULL

    def tell(user: Any, fraction: float, objects: int) -> bool:
        progress(fraction)
        return True

    def fail(kind: Any, error: BaseException, trace: Any) -> bool:
        raised.append(error)
        return False
    return ffi.callback('bool(void *, double, size_t)', tell, error=False, onerror=fail)


class Hits(NamedTuple):
    """By ray: distance in lengths of the direction, inf where nothing is hit; unit normal facing the ray; object, in
    the order of the text, or -1; point, 0 where nothing is hit; color, linear, what is seen along it, or None; uv, where
    uv_mapping is asked, or None."""
    distance: NDArray[np.float64]
    normal: NDArray[np.float64]
    object: NDArray[np.int64]
    point: NDArray[np.float64]
    color: Optional[NDArray[np.float32]]
    uv: Optional[NDArray[np.float64]] = None


class Camera(NamedTuple):
    """A place on the screen is u to the right and v upwards, each from -1/2 to 1/2. Rays of a 'perspective' camera start at
    location, with the direction direction + u right + v up; of an 'orthographic' one at location + u right + v up."""
    type: str
    location: NDArray[np.float64]
    direction: NDArray[np.float64]
    right: NDArray[np.float64]
    up: NDArray[np.float64]


class Picture:
    """Linear red, green, blue and alpha as `pixels`, a float32 array of (height, width, 4), top row first. error: the
    estimated rms error in linear light, None where that is not known; samples: of a pixel, in the mean; maps: those that
    render() was asked for."""

    def __init__(self, context: Any, pixels: NDArray[np.float32], transfer: int, state: Any) -> None:
        self.maps: dict[str, NDArray[Any]] = {}
        self._context, self._transfer = context, transfer
        self.pixels = pixels
        self.error: Optional[float] = float(state.est_rmse) if state.est_rmse >= 0 else None
        self.samples = float(state.spp_mean)

    def __array__(self, dtype: Any = None, copy: Optional[bool] = None) -> NDArray[Any]:
        return np.array(self.pixels, dtype=dtype) if copy else np.asarray(self.pixels, dtype=dtype)

    def png(self, path: Union[str, os.PathLike[str], None] = None) -> bytes:
        """The picture as the bytes of a PNG file, encoded as the scene asks; written to path if there is one."""
        parts: list[bytes] = []
        rgba = np.ascontiguousarray(self.pixels, dtype=np.float32)
        name = ffi.new('char[]', b'png')

        @ffi.callback('bool(void *, const void *, size_t)')
        def put(user: Any, data: Any, count: int) -> bool:
            parts.append(bytes(ffi.buffer(data, count)))
            return True

        output = ffi.new('pov_output *', {'put': put})
        options = _sized('pov_image_options', transfer=self._transfer, format=name)
        height, width, _ = rgba.shape
        _call(lib.pov_image_put, self._context, output, width, height, ffi.from_buffer('float[]', rgba), width * 16,
              options)
        data = b''.join(parts)
        if path is not None:
            with open(path, 'wb') as file:
                file.write(data)
        return data

    def _repr_png_(self) -> bytes:
        return self.png()


class Scene:
    """A scene of scene text (str), of a file (a pathlib.Path), or of a Builder. `declare` gives values of #declare: numbers,
    strings. progress is called with a fraction of 1 while it loads, a few times a second or more often; an exception of its,
    or Ctrl-C while there is one, ends loading.

    The interpreter's lock is free while the library reads and traces.
    """

    def __init__(self, source: Union[str, os.PathLike[str], Builder], *, declare: Optional[Mapping[str, Union[float, str]]] = None,
                 library_path: Optional[str] = None, threads: int = 0,
                 progress: Optional[Callable[[float], Any]] = None) -> None:
        words = [ffi.new('char[]', f'{name}={_value(value)}'.encode()) for name, value in (declare or {}).items()]
        declares = ffi.new('const char *[]', [*words, ffi.NULL])
        path = ffi.NULL if library_path is None else ffi.new('char[]', os.fsencode(library_path))
        desc = _sized('pov_load_desc', declares=declares, library_path=path, threads=threads)
        raised: list[BaseException] = []
        tell = _teller(progress, raised)             # alive until the scene is made
        desc.progress = tell
        self._context = source._context if isinstance(source, Builder) else _make(
            lib.pov_context_destroy, 'pov_context', lib.pov_context_create, ffi.NULL)
        what: tuple[Any, ...]
        if isinstance(source, Builder):
            what = (lib.pov_scene_load_builder, source._builder, desc)
        elif isinstance(source, str):
            text = source.encode()
            what = (lib.pov_scene_load_text, self._context, text, len(text), b'(text)', desc)
        else:
            what = (lib.pov_scene_load_file, self._context, os.fsencode(source), desc)
        try:
            self._scene: Any = _make(lib.pov_scene_destroy, 'pov_scene', *what)
        except PovError:
            if raised:
                raise raised[0] from None
            raise

    def __len__(self) -> int:
        return int(lib.pov_scene_object_count(self._scene))

    @property
    def seconds(self) -> tuple[float, float]:
        """That reading took, and compiling for rays."""
        info = self._info()
        return info.parse_seconds, info.build_seconds

    @property
    def camera(self) -> Camera:
        c = _sized('pov_camera')
        lib.pov_scene_get_camera(self._scene, c)
        return Camera(CAMERAS[c.type], *(np.array([v.x, v.y, v.z]) for v in (c.location, c.direction, c.right, c.up)))

    def _info(self) -> Any:
        info = _sized('pov_scene_info')
        lib.pov_scene_get_info(self._scene, info)
        return info

    def render(self, width: int, height: int, *, spp: int = 0, error: float = 0.0, time: float = 0.0, threads: int = 0,
               seed: int = 0, alpha: bool = False, maps: Sequence[str] = (), progress: Optional[Callable[[float], Any]] = None,
               grown: Optional[Callable[[Picture], Any]] = None) -> Picture:
        """Draw: spp samples a pixel, or until the estimated error is `error`, or `time` seconds have passed. alpha: the
        background is transparent. maps, of what the camera sees first, by name: 'depth', 'normal', 'position', 'object',
        'albedo', 'alpha', 'certainty'; and of the samples 'error', 'samples', 'time'. progress is called with a fraction of
        1, and grown with the picture so far, ten times a second; an exception of theirs, or Ctrl-C, ends the job."""
        unknown = set(maps) - MAPS.keys()
        if unknown:
            raise ValueError(f'there is no map {sorted(unknown)[0]!r}; there are {", ".join(MAPS)}')
        desc = _sized('pov_render_desc', width=width, height=height, samples=spp, target_error=error, time_limit=time,
                      threads=threads, sampling=ADAPTIVE if error > 0 or time > 0 else 0, seed=seed, alpha=alpha,
                      time_map='time' in maps, preview=8 if grown else 0)
        job = _make(lib.pov_job_destroy, 'pov_job', lib.pov_job_create, self._scene, desc)
        try:
            _call(lib.pov_job_start, job)
            while lib.pov_job_wait(job, 0.1) == RUNNING:
                if progress:
                    progress(self._state(job).fraction)
                if grown:
                    grown(self._read(job, width, height))
            _call(lib.pov_job_get_error, job)
            picture = self._read(job, width, height)
            picture.maps = {name: self._map(job, name, width, height) for name in maps}
            return picture
        finally:
            ffi.release(job)

    def show(self, width: int, height: int, **options: Any) -> Picture:
        """render() in a notebook: the picture grows in the cell's output."""
        from IPython.display import display

        handle = display(display_id=True)
        last = self.render(width, height, grown=handle.update, **options)
        handle.update(last)
        return last

    @staticmethod
    def _state(job: Any) -> Any:
        now = _sized('pov_progress')
        lib.pov_job_get_progress(job, now)
        return now

    def _read(self, job: Any, width: int, height: int) -> Picture:
        pixels = np.empty((height, width, 4), dtype=np.float32)
        lib.pov_job_read(job, (0, 0, width, height), LINEAR_FLOAT, ffi.from_buffer(pixels), width * 16)
        return Picture(self._context, pixels, self._info().transfer, self._state(job))

    @staticmethod
    def _map(job: Any, name: str, width: int, height: int) -> NDArray[Any]:
        """Vectors have three numbers, an object that is none is -1."""
        number, channels = MAPS[name]
        values = np.empty((height, width, channels), dtype=np.uint32 if name == 'object' else np.float32)
        lib.pov_job_read(job, (0, 0, width, height), number, ffi.from_buffer(values), width * channels * 4)
        if name == 'object':
            return np.where(values == NOTHING, -1, values.astype(np.int64))[..., 0]
        return values[..., :3] if channels == 4 else values[..., 0]

    def trace(self, origins: ArrayLike, directions: ArrayLike, *, color: bool = False, uv: bool = False) -> Hits:
        """The nearest hits of rays, (n, 3) each or (3,) for all; fastest where rays that follow each other are alike.
        color, uv: these too."""
        given = [np.atleast_2d(np.asarray(a, dtype=np.float64)) for a in (origins, directions)]
        if any(a.ndim != 2 or a.shape[1] != 3 for a in given):
            raise ValueError('origins and directions are arrays of (n, 3)')
        org, dirs = (np.ascontiguousarray(a) for a in np.broadcast_arrays(*given))
        n = len(org)
        distance, normal, point, which = np.empty(n), np.empty((n, 3)), np.empty((n, 3)), np.empty(n, np.uint32)
        rgba, places = np.empty((n if color else 0, 4), np.float32), np.empty((n if uv else 0, 2))
        found = _sized('pov_found', distance=_at('double', distance), normal=_at('pov_vec3', normal),
                       point=_at('pov_vec3', point), object=_at('uint32_t', which),
                       rgba=_at('float', rgba) if color else ffi.NULL, uv=_at('double', places) if uv else ffi.NULL)
        tracer = _make(lib.pov_tracer_destroy, 'pov_tracer', lib.pov_tracer_create, self._scene)
        _call(lib.pov_trace_many, tracer, n, _at('pov_vec3', org), _at('pov_vec3', dirs), found)
        ffi.release(tracer)
        number = np.where(which == NOTHING, -1, which.astype(np.int64))
        return Hits(distance, normal, number, point, rgba[:, :3] if color else None, places if uv else None)

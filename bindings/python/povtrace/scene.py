"""Scenes, their pictures and what rays hit in them."""
from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._library import ffi, lib

RUNNING = 1                      # pov_job_state
LINEAR_FLOAT = 1                 # pov_pixels
ADAPTIVE = 1                     # pov_sampling


class PovError(Exception):
    """What the library said, with the place in the scene's text: file, line and column, 0 where there is none."""

    def __init__(self, err: Any) -> None:
        text = {name: ffi.string(getattr(err, name)).decode(errors='replace')
                for name in ('file', 'message', 'excerpt', 'hint')}
        self.status, self.line, self.column = int(err.status), int(err.line), int(err.column)
        self.file, self.message, self.excerpt, self.hint = (text[n] for n in ('file', 'message', 'excerpt', 'hint'))
        place = f'{self.file}:{self.line}:{self.column}: ' if self.line else f'{self.file}: ' if self.file else ''
        super().__init__(place + self.message + (f'; did you mean "{self.hint}"?' if self.hint else ''))


def _call(function: Callable[..., int], *arguments: Any) -> None:
    """Call what fills a pov_error; it becomes an exception."""
    err = ffi.new('pov_error *')
    if function(*arguments, err) < 0:
        raise PovError(err)


def _make(destroy: Callable[[Any], None], kind: str, create: Callable[..., int], *arguments: Any) -> Any:
    """A handle that is destroyed with the last reference to it."""
    out = ffi.new(f'{kind} **')
    _call(create, out, *arguments)
    return ffi.gc(out[0], destroy)


def _sized(kind: str, **values: Any) -> Any:
    struct = ffi.new(f'{kind} *', values)
    struct.size = ffi.sizeof(kind)
    return struct


def _value(value: Union[float, str]) -> str:
    return f'"{value}"' if isinstance(value, str) else repr(float(value))


class Hits(NamedTuple):
    """By ray: distance in lengths of the direction, inf where nothing is hit; unit normal facing the ray; object, in
    the order of the text, or -1."""
    distance: NDArray[np.float64]
    normal: NDArray[np.float64]
    object: NDArray[np.int64]


class Picture:
    """Linear red, green, blue and alpha as `pixels`, a float32 array of (height, width, 4), top row first."""

    def __init__(self, context: Any, pixels: NDArray[np.float32], transfer: int) -> None:
        self._context, self._transfer = context, transfer
        self.pixels = pixels

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
    """A scene of scene text (str), or of a file (a pathlib.Path). `declare` gives values of #declare: numbers, strings.

    The interpreter's lock is free while the library reads and traces.
    """

    def __init__(self, source: Union[str, os.PathLike[str]], *, declare: Optional[Mapping[str, Union[float, str]]] = None,
                 library_path: Optional[str] = None, threads: int = 0) -> None:
        words = [ffi.new('char[]', f'{name}={_value(value)}'.encode()) for name, value in (declare or {}).items()]
        declares = ffi.new('const char *[]', [*words, ffi.NULL])
        path = ffi.NULL if library_path is None else ffi.new('char[]', os.fsencode(library_path))
        desc = _sized('pov_load_desc', declares=declares, library_path=path, threads=threads)
        self._context = _make(lib.pov_context_destroy, 'pov_context', lib.pov_context_create, ffi.NULL)
        if isinstance(source, str):
            text = source.encode()
            what = (lib.pov_scene_load_text, self._context, text, len(text), b'(text)', desc)
        else:
            what = (lib.pov_scene_load_file, self._context, os.fsencode(source), desc)
        self._scene = _make(lib.pov_scene_destroy, 'pov_scene', *what)

    def __len__(self) -> int:
        return int(lib.pov_scene_object_count(self._scene))

    def render(self, width: int, height: int, *, spp: int = 0, error: float = 0.0, time: float = 0.0, threads: int = 0,
               progress: Optional[Callable[[float], Any]] = None) -> Picture:
        """Draw: spp samples a pixel, or until the estimated error is `error`, or `time` seconds have passed. progress is
        called with a fraction of 1, ten times a second; an exception of it, or Ctrl-C, ends the job."""
        desc = _sized('pov_render_desc', width=width, height=height, samples=spp, target_error=error, time_limit=time,
                      threads=threads, sampling=ADAPTIVE if error > 0 or time > 0 else 0)
        job = _make(lib.pov_job_destroy, 'pov_job', lib.pov_job_create, self._scene, desc)
        try:
            return self._finish(job, width, height, progress)
        finally:
            ffi.release(job)

    def _finish(self, job: Any, width: int, height: int, progress: Optional[Callable[[float], Any]]) -> Picture:
        now = _sized('pov_progress')
        info = _sized('pov_scene_info')
        _call(lib.pov_job_start, job)
        while lib.pov_job_wait(job, 0.1) == RUNNING:
            lib.pov_job_get_progress(job, now)
            if progress:
                progress(now.fraction)
        _call(lib.pov_job_get_error, job)
        pixels = np.empty((height, width, 4), dtype=np.float32)
        lib.pov_job_read(job, (0, 0, width, height), LINEAR_FLOAT, ffi.from_buffer(pixels), width * 16)
        lib.pov_scene_get_info(self._scene, info)
        return Picture(self._context, pixels, info.transfer)

    def trace(self, origins: ArrayLike, directions: ArrayLike) -> Hits:
        """The nearest hits of rays, (n, 3) each or (3,) for all. One call of the library a ray."""
        org, dirs = np.broadcast_arrays(np.atleast_2d(np.asarray(origins, dtype=np.float64)),
                                        np.atleast_2d(np.asarray(directions, dtype=np.float64)))
        if org.ndim != 2 or org.shape[1] != 3:
            raise ValueError('origins and directions are arrays of (n, 3)')
        hits = Hits(np.full(len(org), np.inf), np.zeros((len(org), 3)), np.full(len(org), -1, dtype=np.int64))
        tracer = _make(lib.pov_tracer_destroy, 'pov_tracer', lib.pov_tracer_create, self._scene)
        hit = _sized('pov_hit')
        for i, (start, along) in enumerate(zip(org.tolist(), dirs.tolist())):
            if lib.pov_trace_hit(tracer, start, along, hit):
                hits.distance[i], hits.object[i] = hit.distance, hit.object
                hits.normal[i] = hit.normal.x, hit.normal.y, hit.normal.z
        ffi.release(tracer)
        return hits

"""Calls of the library: errors as exceptions, handles that end by themselves."""
from __future__ import annotations

from collections.abc import Callable
from typing import Any

from numpy.typing import NDArray

from ._library import ffi


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


def _at(kind: str, array: NDArray[Any]) -> Any:
    return ffi.cast(f'{kind} *', ffi.from_buffer(array))

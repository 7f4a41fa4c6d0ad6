"""Render POV-Ray scenes: povtrace.Scene(text).render(320, 240).png('out.png')

Names are loaded when they are first used: povtrace.cluster needs neither numpy nor the library.
"""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .scene import Builder, Camera, Hits, Picture, PovError, Scene

__all__ = ['Builder', 'Camera', 'Hits', 'Picture', 'PovError', 'Scene']


def __getattr__(name: str) -> Any:
    if name not in __all__:
        raise AttributeError(f'module {__name__!r} has no attribute {name!r}')
    from . import scene
    return getattr(scene, name)

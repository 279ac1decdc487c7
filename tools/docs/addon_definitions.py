"""The add-on's own definitions, read without Blender: settings with their names, texts, defaults.

The modules of addon/ are imported over a stand-in of `bpy` that keeps what it is given.
"""

from __future__ import annotations

import importlib
import sys
from dataclasses import dataclass
from types import ModuleType
from typing import Any

from paths import ROOT

PACKAGE = "illustrate_addon"
LIBRARIES = ("bpy", "bpy.types", "bpy.props", "bpy.utils", "bpy.app", "bpy.app.handlers",
             "mathutils", "gpu", "gpu_extras", "bpy_extras")  # fmt: skip


@dataclass(frozen=True)
class Property:
    """A property of bpy.props: its kind and what it was defined with."""

    kind: str
    words: dict[str, Any]

    @property
    def label(self) -> str:
        """As the panels show it."""
        return str(self.words.get("name", ""))

    @property
    def text(self) -> str:
        """Its tooltip."""
        return str(self.words.get("description", ""))

    @property
    def default(self) -> Any:
        """None for pointers."""
        return self.words.get("default")


class _Library(ModuleType):
    """A library of Blender's: whatever is asked of it is there and does nothing."""

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        if self.__name__ == "bpy.types":
            found: Any = type(name, (), {})
        elif self.__name__ == "bpy.props":
            found = _defines(name)
        elif name == "register_classes_factory":
            found = _factory
        elif name == "version":
            found = (5, 2, 0)
        else:
            found = _library(f"{self.__name__}.{name}")
        setattr(self, name, found)
        return found

    def __call__(self, *_given: Any, **_words: Any) -> Any:
        return lambda function: function  # as a decorator


def _factory(_classes: Any) -> tuple[Any, Any]:
    return (lambda: None), (lambda: None)


def _defines(kind: str) -> Any:
    return lambda **words: Property(kind, words)


def _library(name: str) -> _Library:
    if name not in sys.modules:
        made = _Library(name)
        made.__path__ = []
        sys.modules[name] = made
    return sys.modules[name]  # type: ignore[return-value]


def addon_module(name: str) -> Any:
    """A module of addon/, such as 'settings.styles'. For scripts of their own: `bpy` is no more."""
    for library in LIBRARIES:
        _library(library)
    if PACKAGE not in sys.modules:  # without what its __init__.py imports
        sys.modules[PACKAGE] = ModuleType(PACKAGE)
        sys.modules[PACKAGE].__path__ = [str(ROOT / "addon")]
    return importlib.import_module(f"{PACKAGE}.{name}")


def native_settings() -> dict[str, Property]:
    """Of native options, by the native name."""
    found = addon_module("settings.native_options")
    return {option.native: option.prop for option in (*found.PREPARE, *found.DRAW)}


def own_settings() -> dict[str, dict[str, Property]]:
    """Of the add-on alone, by where they are."""
    settings, styles = addon_module("settings.scene_settings"), addon_module("settings.styles")
    return {
        "Scene": settings.OWN,
        "Objects and collections": {**styles.OPTIONS, **styles.SURFACE},
    }


def native_panels() -> dict[str, str]:
    """(native name) the panel that shows a setting."""
    found = addon_module("settings.native_options")
    return {option.native: option.panel for option in (*found.PREPARE, *found.DRAW)}

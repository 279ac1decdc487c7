"""Kinds of native options: how each becomes a property of Blender and its value a native one."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty

MM_PER_PX = 0.1  # between the defaults of lengths in pixels and in millimetres


@dataclass(frozen=True)
class NativeOption:
    """A native option and the property that holds it."""

    native: str  # its name in illustrate_native
    prop: Any  # a property of bpy.props
    panel: str
    name: str = ""  # of the property; the native one where none is given
    to_native: Callable[[Any], Any] = lambda value: value
    prop_mm: Any = None  # lengths on paper: the same in millimetres
    limits: tuple[float, float] = (-math.inf, math.inf)  # of lengths on paper, in pixels

    @property
    def key(self) -> str:
        """The name of the property."""
        return self.name or self.native

    @property
    def key_mm(self) -> str:
        """The name of the property in millimetres; empty where there is none."""
        return self.native.removesuffix("_px") + "_mm" if self.prop_mm is not None else ""


def real(
    native: str, panel: str, label: str, default: float, text: str, **limits: Any
) -> NativeOption:
    """A number."""
    prop = FloatProperty(name=label, default=default, description=text, **limits)
    return NativeOption(native, prop, panel)


def share(native: str, panel: str, label: str, default: float, text: str) -> NativeOption:
    """A number in [0, 1]."""
    return real(native, panel, label, default, text, min=0.0, max=1.0, subtype="FACTOR")


def whole(
    native: str, panel: str, label: str, default: int, text: str, **limits: Any
) -> NativeOption:
    """An integer."""
    prop = IntProperty(name=label, default=default, description=text, **limits)
    return NativeOption(native, prop, panel)


def switch(native: str, panel: str, label: str, default: bool, text: str) -> NativeOption:
    """A choice of yes or no."""
    return NativeOption(native, BoolProperty(name=label, default=default, description=text), panel)


def choice(
    native: str, panel: str, label: str, items: list[Any], default: str, text: str
) -> NativeOption:
    """One of several. items: as those of EnumProperty."""
    prop = EnumProperty(name=label, items=items, default=default, description=text)
    return NativeOption(native, prop, panel)


def paper(
    native: str,
    panel: str,
    label: str,
    default: float,
    text: str,
    least: float,
    most: float,
    soft_most: float,
    default_mm: float = 0.0,
) -> NativeOption:
    """A length in the picture, in pixels of the render or in millimetres of the page."""
    pixels = FloatProperty(
        name=label,
        default=default,
        min=least,
        max=most,
        soft_max=soft_most,
        subtype="PIXEL",
        description=f"{text}, pixels of the render",
    )
    millimetres = FloatProperty(
        name=label,
        default=default_mm or default * MM_PER_PX,
        min=least * 0.001,
        max=most,
        soft_max=soft_most * MM_PER_PX,
        precision=3,
        step=1,
        description=f"{text}, millimetres on the page",
    )
    return NativeOption(native, pixels, panel, prop_mm=millimetres, limits=(least, most))


def pixels(
    native: str, panel: str, label: str, default: float, text: str, **limits: Any
) -> NativeOption:
    """A length in pixels of the render, whatever the unit of the page."""
    text = f"{text}, pixels of the render"
    return real(native, panel, label, default, text, subtype="PIXEL", **limits)


def threshold(native: str, lines: str, default: float) -> NativeOption:
    """The least strength of optional lines."""
    text = f"Leave out weaker {lines}, measured against the size of the object"
    limits = {"min": 0.01, "max": 100_000.0, "soft_min": 1.0, "soft_max": 100.0}
    return real(native, "lines", "Threshold", default, text, **limits)


def value_of(option: NativeOption, settings: Any, px_per_mm: float) -> Any:
    """The native value of an option. px_per_mm: of the page; 0: lengths are in pixels."""
    if px_per_mm and option.prop_mm is not None:
        least, most = option.limits
        return min(max(typed(getattr(settings, option.key_mm)) * px_per_mm, least), most)
    value = option.to_native(getattr(settings, option.key))
    return typed(value) if isinstance(value, float) else value


def typed(value: float) -> float:
    """The number that was typed: Blender keeps the single that is nearest to it."""
    return float(str(np.float32(value)))

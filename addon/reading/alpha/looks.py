"""Where materials are cut out by an image: its alpha or colour, and the level.

Followed are the alpha of a Principled shader, and a mix with a Transparent one by nodes, as far as
an image through a UV map: itself, compared with a constant, inverted, times a constant, or through
a ramp of two colours. Of the value that arrives there what is at least half is there, or at least
the Clip Threshold of a material that is clipped.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

from ..lightness import Look, image_of, luminance

HALF = 0.5
ALPHA, COLOUR = "alpha", "colour"


@dataclass(frozen=True)
class AlphaLook:
    """Where a material is there."""

    image: Look  # with image, wrap, UV map and mapping
    channel: str  # ALPHA, COLOUR: its luminance
    threshold: float
    is_below: bool  # it is there where the image is darker


@dataclass(frozen=True)
class _Level:
    """What a value must be: at least, or at most, so much."""

    value: float
    is_below: bool = False

    def turned(self, value: float) -> "_Level":
        return _Level(value, not self.is_below)


def alpha_look(material: Any) -> AlphaLook | None:
    """Of a material with nodes; None where they are not followed."""
    output = material.node_tree.get_output_node("ALL")
    level = _Level(_threshold(material))
    node = _origin(output.inputs["Surface"])[0]
    if node is not None and node.type == "MIX_SHADER":
        return _of_mix(node, level)
    alpha = node.inputs.get("Alpha") if node is not None else None
    return _followed(alpha, level) if alpha is not None else None


def _threshold(material: Any) -> float:
    is_clipped = getattr(material, "blend_method", "") == "CLIP"
    return float(material.alpha_threshold) if is_clipped else HALF


def _of_mix(node: Any, level: _Level) -> AlphaLook | None:
    """Of a mix with a Transparent shader; its factor is the share of the second one."""
    factor, *sides = node.inputs[:3]
    clear = [_is_transparent(side) for side in sides]
    if clear == [True, False]:
        return _followed(factor, level)
    return _followed(factor, level.turned(1 - level.value)) if clear == [False, True] else None


def _is_transparent(socket: Any) -> bool:
    node = _origin(socket)[0]
    return node is not None and node.type == "BSDF_TRANSPARENT"


def _origin(socket: Any) -> tuple[Any, Any]:
    """The node and its output that a socket gets its value from, past reroutes; None of none."""
    while socket.links:
        link = socket.links[0]
        if link.from_node.type != "REROUTE":
            return link.from_node, link.from_socket
        socket = link.from_node.inputs[0]
    return None, None


# --- Values -------------------------------------------------------------------------------------


def _followed(socket: Any, level: _Level) -> AlphaLook | None:
    """The image that a value comes from, and what it must be for the value to reach the level."""
    node, output = _origin(socket)
    if node is None:
        return None
    if node.type == "TEX_IMAGE":
        return _of_image(node, output, level)
    follow = FOLLOWED.get(node.type)
    found = follow(node, level) if follow is not None else None
    return _followed(*found) if found is not None else None


def _of_image(node: Any, output: Any, level: _Level) -> AlphaLook | None:
    look = image_of(node)
    channel = ALPHA if output.name == "Alpha" else COLOUR
    if look is None or not 0 <= level.value <= 1:
        return None
    return AlphaLook(replace(look, is_whole=True), channel, level.value, level.is_below)


Step = tuple[Any, _Level] | None
"""The socket before, and the level there."""


def _through_math(node: Any, level: _Level) -> Step:
    """Comparisons with a constant, 1 - x, x times a constant, and rounding."""
    a, b = node.inputs[:2]
    if node.operation == "ROUND":
        return a, replace(level, value=HALF)
    if bool(a.links) == bool(b.links):
        return None
    linked, constant = (a, b) if a.links else (b, a)
    known = float(constant.default_value)
    if node.operation in ("GREATER_THAN", "LESS_THAN"):
        is_rising = (node.operation == "GREATER_THAN") == (linked is a or linked == a)
        return linked, replace(level, value=known) if is_rising else level.turned(known)
    if node.operation == "SUBTRACT" and linked == b:
        return linked, level.turned(known - level.value)
    if node.operation == "MULTIPLY" and known > 0:
        return linked, replace(level, value=level.value / known)
    return None


def _through_inverting(node: Any, level: _Level) -> Step:
    factor, colour = node.inputs[:2]
    if factor.links or factor.default_value != 1:
        return None
    return colour, level.turned(1 - level.value)


def _through_ramp(node: Any, level: _Level) -> Step:
    """Where a ramp of two colours passes the level."""
    stops = node.color_ramp.elements
    if len(stops) != 2:
        return None
    (at, low), (to, high) = ((stop.position, luminance(stop.color)) for stop in stops)
    if (low >= level.value) == (high >= level.value):
        return None
    share = 1.0
    if node.color_ramp.interpolation != "CONSTANT":
        share = (level.value - low) / (high - low)
    place = at + share * (to - at)
    return node.inputs[0], replace(level, value=place) if high > low else level.turned(place)


def _through_value(node: Any, level: _Level) -> Step:
    return node.inputs[0], level


FOLLOWED: dict[str, Callable[[Any, _Level], Step]] = {
    "MATH": _through_math,
    "INVERT": _through_inverting,
    "VALTORGB": _through_ramp,
    "RGBTOBW": _through_value,
}

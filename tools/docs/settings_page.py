"""The page of every setting: its name, text and default from the add-on, pictures by the module."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import illustrate_native as ill
import numpy as np
import settings_list
from addon_definitions import Property, native_panels, native_settings, own_settings
from illustrate_native import svg
from settings_list import Effect
from sketch import beside
from stage_pictures import nut
from views import View, formulas, look_at, mesh, ring_and_ball

SIZE_PX = (300, 210)
PANELS = {
    "main": "Illustrate",
    "lines": "Lines",
    "hatching": "Hatching",
    "light": "Light",
    "surface": "Surface and Field",
}
SUN = ill.Light("sun", (-0.5, -0.6, 0.9))
LIGHTS = {"sun": SUN, "head": ill.Light("head"), "side": ill.Light("side")}


def _ring() -> View:
    return ring_and_ball(SIZE_PX)


def _cage() -> View:
    camera = look_at((1.0, -2.2, 1.3), 1.7, size_px=SIZE_PX)
    return View([mesh(*formulas.torus(1.0, 0.5, 9, 5))], camera)


def _corner() -> View:
    camera = look_at((1.0, 0.8, 0.7), 1.6, (0.3, 0.3, 0.3), SIZE_PX)
    return View([mesh(*formulas.smooth_corner(5.0, 16))], camera, {"level": 1}, {"spacing_px": 9.0})


def _cloth() -> View:
    camera = look_at((0.3, -2.0, 0.6), 2.2, (0.0, 0.0, 1.1), SIZE_PX)
    return View([mesh(*formulas.drape(30, 90))], camera, {"level": 1})


def _tube() -> View:
    """An open tube that no curvature rules, since none is asked for."""
    positions, faces = formulas.cylinder(0.8, 2.0, 24)
    free = {"parabolic_ratio": 0.0, "alignment_weight": 0.0}
    camera = look_at((1.0, -2.0, 0.9), 1.7, (0.0, 0.0, 1.0), SIZE_PX)
    return View([mesh(positions, faces)], camera, {"level": 1, **free})


BOX = np.array([(x, y, z) for x in (-1.0, 1.0) for y in (-1.0, 1.0) for z in (-1.0, 1.0)])


def _box() -> View:
    """A cube of which a half of the top has another material; a marked edge and loose ones."""
    on_edges = [(-1.0, 0, 1), (1.0, 0, 1), (0, 0, 1.9), (-1.0, -1, 0), (1.0, -1, 0)]
    front, top = [[0, 4, 12, 11], [11, 12, 5, 1]], [[1, 5, 9, 8], [8, 9, 7, 3]]
    sides = [[0, 11, 1, 8, 3, 2], [4, 6, 7, 9, 5, 12], [2, 3, 7, 6], [0, 2, 6, 4]]
    faces = [*front, *sides, *top]
    made = ill.PolygonMesh(
        np.concatenate([BOX, on_edges]),
        [len(face) for face in faces],
        np.concatenate(faces),
        marked_edges=[(11, 12)],
        face_materials=[0] * 7 + [1],
        loose_edges=[(5, 10), (3, 10)],
        crease_angle_deg=30,
    )
    camera = look_at((1.0, -2.0, 1.1), 2.4, (0, 0, 0.2), SIZE_PX)
    return View([made], camera, {"scheme": "none"})


def _faceted(crease_angle_deg: float = 90.0) -> View:
    """A faceted ball, each face flat."""
    positions, faces = formulas.sphere(1.0, 3)
    made = mesh(positions, faces, crease_angle_deg=crease_angle_deg, cage=False)
    camera = look_at((1.0, -2.0, 1.0), 1.6, size_px=SIZE_PX)
    return View([made], camera, {"scheme": "none"}, {"spacing_px": 9.0})


def _prism(cage: bool = False) -> View:
    return View([nut(cage)], look_at((1.0, -2.2, 1.1), 2.0, size_px=SIZE_PX))


def _floor() -> View:
    """A ball on a floor of two tones, in the sun."""
    positions, faces = formulas.sphere(0.7, 6)
    floor = np.array([(x, y, 0.0) for x in (-2.0, 0.0, 2.0) for y in (-2.0, 2.0)])
    quads = np.array([[0, 2, 3, 1], [2, 4, 5, 3]])
    meshes = [
        mesh(positions + np.array((0.0, 0.0, 0.7)), faces, name="ball"),
        mesh(floor, quads, reflectance=[0.35, 1.0], name="floor"),
    ]
    camera = look_at((1.0, -2.2, 1.1), 1.9, (0.0, 0.0, 0.4), SIZE_PX)
    return View(meshes, camera, {"level": 2}, {"spacing_px": 7.0}, [SUN])


def _fan() -> View:
    """Slats of a fan, closer together the nearer to its hub."""
    angles = np.linspace(0.15, np.pi - 0.15, 40)
    half = 0.4 * (angles[1] - angles[0])
    rim = ((0.3, -half), (0.3, half), (1.6, half), (1.6, -half))
    corners = [(r, angle + aside) for angle in angles for r, aside in rim]
    positions = np.array([(r * np.cos(a), 0.0, r * np.sin(a)) for r, a in corners])
    made = mesh(positions, np.arange(len(corners)).reshape(-1, 4), cage=False)
    camera = look_at((0.3, -2.0, 0.4), 1.7, (0.0, 0.0, 0.8), SIZE_PX)
    return View([made], camera, {"scheme": "none"})


SCENES: dict[str, Callable[..., View]] = {
    "ring": _ring,
    "cage": _cage,
    "corner": _corner,
    "cloth": _cloth,
    "tube": _tube,
    "box": _box,
    "faceted": _faceted,
    "prism": _prism,
    "floor": _floor,
    "fan": _fan,
}
OF_SCENE = ("crease_angle_deg", "cage")  # what a scene is made with


def drawing_of(effect: Effect, chosen: dict[str, Any]) -> ill.Drawing:
    """The drawing of one value."""
    given = {**effect.always, **chosen}
    made = SCENES[effect.scene](**{key: given.pop(key) for key in OF_SCENE if key in given})
    stages = ("prepare", "ball", "lights")
    for each in (effect.always, chosen):
        made.prepare.update(each.get("prepare", {}))
    if "level" not in chosen.get("prepare", {}) and {"edge_length", "triangle_budget"} & set(
        chosen.get("prepare", {})
    ):
        made.prepare.pop("level", None)
    made.draw.update({key: value for key, value in given.items() if key not in stages})
    if "ball" in given:
        made.draw["styles"] = [ill.ObjectStyle(), ill.ObjectStyle(**given["ball"])]
    if "lights" in given:
        made.lights = [LIGHTS[given["lights"]]]
    return made.drawn()[1]


def picture_of(name: str, effect: Effect) -> str:
    """The drawings of an effect side by side. Raises ValueError where two are the same."""
    panels = [
        (caption, svg.to_svg(drawing_of(effect, chosen), *SIZE_PX, style="tapered"))
        for caption, chosen in effect.values
    ]
    if len({text for _, text in panels}) < len(panels):
        raise ValueError(f"{name}: two of its values give the same drawing")
    return beside(panels, SIZE_PX[0])


def default_in_words(found: Property) -> str:
    """As the panels show it; empty where there is none."""
    default = found.default
    if default is None:
        return ""
    if found.kind == "EnumProperty":
        return next(str(item[1]) for item in found.words["items"] if item[0] == default)
    if isinstance(default, bool):
        return "on" if default else "off"
    if found.words.get("subtype") == "ANGLE":
        return f"{math.degrees(default):g}°"
    if found.words.get("subtype", "").startswith("COLOR"):
        return ""
    if isinstance(default, tuple):
        return ", ".join(f"{value:g}" for value in default)
    return f"{default:g}" if isinstance(default, int | float) else str(default)


def _entry(
    name: str, found: Property, effect: Effect | str, folder: Path | None, prefix: str
) -> Iterator[str]:
    """A setting: heading, text, default, picture. folder: None: without pictures."""
    default = default_in_words(found)
    yield f"### {found.label}\n"
    yield f"{found.text}." + (f" Default: {default}." if default else "") + f" (`{name}`)\n"
    if isinstance(effect, str):
        yield f"*No picture: {effect}.*\n"
    elif folder is not None:
        file = f"{prefix}-{name}.svg"
        (folder / file).write_text(picture_of(name, effect), encoding="utf-8")
        yield f"![{found.label}: {', '.join(c for c, _ in effect.values)}]({folder.name}/{file})\n"


def page(folder: Path | None) -> str:
    """MyST text of the page; pictures go to `folder`, beside the page."""
    lines = ["# Every setting\n", INTRODUCTION]
    panels, found = native_panels(), native_settings()
    for panel, title in PANELS.items():
        lines.append(f"## {title}\n")
        for name in (each for each in found if panels[each] not in PANELS or panels[each] == panel):
            lines += _entry(name, found[name], settings_list.NATIVE[name], folder, "native")
    own = own_settings()
    for title, effects in (
        ("Scene", settings_list.SCENE),
        ("Objects and collections", settings_list.OBJECTS),
    ):
        lines.append(f"## {title}\n")
        for name, what in own[title].items():
            lines += _entry(name, what, effects[name], folder, title.split()[0].lower())
    return "\n".join(lines)


INTRODUCTION = """The names and texts are those of the panels. Lengths are in pixels of the
render, or in millimetres of the page where *Unit* says so. Each picture shows one setting at the
values below it, all else alike.
"""

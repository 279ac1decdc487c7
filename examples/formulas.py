"""Meshes from formulas: positions (n, 3) and quads (f, 4)."""

from typing import Any

import numpy as np


def grid_quads(index: Any) -> Any:
    """Quads (f, 4) between neighbours of a grid of vertex numbers (rows, columns)."""
    corners = index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]
    return np.stack(corners, axis=-1).reshape(-1, 4)


def torus(ring: float, tube: float, rows: int = 64, columns: int = 32) -> tuple[Any, Any]:
    """A torus round the z axis: radius of the ring, radius of the tube."""
    u, v = np.meshgrid(
        2 * np.pi * np.arange(rows) / rows, 2 * np.pi * np.arange(columns) / columns, indexing="ij"
    )
    rho = ring + tube * np.cos(v)
    positions = np.stack([rho * np.cos(u), rho * np.sin(u), tube * np.sin(v)], axis=-1)
    index = np.pad(np.arange(u.size).reshape(u.shape), ((0, 1), (0, 1)), mode="wrap")
    return positions.reshape(-1, 3), grid_quads(index)


def sphere(radius: float, cells: int = 24) -> tuple[Any, Any]:
    """A sphere without poles: the six sides of a cube of cells x cells quads, blown up."""
    line = np.tan(np.linspace(-np.pi / 4, np.pi / 4, cells + 1))
    a, b = np.meshgrid(line, line, indexing="ij")
    one = np.ones_like(a)
    sides = [(one, a, b), (-one, b, a), (b, one, a), (a, -one, b), (a, b, one), (b, a, -one)]
    points = np.concatenate([np.stack(side, axis=-1).reshape(-1, 3) for side in sides])
    points *= radius / np.linalg.norm(points, axis=1, keepdims=True)
    return _welded(points / radius, points, cells + 1)


def _welded(keys: Any, points: Any, side: int) -> tuple[Any, Any]:
    """Square sides of side x side points each, joined where their keys are the same."""
    _, first, same = np.unique(np.round(keys, 9), axis=0, return_index=True, return_inverse=True)
    index = same.reshape(-1, side, side)
    return points[first], np.concatenate([grid_quads(each) for each in index])


def cylinder(radius: float = 1.0, height: float = 3.0, rows: int = 96) -> tuple[Any, Any]:
    """An open cylinder round the z axis."""
    u, z = np.meshgrid(
        2 * np.pi * np.arange(rows) / rows, np.linspace(0, height, rows // 2), indexing="ij"
    )
    positions = np.stack([radius * np.cos(u), radius * np.sin(u), z], axis=-1)
    index = np.pad(np.arange(u.size).reshape(u.shape), ((0, 1), (0, 0)), mode="wrap")
    return positions.reshape(-1, 3), grid_quads(index)


def smooth_corner(roundness: float = 5.0, cells: int = 48) -> tuple[Any, Any]:
    """Three walls that meet in a rounded corner (paper figure 10).

    Part of |x|^p + |y|^p + |z|^p = 1, p the roundness.
    """
    line = np.linspace(-0.3, 1, cells + 1)
    a, b = np.meshgrid(line, line, indexing="ij")
    one = np.ones_like(a)
    sides = [(one, a, b), (b, one, a), (a, b, one)]
    points = np.concatenate([np.stack(side, axis=-1).reshape(-1, 3) for side in sides])
    norm = (np.abs(points) ** roundness).sum(axis=1, keepdims=True) ** (1 / roundness)
    return _welded(points, points / norm, cells + 1)


def goblet(columns: int = 24) -> tuple[Any, Any]:
    """The control cage of a goblet on its foot, round the z axis; a small hole in the foot."""
    radii = [0.1, 0.75, 0.8, 0.7, 0.3, 0.13, 0.1, 0.11, 0.2, 0.12, 0.35, 0.68, 0.78, 0.76, 0.74]
    radii += [0.72, 0.7, 0.7, 0.72, 0.62, 0.3, 0.05]
    heights = [0.0, 0.0, 0.03, 0.06, 0.1, 0.2, 0.5, 0.8, 0.95, 1.05, 1.2, 1.5, 1.8, 2.1, 2.2]
    heights += [2.22, 2.2, 2.1, 1.8, 1.5, 1.25, 1.15]
    angles = 2 * np.pi * np.arange(columns) / columns
    rho, angle = np.meshgrid(radii, angles, indexing="ij")
    z = np.broadcast_to(np.array(heights)[:, None], rho.shape)
    positions = np.stack([rho * np.cos(angle), rho * np.sin(angle), z], axis=-1)
    index = np.pad(np.arange(rho.size).reshape(rho.shape), ((0, 0), (0, 1)), mode="wrap")
    return positions.reshape(-1, 3), grid_quads(index)[:, ::-1]


def klein_bottle(rows: int = 128, columns: int = 40) -> tuple[Any, Any]:
    """The classic bottle, upright along z: its neck bends round and enters the body from the side.

    The last row meets the first mirrored, v against pi - v: the surface has one side only
    (`columns` even).
    """
    u, v = np.meshgrid(
        np.pi * np.arange(rows) / rows, 2 * np.pi * np.arange(columns) / columns, indexing="ij"
    )
    c, s, cv = np.cos(u), np.sin(u), np.cos(v)
    x = -2 / 15 * c * (3 * cv - 30 * s + 90 * c**4 * s - 60 * c**6 * s + 5 * c * s * cv)
    z = (
        -1
        / 15
        * s
        * (
            3 * cv
            - 3 * c**2 * cv
            - 48 * c**4 * cv
            + 48 * c**6 * cv
            - 60 * s
            + 5 * c * s * cv
            - 5 * c**3 * s * cv
            - 80 * c**5 * s * cv
            + 80 * c**7 * s * cv
        )
    )
    y = 2 / 15 * (3 + 5 * c * s) * np.sin(v)
    index = np.arange(u.size).reshape(u.shape)
    mirrored = index[0, (columns // 2 - np.arange(columns)) % columns]
    index = np.pad(np.vstack([index, mirrored]), ((0, 0), (0, 1)), mode="wrap")
    return np.stack([x, y, z], axis=-1).reshape(-1, 3), grid_quads(index)


def drape(rows: int = 90, columns: int = 260, folds: float = 4.8) -> tuple[Any, Any]:
    """A cloth in the x-z plane that hangs from a gathered top, in folds that lie over each other.

    Each level is a meander: its direction swings to and fro, below by more than a right angle, so
    that the folds hide parts of the cloth.
    """
    s, t = np.linspace(0, 1, columns + 1), np.linspace(0, 1, rows + 1)[:, None]
    phase = 2 * np.pi * folds * (s + 0.035 * np.sin(2 * np.pi * s + 1)) + 0.5 * t * np.cos(5 * s)
    swing = (0.6 + 1.2 * np.sqrt(t)) * (1 + 0.08 * np.sin(4.1 * s + 0.6) - 0.05 * np.cos(9 * s))
    heading = swing * np.cos(phase)
    step = np.stack([np.cos(heading), np.sin(heading)], axis=-1)
    plan = np.cumsum(step, axis=1) - step / 2
    plan -= plan.mean(axis=1, keepdims=True)
    width = np.ptp(plan[..., 0], axis=1)[:, None, None]
    plan *= (1.55 + 0.75 * t[..., None] ** 1.5) / width
    z = 2.2 * (1 - t) - 0.05 * np.sin(np.pi * s) + 0.03 * t * np.sin(phase)
    positions = np.concatenate([plan, z[..., None]], axis=-1)
    return positions.reshape(-1, 3), grid_quads(np.arange(z.size).reshape(z.shape))


def romboy(bend: float, cells: int = 48) -> tuple[Any, Any]:
    """Apery's way from the Roman surface (bend 0) to Boy's surface (bend 1): one-sided, closed.

    It is a sphere whose opposite points are one: three sides of the cube of `sphere`.
    """
    line = np.tan(np.linspace(-np.pi / 4, np.pi / 4, cells + 1))
    a, b = np.meshgrid(line, line, indexing="ij")
    one = np.ones_like(a)
    sides = [(one, a, b), (b, one, a), (a, b, one)]
    way = np.concatenate([np.stack(side, axis=-1).reshape(-1, 3) for side in sides])
    way /= np.linalg.norm(way, axis=1, keepdims=True)
    u = np.arctan2(way[:, 1], way[:, 0])
    v = np.arcsin(np.clip(way[:, 2], -1, 1))
    return _welded(_without_sign(way), _francis(u, v, 0.0, bend), cells + 1)


def _without_sign(way: Any) -> Any:
    """Of each direction and its opposite the same one."""
    rounded = np.round(way, 9)
    first = np.argmax(rounded != 0, axis=1)
    return way * np.sign(rounded[np.arange(len(way)), first])[:, None]


def venus(bend: float, rows: int = 96, columns: int = 128) -> tuple[Any, Any]:
    """Francis's Klein bottles: the Etruscan Venus (bend 0) and Ida (bend 1).

    The last row meets the first mirrored, v against -v: the surface has one side only.
    """
    u, v = np.meshgrid(
        np.pi * np.arange(rows) / rows, 2 * np.pi * np.arange(columns) / columns, indexing="ij"
    )
    index = np.arange(u.size).reshape(u.shape)
    mirrored = index[0, -np.arange(columns) % columns]
    index = np.pad(np.vstack([index, mirrored]), ((0, 0), (0, 1)), mode="wrap")
    return _francis(u, v, 1.0, bend).reshape(-1, 3), grid_quads(index)


def _francis(u: Any, v: Any, uncurled: float, bend: float) -> Any:
    """Ovals that sweep a surface; u says which, v where on it.

    Curled (0) each is run through twice and meets all others at one point, uncurled (1) it is
    run through once. The bend lifts them past each other.
    """
    scale = (uncurled + (1 - uncurled) * np.cos(v)) / (
        2 - bend * np.sqrt(2) * np.sin(3 * u) * np.sin(2 * v)
    )
    x = np.sqrt(2) * np.cos(2 * u) * np.cos(v) + 2 * np.cos(u) * np.sin(v)
    y = np.sqrt(2) * np.sin(2 * u) * np.cos(v) - 2 * np.sin(u) * np.sin(v)
    return np.stack([scale * x, scale * y, scale * 3 * np.cos(v)], axis=-1)


def torus_knot(turns: int, winds: int, points: int = 400) -> Any:
    """Points (n, 3) of the knot that goes `turns` times round a torus and winds round its tube."""
    t = 2 * np.pi * np.arange(points) / points
    rho = 1 + 0.42 * np.cos(winds * t)
    return np.column_stack(
        [rho * np.cos(turns * t), rho * np.sin(turns * t), 0.42 * np.sin(winds * t)]
    )

"""The native core: stages of a line illustration, from meshes to strokes.

World coordinates are the caller's; image coordinates are pixels, origin top left, y down.
Arguments that are arrays accept what `numpy.asarray` accepts. Arrays that are returned are
read-only views. An index names an element, -1 is none. Sizes in the shapes: n vertices,
t triangles, s strokes, p points of strokes, k nodes and a arcs of the curve network, q points of
arcs.
"""

import enum
from collections.abc import Callable, Iterable, Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

_Doubles: TypeAlias = NDArray[np.float64]
_Singles: TypeAlias = NDArray[np.float32]
_Indices: TypeAlias = NDArray[np.int32]
_Codes: TypeAlias = NDArray[np.uint8]
_Flags: TypeAlias = NDArray[np.bool_]

_Progress: TypeAlias = Callable[[float, str], bool | None]
"""Called with (fraction in [0, 1], name of the stage) from the calling thread; False cancels."""

class InvalidInput(ValueError):
    """Arrays, options or a camera that cannot be used; the message names the argument and index."""

class Cancelled(RuntimeError):
    """The progress function returned False."""

class Kind(enum.IntEnum):
    """What a curve is. The numbers never change."""

    SILHOUETTE = 0
    BOUNDARY = 1
    CREASE = 2
    INTERSECTION = 3
    HATCH = 4
    CROSS_HATCH = 5
    """Confined to cross-hatched regions."""
    UNDERCUT = 6
    MARK = 7
    MATERIAL = 8
    FLAT_OUTLINE = 9
    SEAM = 10
    """Where a non-manifold edge was split; never drawn."""
    SUGGESTIVE = 11
    """Suggestive contour."""
    RIDGE = 12
    """As seen from the viewer's side of the surface."""
    VALLEY = 13
    """As seen from the viewer's side of the surface."""
    LOOSE = 14
    """An edge of no face."""
    TERMINATOR = 15
    """Where a form turns away from a light."""
    SHADOW_OUTLINE = 16
    """Of a cast shadow, on what receives it."""

class Node(enum.IntEnum):
    """What a node of the curve network is."""

    CUSP = 0
    CROSSING = 1
    JOINT = 2
    END = 3

class Texture:
    """An image as luminance, linear in light. Immutable."""

    def __init__(self, luminance: ArrayLike, wrap: str = "repeat") -> None:
        """Copies its arguments.

        Args:
            luminance: (h, w) float, rows upwards from v = 0; negative or not finite: black.
            wrap: what is read outside of [0, 1]: 'repeat', 'mirror', 'extend' (the border) or
                'clip' (black).

        Raises:
            InvalidInput: no texel, wrong shape, an unknown wrap.
        """

class PolygonMesh:
    """Any polygon mesh in world space, whatever its defects. Immutable."""

    def __init__(
        self,
        positions: ArrayLike,
        face_sizes: ArrayLike,
        corner_vertices: ArrayLike,
        edge_vertices: ArrayLike | None = None,
        edge_sharpness: ArrayLike | None = None,
        vertex_sharpness: ArrayLike | None = None,
        marked_edges: ArrayLike | None = None,
        face_materials: ArrayLike | None = None,
        hole_faces: ArrayLike | None = None,
        boundary: str = "corners",
        crease_angle_deg: float = 180.0,
        scheme: str | None = None,
        level: int | None = None,
        edge_length: float | None = None,
        name: str = "",
        corner_normals: ArrayLike | None = None,
        cage: bool = True,
        loose_edges: ArrayLike | None = None,
        reflectance: ArrayLike | None = None,
        uv: ArrayLike | None = None,
        textures: Iterable[Texture] = (),
        face_textures: ArrayLike | None = None,
    ) -> None:
        """Copies its arguments.

        Args:
            positions: (n, 3) float, world space; vertices that are not finite are mended away.
            face_sizes: (f,) int, corners per face.
            corner_vertices: (sum of face_sizes,) int, vertex of each corner.
            edge_vertices: (e, 2) int, edges that carry a sharpness.
            edge_sharpness: (e,) float, 0 smooth .. 10 infinitely sharp (OpenSubdiv's scale).
            vertex_sharpness: (n,) float.
            marked_edges: (m, 2) int, drawn as Kind.MARK when asked for.
            face_materials: (f,) int, their borders drawn as Kind.MATERIAL when asked for.
            hole_faces: (h,) int, faces that shape the limit and are not there.
            boundary: 'corners' or 'edges' (OpenSubdiv's EDGE_AND_CORNER, EDGE_ONLY).
            crease_angle_deg: edges with a sharper turn become infinitely sharp; 180: none. With
                corner_normals, or where cage is False, only between faces that are shaded flat.
            scheme: this mesh's own, in place of PrepareOptions.scheme.
            level: this mesh's own, in place of PrepareOptions.level.
            edge_length: this mesh's own, in place of PrepareOptions.edge_length.
            name: for reports.
            corner_normals: (sum of face_sizes, 3) float, shading normals at the corners in the
                space of positions, of any length; zero or not finite: unknown, the face's own
                stands in. Edges where those of both faces differ are creases.
            cage: True: the vertices are the control mesh of a subdivision surface. False: the
                surface keeps to the mesh as it is shaded: to its vertices within a pixel or so,
                with corners where its boundaries turn, whatever `boundary` says.
            loose_edges: (l, 2) int, edges of no face, drawn as Kind.LOOSE when asked for: straight
                from vertex to vertex. They hide nothing; their points lie on no triangle (-1).
            reflectance: (f,) or (sum of face_sizes,) float, the share of the light that faces or
                corners throw back, in [0, 1] (luminance, linear); None: 1.
            uv: (sum of face_sizes, 2) float, places on the textures, v upwards.
            textures: what faces are covered with; their luminance is multiplied by reflectance.
            face_textures: (f,) int, index of each face's texture, -1: none. Needs uv.

        Raises:
            InvalidInput: wrong shapes, wrong types, indices out of range.
        """

    def instance(
        self,
        placement: ArrayLike,
        name: str | None = None,
        edge_length: float | None = None,
    ) -> PolygonMesh:
        """The same mesh at another place, which shares what is prepared of it.

        Args:
            placement: (4, 4) float, affine, points as columns. Where it is no similarity (it
                mirrors, or has more than one scale) the result is a mesh of its own.
            name: for reports; this mesh's where it is None.
            edge_length: its own, world units; this mesh's where it is None.
        """

    def deformed(
        self, positions: ArrayLike, corner_normals: ArrayLike | None = None
    ) -> PolygonMesh:
        """The same faces with their vertices elsewhere: the mesh in another frame.

        Args:
            positions: (n, 3) float, world space, as many as this mesh has.
            corner_normals: as those of the constructor; this mesh's where None, from which edges
                are known to be sharp.

        Raises:
            InvalidInput: another number of positions or normals.
        """

    @property
    def name(self) -> str:
        """As given."""
    @property
    def vertex_count(self) -> int:
        """As given, before mending."""
    @property
    def face_count(self) -> int:
        """As given, before mending."""

class Camera:
    """Perspective or orthographic, in OpenGL's convention. Immutable."""

    def __init__(
        self, projection: ArrayLike, view: ArrayLike, width_px: int, height_px: int
    ) -> None:
        """Copies its arguments.

        Args:
            projection: (4, 4) clip from view; the camera looks down -z.
            view: (4, 4) view from world.
            width_px: of the image, at least 1.
            height_px: of the image, at least 1.

        Raises:
            InvalidInput: matrices that are not finite or not a camera's, sizes below 1.
        """

    @property
    def projection(self) -> _Doubles:
        """(4, 4)."""
    @property
    def view(self) -> _Doubles:
        """(4, 4)."""
    @property
    def width_px(self) -> int:
        """Width of the image."""
    @property
    def height_px(self) -> int:
        """Height of the image."""

class Light:
    """One light. Immutable.

    Brightness is min(1, sum of strength * max(0, n . l)), n turned to the eye, spot and area times
    their cosine lobe. Without a `falloff_distance` it does not depend on the distance.
    """

    def __init__(
        self,
        kind: str,
        vector: ArrayLike | None = None,
        strength: float = 1.0,
        direction: ArrayLike | None = None,
        angle_rad: float | None = None,
        blend: float = 0.0,
        falloff_distance: float = 0.0,
        edges: ArrayLike | None = None,
        ellipse: bool = False,
        casts_shadows: bool = True,
        contours: bool = True,
        cosine: bool = True,
        spread_rad: float = ...,
        radius: float = 0.0,
    ) -> None:
        """Copies its arguments.

        Args:
            kind: 'head' (at the eye), 'side' (to the side of it), 'sun', 'point', 'spot', 'area',
                'ambient' (from everywhere).
            vector: (3,) of a sun: direction towards the light; of a side light: the same as the
                viewer sees it (right, up, towards the viewer), None: (-1, 1, 1); of point, spot
                and area: position, world.
            strength: at least 0.
            direction: (3,) where a spot or area light shines.
            angle_rad: half angle of a spot's cone.
            blend: share of a spot's cone over which it fades, [0, 1].
            falloff_distance: the distance, world, at which point, spot and area are as strong as
                `strength`, falling with the square of the distance; 0: as strong everywhere.
            edges: (2, 3) sides of the rectangle that an area light is, world, centred at its
                position; None: no larger than a point.
            ellipse: the ellipse that touches the rectangle's sides instead.
            casts_shadows: where DrawOptions.cast_shadows asks for them.
            contours: whether DrawOptions.terminators and shadow_outlines are about this light.
            cosine: a spot is weaker by the cosine from its axis; else by its `blend` only.
            spread_rad: the angle that an area's light stays within, as between slats, in (0, pi];
                there is as much light in all as without.
            radius: of the ball or disk that a point or spot is, world: strength falls with the sum
                of the squares of distance and radius. Shadows stay sharp.

        Raises:
            InvalidInput: an unknown kind, or what that kind needs is missing.
        """

    @property
    def kind(self) -> str:
        """As given."""
    @property
    def vector(self) -> _Doubles:
        """(3,)."""
    @property
    def direction(self) -> _Doubles:
        """(3,)."""
    @property
    def strength(self) -> float:
        """As given."""
    @property
    def angle_rad(self) -> float:
        """As given; 0 where none was given."""
    @property
    def blend(self) -> float:
        """As given."""
    @property
    def falloff_distance(self) -> float:
        """As given."""
    @property
    def edges(self) -> _Doubles:
        """(2, 3); 0 where none were given."""
    @property
    def ellipse(self) -> bool:
        """As given."""
    @property
    def casts_shadows(self) -> bool:
        """As given."""
    @property
    def contours(self) -> bool:
        """As given."""
    @property
    def cosine(self) -> bool:
        """As given."""
    @property
    def spread_rad(self) -> float:
        """As given; pi where none was given."""
    @property
    def radius(self) -> float:
        """As given."""

class Guide:
    """A stroke for the field to follow: a polyline on the surface or near it. Immutable."""

    def __init__(self, points: ArrayLike, weight: float = 10.0) -> None:
        """Copies its arguments.

        Args:
            points: (k, 3) float, world; each is moved to the nearest point of the surface. What is
                farther from it than a twentieth of the scene's diagonal guides nothing.
            weight: at each vertex that the stroke passes, against 1 for an edge of a triangle.

        Raises:
            InvalidInput: wrong shapes or types.
        """

    @property
    def points(self) -> _Doubles:
        """(k, 3)."""
    @property
    def weight(self) -> float:
        """As given."""

class PrepareOptions:
    """How meshes are prepared. Values are checked when they are used."""

    scheme: str
    """'auto', 'catmull-clark', 'loop' or 'none'."""
    level: int
    """Of subdivision; -1: the first whose median edge is at most edge_length, and whose chords
    where a coarse part bends stay within an eighth of it of their arcs, within the budget.
    """
    edge_length: float
    """World units; 0: 1/600 of the diagonal of all meshes."""
    triangle_budget: int
    """Binds automatic levels only, all meshes together."""
    threads: int
    """0: all cores."""
    field: bool
    """False: hatching curvature and field wait until first asked for; above 500,000 triangles also
    search trees and intersections."""
    most_intersections: int
    """Pairs of triangles that cross, beyond which objects have no curves where they pass through
    each other, or through themselves: those first that cross most."""
    rings: int
    """Rings of neighbours that the hatching curvature is fitted to, [1, 10]."""
    parabolic_ratio: float
    """A vertex is reliable where |k2| <= this * |k1|; 0: none is."""
    least_curvature: float
    """A vertex is reliable where |k1| >= this / the object's diagonal."""
    largest_energy: float
    """A vertex is reliable where the mean of 1 + e over its edges is at most this, [0, 2]."""
    alignment_weight: float
    """Soft pull of creases and boundaries."""
    inverse_length_weights: bool
    """Edges count in inverse proportion to their length, 1 in the mean; False: alike."""
    field_start: str
    """'search': the best of many fields; 'principal': near the principal directions."""
    guide_radius: float
    """No vertex so near a guide is reliable; share of the object's diagonal."""
    max_evaluations: int
    """Of the field's energy."""

    @property
    def guides(self) -> list[Guide]:
        """Strokes for the field to follow; a copy: assign a list to change it."""
    @guides.setter
    def guides(self, value: Sequence[Guide] | None) -> None: ...
    @property
    def singularities(self) -> tuple[_Doubles, _Indices] | None:
        """(positions (k, 3), quarter turns (k,)) that the field is to have, or None.

        They hold for the connected parts of the surface on which they lie, which then have no
        others; creases divide parts. On a closed part they must sum to 4 chi. Several quarter turns
        at one place become single ones in triangles close by.
        """
    @singularities.setter
    def singularities(self, value: tuple[ArrayLike, ArrayLike] | None) -> None: ...
    @property
    def default_direction(self) -> tuple[float, float, float]:
        """World direction of the field where nothing is reliable."""
    @default_direction.setter
    def default_direction(self, value: ArrayLike) -> None: ...
    def __init__(self, **options: object) -> None:
        """Defaults, and the attributes given by keyword. Raises TypeError for other keywords."""

class MaterialStyle:
    """What is drawn of the faces of one material, within what their object's style allows."""

    lines: bool
    hatching: bool
    spacing_scale: float
    """Of the hatches on it, times the object's, above 0."""
    width_scale: float
    """Of all strokes on it, at least 0."""
    pen: int
    """Of all strokes on it, which end where it changes, at least 0; 0: the object's."""

    def __init__(self, **options: object) -> None:
        """Defaults, and the attributes given by keyword. Raises TypeError for other keywords."""

class ObjectStyle:
    """What is drawn of one mesh."""

    ignore: bool
    """Left out entirely: neither drawn nor in front of anything."""
    see_through: bool
    """Hides nothing and is not hatched, as glass. Its own lines are drawn, but not in the graph."""
    occlude_only: bool
    """Hides what is behind it, but is not drawn."""
    shadow_only: bool
    """Left out as if ignored, but keeps the light from others."""
    shadow_catcher: bool
    """Without lines, and hatched only where others keep the light away."""
    lines: bool
    hatching: bool
    loose_edges: bool
    """Its edges of no face are drawn, whatever DrawOptions.loose_edges says."""
    spacing_scale: float
    """Of its hatches, above 0."""
    width_scale: float
    """Of all its strokes, at least 0."""
    pen: int
    """Of all its strokes, as Drawing.pens has it; at least 0."""
    materials: list[MaterialStyle]
    """By the numbers in PolygonMesh's face_materials; those beyond are drawn as the object.

    A copy: set the whole list.
    """

    def __init__(self, **options: object) -> None:
        """Defaults, and the attributes given by keyword. Raises TypeError for other keywords."""

class DrawOptions:
    """How a view is drawn. Values are checked when they are used."""

    hatching: bool
    """False: lines only, no tone."""
    hatch_seeding: str
    """Where hatches start: 'surface-curves', evened out, or the paper's 'critical-curves'."""
    spacing_px: float
    """Between hatches."""
    undercut_spacing_px: float
    """Between hatches inside undercuts."""
    least_spacing_px: float
    """Parts smaller than sixteen spacings are hatched finer, until their spacing is this.

    Undercuts in proportion. As large as spacing_px: no finer.
    """
    test_factor: float
    """A hatch ends this share of the spacing away from a parallel one.

    Like min_length_px for the paper's seeding, and in undercuts.
    """
    step_px: float
    """Length of a tracing step of the paper's seeding, at most a quarter of the spacing."""
    max_turn_deg: float
    """How far a hatch may turn in the world."""
    max_length_px: float
    """Length of a hatch."""
    min_length_px: float
    """Shorter hatches are dropped."""
    highlight_threshold: float
    """Brighter: highlight, not hatched."""
    shadow_threshold: float
    """At most as bright: shadow, hatched in two directions; else midtone, in one."""
    highlight_share: float | None
    """Share of the visible hatched objects' area that is highlight, in place of the threshold."""
    shadow_share: float | None
    """Share of it that is shadow, in place of the threshold; both together at most 1."""
    extra_levels: int
    """Into which shadows are divided further, [0, 3], each with one more set of hatches."""
    reflectance: float
    """How much the meshes' own reflectance counts, [0, 1]; 0: all are white."""
    exposure: float
    """The light is multiplied by it; above 0."""
    auto_exposure: bool
    """Whether the light is also multiplied by what suits the view: the lightest places white, not
    more than 60 % of the area shadow, or highlight. ToneMap.exposure says what came of both."""
    cast_shadows: bool
    """Whether surfaces keep the light from others."""
    smallest_tone: float
    """Patches of one tone smaller than a square of so many spacings join their neighbour, [0, 20];
    0: all stay, and edges of tone are as rough as the light."""
    tone_image: ArrayLike | None
    """(h, w) light that comes back, linear, 1 as bright as white paper, rows downwards: in place of
    lights and reflectance, stretched over the view. What is negative or not finite is black."""
    mach_bands: bool
    """Blank bands on the near side of folds."""
    undercuts: bool
    """Dense hatching beyond folds."""
    mach_band_px: float
    """Width of Mach bands."""
    undercut_contact: float
    """How near what lies beyond a fold must be for an undercut: 0: anywhere, 1: touching."""
    undercut_px: float
    """Width of undercuts."""
    cell_px: float
    """Cells of the tone map, [0.25, 64]; larger where the image has over 16 million of them."""
    line_width_px: float
    """Of silhouettes and boundaries."""
    feature_width_px: float
    """Of all other lines."""
    hatch_width_px: float
    """Of hatches at the border of shadow and midtone."""
    hatch_width_by_light: float
    """Share by which hatches swell towards the dark and thin towards highlights, [0, 1]."""
    line_width_by_light: float
    """Share by which lines swell on the side of a form that is turned from the light, [0, 1]."""
    line_width_by_depth: float
    """Share by which the nearest lines swell and the farthest thin out, [0, 1]."""
    inner_width_scale: float
    """Of lines that have the same object on both sides."""
    line_width_by_crowding: float
    """How far lines thin out where gaps between them would close, [0, 1]."""
    hidden_width_scale: float
    """Of hidden lines."""
    taper_px: float
    """Length over which ends that meet no other line thin out."""
    speck_px: float
    """Shorter lines are dropped unless they close a gap."""
    simplify_px: float
    """How far a stroke may be from its curve."""
    marks: bool
    """Draw marked edges."""
    materials: bool
    """Draw borders between materials."""
    flat_outlines: bool
    """Draw outlines of flat areas."""
    loose_edges: bool
    """Draw edges of no face (PolygonMesh's loose_edges)."""
    scan_silhouettes: bool
    """Look at every triangle for silhouettes instead of searching: slower, the same drawing."""
    visibility: str
    """'labels', which cannot contradict each other, or 'vote', the paper's own, for comparison.

    By vote every arc of the graph has 0 or 1 layers in front, and no rule holds between them.
    """
    suggestive_contours: bool
    """Draw suggestive contours: where the surface nearly turns away from the eye."""
    ridges: bool
    """Draw ridges of smooth surfaces."""
    valleys: bool
    """Draw valleys of smooth surfaces."""
    suggestive_threshold: float
    """Least growth of the radial curvature towards the eye, times the object's diagonal squared."""
    ridge_threshold: float
    """Least curvature across a ridge, times the object's diagonal."""
    valley_threshold: float
    """Least curvature across a valley, times the object's diagonal."""
    terminators: bool
    """Draw where smooth forms turn away from the lights, as far as their light reaches there."""
    shadow_outlines: bool
    """Draw the outlines of cast shadows on what receives them."""
    styles: Sequence[ObjectStyle] | None
    """One per mesh, or None."""
    threads: int
    """0: all cores."""

    @property
    def hidden_lines(self) -> tuple[int, int] | None:
        """(low, high): also lines with so many layers in front, inclusive; None: visible only."""
    @hidden_lines.setter
    def hidden_lines(self, value: Sequence[int] | None) -> None: ...
    def __init__(self, **options: object) -> None:
        """Defaults, and the attributes given by keyword. Raises TypeError for other keywords."""

class Surface:
    """The triangulated limit surface of all meshes.

    A vertex on a crease stands once for each smooth side, with that side's normal and curvature.
    Vertices and triangles have an order of their own, the same in every pose of a mesh.
    """

    @property
    def positions(self) -> _Doubles:
        """(n, 3) world."""
    @property
    def normals(self) -> _Doubles:
        """(n, 3) unit; at the seam of a surface that cannot be oriented, of one of its sheets."""
    @property
    def triangles(self) -> _Indices:
        """(t, 3) vertices, counter-clockwise seen from the front."""
    @property
    def objects(self) -> _Indices:
        """(n,) mesh of each vertex."""
    @property
    def base_faces(self) -> _Indices:
        """(n,) ptex face of the base meshes, one mesh after another.

        -1 for scheme 'none', and where the surface leaves the limit to keep to a mesh that is no
        cage.
        """
    @property
    def base_uv(self) -> _Doubles:
        """(n, 2) where on that face."""
    @property
    def triangle_faces(self) -> _Indices:
        """(t,) face of the mesh that each triangle is a piece of."""
    @property
    def feature_edges(self) -> _Indices:
        """(e, 2) vertices; a crease edge once for each side."""
    @property
    def feature_kinds(self) -> _Codes:
        """(e,) Kind of each feature edge."""
    def evaluate(
        self, base_faces: ArrayLike, base_uv: ArrayLike
    ) -> tuple[_Doubles, _Doubles, _Doubles, _Doubles, _Doubles, _Doubles]:
        """The limit surface and its derivatives at any of its points (paper section 3).

        base_faces (m,) and base_uv (m, 2) as `base_faces` and `base_uv` have them: in [0, 1]^2 on
        quads, u, v >= 0 and u + v <= 1 on the triangles of Loop's scheme. Returns position, du, dv,
        duu, duv and dvv, each (m, 3). Within 1/64 of an extraordinary vertex the second derivatives
        have no meaning: there the surface has none. What a face needs is made once and kept.

        Raises InvalidInput for a face that does not exist (scheme 'none' has none), where the
        surface leaves the limit to keep to a mesh that is no cage, for a face of more than 100
        corners or with more than 100 edges at a corner, and for coordinates outside of it.
        """
    @property
    def k1(self) -> _Doubles:
        """(n,) principal curvature for silhouettes and cusps, 1 / world units; |k1| >= |k2|.

        Positive where the surface bends towards the normal's side. Objects of scheme 'none' have
        the hatching curvature only, and show it here too.
        """
    @property
    def k2(self) -> _Doubles:
        """(n,) the other principal curvature."""
    @property
    def w1(self) -> _Doubles:
        """(n, 3) unit tangent, direction of k1."""
    @property
    def w2(self) -> _Doubles:
        """(n, 3) unit tangent, direction of k2."""
    @property
    def hatch_k1(self) -> _Doubles:
        """(n,) principal curvature for hatching, smoother."""
    @property
    def hatch_k2(self) -> _Doubles:
        """(n,) the other one."""
    @property
    def hatch_w1(self) -> _Doubles:
        """(n, 3) unit tangent, direction of hatch_k1."""
    @property
    def hatch_w2(self) -> _Doubles:
        """(n, 3) unit tangent, direction of hatch_k2."""

class CrossField:
    """Four directions at each vertex, at right angles to each other, that vary smoothly."""

    @property
    def theta(self) -> _Doubles:
        """(n,) radians against `reference`."""
    @property
    def reference(self) -> _Doubles:
        """(n, 3) unit tangent."""
    @property
    def directions(self) -> _Doubles:
        """(n, 3) one unit tangent of the cross."""
    @property
    def reliable(self) -> _Flags:
        """(n,) where the curvature directions were kept."""
    @property
    def energy(self) -> float:
        """What was minimised, E over all edges of the triangles, without soft alignments.

        With the terms of guides; by the adjusted connection where singularities are prescribed.
        """
    @property
    def energy_initial(self) -> float:
        """E of the start."""
    @property
    def converged(self) -> bool:
        """False where the solver stopped at max_evaluations."""
    @property
    def evaluations(self) -> int:
        """Of the energy."""
    @property
    def singular_triangles(self) -> _Indices:
        """(s,) triangles around which the cross turns."""
    @property
    def singular_indices(self) -> _Indices:
        """(s,) quarter turns; over a closed surface they sum to 4 chi."""
    @property
    def singular_positions(self) -> _Doubles:
        """(s, 3) world, middles of those triangles."""

class HatchCurves:
    """Nested curves along the cross field, in rank order, that hatches start from in every view."""

    @property
    def offsets(self) -> _Indices:
        """(c + 1,) curve i is points offsets[i] .. offsets[i + 1]."""
    @property
    def points(self) -> _Doubles:
        """(p, 3) world."""
    @property
    def triangles(self) -> _Indices:
        """(p,) triangle of the surface that the point lies on."""
    @property
    def barycentrics(self) -> _Doubles:
        """(p, 2) weights of that triangle's corners 1 and 2."""

class Prepared:
    """Everything of a scene that does not depend on the view. Immutable; threads may share it."""

    @property
    def surface(self) -> Surface:
        """All meshes in one."""
    @property
    def left_out_intersections(self) -> list[tuple[int, int]]:
        """Pairs of meshes that cross in more triangles than `most_intersections` allows."""
    @property
    def field(self) -> CrossField:
        """Solved when first asked for, unless PrepareOptions.field asked for it at once."""
    @property
    def hatch_curves(self) -> HatchCurves:
        """Made when first asked for, or when a view is first hatched."""
    @property
    def report(self) -> dict[str, int]:
        """What was found and mended, summed over all meshes."""
    @property
    def reports(self) -> list[dict[str, int | str]]:
        """What was mended in each mesh, with its 'name'."""
    @property
    def timings(self) -> dict[str, float]:
        """Seconds per stage, so far.

        'sanitize', 'surface', 'dual_surface', 'intersections', 'curvature', 'field' and
        'hatch_curves'. What was taken over from `previous` took none.
        """

def prepare(
    meshes: Iterable[PolygonMesh],
    options: PrepareOptions | None = None,
    progress: _Progress | None = None,
    previous: Prepared | None = None,
) -> Prepared:
    """Mends and subdivides meshes, and finds what every view of them needs.

    Args:
        meshes: one object each; one without faces stays an object that shows nothing.
        options: None: the defaults.
        progress: told how far it is.
        previous: what it made from the same meshes with the same options is taken over. Of meshes
            that changed, those of the same name and form that rest or have moved as rigid bodies
            keep their surface, field and families, where the length of their edges or their level
            is given (by `PolygonMesh` or the options; without, both go by the size of the scene).
            Where the vertices are the same and its field is solved, the search for this field
            starts there, and families and seeds of hatches stay: a mesh that deforms keeps its
            hatching.

    Raises:
        InvalidInput: an option out of its range, named; singularities that cannot be.
        Cancelled: progress returned False. What progress raises passes through.
    """

def start_prepare(
    meshes: Iterable[PolygonMesh],
    options: PrepareOptions | None = None,
    previous: Prepared | None = None,
) -> Job:
    """`prepare` as a job, whose result is a Prepared."""

def solve_cross_field(
    prepared: Prepared,
    options: PrepareOptions | None = None,
    progress: _Progress | None = None,
) -> CrossField:
    """The cross field of a prepared surface, anew, with the field's options of `options`.

    Raises InvalidInput and Cancelled as `prepare` does.
    """

class Silhouettes:
    """Where the surface turns away from the eye."""

    @property
    def triangles(self) -> _Indices:
        """(m,) triangles that carry a silhouette, ascending."""

def silhouettes(prepared: Prepared, camera: Camera, brute_force: bool = False) -> Silhouettes:
    """The triangles that carry silhouettes, found by the dual search.

    brute_force tells them from the signs at the corners of every triangle instead, as a check.
    """

class Graph:
    """The labelled curve network of a view, clipped at the near plane but not at the frame."""

    @property
    def node_kind(self) -> _Codes:
        """(k,) Node."""
    @property
    def node_image(self) -> _Doubles:
        """(k, 2) px."""
    @property
    def node_arcs(self) -> _Indices:
        """(k, 4) of a crossing: front in, front out, back in, back out; of a cusp: near, far.

        "In" arcs end at the node, "out" arcs start there. Else -1.
        """
    @property
    def arc_nodes(self) -> _Indices:
        """(a, 2) start and end; (-1, -1) for a closed loop without nodes."""
    @property
    def arc_kind(self) -> _Codes:
        """(a,) Kind."""
    @property
    def arc_object(self) -> _Indices:
        """(a,) mesh that the curve lies on."""
    @property
    def arc_invisibility(self) -> _Indices:
        """(a,) layers of surface in front: what the rules of crossings and cusps are about."""
    @property
    def arc_flush(self) -> _Codes:
        """(a,) 1 where it runs within a face of another part in the same plane."""
    @property
    def arc_layers_over(self) -> _Indices:
        """(a,) layers that hide it as a line: at least 1 where it is flush. What shows has 0."""
    @property
    def arc_offsets(self) -> _Indices:
        """(a + 1,) arc i is points arc_offsets[i] .. arc_offsets[i + 1]."""
    @property
    def arc_image(self) -> _Doubles:
        """(q, 2) px; a closed loop does not repeat its first point."""
    @property
    def arc_points(self) -> _Doubles:
        """(q, 3) world."""

class ToneMap:
    """Light and shadow on a grid of h x w cells over the image; (0, 0) without hatching."""

    @property
    def level(self) -> _Codes:
        """(h, w) 0 highlight, 1 midtone, 2 shadow, 255 no surface."""
    @property
    def band(self) -> _Codes:
        """(h, w) 0 none, 1 Mach band, 2 undercut."""
    @property
    def brightness(self) -> _Singles:
        """(h, w) in [0, 1]; 0 where there is no surface."""
    @property
    def extra(self) -> _Codes:
        """(h, w) 1 to extra_levels in the deeper shadows, else 0; (0, 0) without extra_levels."""
    @property
    def highlight_threshold(self) -> float:
        """Brighter is highlight: as given, or what gives its share."""
    @property
    def shadow_threshold(self) -> float:
        """At most as bright is shadow: as given, or what gives its share."""
    @property
    def exposure(self) -> float:
        """What the light was multiplied by."""
    @property
    def cell_px(self) -> float:
        """Side of a cell."""

class Drawing:
    """One finished view: strokes, clipped at the frame."""

    @property
    def points(self) -> _Doubles:
        """(p, 3) world."""
    @property
    def image(self) -> _Doubles:
        """(p, 2) px."""
    @property
    def widths(self) -> _Singles:
        """(p,) px."""
    @property
    def triangles(self) -> _Indices:
        """(p,) triangle of the surface that the point lies on."""
    @property
    def barycentrics(self) -> _Singles:
        """(p, 2) weights of that triangle's corners 1 and 2."""
    @property
    def offsets(self) -> _Indices:
        """(s + 1,) stroke i is points offsets[i] .. offsets[i + 1]."""
    @property
    def kinds(self) -> _Codes:
        """(s,) Kind."""
    @property
    def closed(self) -> _Flags:
        """(s,) a closed stroke does not repeat its first point."""
    @property
    def objects(self) -> _Indices:
        """(s,) mesh."""
    @property
    def invisibility(self) -> _Indices:
        """(s,) layers of surface in front; 0 is visible."""
    @property
    def pens(self) -> _Indices:
        """(s,) as the styles of objects and materials have it; 0 where they have none."""
    @property
    def frame(self) -> int:
        """How many drawings came before in the sequence; 0 without a previous one."""
    @property
    def stroke_ids(self) -> _Indices:
        """(s,) number that a stroke keeps through the frames of a sequence."""
    @property
    def stroke_births(self) -> _Indices:
        """(s,) the frame in which each stroke was first."""
    @property
    def stroke_starts(self) -> _Doubles:
        """(s,) px along the stroke that its first point counts as.

        So dashes and textures stay in place through the frames.
        """
    @property
    def stroke_deaths(self) -> _Indices:
        """(d,) numbers of the previous drawing's strokes that have no heir, ascending."""
    @property
    def graph(self) -> Graph:
        """The curves that the lines come from."""
    @property
    def repair_max_px(self) -> float:
        """The farthest that a repair moved a point."""
    @property
    def tone(self) -> ToneMap:
        """What the hatching goes by."""
    @property
    def counts(self) -> dict[str, int]:
        """Exact work, the same on every machine."""
    @property
    def timings(self) -> dict[str, float]:
        """Seconds of 'contour', 'visibility', 'tone', 'hatch', 'stroke', disjoint."""

def draw(
    prepared: Prepared,
    camera: Camera,
    options: DrawOptions | None = None,
    lights: Iterable[Light] | None = None,
    progress: _Progress | None = None,
    previous: Drawing | None = None,
) -> Drawing:
    """One view of a prepared scene. The same input gives the same bytes at any thread count.

    Args:
        prepared: the scene; its field and self-intersections are made now if they were left out.
        camera: the view.
        options: None: the defaults.
        lights: none: one headlight.
        progress: told how far it is.
        previous: the drawing of the frame before: its strokes live on. Of the same scene, or of
            one with the same vertices that has moved, its hatches are kept where they can be.
            Objects are found again by their names.

    Raises:
        InvalidInput: an option, style or light out of its range, named.
        Cancelled: progress returned False. What progress raises passes through.
    """

def start_draw(
    prepared: Prepared,
    camera: Camera,
    options: DrawOptions | None = None,
    lights: Iterable[Light] | None = None,
    previous: Drawing | None = None,
) -> Job:
    """`draw` as a job, whose result is a Drawing. What it is given may be changed meanwhile."""

def view(
    prepared: Prepared,
    camera: Camera,
    options: DrawOptions | None = None,
    lights: Iterable[Light] | None = None,
    progress: _Progress | None = None,
) -> View:
    """Lines and tones of a view: the first half of `draw`, which needs no previous drawing.

    In a sequence it may be made while the frame before is still being drawn.

    Args:
        prepared: as in `draw`, like all the others.
        camera: the view.
        options: None: the defaults.
        lights: none: one headlight.
        progress: told how far it is.

    Raises:
        InvalidInput: as `draw`.
        Cancelled: progress returned False. What progress raises passes through.
    """

def start_view(
    prepared: Prepared,
    camera: Camera,
    options: DrawOptions | None = None,
    lights: Iterable[Light] | None = None,
) -> Job:
    """`view` as a job, whose result is a View. What it is given may be changed meanwhile."""

class View:
    """A view before it is hatched: its lines, labelled, and its tones. It does not change."""

    @property
    def exposure(self) -> float:
        """What the light was multiplied by; 1 where nothing is hatched."""
    def draw(
        self,
        progress: _Progress | None = None,
        previous: Drawing | None = None,
        detail: str = "whole",
    ) -> Drawing:
        """The drawing of the view, the same that `draw` makes at once.

        Args:
            progress: told how far it is.
            previous: the drawing of the frame before, as in `draw`.
            detail: 'lines' alone; a 'draft', whose hatches are as they are first placed, with gaps
                and uneven, in less than half of the time; or the 'whole'.

        Raises:
            InvalidInput: a detail that there is none of.
            Cancelled: progress returned False. What progress raises passes through.
        """
    def start_draw(self, previous: Drawing | None = None, detail: str = "whole") -> Job:
        """`draw` as a job, whose result is a Drawing."""

def rough_silhouettes(prepared: Prepared, camera: Camera) -> _Singles:
    """Silhouettes for a viewer that redraws while it moves: quick, not exact, hidden ones too.

    Returns:
        (2 s, 3) world, the ends of segments, in no order: the zero set of n . (c - p), linear on
        each triangle, and edges of polygon objects between a front and a back face.
    """

def rough_features(prepared: Prepared) -> _Singles:
    """Lines that every view has: creases, boundaries, and where surfaces pass through each other.

    Returns:
        (2 s, 3) world, the ends of segments, in no order.
    """

class Job:
    """Work in a thread of its own, which holds no Python object and never waits for Python's lock.

    A job that is dropped is cancelled and waited for: keep one that was cancelled until it is done.
    """

    @property
    def is_done(self) -> bool:
        """True when there is a result or an error."""
    def poll(self) -> tuple[float, str]:
        """How far it is: a share in [0, 1] that never falls, and the name of the stage."""
    def cancel(self) -> None:
        """Asks it to stop, and does not wait; it ends with Cancelled."""
    def wait(self, seconds: float) -> bool:
        """Waits for the end, at most so long; True when it has come."""
    def result(self) -> Any:
        """What it made, as often as it is asked for.

        Raises:
            InvalidInput: it is not done; or what `prepare` and `draw` raise it for.
            Cancelled: it was told to stop in time.
        """

def stop_jobs() -> None:
    """Cancels all jobs and waits for their ends, as is done when Python ends."""

def rasterise(
    image: ArrayLike,
    widths: ArrayLike,
    offsets: ArrayLike,
    closed: ArrayLike,
    colours: ArrayLike,
    width_px: int,
    height_px: int,
    paper: ArrayLike = (255, 255, 255, 255),
    threads: int = 0,
) -> NDArray[np.uint8]:
    """Strokes as pixels: what a round pen of their widths covers, each over those before it.

    Args:
        image: (p, 2) px, origin top left, y down.
        widths: (p,) px.
        offsets: (s + 1,) int: stroke i is the points offsets[i] to offsets[i + 1].
        closed: (s,) bool, the last point is joined to the first.
        colours: (s, 4) red, green, blue, alpha in [0, 255], as encoded in sRGB.
        width_px: of the picture, at most 32768.
        height_px: of the picture, at most 32768.
        paper: (4,) its colour.
        threads: 0: all cores. The same bytes at any number.

    Returns:
        (height_px, width_px, 4) uint8.

    Raises:
        InvalidInput: arrays that do not fit together.
    """

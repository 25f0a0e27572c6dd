# SPDX-License-Identifier: LGPL-2.1-or-later
"""The preview's nodes in the 3D view: floors, paths and the cutter.

They hang below the operation's own root node, so that they are in every view of the
document and go with the operation; while they are shown the operation's own path is
not, which is the same path or an outdated one. Nothing of this is part of the document.
Paths are few nodes with many vertices: a line set for each kind of motion, which the
player cuts off at a vertex.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray
from pivy import coin

from ...engine.model import Floats
from ...engine.toolpath import Role
from . import colors

if TYPE_CHECKING:
    from ...engine.draft import Draft
    from ...trace import Areas, Trace

#: Faces lie this far above the floor, paths a little higher, so that both show on it [mm].
FACES_ABOVE, LINES_ABOVE = 0.02, 0.04
TRANSPARENCY = 0.65
WIDTHS = {"cut": 2.0, "entry": 1.5, "link": 1.0, "air": 1.0}  # pixels
DASHES = 0xF0F0
NAME = "SpiralPocketPreview"


class Scene:
    """All nodes of one preview."""

    def __init__(self, view_object: Any) -> None:
        self._view_object = view_object
        self._root = coin.SoSeparator()
        self._root.setName(NAME)
        unpickable = coin.SoPickStyle()
        unpickable.style = coin.SoPickStyle.UNPICKABLE
        light = coin.SoLightModel()
        light.model = coin.SoLightModel.BASE_COLOR
        self._content, self._cutter = coin.SoSeparator(), Cutter()
        for node in (unpickable, light, self._content, self._cutter.root):
            self._root.addChild(node)
        self._hidden: int | None = None
        view_object.RootNode.addChild(self._root)

    def show(self, items: Sequence[Any]) -> None:
        """Show these items, each with a node `root`, and nothing else."""
        self._content.removeAllChildren()
        for item in items:
            self._content.addChild(item.root)
        self._hide_path(bool(items))

    def place_cutter(self, point: Floats | None, radius: float = 1.0, height: float = 1.0) -> None:
        """Show the cutter with its tip at a point [mm], or nowhere."""
        self._cutter.place(point, radius, height)

    def close(self) -> None:
        """Remove everything."""
        try:
            self._hide_path(False)
            self._view_object.RootNode.removeChild(self._root)
        except ReferenceError:
            return  # the operation is gone, and its root node with it

    def _hide_path(self, hide: bool) -> None:
        """Switch the operation's own path off or back; its `Visibility` stays as it is."""
        switch = self._view_object.SwitchNode
        if hide and self._hidden is None:
            self._hidden = switch.whichChild.getValue()
        if hide:
            switch.whichChild.setValue(coin.SO_SWITCH_NONE)
        elif self._hidden is not None:
            switch.whichChild.setValue(self._hidden)
            self._hidden = None


class DraftItem:
    """Rough laps in one color."""

    def __init__(self, draft: Draft) -> None:
        self.root = coin.SoSeparator()
        z = draft.z + LINES_ABOVE
        for lines, color, width in (
            (draft.laps, colors.DRAFT, WIDTHS["cut"]),
            (draft.entries, colors.ENTRY, WIDTHS["entry"]),
        ):
            if lines:
                vertices = np.concatenate([np.column_stack([p, np.full(len(p), z)]) for p in lines])
                node = _Lines(vertices, np.array([color]), width)
                node.cut_into(np.array([len(p) for p in lines]))
                self.root.addChild(node.root)


class PathItem:
    """A proved path, colored, on its floor."""

    def __init__(self, trace: Trace, areas: Areas, z: float, scale: colors.Scale) -> None:
        self.root = coin.SoSeparator()
        self._trace = trace
        self._layers = [
            layer
            for layer in (
                _Layer("air", trace, trace.roles == Role.AIR, colors.AIR),
                _Layer("link", trace, trace.roles == Role.LINK, colors.LINK),
                _Layer("entry", trace, trace.roles == Role.ENTRY, colors.ENTRY),
                _Layer("cut", trace, colors.is_cut(trace), scale.colors(trace)),
            )
            if layer.is_drawn
        ]
        for rings, color in (
            (areas.cleared, colors.CLEARED),
            (areas.left, colors.LEFT),
            (areas.islands, colors.ISLAND),
        ):
            if rings:
                self.root.addChild(_faces(rings, z + FACES_ABOVE, color))
        for layer in self._layers:
            self.root.addChild(layer.lines.root)

    def play(self, seconds: float) -> None:
        """Show the path up to a time of its own [s]."""
        last = int(np.searchsorted(self._trace.clock, seconds, side="right"))
        for layer in self._layers:
            layer.cut_off(last)

    def color(self, scale: colors.Scale) -> None:
        """Color the cuts by another scale."""
        for layer in self._layers:
            if layer.kind == "cut":
                layer.color(scale.colors(self._trace))


class Cutter:
    """A translucent cylinder."""

    def __init__(self) -> None:
        self.root = coin.SoSwitch()
        group, light, material = coin.SoSeparator(), coin.SoLightModel(), coin.SoMaterial()
        light.model = coin.SoLightModel.PHONG
        material.diffuseColor = colors.CUTTER
        material.transparency = 0.4
        self._shift, upright = coin.SoTranslation(), coin.SoRotationXYZ()
        upright.axis, upright.angle = coin.SoRotationXYZ.X, np.pi / 2
        self._cylinder = coin.SoCylinder()
        for node in (light, material, self._shift, upright, self._cylinder):
            group.addChild(node)
        self.root.addChild(group)
        self.place(None, 1.0, 1.0)

    def place(self, point: Floats | None, radius: float, height: float) -> None:
        """Move the tip to a point [mm], or vanish."""
        self.root.whichChild = coin.SO_SWITCH_NONE if point is None else coin.SO_SWITCH_ALL
        if point is not None:
            x, y, z = (float(v) for v in point)
            self._shift.translation = (x, y, z + height / 2)
            self._cylinder.radius, self._cylinder.height = radius, height


class _Lines:
    """A line set with a color for each vertex, or one for all."""

    def __init__(self, vertices: Floats, rgb: Floats, width: float, dashes: int = 0xFFFF) -> None:
        self.root = coin.SoSeparator()
        style = coin.SoDrawStyle()
        style.lineWidth, style.linePattern = width, dashes
        self._property = coin.SoVertexProperty()
        self._property.vertex.setValues(0, len(vertices), vertices.astype(np.float32))
        self._property.materialBinding = (
            coin.SoMaterialBinding.OVERALL if len(rgb) == 1 else coin.SoMaterialBinding.PER_VERTEX
        )
        self.color(rgb)
        self._set = coin.SoLineSet()
        self._set.vertexProperty = self._property
        self.root.addChild(style)
        self.root.addChild(self._set)

    def color(self, rgb: Floats) -> None:
        """Set the color of each vertex, or that of all."""
        self._property.orderedRGBA.setValues(0, len(rgb), colors.packed(rgb).tolist())

    def cut_into(self, counts: NDArray[np.int64]) -> None:
        """Draw runs of so many vertices each."""
        field = self._set.numVertices
        field.setNum(len(counts))
        if len(counts):
            field.setValues(0, len(counts), counts.tolist())


class _Layer:
    """One kind of motion of a trace: its runs, and the vertices of the trace they begin at."""

    def __init__(self, kind: str, trace: Trace, chosen: Any, rgb: Any) -> None:
        self.kind = kind
        edges = np.diff(np.r_[False, chosen, False].astype(np.int8))
        self._firsts, ends = np.flatnonzero(edges == 1), np.flatnonzero(edges == -1)
        self._counts = ends - self._firsts + 1
        self.is_drawn = len(ends) > 0
        if not self.is_drawn:
            return
        parts = [np.arange(a, b + 1) for a, b in zip(self._firsts, ends, strict=True)]
        self._vertices = np.concatenate(parts)
        dashes = DASHES if kind == "air" else 0xFFFF
        points = trace.points[self._vertices] + (0.0, 0.0, LINES_ABOVE)
        self.lines = _Lines(points, self._of_vertices(rgb), WIDTHS[kind], dashes)
        self.lines.cut_into(self._counts)

    def color(self, rgb: Floats) -> None:
        """Color the stretches."""
        self.lines.color(self._of_vertices(rgb))

    def cut_off(self, last: int) -> None:
        """Draw nothing from a vertex of the trace on."""
        shown = np.clip(last - self._firsts, 0, self._counts)
        # the first run without vertices ends the set: Coin takes -1 and 0 for "the rest"
        self.lines.cut_into(shown[: int(np.argmax(shown < 2)) if (shown < 2).any() else None])

    def _of_vertices(self, rgb: Any) -> Floats:
        """Return the colors of the vertices from those of the stretches that end there."""
        if np.ndim(rgb) == 1:
            return np.tile(rgb, (len(self._vertices), 1))
        return rgb[np.maximum(self._vertices - 1, 0)]


def _faces(rings: Sequence[Floats], z: float, color: tuple[float, float, float]) -> Any:
    """Return level, translucent faces within rings of any shape."""
    group = coin.SoSeparator()
    material = coin.SoMaterial()
    material.diffuseColor = color
    material.transparency = TRANSPARENCY
    hints = coin.SoShapeHints()
    hints.faceType = coin.SoShapeHints.UNKNOWN_FACE_TYPE
    hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
    points = np.concatenate([np.column_stack([r, np.full(len(r), z)]) for r in rings])
    coordinates, faces = coin.SoCoordinate3(), coin.SoFaceSet()
    coordinates.point.setValues(0, len(points), points.astype(np.float32))
    faces.numVertices.setValues(0, len(rings), [len(r) for r in rings])
    for node in (material, hints, coordinates, faces):
        group.addChild(node)
    return group

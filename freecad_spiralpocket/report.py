# SPDX-License-Identifier: LGPL-2.1-or-later
"""A page about a program or an operation: the figures and the papers' plots.

Reads G-code anywhere; of a FreeCAD document (inside FreeCAD's Python) it takes the path of
an operation with its tool, depths and step-over. Writes one HTML file with the pictures in it.
"""

from __future__ import annotations

import argparse
import base64
import html
import io
import re
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from shapely import Polygon

from . import gcode, machines
from .arguments import positive, positive_whole
from .engine.errors import RequestError, SetupError, SpiralPocketError
from .engine.motion.force import MATERIALS, Cutter
from .engine.stepover import engagement_angle
from .engine.toolpath import Kind, Toolpath
from .study import Setup, Study

#: Where the program does not say [1/min].
SPINDLE_SPEED = 10_000.0
MACHINE = "vmc"
#: Heights closer than this are one level [mm].
SAME_HEIGHT = 1e-3
#: A level is as long as this over the longest: no loop of a slot that opens one.
LEVEL = 0.5

_STYLE = """body{font:15px/1.5 sans-serif;max-width:1100px;margin:2em auto;padding:0 1em}
table{border-collapse:collapse}td{padding:.15em 1.5em .15em 0}img{max-width:100%}
figure{margin:1.5em 0}figcaption{color:#555}"""


@dataclass(frozen=True)
class Source:
    """A toolpath and what its file says about it; None where it says nothing."""

    toolpath: Toolpath
    diameter: float | None = None
    spindle_speed: float | None = None
    axial_depth: float | None = None
    top: float | None = None
    stepover: float | None = None
    stock: Polygon | None = None
    machine: str | None = None
    climb: bool = True


def parser() -> argparse.ArgumentParser:
    """Return the parser of the command line."""
    p = argparse.ArgumentParser(
        prog="./dev report", description="Write a page with the figures and plots of a program."
    )
    add = p.add_argument
    add("file", type=Path, help="G-code, or a FreeCAD document with an operation")
    add(
        "-o",
        "--output",
        type=Path,
        metavar="FILE",
        help="page to write, beside the file if not given",
    )
    add("--operation", metavar="LABEL", help="of the document, the first one if not given")
    add("--tool", type=positive, metavar="D", help="diameter of the end mill [mm]")
    add("--flutes", type=positive_whole, default=2)
    add("--helix", type=float, default=30.0, metavar="DEG", help="helix angle of the flutes")
    add("--stepover", type=positive, metavar="MM", help="largest radial depth of cut [mm]")
    add(
        "--axial-depth",
        type=positive,
        metavar="MM",
        help="of a full cut; how far the program's levels are apart if not given",
    )
    add("--top", type=float, metavar="Z", help="top of the stock, 0 if not given")
    add("--spindle", type=positive, metavar="RPM", help="spindle speed")
    add("--conventional", action="store_true", help="the program mills conventionally")
    add("--machine", help=f"preset, such as hobby_router; the operation's own or {MACHINE}")
    add("--machines", type=Path, metavar="FOLDER", help="folder with presets of your own")
    add("--material", default=next(iter(MATERIALS)), choices=list(MATERIALS))
    return p


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command line and return the exit code: 0, or 1 if there is no page."""
    args = parser().parse_args(argv)
    try:
        study = Study(*_study(args))
        target = args.output or args.file.with_suffix(".html")
        if target.resolve() == args.file.resolve():
            raise RequestError("The page would overwrite the program.", "Give another -o.")
        write_page(study, target, args.file.name)
    except (SpiralPocketError, OSError) as error:
        print(f"report: {error}", file=sys.stderr)
        return 1
    for name, value in study.figures().items():
        print(f"{name:40} {value}")
    print(f"Written: {target}")
    return 0


def write_page(study: Study, target: Path, title: str) -> None:
    """Write the page about `study` to `target`.

    Raises
    ------
    SetupError
        If matplotlib is missing.
    """
    rows = "".join(
        f"<tr><td>{html.escape(name)}</td><td>{html.escape(value)}</td></tr>\n"
        for name, value in study.figures().items()
    )
    pictures = "".join(
        f'<figure><img alt="" src="data:image/png;base64,{data}">'
        f"<figcaption>{html.escape(caption)}</figcaption></figure>\n"
        for caption, data in _pictures(study)
    )
    title = html.escape(title)
    target.write_text(
        f'<!doctype html>\n<html lang="en"><meta charset="utf-8"><title>{title}</title>\n'
        f"<style>{_STYLE}</style>\n<h1>{title}</h1>\n<table>\n{rows}</table>\n{pictures}</html>\n",
        encoding="utf-8",
    )


def _pictures(study: Study) -> list[tuple[str, str]]:
    """Return captions and PNG pictures in base 64."""
    try:
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure
    except ImportError as error:
        raise SetupError(
            "The page's plots need the Python library matplotlib, which is missing here.",
            "Install it with the Addon Manager or pip.",
        ) from error
    from . import plots

    source = f"Force model: {study.setup.material.source}."
    drawings: list[tuple[Callable[[Any, Study], None], str, tuple[float, float]]] = [
        (plots.path_by_engagement, "The path, colored by engagement angle.", (10, 8)),
        (plots.engagement_along_path, "Engagement angle along the path.", (11, 3.5)),
        (plots.feed_direction_along_path, "Feed direction along the path.", (11, 3.5)),
        (plots.velocity_along_path, f"Velocity profile on {study.setup.machine.name}.", (11, 3.5)),
        (plots.force_against_time, f"Cutting force against time. {source}", (11, 3.5)),
        (plots.curvature_histogram, "Curvature of the path.", (8, 3.5)),
        (plots.engagement_histogram, "Engagement over length and time.", (8, 3.5)),
    ]
    pictures = []
    for draw, caption, size in drawings:
        figure = Figure(figsize=size, dpi=110, layout="constrained")
        FigureCanvasAgg(figure)
        draw(figure.add_subplot(), study)
        buffer = io.BytesIO()
        figure.savefig(buffer, format="png")
        pictures.append((caption, base64.b64encode(buffer.getvalue()).decode()))
    return pictures


def _study(args: argparse.Namespace) -> tuple[Toolpath, Setup]:
    """Return path and setup; what the arguments say goes before what the file says."""
    if not args.file.is_file():
        raise RequestError(f"There is no file {args.file}.")
    if args.machines is not None and not args.machines.is_dir():
        raise RequestError(f"There is no folder {args.machines}.")
    is_document = args.file.suffix.lower() == ".fcstd"
    source = _from_document(args.file, args.operation) if is_document else _from_program(args.file)

    given = {
        "diameter": args.tool,
        "spindle_speed": args.spindle and args.spindle / 60,
        "axial_depth": args.axial_depth,
        "top": args.top,
        "stepover": args.stepover,
        "machine": args.machine,
    }
    source = replace(source, **{name: value for name, value in given.items() if value is not None})
    if source.diameter is None:
        raise RequestError("The program does not say how wide the cutter is.", "Give --tool.")
    top = source.top or 0.0
    depth = source.axial_depth or step_down_of(source.toolpath, top)
    if not depth > 0:
        raise RequestError("The program never goes below the top of the stock.", "Give --top.")
    limit = np.nan
    if source.stepover is not None:
        limit = engagement_angle(source.stepover, source.diameter / 2)
    return source.toolpath, Setup(
        cutter=Cutter(source.diameter, args.flutes, np.radians(args.helix)),
        machine=machines.load(source.machine or MACHINE, args.machines),
        material=MATERIALS[args.material],
        spindle_speed=source.spindle_speed or SPINDLE_SPEED / 60,
        axial_depth=depth,
        top=top,
        stock=source.stock,
        engagement_limit=limit,
        climb=source.climb and not args.conventional,
    )


def step_down_of(toolpath: Toolpath, top: float) -> float:
    """Return how far the levels of a program are apart at most, from the stock's top on [mm].

    A level is what the cutter goes along for a good part of the longest one. The whole depth where
    there is none.
    """
    ends, starts = toolpath.points[:, 2], toolpath.starts[:, 2]
    level = (np.abs(ends - starts) < SAME_HEIGHT) & (toolpath.kinds != Kind.RAPID)
    level &= ends < top - SAME_HEIGHT
    if not level.any():
        return top - float(ends.min())
    heights, of = np.unique(np.round(ends[level] / SAME_HEIGHT), return_inverse=True)
    lengths = np.bincount(of, weights=toolpath.lengths[level])
    heights = heights[lengths > LEVEL * lengths.max()] * SAME_HEIGHT
    return float(-np.diff([top, *heights[::-1]]).min())


def _from_program(path: Path) -> Source:
    """Return what a G-code file says."""
    text = path.read_text(encoding="utf-8", errors="replace")
    speeds = [float(s) for s in re.findall(r"\bS(\d+\.?\d*)", text)]
    spindle = max(speeds, default=0.0)
    return Source(gcode.parse_program(text), spindle_speed=spindle / 60 or None)


def _from_document(path: Path, label: str | None) -> Source:
    """Return what an operation in a FreeCAD document says."""
    try:
        import FreeCAD
    except ImportError as error:
        raise SetupError(
            "A FreeCAD document can only be read by FreeCAD's own Python.",
            "Post the program and give that file instead.",
        ) from error
    document = FreeCAD.openDocument(str(path.resolve()), True)
    try:
        return from_operation(_find_operation(document, label))
    finally:
        FreeCAD.closeDocument(document.Name)


def _find_operation(document: Any, label: str | None) -> Any:
    """Return the operation of a document that is called `label`, or the first one."""
    operations = [
        o
        for o in document.Objects
        if hasattr(o, "ToolController") and hasattr(o, "Path") and hasattr(o, "FinalDepth")
    ]
    if label is not None:
        operations = [o for o in operations if label in (o.Label, o.Name)]
    if not operations:
        raise RequestError("The document holds no such operation.", "Name one with --operation.")
    return operations[0]


def from_operation(op: Any) -> Source:
    """Return what an operation says."""
    lines = []
    for command in op.Path.Commands:
        # FreeCAD's feeds are mm/s, those of programs mm/min
        words = {k: v * 60 if k == "F" else v for k, v in command.Parameters.items()}
        if not command.Name.startswith("("):
            lines.append(" ".join([command.Name, *(f"{k}{v:.6f}" for k, v in words.items())]))
    diameter = float(op.ToolController.Tool.Diameter)
    start, final = op.StartDepth.Value, op.FinalDepth.Value
    step_down = op.StepDown.Value if hasattr(op, "StepDown") else start - final
    return Source(
        gcode.parse_program("\n".join(lines)),
        diameter=diameter,
        spindle_speed=float(op.ToolController.SpindleSpeed) / 60 or None,
        axial_depth=min(start - final, step_down),
        top=start,
        stepover=_stepover(op, diameter),
        stock=_stock(op),
        machine=getattr(op, "Machine", None),
        climb=getattr(op, "CutMode", "Climb") == "Climb",
    )


def _stock(op: Any) -> Polygon | None:
    """Return the outline of the stock of an operation's job."""
    from .op.compat import parent_job
    from .op.open_sides import outline_of_stock

    job = parent_job(op)
    return None if job is None else outline_of_stock(job.Stock.Shape)


def _stepover(op: Any, diameter: float) -> float | None:
    """Return the step-over [mm] of an operation, ours or one of FreeCAD's own."""
    if hasattr(op, "MaxEngagement"):
        from .op import request

        return request.stepover(op)
    return diameter * op.StepOver / 100 if hasattr(op, "StepOver") else None


if __name__ == "__main__":
    sys.exit(main())

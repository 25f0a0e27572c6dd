# SPDX-License-Identifier: LGPL-2.1-or-later
"""Spiral Pocket on the command line, inside FreeCAD's Python.

Opens a part, makes a job with an end mill (or takes the job that is there), adds
one operation for the chosen floors and writes what was asked for: G-code, the
FreeCAD document, a picture. The report on the terminal has one line for each
figure. In a job that it makes the stock's top is the part's top.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import FreeCAD

from . import api, picture, posting
from .arguments import positive
from .engine.errors import SelectionError, SetupError, SpiralPocketError
from .engine.model import Progress
from .op import compat, operation, part_files, results
from .op.floors import find_floors

#: What a new tool controller gets where nothing is said [mm/min].
FEED, RAPID = 1000.0, 5000.0
#: Plunge feed over horizontal feed.
PLUNGE_SHARE = 0.25
#: Depth of a pocket of which only the outline is given [mm].
DEPTH = 5.0
#: Diameters closer than this are one tool [mm].
SAME_DIAMETER = 1e-6

NO_TOOL = ("There is no tool.", "Give the end mill's diameter with --tool.")


def parser() -> argparse.ArgumentParser:
    """Return the parser of the command line."""
    p = argparse.ArgumentParser(
        prog="./dev cam", description="Clear pockets with a spiral and write the program."
    )
    add = p.add_argument
    add(
        "part",
        type=Path,
        help="STEP, IGES, BREP or FCStd file, or a pocket's outline as JSON: "
        '{"outer": [[x, y], ...], "holes": [[[x, y], ...], ...]}',
    )
    add("--part", dest="part_name", metavar="NAME", help="the part, if the file has several")
    add(
        "--face",
        dest="faces",
        action="append",
        metavar="FACE",
        help="floor of a pocket such as Face12, or several with commas; all: every one",
    )
    add("--tool", type=length, metavar="D", help="diameter of the end mill [mm, or with a unit]")
    add("--stepover", type=percent, metavar="PERCENT", help="of the tool's diameter, at most")
    add(
        "--depth",
        type=length,
        help="how deep to cut below the stock's top [mm, or with a unit]; "
        f"{DEPTH:g} for an outline if not given",
    )
    add("--feed", type=positive, help=f"horizontal feed [mm/min], {FEED:g} for a new tool")
    add("--plunge", type=positive, help="vertical feed [mm/min], a quarter of the feed")
    add("--rapid", type=positive, help=f"rapid rate [mm/min], {RAPID:g} for a new tool")
    add("--spindle", type=positive, metavar="RPM", help="spindle speed [1/min]")
    add(
        "--set",
        dest="values",
        action="append",
        default=[],
        metavar="NAME=VALUE",
        help="any property of the operation, may be given several times",
    )
    add("--post", default="linuxcnc", help="FreeCAD post-processor, linuxcnc if not given")
    add(
        "--post-args",
        default="",
        metavar="ARGS",
        help='arguments for the post-processor: --post-args="--inches"',
    )
    add("-o", "--output", type=Path, metavar="FILE", help="G-code to write")
    add("--fcstd", type=Path, metavar="FILE", help="FreeCAD document to write")
    add("--png", type=Path, metavar="FILE", help="picture to write")
    return p


def length(text: str) -> float:
    """Return a length above 0 [mm] from a number, or one with a unit."""
    try:
        quantity = FreeCAD.Units.Quantity(text)
    except (ValueError, ArithmeticError, RuntimeError):
        return positive(text)
    if quantity.Unit == FreeCAD.Units.Length:
        return positive(str(quantity.Value))
    return positive(text)


def percent(text: str) -> int:
    """Return a whole number from one, with or without a percent sign."""
    return int(text.strip().rstrip("%"))


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command line.

    Returns
    -------
    int
        The exit code: 0, 1 if nothing could be cut, 3 if some of the pockets could not.
    """
    args = parser().parse_args(argv)
    try:
        op = run(args)
    except SpiralPocketError as error:
        print(f"cam: {error}", file=sys.stderr)
        return 1
    return 3 if op.Proxy.errors else 0


def run(args: argparse.Namespace) -> Any:
    """Do what the arguments ask for and return the operation."""
    for file in (args.output, args.png):  # a document may be saved where it was
        if file is not None and file.resolve() == args.part.resolve():
            raise SetupError(f"{file} is the part itself.", "Write to another file.")
    for file in (args.output, args.png, args.fcstd):  # what is planned takes its time
        if file is not None:
            posting.check_file(file)
    if args.png:
        picture.check(args.png)
    if args.output:
        posting.check_post(args.post)
    document, outline = part_files.load(args.part, args.depth or DEPTH)
    if args.tool is None:
        args.tool = outline.get("tool")
    if args.stepover is None and "ae" in outline and args.tool:
        args.stepover = round(100 * outline["ae"] / args.tool)
    with compat.active_document(document):
        job = part_files.find_job(document)
        part = part_files.find_part(document, args.part_name) if job is None else None
        model = part_files.find_model(job, args.part_name) if job else part
        faces = choose_faces(model, args.faces)
        if job is None:
            if args.tool is None:
                raise SetupError(*NO_TOOL)
            job = new_job(part, args.tool)
        controller = tool_controller(job, args.tool)
        set_speeds(controller, args)
        document.recompute()
        with told_progress():
            op = api.add_spiral_pocket(job, [(model, faces)], controller, **properties(args, job))
        write(args, job, op)
    print("\n".join(results.summary(op)))
    others = [o.Label for o in job.Operations.Group if o is not op and getattr(o, "Active", True)]
    if others and args.output:
        print(f"also in the program: {', '.join(others)}, which the job had before")
    return op


@contextmanager
def told_progress() -> Iterator[None]:
    """Tell on a terminal how far the planning is: small step-overs may take minutes."""
    if not sys.stderr.isatty():
        yield
        return

    @contextmanager
    def factory(label: str) -> Iterator[Progress]:
        def tell(done: float, stage: str) -> bool:
            print(f"\r{100 * done:3.0f} %  {stage:30}", end="", file=sys.stderr, flush=True)
            return False

        try:
            yield tell
        finally:
            print("\r" + 40 * " ", end="\r", file=sys.stderr, flush=True)

    kind = operation.ObjectSpiralPocket
    before, kind.progress_factory = kind.progress_factory, staticmethod(factory)
    try:
        yield
    finally:
        kind.progress_factory = before


def new_job(part: Any, diameter: float) -> Any:
    """Return a job for `part` with an end mill, whose stock ends at the part's top.

    Parameters
    ----------
    part : object
    diameter : float
        Of the end mill [mm].
    """
    job = compat.PathJob.Create("Job", [part], None)
    job.Stock.ExtZpos = 0
    compat.set_end_mill(job.Tools.Group[0], diameter)
    return job


def choose_faces(model: Any, names: Sequence[str] | None) -> list[str]:
    """Return the names of the floors to cut.

    Raises
    ------
    SelectionError
        If none was named and there is not exactly one; its hint lists them.
    """
    # as in a list, or without the capital
    names = [name.strip().capitalize() for one in names or () for name in one.split(",")]
    if names and "All" not in names:
        return names
    floors = sorted(find_floors(model), key=lambda f: f.face.BoundBox.XMin)
    if not floors:
        raise SelectionError(
            "The part has no pocket that is walled all around.", "Name its floor with --face."
        )
    if len(floors) > 1 and not names:
        listed = "\n".join(
            f"  --face {','.join(f.names):8} at Z{f.z:g}, {f.face.Area / 100:.1f} cm2, around "
            f"X{f.face.CenterOfMass.x:.1f} Y{f.face.CenterOfMass.y:.1f}"
            for f in floors
        )
        raise SelectionError(
            f"The part has {len(floors)} pockets.", f"Choose with --face, or --face all:\n{listed}"
        )
    return [name for f in floors for name in f.names]


def tool_controller(job: Any, diameter: float | None) -> Any:
    """Return the job's tool controller with the end mill asked for, a new one if there is none.

    Raises
    ------
    SetupError
        If none was asked for and there is none.
    """
    found = list(job.Tools.Group)
    if diameter is not None:
        found = [tc for tc in found if abs(float(tc.Tool.Diameter) - diameter) < SAME_DIAMETER]
    if found:
        return found[0]
    if diameter is None:
        raise SetupError(*NO_TOOL)
    return compat.add_tool_controller(job, diameter)


def set_speeds(controller: Any, args: argparse.Namespace) -> None:
    """Set the speeds that were given, and those that the tool controller lacks."""
    feed = args.feed or 60 * controller.HorizFeed.Value or FEED
    # a feed that is given changes the plunge with it
    plunge = args.plunge or (PLUNGE_SHARE * args.feed if args.feed else 0)
    for name, given, default in (
        ("HorizFeed", args.feed, feed),
        ("VertFeed", plunge, PLUNGE_SHARE * feed),
        ("HorizRapid", args.rapid, RAPID),
        ("VertRapid", args.rapid, RAPID),
    ):
        if given or not getattr(controller, name).Value:
            controller.setExpression(name, None)
            setattr(controller, name, (given or default) / 60)
    if args.spindle:
        controller.SpindleSpeed = args.spindle


def properties(args: argparse.Namespace, job: Any) -> dict[str, Any]:
    """Return the properties that the arguments set."""
    values: dict[str, Any] = {}
    if args.stepover is not None:
        values["StepOver"] = args.stepover
    if args.depth is not None:
        values["FinalDepth"] = job.Stock.Shape.BoundBox.ZMax - args.depth
    for pair in args.values:
        name, found, text = pair.partition("=")
        if not found:
            raise SetupError(f"--set {pair} has no value.", "Write it as NAME=VALUE.")
        values[name] = value_of(text)
    return values


def value_of(text: str) -> Any:
    """Return `text` as a truth value, a number or three numbers where it is such."""
    if text.lower() in ("true", "false"):
        return text.lower() == "true"
    try:
        numbers = [float(part) for part in text.strip("() ").split(",")]
    except ValueError:
        return text
    if len(numbers) == 1:
        return numbers[0]
    return tuple(numbers) if len(numbers) == 3 else text


def write(args: argparse.Namespace, job: Any, op: Any) -> None:
    """Write the files that were asked for."""
    if args.output:
        api.export(job, args.output, args.post, args.post_args)
    if args.png:
        tool = compat.tool_name(op.ToolController.Tool)
        picture.draw(op.Proxy.plans, args.png, f"{args.part.stem}, {tool}")
    if args.fcstd:
        save(job.Document, args.fcstd)


def save(document: Any, path: Path) -> None:
    """Write a FreeCAD document.

    Raises
    ------
    SetupError
        If that is not possible.
    """
    try:
        document.saveAs(str(path.resolve()))
    except (OSError, RuntimeError) as error:
        raise SetupError(f"Cannot write {path}.", "Choose another file.") from error


if __name__ == "__main__":
    sys.exit(main())

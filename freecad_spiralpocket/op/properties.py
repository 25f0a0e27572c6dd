# SPDX-License-Identifier: LGPL-2.1-or-later
"""The operation's own properties, in one table.

A row is all there is to a property: creation, the defaults, the presets of the
setup sheet, the migration of old documents and the checks of the scripting
interface read it, so that a new property is a new row with `since` one higher
than the newest. Names, units and types follow FreeCAD's Adaptive and Pocket,
so that presets and scripts carry over. Only types that the setup sheet's
``OpPrototype`` knows may be used: any other breaks the editor of every job.

FreeCAD looks the tooltips up for translation itself (context App::Property).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from .. import machines
from ..engine.model import CutMode, FeedMode, Strategy
from . import preferences

#: Version of the table that this release writes into documents.
SCHEMA_VERSION = 4
#: The user's machines and those of resources/machines, the default first.
MACHINES = tuple(
    sorted(machines.names(preferences.machine_folder()), key=lambda name: name != "hobby_router")
)

OPTIONS, START, RESULT = "Spiral Pocket", "Start Point", "Result"
_EDITABLE, _READ_ONLY, _HIDDEN = 0, 1, 2


@dataclass(frozen=True)
class Property:
    """One property of the operation.

    Attributes
    ----------
    name, type, group, tooltip : str
        As FreeCAD's ``addProperty`` takes them.
    default : object
        In mm, deg or percent; the first of `choices` for an enumeration.
    choices : tuple of str
        What an enumeration may hold.
    since : int
        Schema version that brought it.
    """

    name: str
    type: str
    group: str
    tooltip: str
    default: Any = None
    choices: tuple[str, ...] = ()
    since: int = 1

    @property
    def is_option(self) -> bool:
        """Return whether the user sets it."""
        return self.group in (OPTIONS, START)

    @property
    def editor_mode(self) -> int:
        """Return FreeCAD's number for editable, read-only or hidden."""
        if self.is_option:
            return _EDITABLE
        return _READ_ONLY if self.group == RESULT else _HIDDEN


def _option(name: str, kind: str, tooltip: str, default: Any, **more: Any) -> Property:
    return Property(name, f"App::Property{kind}", OPTIONS, tooltip, default, **more)


def _choice(name: str, tooltip: str, choices: tuple[str, ...], **more: Any) -> Property:
    return _option(name, "Enumeration", tooltip, choices[0], choices=choices, **more)


def _result(name: str, kind: str, tooltip: str, default: Any, **more: Any) -> Property:
    kind = kind if "::" in kind else f"App::Property{kind}"
    return Property(name, kind, RESULT, tooltip, default, **more)


#: The default step-over of 40 percent lies between Adaptive's 20 and Pocket's 50: the largest
#: engagement is 78 degrees, still below the right angle from which on the chip is as thick as
#: the feed per tooth, and most of a spiral's laps lie closer than the step-over anyway.
TABLE = (
    _choice("Strategy", "How the laps of the spiral are made", tuple(s.value for s in Strategy)),
    _option(
        "StepOver",
        "Percent",
        "Percent of cutter diameter to step over on each lap, at most",
        40,
    ),
    _option(
        "MaxEngagement",
        "Angle",
        "Largest engagement angle of a straight cut, in place of StepOver; 0 for that of StepOver",
        0.0,
        since=2,
    ),
    _choice(
        "CutMode",
        "Climb or conventional milling, for a spindle that turns clockwise",
        tuple(m.value for m in CutMode),
    ),
    _option(
        "StockToLeave",
        "Distance",
        "How much stock to leave in the XY plane (eg for finishing operation)",
        0.0,
    ),
    _option("ZStockToLeave", "Distance", "How much stock to leave along the Z axis", 0.0),
    _option("HelixAngle", "Angle", "Ramp angle of the helical entry", 5.0),
    _option(
        "HelixDiameterLimit",
        "Length",
        "Limit helix entry diameter, if limit larger than tool diameter or 0, tool diameter is "
        "used",
        0.0,
    ),
    _option("Tolerance", "Length", "Largest deviation of the path from the exact curve", 0.01),
    _choice(
        "Machine",
        "The machine on which the time is to be least",
        MACHINES,
    ),
    _choice(
        "FeedMode",
        "How the feed follows the engagement: slowed where it passes the limit, slowed linearly "
        "with the chip, or raised where the chip is thin",
        tuple(m.value for m in FeedMode),
    ),
    _option(
        "SlowdownPercent",
        "Percent",
        "Feed at the largest radial depth of cut, in percent (Linear slow-down)",
        75,
    ),
    _option(
        "MaxFeedRatio",
        "Float",
        "Largest feed where the chip is thin, as a multiple of the tool controller's (Chip "
        "thickness)",
        2.0,
    ),
    _option(
        "LinkFeed",
        "Float",
        "Feed of moves at depth through cleared ground in mm/min, 0 for the horizontal rapid rate",
        0.0,
    ),
    _option(
        "SlotBite",
        "Length",
        "Largest axial depth of one level of a slot that opens the pocket, 0 for automatic",
        0.0,
    ),
    _option(
        "FinishingProfile",
        "Bool",
        "To take a finishing lap along the walls at the end; Automatic and Extended Archimedean do "
        "without, their laps finish the walls",
        True,
    ),
    _option("UseOutline", "Bool", "Ignore islands and clear everything inside the outline", False),
    _option(
        "ExtendOpenSides",
        "Bool",
        "Clear the floor beyond its edge where no wall rises, and begin there in the air where the "
        "stock ends near by; else the cutter stays within the floor",
        True,
        since=3,
    ),
    _option(
        "UseRestMachining",
        "Bool",
        "Cut only what earlier operations of the job have left standing in the pocket",
        False,
        since=4,
    ),
    Property(
        "UseStartPoint",
        "App::PropertyBool",
        START,
        "Make True, if specifying a Start Point",
        False,
        since=2,
    ),
    Property(
        "StartPoint",
        "App::PropertyVectorDistance",
        START,
        "Where the cutter goes down, as near as it can; its height does not matter",
        since=2,
    ),
    _result(
        "SpiralCurve",
        "Part::PropertyPartShape",
        "The exact curves behind the path, B-splines at the floors; can be exported to STEP",
        None,
    ),
    _result(
        "LargestEngagement",
        "Angle",
        "Largest engagement angle that was measured, at the floor after the entry",
        0.0,
    ),
    _result("UncutArea", "Float", "Area within the cutter's reach left standing, in mm^2", 0.0),
    _result("Gouge", "Length", "How far the cutter passes the walls, measured", 0.0),
    _result("PathLength", "Length", "Length of all cutting moves", 0.0),
    _result("MachiningTime", "Float", "Time of the path on the chosen machine, in seconds", 0.0),
    _result("Notices", "StringList", "What the machinist should know about this path", []),
    Property("SchemaVersion", "App::PropertyInteger", "Internal", "Version of these properties", 0),
)

#: Properties of FreeCAD's own operation base that scripts may set as well.
INHERITED = (
    "Active",
    "ClearanceHeight",
    "Comment",
    "CoolantMode",
    "FinalDepth",
    "FinishDepth",
    "SafeHeight",
    "StartDepth",
    "StepDown",
    "UserLabel",
)


def option_names() -> list[str]:
    """Return the names of the properties that the user sets, in the order of the table."""
    return [p.name for p in TABLE if p.is_option]


def preset_names() -> list[str]:
    """Return the names of the options that a preset may hold: all but a place on one part."""
    return [p.name for p in TABLE if p.group == OPTIONS]


def choices() -> dict[str, tuple[str, ...]]:
    """Return what each enumeration may hold."""
    return {p.name: p.choices for p in TABLE if p.choices}


def create(obj: Any) -> list[Property]:
    """Add the properties that `obj` lacks and return them, without setting any value.

    `obj` is the operation or the setup sheet's prototype of one, which has nothing but
    ``addProperty``, ``setEditorMode`` and the setting of attributes.
    """
    present = set(getattr(obj, "PropertiesList", ()))
    added = [p for p in TABLE if p.name not in present]
    for p in added:
        obj.addProperty(p.type, p.name, p.group, p.tooltip)
        if p.choices:
            setattr(obj, p.name, list(p.choices))
    for p in TABLE:
        obj.setEditorMode(p.name, p.editor_mode)
    return added


def set_defaults(obj: Any, rows: tuple[Property, ...] | list[Property] = TABLE) -> None:
    """Set the properties in `rows` to their defaults and stamp the schema version."""
    for p in rows:
        if p.default is not None:
            setattr(obj, p.name, p.default)
    obj.SchemaVersion = SCHEMA_VERSION


def set_preferred(obj: Any) -> None:
    """Set what the user prefers for new operations, as far as this release knows the choice."""
    for p in TABLE:
        if p.name in preferences.NAMES:
            value = preferences.read(p.name, p.default)
            if not p.choices or value in p.choices:
                setattr(obj, p.name, value)


def offered(p: Property, value: str) -> list[str]:
    """Return the choices of an enumeration that holds a value: another user's machine stays."""
    is_foreign = p.name == "Machine" and value not in p.choices
    return [*p.choices, value] if is_foreign else list(p.choices)


def renew_choices(obj: Any, name: str, p: Property) -> None:
    """Bring the choices of an enumeration up to this release; what is no choice becomes default."""
    value = getattr(obj, name)
    choices = offered(p, value)
    if choices != obj.getEnumerationsOfProperty(name):
        setattr(obj, name, choices)
        setattr(obj, name, value if value in choices else p.default)


def migrate(obj: Any) -> None:
    """Bring the properties of a restored document up to this release.

    Adds what is missing with its default, renews the choices of enumerations and, as FreeCAD
    does not save them, the editor modes. Values that were saved stay.
    """
    added = create(obj)
    for p in TABLE:
        if p.choices:
            renew_choices(obj, p.name, p)
    if added or obj.SchemaVersion < SCHEMA_VERSION:
        set_defaults(obj, added)


def clear_results(obj: Any) -> None:
    """Forget the figures that were measured on an earlier path."""
    set_results(
        obj, {p.name: p.default for p in TABLE if p.group == RESULT and p.default is not None}
    )


def set_results(obj: Any, values: dict[str, Any]) -> None:
    """Set results by name, only where they differ: every assignment marks the document changed."""
    for name, value in values.items():
        old = getattr(obj, name)
        if getattr(old, "Value", old) != value:
            setattr(obj, name, value)

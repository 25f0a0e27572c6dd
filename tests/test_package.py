# SPDX-License-Identifier: LGPL-2.1-or-later
"""The package as a whole: one version everywhere, and imports that point one way.

gui may import op, op may import beside, beside may import engine; the last two know
neither FreeCAD nor Qt, so that they can be tested, and used, in plain Python. The engine
knows no files either.
"""

import ast
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest

import freecad_spiralpocket

ROOT = Path(__file__).parent.parent
PACKAGE = ROOT / "freecad_spiralpocket"
MANIFEST = ElementTree.parse(ROOT / "package.xml").getroot()
NAMESPACE = {"p": "https://wiki.freecad.org/Package_Metadata"}

OURS = "freecad_spiralpocket"
FREECAD = {"FreeCAD", "Part", "Path", "PathScripts"}
WINDOW = {"FreeCADGui", "PySide", "pivy"}
STANDARD = set(sys.stdlib_module_names)
#: What of the standard library does nothing but compute.
PURE = {
    *("__future__", "array", "collections", "contextlib", "copy", "dataclasses", "enum"),
    *("functools", "heapq", "importlib", "itertools", "math", "types", "typing"),
}


def own(*names):
    """Return parts of the package as they are imported."""
    return {f"{OURS}.{name}" for name in names}


#: What each package and each module beside them may import but for itself.
ALLOWED = {
    "__init__": set(),
    "engine": PURE | {"numpy", "scipy", "shapely", "contourpy"},
    "machines": STANDARD | own("engine"),
    "gcode": STANDARD | {"numpy"} | own("engine"),
    "study": STANDARD | {"numpy", "shapely"} | own("engine"),
    "trace": STANDARD | {"numpy", "shapely"} | own("engine"),
    "adaptive": STANDARD | {"numpy", "shapely", "area"} | own("engine"),
    "arguments": STANDARD,
    "beside": STANDARD | {"shapely"} | own("engine", "trace", "adaptive"),
    "op": STANDARD | FREECAD | {"numpy", "shapely"} | own("engine", "beside", "gcode", "machines"),
    "picture": STANDARD | {"numpy", "shapely", "matplotlib"} | own("engine", "trace"),
    "plots": STANDARD | {"numpy", "matplotlib"} | own("engine", "study"),
    "report": {
        *(STANDARD | FREECAD | {"numpy", "shapely", "matplotlib"}),
        *own("engine", "op", "arguments", "gcode", "machines", "plots", "study"),
    },
    "gui": {
        *(STANDARD | FREECAD | WINDOW | {"numpy", "matplotlib"}),
        *own("engine", "beside", "op", "trace"),
    },
    "posting": STANDARD | own("engine", "op"),
    "api": STANDARD | FREECAD | own("engine", "op", "posting"),
    "cli": STANDARD | FREECAD | own("engine", "op", "api", "arguments", "picture", "posting"),
}


def imported_modules(source, module, is_package=False):
    """Return the dotted names that a module's source imports, relative ones made absolute."""
    names = set()
    parents = module.split(".") if is_package else module.split(".")[:-1]
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            base = parents[: len(parents) + 1 - node.level] if node.level else []
            origin = ".".join([*base, *filter(None, [node.module])])
            names |= {origin} | {f"{origin}.{alias.name}" for alias in node.names}
    return names


def forbidden_imports(part, source, module, is_package=False):
    """Return what the module imports although its part of the package may not."""
    roots = ALLOWED[part] | own(part)
    return sorted(
        name
        for name in imported_modules(source, module, is_package)
        if name not in (OURS, f"{OURS}.__version__")
        and not any(name == root or name.startswith(root + ".") for root in roots)
    )


def test_every_part_of_the_package_has_its_imports():
    files = {file.stem for file in PACKAGE.glob("*.py")}
    folders = {file.parent.name for file in PACKAGE.glob("*/__init__.py")}
    assert files | folders == ALLOWED.keys()


@pytest.mark.parametrize("part", ALLOWED)
def test_imports_point_one_way(part):
    files = sorted((PACKAGE / part).rglob("*.py")) or [PACKAGE / f"{part}.py"]
    for file in files:
        module = ".".join(file.relative_to(ROOT).with_suffix("").parts)
        is_package = file.name == "__init__.py"
        module = module.removesuffix(".__init__")
        found = forbidden_imports(part, file.read_text(encoding="utf-8"), module, is_package)
        assert not found, f"{file.relative_to(ROOT)} imports {', '.join(found)}"


@pytest.mark.parametrize(
    ("part", "line"),
    [
        ("engine", "import Path.Op.Base"),
        ("engine", "from ..op import geometry"),
        ("engine", "from .. import op"),
        ("engine", "def f():\n    from PySide import QtCore"),
        ("engine", "from PySide6 import QtCore"),
        ("engine", "from ..study import Study"),
        ("engine", "from pathlib import Path"),
        ("engine", "import matplotlib"),
        ("beside", "from ..op import pockets"),
        ("op", "from freecad_spiralpocket.gui.panel.extras import Extra"),
        ("gui", "from ..api import export"),
        ("trace", "from ..op import rest"),
    ],
)
def test_import_rule_sees(part, line):
    assert forbidden_imports(part, line, f"{OURS}.{part}.module")


def test_import_rule_lets_pass():
    assert not forbidden_imports("op", "from ..engine import plan", f"{OURS}.op.module")
    assert not forbidden_imports("engine", "from scipy import sparse", f"{OURS}.engine.module")


#: What each package of a part may import of the others.
BELOW = {
    "engine": {
        "numerics": set(),
        "shapes": {"numerics"},
        "motion": {"numerics", "shapes"},
        "contact": {"numerics", "shapes"},
        "proof": {"numerics", "shapes", "motion", "contact"},
        "growth": {"numerics", "shapes"},
        "opening": {"numerics", "shapes", "growth"},
        "links": {"numerics", "shapes", "motion", "growth", "opening"},
        "heat": {"numerics", "shapes", "growth", "opening", "links"},
        "middle_line": {"numerics", "shapes", "growth", "opening", "links"},
        "laps": {
            *("numerics", "shapes", "motion", "growth", "opening", "links"),
            *("heat", "middle_line"),
        },
    },
    "gui": {
        "qt": set(),
        "texts": set(),
        "planning": {"qt", "texts"},
        "fields": {"qt", "texts"},
        "preview": {"texts", "planning"},
        "result": {"texts", "planning"},
        "plots": {"qt", "texts", "planning"},
        "compare": {"qt", "texts", "planning", "preview", "result"},
        "panel": {
            *("qt", "texts", "planning", "fields"),
            *("preview", "result", "plots", "compare"),
        },
    },
}
#: What of the modules beside them all may.
FOR_ALL = {
    "engine": {
        *("dependencies", "errors", "floor", "levels", "machine", "model"),
        *("stepover", "toolpath"),
    },
    "gui": {"compat", "resources"},
}
PACKAGES = [(part, package) for part, packages in BELOW.items() for package in packages]


def forbidden_neighbors(part, package, source):
    """Return what a module of a package imports of its part although it must not."""
    home = f"{OURS}.{part}"
    known = {file.stem for file in (PACKAGE / part).glob("*.py")} | BELOW[part].keys()
    names = imported_modules(source, f"{home}.{package}.module")
    found = {n.removeprefix(f"{home}.").split(".")[0] for n in names if n.startswith(f"{home}.")}
    return (found & known) - FOR_ALL[part] - BELOW[part][package] - {package}


@pytest.mark.parametrize("part", BELOW)
def test_every_package_is_known(part):
    found = {file.parent.name for file in (PACKAGE / part).glob("*/__init__.py")}
    assert found == BELOW[part].keys()


@pytest.mark.parametrize(("part", "package"), PACKAGES)
def test_packages_import_from_below_only(part, package):
    for file in sorted((PACKAGE / part / package).glob("*.py")):
        found = forbidden_neighbors(part, package, file.read_text(encoding="utf-8"))
        assert not found, f"{file.relative_to(ROOT)} imports {', '.join(sorted(found))}"


def test_packages_have_an_order():
    # nothing below imports what is above it, over however many others
    for packages in BELOW.values():
        seen = set()
        for package, below in packages.items():
            assert below <= seen
            seen.add(package)


def test_rule_of_packages_sees():
    assert forbidden_neighbors("engine", "growth", "from ..links.routing import R") == {"links"}
    assert forbidden_neighbors("engine", "growth", "from .. import links") == {"links"}
    assert forbidden_neighbors("engine", "laps", "from ..planner import plan") == {"planner"}
    assert forbidden_neighbors("gui", "preview", "from ..panel import extras") == {"panel"}
    assert forbidden_neighbors("gui", "panel", "from ..viewprovider import V") == {"viewprovider"}
    assert not forbidden_neighbors("engine", "links", "from ..growth import strokes")
    assert not forbidden_neighbors("gui", "plots", "from ...engine.errors import SetupError")


def test_strategies_stand_apart():
    # what two of them need has a module of its own; closing.py is one
    laps = PACKAGE / "engine" / "laps"
    strategies = {f"{OURS}.engine.laps.{file.stem}" for file in laps.glob("[!_]*.py")}
    strategies.remove(f"{OURS}.engine.laps.closing")
    assert len(strategies) == 5
    for file in sorted((PACKAGE / "engine").rglob("*.py")):
        module = ".".join(file.relative_to(ROOT).with_suffix("").parts)
        found = imported_modules(file.read_text(encoding="utf-8"), module) & strategies
        assert not found, f"{file.relative_to(ROOT)} imports {', '.join(found)}"


def test_architecture_tells_of_every_module():
    told = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    homes = ["engine/middle_line", "engine/laps", "beside", "op", ""]
    files = [file.name for home in homes for file in (PACKAGE / home).glob("[!_]*.py")]
    assert len(files) > 50
    assert not [name for name in files if f"{name}`" not in told]


def modules_after(statement):
    """Return the modules that a fresh Python has loaded after the statement, and its seconds."""
    code = (
        f"import sys, time; start = time.perf_counter(); {statement}; "
        "print(time.perf_counter() - start, *sys.modules)"
    )
    answer = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True
    )
    seconds, *modules = answer.stdout.split()
    return set(modules), seconds


def test_package_import_is_light():
    modules, _ = modules_after(f"import {OURS}")
    assert not {"numpy", "scipy", "shapely"} & modules


def test_records_load_without_shapely():
    # documents can be opened where it is missing
    modules, _ = modules_after(f"from {OURS}.engine import errors, machine, model, toolpath")
    assert "numpy" in modules
    assert not {"scipy", "shapely"} & modules


def test_automatic_does_without_scipy():
    # to load it takes as long as to plan a small pocket
    modules, _ = modules_after(
        f"from shapely import box; from {OURS}.engine import plan; "
        f"from {OURS}.engine.model import Cutting, Feeds, Heights, PocketRequest; "
        "plan(PocketRequest(box(0, 0, 30, 20), 6.0, Heights(5.0, 2.0, 0.0, -2.0, 2.0), "
        "Feeds(50.0, 10.0, 80.0, 80.0), Cutting(2.4)))"
    )
    assert "shapely" in modules
    assert "scipy" not in modules


def test_engine_imports_without_freecad(record_property):
    modules, seconds = modules_after(f"import {OURS}.engine.planner")
    record_property("seconds", seconds)  # reported in the results, not judged
    assert not (FREECAD | WINDOW) & modules


def test_version_is_the_same_everywhere():
    version = freecad_spiralpocket.__version__
    changelog = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    top = re.search(r"^## \[(\d+\.\d+\.\d+)\] - (\d{4}-\d\d-\d\d)$", changelog, re.MULTILINE)
    assert MANIFEST.findtext("p:version", namespaces=NAMESPACE) == version
    assert top.groups() == (version, MANIFEST.findtext("p:date", namespaces=NAMESPACE))


def test_manifest_makes_freecad_run_both_start_files():
    # Without a workbench in its content FreeCAD runs neither Init.py nor InitGui.py.
    folder = MANIFEST.findtext("p:content/p:workbench/p:subdirectory", namespaces=NAMESPACE)
    assert folder == "./"
    for name in ("Init.py", "InitGui.py"):
        assert (ROOT / name).is_file()


def test_manifest_names_files_that_exist():
    names = [license.get("file") for license in MANIFEST.findall("p:license", NAMESPACE)]
    names.append(MANIFEST.findtext("p:icon", namespaces=NAMESPACE))
    for name in names:
        assert (ROOT / name).is_file(), name


def test_manifest_names_the_libraries_that_the_package_imports():
    named = {depend.text for depend in MANIFEST.findall("p:depend", NAMESPACE)}
    known = set().union(*ALLOWED.values())
    ours = {name for name in known if name.startswith(OURS)}
    # contourpy comes with matplotlib, area with FreeCAD
    assert named == known - ours - STANDARD - FREECAD - WINDOW - {"contourpy", "area"}


def test_files_start_with_their_license():
    files = [ROOT / "Init.py", ROOT / "InitGui.py"]
    for folder in (OURS, "benchmarks", "examples", "tests"):
        files += (ROOT / folder).rglob("*.py")
    for file in files:
        first = file.read_text(encoding="utf-8").partition("\n")[0]
        assert first == "# SPDX-License-Identifier: LGPL-2.1-or-later", file

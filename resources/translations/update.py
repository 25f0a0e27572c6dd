# SPDX-License-Identifier: LGPL-2.1-or-later
"""Collect the add-on's texts into the .ts files and compile them (``./dev translate``).

A text is what stands in a form, in ``translate(...)`` or ``QT_TRANSLATE_NOOP(...)``, as a
property's tooltip, as a choice, or as a sentence that the engine says. Qt's own lupdate
knows neither the last three nor all of Python. What is translated already stays; what is
new is left unfinished for Qt Linguist or a text editor and shows in English until then; what
is gone is dropped.

The engine's sentences become templates, ``"The {0} mm cutter does not fit ..."``, which are
also written to messages.json: by them the window finds the figures in a finished sentence.
"""

from __future__ import annotations

import ast
import itertools
import json
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterator
from pathlib import Path
from xml.sax.saxutils import escape

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
PACKAGE = ROOT / "freecad_spiralpocket"
LANGUAGES = ("de", "es-ES", "fr", "zh-CN")

TEXTS, TOOLTIPS, MESSAGES = "SpiralPocket", "App::Property", "SpiralPocketMessages"
#: Functions whose first two arguments are context and text.
TRANSLATORS = {"translate", "QT_TRANSLATE_NOOP"}
#: Functions of the table of properties, and which argument is the tooltip.
ROWS = {"_option": 2, "_choice": 1, "_result": 2, "Property": 3}
#: The planner's function that names a stage of the work.
STAGES = "report_progress"

Text = tuple[str, str]


def main() -> int:
    """Bring all files up to date; return the exit code."""
    templates = sorted(set(engine_sentences()))
    collected = list(dict.fromkeys([*collect(), *((MESSAGES, text) for text in templates)]))
    (HERE / "messages.json").write_text(json.dumps(templates, indent=0) + "\n", encoding="utf-8")
    for language in LANGUAGES:
        path = HERE / f"SpiralPocket_{language}.ts"
        known = read(path)
        path.write_text(ts(language, collected, known), encoding="utf-8")
        missing = [source for context, source in collected if not known.get((context, source))]
        print(f"{language}: {len(collected)} texts, {len(missing)} unfinished")
        for source in missing:
            print(f"    {source}")
    return compile_all()


def collect() -> Iterator[Text]:
    """Yield context and source of every text but the engine's sentences."""
    for path in sorted((ROOT / "resources" / "panels").glob("*.ui")):
        yield from form_texts(path)
    for path in sorted([*PACKAGE.glob("gui/**/*.py"), *PACKAGE.glob("op/*.py")]):
        yield from call_texts(ast.parse(path.read_text(encoding="utf-8")))
    for text in enumerated():
        yield TEXTS, text


def form_texts(path: Path) -> Iterator[Text]:
    """Yield the texts of a form."""
    form = ElementTree.parse(path).getroot()
    for string in form.iter("string"):
        if string.text and string.get("notr") != "true":
            yield form.findtext("class", ""), string.text


def call_texts(tree: ast.AST) -> Iterator[Text]:
    """Yield what is translated in Python, and the tooltips of the table of properties."""
    for node in ast.walk(tree):
        if not isinstance(node, ast.Call):
            continue
        name = getattr(node.func, "id", getattr(node.func, "attr", ""))
        values = [getattr(argument, "value", None) for argument in node.args]
        if name in TRANSLATORS and all(isinstance(v, str) for v in values[:2]):
            yield values[0], values[1]
        elif name in ROWS and len(values) > ROWS[name] and isinstance(values[ROWS[name]], str):
            yield TOOLTIPS, values[ROWS[name]]


def enumerated() -> Iterator[str]:
    """Yield the choices of the engine and the names of the machines."""
    sys.path.insert(0, str(ROOT))
    from freecad_spiralpocket import machines
    from freecad_spiralpocket.engine.model import CutMode, FeedMode, Strategy

    for choices in (Strategy, CutMode, FeedMode):
        yield from (choice.value for choice in choices)
    yield from (machines.load(name).name for name in machines.names())


def engine_sentences() -> Iterator[str]:
    """Yield what the engine and the operation say, with numbered places for figures."""
    files = [*PACKAGE.glob("engine/**/*.py"), *PACKAGE.glob("op/*.py")]
    files += [PACKAGE / "machines.py", PACKAGE / "adaptive.py"]
    for path in sorted(set(files) - {PACKAGE / "op" / "part_files.py"}):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        passed_over = _docstrings_and_parts(tree)
        for node in ast.walk(tree):
            if id(node) not in passed_over:
                text = own_sentence(template(node))
                if " " in text and text.endswith("."):
                    yield text
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") == STAGES:
                yield from filter(None, map(template, node.args))


def template(node: ast.AST) -> str:
    """Return the text of a constant or f-string with numbered places, "" for another node."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return node.value
    if not isinstance(node, ast.JoinedStr):
        return ""
    parts = [part.value if isinstance(part, ast.Constant) else None for part in node.values]
    numbers = iter(range(len(parts)))
    return "".join(f"{{{next(numbers)}}}" if part is None else str(part) for part in parts)


def own_sentence(text: str) -> str:
    """Return a template without the whole sentences put before and after it, told by themselves.

    What goes before is followed by a capital letter, what follows comes after a full stop. What is
    a label and a colon with something is no sentence.
    """
    if text.startswith("{0}: "):
        return ""
    text = re.sub(r"(?<=\.) \{\d+\}$", "", text)
    numbers = itertools.count()
    text = re.sub(r"^\{\d+\} (?=[A-Z])", "", text)
    return re.sub(r"\{\d+\}", lambda _: f"{{{next(numbers)}}}", text)


def _docstrings_and_parts(tree: ast.AST) -> set[int]:
    """Return the ids of docstrings and of what f-strings are made of."""
    found = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Expr):
            found.add(id(node.value))
        elif isinstance(node, ast.JoinedStr):
            found |= {id(part) for part in ast.walk(node) if part is not node}
    return found


def read(path: Path) -> dict[Text, str]:
    """Return the translations that a .ts file holds."""
    if not path.exists():
        return {}
    return {
        (context.findtext("name", ""), message.findtext("source", "")): translation.text or ""
        for context in ElementTree.parse(path).getroot().iter("context")
        for message in context.iter("message")
        for translation in message.iter("translation")
        if translation.get("type") != "unfinished"
    }


def ts(language: str, collected: list[Text], known: dict[Text, str]) -> str:
    """Return a .ts file with all texts in one language."""
    lines = [
        '<?xml version="1.0" encoding="utf-8"?>',
        "<!DOCTYPE TS>",
        "<!-- SPDX-License-Identifier: LGPL-2.1-or-later -->",
        f'<TS version="2.1" language="{language.replace("-", "_")}" sourcelanguage="en">',
    ]
    for context in sorted({context for context, _ in collected}):
        lines += ["<context>", f"    <name>{context}</name>"]
        for source in (source for its, source in collected if its == context):
            text = known.get((context, source), "")
            state = "" if text else ' type="unfinished"'
            lines += [
                "    <message>",
                f"        <source>{escape(source)}</source>",
                f"        <translation{state}>{escape(text)}</translation>",
                "    </message>",
            ]
        lines.append("</context>")
    return "\n".join([*lines, "</TS>", ""])


def compile_all() -> int:
    """Compile every .ts file with Qt's lrelease; return the exit code."""
    names = ("lrelease", "pyside6-lrelease", "lrelease-qt5", "lrelease6")
    lrelease = next(filter(None, map(shutil.which, names)), None)
    if lrelease is None:
        print("Qt's lrelease is missing (Debian: qttools5-dev-tools; pip: pyside6-essentials).")
        return 1
    files = [str(HERE / f"SpiralPocket_{language}.ts") for language in LANGUAGES]
    return subprocess.run([lrelease, "-silent", *files], check=False).returncode


if __name__ == "__main__":
    sys.exit(main())

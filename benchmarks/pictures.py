# SPDX-License-Identifier: LGPL-2.1-or-later
# runs in: freecad
"""The pictures of the window in README and docs, taken anew.

    ./dev bench pictures [THEME]

They go to ``build/bench/THEME-NAME.png``, to be looked at before they replace those in
``docs/images``. THEME is one of FreeCAD's own, as "FreeCAD Dark"; without one the window
is as it comes.
"""

import os
import sys
from pathlib import Path
from xml.etree import ElementTree

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "tests" / "gui"), str(ROOT / "benchmarks")]

from conftest import add_job, floors  # noqa: E402
from gui import PARTS  # noqa: E402
from window import (  # noqa: E402
    OK,
    WORKBENCH,
    is_panel_open,
    main_window,
    page,
    press,
    press_toolbar_button,
    pump,
    select,
    wait_for,
    widget,
)

from freecad_spiralpocket.gui.preview.scene import DraftItem  # noqa: E402

SIZE = 1280, 1130  # of the window
PANEL_WIDTH = 400  # of the task panel
FOLDER = Path(os.environ["SPIRALPOCKET_OUT"])


def wear(theme):
    """Give the window a theme: a preference pack of 1.0 and later, a style sheet of 0.20."""
    resources = Path(FreeCAD.getResourceDir())
    pack = resources / "Gui" / "PreferencePacks" / theme / f"{theme}.cfg"
    if pack.exists():
        root = ElementTree.parse(pack).getroot()
        apply(root.find("FCParamGroup/FCParamGroup[@Name='BaseApp']"), "User parameter:BaseApp")
    else:
        FreeCAD.ParamGet("User parameter:BaseApp/Preferences/MainWindow").SetString(
            "StyleSheet", f"{theme}.qss"
        )
        sheet = resources / "Gui" / "Stylesheets" / f"{theme}.qss"
        QtCore.QDir.setSearchPaths("qss", [str(sheet.parent)])
        QtGui.QApplication.instance().setStyleSheet(sheet.read_text(encoding="utf-8"))
    pump(2)


def apply(group, path):
    """Set what a group of a preference pack holds."""
    setters = {
        "FCText": ("SetString", lambda item: item.text or ""),
        "FCBool": ("SetBool", lambda item: item.get("Value") == "1"),
        "FCInt": ("SetInt", lambda item: int(item.get("Value"))),
        "FCUInt": ("SetUnsigned", lambda item: int(item.get("Value"))),
        "FCFloat": ("SetFloat", lambda item: float(item.get("Value"))),
    }
    parameters = FreeCAD.ParamGet(path)
    for item in group:
        if item.tag == "FCParamGroup":
            apply(item, f"{path}/{item.get('Name')}")
        else:
            setter, value_of = setters[item.tag]
            getattr(parameters, setter)(item.get("Name"), value_of(item))


def dock_tasks():
    """Let the task panel stand beside the 3D view, where FreeCAD 1.0 and later lay it over it."""
    window = main_window()
    docks = {dock.objectName(): dock for dock in window.findChildren(QtGui.QDockWidget)}
    if "Std_DockOverlayAll" in FreeCADGui.listCommands():
        FreeCADGui.runCommand("Std_DockOverlayAll")
    pump(0.5)
    tasks = docks.get("Tasks")
    if tasks is not None:
        window.addDockWidget(QtCore.Qt.RightDockWidgetArea, tasks)
        tasks.show()
        window.resizeDocks([tasks], [PANEL_WIDTH], QtCore.Qt.Horizontal)
    pump(0.5)


class Pictures:
    """Takes pictures of the window, each under its name."""

    def __init__(self, theme):
        self.prefix = theme.lower().replace(" ", "-") or "plain"

    def whole(self, name):
        """Keep what the screen shows of the window."""
        main_window().repaint()
        pump(0.5)
        screen = main_window().windowHandle().screen().grabWindow(0)
        self.keep(name, screen.copy(main_window().frameGeometry()))

    def of(self, name, shown):
        """Keep a widget."""
        pump(0.3)
        self.keep(name, shown.grab())

    def keep(self, name, picture):
        """Write a picture."""
        picture.save(str(FOLDER / f"{self.prefix}-{name}.png"))


def open_panel(name):
    """Open the panel on all pockets of a part; return the job."""
    make, diameter, z = PARTS[name]
    document = FreeCAD.newDocument(name)
    job = add_job(document, make(), diameter, feed=3000.0)
    job.Tools.Group[0].SpindleSpeed = 12000
    part = document.getObject("Part")
    select(*((part, face) for face in floors(part, z)))
    press_toolbar_button()
    FreeCADGui.Selection.clearSelection()
    job.Stock.ViewObject.Visibility = False
    wait_for(is_settled, 120)
    view = FreeCADGui.getDocument(document.Name).ActiveView
    pump(0.5)
    view.fitAll()
    FreeCADGui.runCommand("Std_ViewZoomIn")
    FreeCADGui.runCommand("Std_ViewZoomIn")
    show_from_top(widget("strategy"))
    return job


def is_settled():
    """Return whether everything is proved."""
    return page().outlook.is_settled


def show_from_top(shown):
    """Scroll the panel so that a widget is at its top."""
    areas = [a for a in main_window().findChildren(QtGui.QScrollArea) if a.isAncestorOf(shown)]
    if areas:
        innermost = min(areas, key=lambda a: a.height())
        bar = innermost.verticalScrollBar()
        bar.setValue(bar.value() + shown.mapTo(innermost, QtCore.QPoint(0, 0)).y() - 8)
    pump(0.2)


def compared():
    """Return whether all strategies are there or told why not."""
    return all(card.job is None or card.job.is_done for card in page().compare.window.cards)


def take(pictures):
    """Take all."""
    job = open_panel("islands3")
    pictures.whole("panel")
    widget("advanced").setChecked(True)
    pictures.of("page", page().form)
    widget("advanced").setChecked(False)
    show_from_top(page().preview.box)
    pictures.whole("preview")
    widget("stepOverPercent").setValue(30)
    wait_for(lambda: all(isinstance(i, DraftItem) for i in page().preview.items.values()), 20)
    pictures.whole("draft")
    widget("stepOverPercent").setValue(40)
    wait_for(is_settled, 200)
    page().preview.box.slider.setValue(400)
    pictures.whole("player")
    page().preview.box.slider.setValue(1000)
    page().plots.button.setChecked(True)
    pump(1)
    page().plots.dock.point_at(40.0)
    pictures.whole("plots")
    page().plots.button.setChecked(False)
    page().compare.button.click()
    wait_for(compared, 400)
    pump(0.5)
    pictures.of("compare", page().compare.window.dialog)
    page().compare.window.dialog.reject()
    press(OK)
    wait_for(lambda: not is_panel_open())
    view = FreeCADGui.getDocument(job.Document.Name).ActiveView
    view.viewTop()
    view.fitAll()
    pictures.whole("path")
    FreeCAD.closeDocument(job.Document.Name)


def main():
    """Take the pictures."""
    theme = " ".join(sys.argv[1:])
    main_window().resize(*SIZE)
    main_window().move(0, 0)
    FreeCADGui.activateWorkbench(WORKBENCH)
    if theme:
        wear(theme)
    dock_tasks()
    take(Pictures(theme))


main()

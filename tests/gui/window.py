# SPDX-License-Identifier: LGPL-2.1-or-later
"""The user's hands and eyes: presses buttons, reads the window, waits for it.

The tests run inside FreeCAD's event loop; while they run nothing else does, so
whatever the window has to do needs a `pump`. A dialog that blocks is answered
by an `Answer`, which looks for it while the test waits in it.
"""

import gc
import time
from contextlib import contextmanager

import FreeCAD
import FreeCADGui
import numpy as np
from PySide import QtCore, QtGui

from freecad_spiralpocket.gui.qt.later import later

IS_LEGACY = "CAMWorkbench" not in FreeCADGui.listWorkbenches()
WORKBENCH = "PathWorkbench" if IS_LEGACY else "CAMWorkbench"
VERSION = ".".join(FreeCAD.Version()[:2])
COMMAND = "SpiralPocket_Create"
OK, APPLY, CANCEL = (
    QtGui.QDialogButtonBox.Ok,
    QtGui.QDialogButtonBox.Apply,
    QtGui.QDialogButtonBox.Cancel,
)


#: Loops that are not running. None goes, for the same reason as timers (later.py).
_LOOPS = []

#: How long the window works for what a press of a button brings [s].
AFTER_PRESS = 0.1


def pump(seconds=0.05):
    """Let the window work for `seconds`."""
    loop = _LOOPS.pop() if _LOOPS else QtCore.QEventLoop()
    later(int(1000 * seconds), loop.quit)
    (getattr(loop, "exec", None) or loop.exec_)()
    _LOOPS.append(loop)


def wait_for(condition, seconds=20):
    """Let the window work until `condition()` holds."""
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, f"waited {seconds} s in vain"
        pump()


def main_window():
    """Return FreeCAD's main window."""
    return FreeCADGui.getMainWindow()


def action(widget):
    """Return the command's action in a toolbar or menu, or None."""
    return next((a for a in widget.actions() if a.objectName() == COMMAND), None)


def toolbar(name="New Operations"):
    """Return the toolbar of that name, of the workbench that is active."""
    return next(t for t in main_window().findChildren(QtGui.QToolBar) if t.objectName() == name)


def menus():
    """Return the menus of the menu bar that can be opened, with those inside them."""
    bar = main_window().menuBar()
    tops = [m for m in bar.findChildren(QtGui.QMenu) if m.menuAction() in bar.actions()]
    shown = [m for m in tops if m.menuAction().isVisible()]
    return shown + [inner for m in shown for inner in m.findChildren(QtGui.QMenu)]


def select(*pairs):
    """Select the faces given as pairs of object and name."""
    FreeCADGui.Selection.clearSelection()
    for obj, name in pairs:
        FreeCADGui.Selection.addSelection(obj, name)


def press_toolbar_button():
    """Press the command's toolbar button and wait for what comes of it."""
    pump()  # the selection enables the button
    button = toolbar().widgetForAction(action(toolbar()))
    assert button.isEnabled()
    button.click()
    pump(AFTER_PRESS)


def set_units(document, number):
    """Choose units by FreeCAD's number for them."""
    FreeCAD.Units.setSchema(number)
    if hasattr(document, "UnitSystem"):  # since 1.0 documents have a unit system of their own
        document.UnitSystem = document.getEnumerationsOfProperty("UnitSystem")[number]


def is_panel_open():
    """Return whether a task panel is open."""
    return bool(FreeCADGui.Control.activeDialog())


def panel():
    """Return the operation's open panel.

    Reached through the operation: a search through the window's widgets would wake Qt 5's
    memory of those that are gone.
    """
    proxies = [
        o.ViewObject.Proxy
        for document in FreeCAD.listDocuments().values()
        for o in document.findObjects("Path::Feature")
    ]
    return next(p.panel for p in proxies if getattr(p, "panel", None) is not None)


def page():
    """Return the open panel's own page."""
    return panel().operation_page


def settle():
    """Wait until every pocket of the open panel is proved."""
    wait_for(lambda: page().outlook.is_settled, 60)


def widget(name):
    """Return the widget of that name in the open panel's own page."""
    return getattr(page().form, name)


def type_into(box, letters):
    """Replace what a box holds by typing, without leaving it."""
    box.setFocus()
    box.selectAll()
    for letter in letters:
        strike(box, ord(letter.upper()), letter)
    pump()


def enter(box, letters):
    """Replace what a box holds by typing, and leave it."""
    type_into(box, letters)
    leave(box)


def leave(box):
    """Take the focus from a box, which the window may never have had without a window manager."""
    box.clearFocus()
    QtGui.QApplication.sendEvent(box, QtGui.QFocusEvent(QtCore.QEvent.FocusOut))
    pump()


def strike(box, key, letter=""):
    """Press a key and let it go."""
    for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
        event = QtGui.QKeyEvent(kind, int(key), QtCore.Qt.NoModifier, letter)
        QtGui.QApplication.sendEvent(box, event)


def remarks():
    """Return what the result box of the open panel remarks, in one text."""
    box = page().result_box.list
    return " ".join(box.item(row).text() for row in range(box.count()))


def panel_button(which):
    """Return the panel's button OK, APPLY or CANCEL."""
    return panel().buttonBox.button(which)


def press(which):
    """Press the panel's button OK, APPLY or CANCEL and wait for what comes of it."""
    panel_button(which).click()
    pump(AFTER_PRESS)


def edit(obj):
    """Open the panel of an operation as a double click in the tree does."""
    FreeCADGui.getDocument(obj.Document.Name).setEdit(obj.ViewObject, 0)
    pump(AFTER_PRESS)


def dialog(name):
    """Return the visible dialog with that object name, or None.

    PySide 2 crashes if garbage with a widget in it is collected while it makes the list.
    """
    was_enabled = gc.isenabled()
    gc.disable()
    try:
        tops = QtGui.QApplication.topLevelWidgets()
        return next((w for w in tops if w.objectName() == name and w.isVisible()), None)
    finally:
        if was_enabled:
            gc.enable()


class Answer:
    """Presses OK on message boxes of ours and keeps their texts."""

    def __init__(self):
        self.texts = []
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._look)

    def _look(self):
        box = dialog("SpiralPocketMessage")
        if box is not None:
            self.texts.append(f"{box.text()} {box.informativeText()}".strip())
            box.button(QtGui.QMessageBox.Ok).click()


@contextmanager
def answered():
    """Answer message boxes in the block; yields the `Answer`."""
    answer = Answer()
    answer._timer.start(50)
    try:
        yield answer
    finally:
        answer._timer.stop()


def report_view():
    """Return the text of the Report view."""
    docks = main_window().findChildren(QtGui.QDockWidget, "Report view")
    return docks[0].findChild(QtGui.QTextEdit).toPlainText()


def screenshot():
    """Return what the screen shows, as an image."""
    main_window().repaint()
    pump(0.3)
    window = main_window()
    picture = window.windowHandle().screen().grabWindow(0)
    return picture.copy(window.frameGeometry()).toImage()


def pixels_that_differ(image, other):
    """Return how many pixels of two images of one size differ."""
    one, two = (
        np.frombuffer(i.convertToFormat(QtGui.QImage.Format_RGB32).constBits(), np.uint32)
        for i in (image, other)
    )
    return int(np.count_nonzero(one != two))

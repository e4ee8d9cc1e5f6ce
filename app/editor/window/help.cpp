// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/help.h"

#include <QCoreApplication>
#include <QMessageBox>

namespace patina {
namespace {

QString helpText(const char* text) {
    return QCoreApplication::translate("Help", text);
}

} // namespace

std::vector<KeyRow> viewKeys() {
    return {
        {helpText("Left drag, Alt+left"), helpText("orbit")},
        {helpText("Middle drag, Shift+left, Alt+middle"), helpText("pan")},
        {helpText("Wheel, right drag, Alt+right"), helpText("move nearer or farther")},
        {helpText("Ctrl+left drag"), helpText("turn the object")},
        {helpText("L and left drag"), helpText("turn the key light")},
        {helpText("Shift+right drag"), helpText("turn the environment")},
        {helpText("Click, Ctrl+click"), helpText("select an object, several")},
        {helpText("Esc while dragging"), helpText("take the drag back")},
        {helpText("Ctrl+wheel"), helpText("nearer or farther, towards the pointer")},
        {helpText("Arrows, with Shift; + and -"), helpText("orbit, pan; nearer, farther")},
        {helpText("1 to 9; with Ctrl"), helpText("go to a kept view; keep the view")},
        {helpText("Alt+Z, Shift+Alt+Z"), helpText("undo and redo moves of the camera")},
        {helpText("Double click"), helpText("turn about that point of the surface")},
        {helpText("C"), helpText("compare in the next way; Ctrl+Shift+B: one view more")},
        {helpText("Space"),
         helpText("reset the view; where A and B are one picture, hold it: the other side")},
        {helpText("[ and ], Shift: { and }"), helpText("move and turn the line between them")},
        {helpText("Page Down, Page Up; with Shift"),
         helpText("next and previous preset on B; on A")},
        {helpText("Arrows in the library or the bar of the comparison; with Shift"),
         helpText("while comparing: next and previous preset on B; on A")},
        {helpText("N"), helpText("numerical check of every pixel")},
        {helpText("F"), helpText("frame the object; once more: all of them")},
        {helpText("Home"), helpText("reset the view")},
        {helpText("1, 3, 7 of the number pad; with Ctrl"),
         helpText("from the front, the right, above; from behind them")},
        {helpText("2, 4, 6, 8 of the number pad"), helpText("orbit")},
        {helpText("5 of the number pad"), helpText("orthographic, and back")},
        {helpText("Drag on a slider or a name"), helpText("change it; Shift: finer, Ctrl: steps")},
        {helpText("Ctrl+C, X, V; in lists Ctrl+D"),
         helpText("copy, cut, paste, duplicate objects and lights")},
        {helpText("Ctrl+C, Ctrl+V on a value"), helpText("copy and paste it with its image")},
        {helpText("Arrows, Page Up, Page Down"), helpText("one step, ten steps")},
        {helpText("Backspace, double click on a name"), helpText("back to the default")},
        {helpText("L and click, with Shift"),
         helpText("put the light's highlight there; the object's shadow")},
        {helpText("W, R, S"),
         helpText("handles that move, turn and scale; drag with Ctrl for steps")},
        {helpText("Drag of a lamp"),
         helpText("move the light, its target, its distance, its cone")}};
}

void showAbout(QWidget* window) {
    QMessageBox::about(
        window, helpText("About Patina"),
        helpText("<p><b>Patina %1</b></p><p>An editor of lighting models.</p>"
                 "<p>The program is free software under the GNU General Public License, "
                 "version 3 or later. What you make with it is yours.</p>")
            .arg(QCoreApplication::applicationVersion()));
}

} // namespace patina

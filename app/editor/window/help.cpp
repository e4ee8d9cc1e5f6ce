// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/help.h"

#include <iterator>

#include <QCoreApplication>
#include <QMessageBox>

namespace patina {
namespace {

QString helpText(const char* text) {
    return QCoreApplication::translate("Help", text);
}

/// Lists what moves the camera, as CameraNavigation does in each scheme.
std::vector<KeyRow> cameraDrags(MouseScheme scheme) {
    const auto rows = [](const QString& orbit, const QString& pan, const QString& dolly) {
        return std::vector<KeyRow>{{orbit, helpText("Orbit")},
                                   {pan, helpText("Pan")},
                                   {dolly, helpText("Move nearer or farther")}};
    };
    switch (scheme) {
    case MouseScheme::Maya:
        return rows(helpText("Alt+left drag"), helpText("Alt+middle drag"),
                    helpText("Alt+right drag"));
    case MouseScheme::Blender:
        return rows(helpText("Middle drag, Alt+left"), helpText("Shift+middle drag"),
                    helpText("Ctrl+middle drag, right drag"));
    case MouseScheme::Trackpad:
        return rows(helpText("Two fingers, left drag"), helpText("Shift+two fingers, Shift+left"),
                    helpText("Ctrl+two fingers, right drag"));
    default:
        return rows(helpText("Left drag, Alt+left"),
                    helpText("Middle drag, Shift+left, Alt+middle"),
                    helpText("Right drag, Alt+right"));
    }
}

} // namespace

std::vector<KeyRow> viewKeys(const MouseHabits& habits) {
    std::vector<KeyRow> rows = cameraDrags(habits.scheme);
    if (habits.scheme != MouseScheme::Trackpad && habits.wheelZooms) {
        rows.push_back({helpText("Wheel"), helpText("Move nearer or farther")});
    }
    const KeyRow others[] = {
        {helpText("Ctrl+wheel"), helpText("Move nearer or farther, towards the pointer")},
        {helpText("Ctrl+left drag"), helpText("Turn the object")},
        {helpText("L and left drag"), helpText("Turn the key light")},
        {helpText("Shift+right drag"), helpText("Turn the environment")},
        {helpText("Click, Ctrl+click"), helpText("Select an object, several")},
        {helpText("Esc while dragging"), helpText("Take the drag back")},
        {helpText("Arrows, with Shift; + and -"), helpText("Orbit, pan; nearer, farther")},
        {helpText("1 to 9; with Ctrl"), helpText("Go to a kept view; keep the view")},
        {helpText("Alt+Z, Shift+Alt+Z"), helpText("Undo and redo moves of the camera")},
        {helpText("Double click"), helpText("Turn about that point of the surface")},
        {helpText("F"), helpText("Frame the object; once more: all of them")},
        {helpText("Home"), helpText("Reset the view")},
        {helpText("1, 3, 7 of the number pad; with Ctrl"),
         helpText("From the front, the right, above; from behind them")},
        {helpText("2, 4, 6, 8 of the number pad"), helpText("Orbit")},
        {helpText("5 of the number pad"), helpText("Orthographic, and back")},
        {helpText("W, R, S"),
         helpText("Handles that move, turn and scale; drag with Ctrl for steps")},
        {helpText("Drag of a lamp"),
         helpText("Move the light, its target, its distance, its cone")},
        {helpText("L and click, with Shift"),
         helpText("Put the light's highlight there; the object's shadow")},
        {helpText("N"), helpText("Numerical check of every pixel")},
        {helpText("C"), helpText("Compare in the next way; Ctrl+Shift+B: one view more")},
        {helpText("Space"),
         helpText("Reset the view; where A and B are one picture, hold it: the other side")},
        {helpText("[ and ], Shift: { and }"), helpText("Move and turn the line between them")},
        {helpText("Page Down, Page Up; with Shift"),
         helpText("Next and previous preset on B; on A")},
        {helpText("Arrows in library or bar; with Shift"),
         helpText("While comparing: next and previous preset on B; on A")}};
    rows.insert(rows.end(), std::begin(others), std::end(others));
    return rows;
}

std::vector<KeyRow> valueKeys() {
    return {
        {helpText("Drag on a slider or a name"), helpText("Change it; Shift: finer, Ctrl: steps")},
        {helpText("Arrows, Page Up, Page Down"), helpText("One step, ten steps")},
        {helpText("Backspace, double click on a name"), helpText("Back to the default")},
        {helpText("Ctrl+C, Ctrl+V on a value"), helpText("Copy and paste it with its image")},
        {helpText("Ctrl+C, X, V; in lists Ctrl+D"),
         helpText("Copy, cut, paste, duplicate objects and lights")}};
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

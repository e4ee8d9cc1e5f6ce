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

void showKeys(QWidget* window) {
    const auto row = [](const QString& keys, const QString& what) {
        return QStringLiteral("<tr><td><b>%1</b></td><td>&nbsp;&nbsp;%2</td></tr>").arg(keys, what);
    };
    const QString table =
        "<table>" + row(helpText("Left drag, Alt+left"), helpText("orbit")) +
        row(helpText("Middle drag, Shift+left, Alt+middle"), helpText("pan")) +
        row(helpText("Wheel, right drag, Alt+right"), helpText("move nearer or farther")) +
        row(helpText("Ctrl+left drag"), helpText("turn the object")) +
        row(helpText("L and left drag"), helpText("turn the key light")) +
        row(helpText("Shift+right drag"), helpText("turn the environment")) +
        row(helpText("Double click"), helpText("turn about that point of the surface")) +
        row(helpText("C"), helpText("compare in the next way; Ctrl+Shift+B: one view more")) +
        row(helpText("Space"), helpText("hold it: the other side, where A and B are one picture")) +
        row(helpText("[ and ], Shift: { and }"), helpText("move and turn the line between them")) +
        row(helpText("Page Down, Page Up; with Shift"),
            helpText("next and previous preset on B; on A")) +
        row(helpText("N"), helpText("numerical check of every pixel")) +
        row(helpText("F"), helpText("frame the object; once more: all of them")) +
        row(helpText("Home"), helpText("reset the view")) +
        row(helpText("1, 3, 7 of the number pad"), helpText("from the front, the right, above")) +
        row(helpText("Drag on a slider or a name"),
            helpText("change it; Shift: finer, Ctrl: steps")) +
        row(helpText("Arrows, Page Up, Page Down"), helpText("one step, ten steps")) +
        row(helpText("Backspace, double click on a name"), helpText("back to the default")) +
        "</table>";
    QMessageBox::information(window, helpText("Mouse and Keys"), table);
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

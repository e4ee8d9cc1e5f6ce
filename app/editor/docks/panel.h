// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QString>

class QLabel;
class QToolButton;
class QWidget;

namespace patina {

/// Lays out a dock's widget: fixed rows on top, and `scrolled` below, which grows and scrolls.
void fillPanel(QWidget* panel, const std::vector<QWidget*>& rows, QWidget* scrolled);

/// Returns a scroll area without a frame around `content`, which scrolls up and down. It is at
/// least as wide as its content, up to 340 pixels; wider content scrolls sideways, too.
QWidget* scrolledUpDown(QWidget* content);

/// Scrolls a panel of fillPanel() so far that the section with a title is seen from its top.
void scrollToSection(const QWidget& panel, const QString& title);

/// Returns a row of a label and a widget, which is the label's buddy.
QWidget* labelled(const QString& text, QWidget* widget);

/// Returns a row of widgets, of which the first takes the room that is left.
QWidget* rowOf(const std::vector<QWidget*>& widgets);

/// Returns a word-wrapped, faint line of help.
QLabel* hintLabel(QWidget* parent);

/// Returns a flat button with a text. The tool tip is its accessible name, too.
QToolButton* textButton(const QString& text, const QString& toolTip, QWidget* parent);

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QString>

class QLabel;
class QToolButton;
class QWidget;

namespace patina {

/// Lays out a dock's widget: fixed rows on top, and below them what may grow and scroll.
void fillPanel(QWidget* panel, const std::vector<QWidget*>& rows, QWidget* scrolled);

/// A widget in a scroll area without a frame that scrolls up and down. It cannot be made narrower
/// than its content; one that is very wide scrolls to the sides, too.
QWidget* scrolledUpDown(QWidget* content);

/// Returns a label before a widget, as its buddy.
QWidget* labelled(const QString& text, QWidget* widget);

/// Returns widgets in one row, the first stretched.
QWidget* rowOf(const std::vector<QWidget*>& widgets);

/// Returns a word-wrapped, faint line of help.
QLabel* hintLabel(QWidget* parent);

/// Returns a flat button with a text.
QToolButton* textButton(const QString& text, const QString& toolTip, QWidget* parent);

} // namespace patina

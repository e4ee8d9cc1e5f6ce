// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

namespace patina {
namespace {

constexpr int margin = 6;

} // namespace

void fillPanel(QWidget* panel, const std::vector<QWidget*>& rows, QWidget* scrolled) {
    auto* layout = new QVBoxLayout(panel);
    layout->setContentsMargins(margin, margin, margin, 0);
    layout->setSpacing(margin);
    for (QWidget* row : rows) {
        layout->addWidget(row);
    }
    layout->addWidget(scrolledUpDown(scrolled), 1);
}

QWidget* scrolledUpDown(QWidget* content) {
    auto* area = new QScrollArea;
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setFocusPolicy(Qt::NoFocus);
    auto* holder = new QWidget;
    auto* layout = new QVBoxLayout(holder);
    layout->setContentsMargins(0, 0, 0, margin);
    layout->addWidget(content);
    layout->addStretch(1);
    area->setWidget(holder);
    return area;
}

QWidget* labelled(const QString& text, QWidget* widget) {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* label = new QLabel(text);
    label->setBuddy(widget);
    layout->addWidget(label);
    layout->addWidget(widget, 1);
    return row;
}

QWidget* rowOf(const std::vector<QWidget*>& widgets) {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    for (std::size_t i = 0; i < widgets.size(); ++i) {
        layout->addWidget(widgets[i], i == 0 ? 1 : 0);
    }
    return row;
}

QLabel* hintLabel(QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setWordWrap(true);
    label->setForegroundRole(QPalette::PlaceholderText);
    return label;
}

QToolButton* textButton(const QString& text, const QString& toolTip, QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setText(text);
    button->setToolTip(toolTip);
    button->setAccessibleName(toolTip);
    button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    return button;
}

} // namespace patina

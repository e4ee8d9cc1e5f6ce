// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/task_popup.h"

#include <algorithm>
#include <cmath>

#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "text/short_text.h"

namespace patina {
namespace {

constexpr int popupWidth = 360;
constexpr int wholeShare = 100;

} // namespace

TaskPopup::TaskPopup(LongTasks& tasks, QWidget* parent)
    : QFrame(parent, Qt::Popup), tasks_(tasks), column_(new QVBoxLayout(this)) {
    setAttribute(Qt::WA_DeleteOnClose);
    setFrameShape(QFrame::StyledPanel);
    setObjectName("taskPopup");
    setAccessibleName(tr("What is going on"));
    setFixedWidth(popupWidth);
    connect(&tasks_, &LongTasks::changed, this, &TaskPopup::follow);
    follow();
}

void TaskPopup::showAt(const QPoint& place) {
    corner_ = place;
    adjustSize();
    move(corner_ - QPoint(width(), height()));
    show();
}

void TaskPopup::follow() {
    const std::vector<LongTasks::Row> rows = tasks_.shown();
    if (rows.empty()) {
        close();
        return;
    }
    const auto isGone = [&](const auto& line) {
        return std::ranges::find(rows, line.first, &LongTasks::Row::number) == rows.end();
    };
    for (const auto& [number, line] : lines_) {
        if (isGone(std::pair(number, 0))) {
            line.widget->hide();
            line.widget->deleteLater();
        }
    }
    std::erase_if(lines_, isGone);
    for (const LongTasks::Row& row : rows) {
        Line& shown = line(row.number, row.name);
        shown.doing->setText(shortened(row.state.doing));
        shown.doing->setVisible(!row.state.doing.isEmpty());
        shown.share->setVisible(row.state.share >= 0.0);
        shown.share->setValue(static_cast<int>(std::lround(row.state.share * wholeShare)));
        shown.cancel->setVisible(row.canCancel);
    }
    if (isVisible()) {
        adjustSize();
        move(corner_ - QPoint(width(), height()));
    }
}

TaskPopup::Line& TaskPopup::line(quint64 number, const QString& name) {
    if (const auto known = lines_.find(number); known != lines_.end()) {
        return known->second;
    }
    auto* widget = new QWidget(this);
    Line made{widget, new QLabel(shortened(name), widget), new QLabel(widget),
              new QProgressBar(widget), new QToolButton(widget)};
    made.doing->setForegroundRole(QPalette::PlaceholderText);
    made.doing->setTextFormat(Qt::PlainText);
    made.share->setRange(0, wholeShare);
    made.share->setAccessibleName(tr("Progress of %1").arg(name));
    made.cancel->setText(tr("Cancel"));
    made.cancel->setToolTip(tr("Stop %1").arg(name));
    made.cancel->setAccessibleName(made.cancel->toolTip());
    connect(made.cancel, &QToolButton::clicked, this, [this, number] { tasks_.cancel(number); });
    auto* grid = new QGridLayout(widget);
    grid->setContentsMargins(4, 2, 4, 2);
    grid->setColumnStretch(0, 1);
    grid->addWidget(made.name, 0, 0);
    grid->addWidget(made.doing, 1, 0);
    grid->addWidget(made.share, 2, 0);
    grid->addWidget(made.cancel, 0, 1, 3, 1, Qt::AlignVCenter);
    column_->addWidget(widget);
    return lines_.emplace(number, made).first->second;
}

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/parameter_section.h"

#include <QToolButton>
#include <QVBoxLayout>

#include "parameters/parameter_row.h"

namespace patina {

ParameterSection::ParameterSection(const QString& title, bool isFolded, QWidget* parent)
    : QWidget(parent), title_(title), header_(new QToolButton(this)), body_(new QWidget(this)),
      rows_(new QVBoxLayout(body_)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 6, 0, 0);
    column->setSpacing(2);
    column->addWidget(header_);
    column->addWidget(body_);
    rows_->setContentsMargins(0, 0, 0, 0);
    rows_->setSpacing(4);

    QFont bold = font();
    bold.setBold(true);
    header_->setFont(bold);
    header_->setText(title);
    header_->setMinimumWidth(1); // a long title is cut, not the rows beside it
    header_->setAutoRaise(true);
    header_->setFocusPolicy(Qt::StrongFocus);
    header_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed); // easy to hit
    header_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    header_->setAccessibleName(tr("Group %1").arg(title));
    header_->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(header_, &QWidget::customContextMenuRequested, this,
            [this](const QPoint& at) { Q_EMIT menuWished(header_->mapToGlobal(at)); });
    connect(header_, &QToolButton::clicked, this, [this] { setFolded(!isFolded_); });
    setFolded(isFolded);
}

std::vector<ParameterRow*> ParameterSection::parameterRows() const {
    std::vector<ParameterRow*> all;
    for (int i = 0; i < rows_->count(); ++i) {
        all.push_back(qobject_cast<ParameterRow*>(rows_->itemAt(i)->widget()));
    }
    return all;
}

void ParameterSection::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    showTitle();
}

/// Shows as much of the title as has room beside the arrow.
void ParameterSection::showTitle() {
    const int arrow = header_->iconSize().width() + 4 * header_->fontMetrics().averageCharWidth();
    const int room = width() - arrow;
    const QString shown = header_->fontMetrics().elidedText(title_, Qt::ElideRight, room);
    header_->setText(shown);
    header_->setToolTip(shown == title_ ? QString() : title_); // says no more than is to be seen
}

void ParameterSection::setFolded(bool isFolded) {
    isFolded_ = isFolded;
    header_->setArrowType(isFolded ? Qt::RightArrow : Qt::DownArrow);
    header_->setAccessibleDescription(isFolded ? tr("Folded") : tr("Open"));
    body_->setVisible(!isFolded);
    Q_EMIT folded(isFolded);
}

} // namespace patina

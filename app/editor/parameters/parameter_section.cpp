// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/parameter_section.h"

#include <QToolButton>
#include <QVBoxLayout>

namespace patina {

ParameterSection::ParameterSection(const QString& title, bool isFolded, QWidget* parent)
    : QWidget(parent), header_(new QToolButton(this)), body_(new QWidget(this)),
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
    header_->setCheckable(true);
    header_->setAutoRaise(true);
    header_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    header_->setAccessibleName(tr("Group %1").arg(title));
    connect(header_, &QToolButton::toggled, this, [this](bool isOpen) {
        header_->setArrowType(isOpen ? Qt::DownArrow : Qt::RightArrow);
        body_->setVisible(isOpen);
    });
    header_->setArrowType(Qt::RightArrow);
    body_->setVisible(false);
    header_->setChecked(!isFolded);
}

QString ParameterSection::title() const {
    return header_->text();
}

bool ParameterSection::isFolded() const {
    return !header_->isChecked();
}

} // namespace patina

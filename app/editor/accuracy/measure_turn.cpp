// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/measure_turn.h"

#include <QWidget>

namespace patina {

bool MeasureTurn::take(const QWidget& page) {
    if (holder_ != nullptr && holder_ != &page) {
        return false;
    }
    holder_ = &page;
    Q_EMIT changed();
    return true;
}

void MeasureTurn::giveBack(const QWidget& page) {
    if (holder_ == &page) {
        holder_ = nullptr;
        Q_EMIT changed();
    }
}

QString MeasureTurn::whyNot(const QWidget& page) const {
    if (holder_ == nullptr || holder_ == &page) {
        return {};
    }
    return tr("“%1” is being measured. Two measurements at once would spoil each other's times.")
        .arg(holder_->windowTitle());
}

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/comparison_readout.h"

#include <utility>

#include <QMouseEvent>
#include <QWidget>

#include "viewport/comparison_meter.h"
#include "viewport/comparison_text.h"

namespace patina {

ComparisonReadout::ComparisonReadout(const Document& document, const ComparisonMeter& meter)
    : document_(document), meter_(meter) {
    connect(&meter_, &ComparisonMeter::framesChanged, this, &ComparisonReadout::publish);
    connect(&meter_, &ComparisonMeter::numbersChanged, this, &ComparisonReadout::publish);
}

void ComparisonReadout::watch(QWidget& widget, std::function<QRect()> place) {
    places_.insert(&widget, std::move(place));
    widget.installEventFilter(this);
}

bool ComparisonReadout::eventFilter(QObject* watched, QEvent* event) {
    const bool isOver = event->type() == QEvent::MouseMove;
    if (isOver || event->type() == QEvent::Leave) {
        const QRect place = places_.value(watched)();
        pointer_.reset();
        if (isOver && !place.isEmpty()) {
            const QPointF at =
                static_cast<QMouseEvent*>(event)->position() - QPointF(place.topLeft());
            pointer_ = QPointF(at.x() / place.width(), at.y() / place.height());
        }
        publish();
    }
    return QObject::eventFilter(watched, event);
}

void ComparisonReadout::publish() {
    const bool isPixelKnown = pointer_ && meter_.isUpToDate() && document_.isComparing();
    Q_EMIT changed(isPixelKnown ? pixelText(*meter_.frames(), meter_.other(), *pointer_)
                                : comparisonText(meter_.numbers()),
                   comparisonDetails(meter_.numbers()));
}

} // namespace patina

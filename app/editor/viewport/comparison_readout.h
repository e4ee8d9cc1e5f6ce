// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include <QHash>
#include <QObject>
#include <QPointF>
#include <QRect>

#include "document/document.h"

class QWidget;

namespace patina {

class ComparisonMeter;

/// Says how far A and another side are apart and, while the pointer is over a picture, what both
/// have there.
class ComparisonReadout : public QObject {
    Q_OBJECT

  public:
    /// Both outlive it.
    ComparisonReadout(const Document& document, const ComparisonMeter& meter);

    /// Follows the pointer over a widget, whose picture lies at `place`, in its pixels.
    void watch(QWidget& widget, std::function<QRect()> place);

  Q_SIGNALS:
    /// Tells what is known now; both texts are empty while nothing is.
    void changed(const QString& text, const QString& details);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void publish();

    const Document& document_;
    const ComparisonMeter& meter_;
    QHash<QObject*, std::function<QRect()>> places_; ///< by the widget that shows the picture
    std::optional<QPointF> pointer_; ///< over a picture, as a share of its width and height
};

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProxyStyle>

namespace patina {

/// Fusion, but what it draws too dark to see in a dark look: outlines of check boxes and the
/// buttons of docks, which follow the palette also when it changes.
class LookStyle : public QProxyStyle {
    Q_OBJECT

  public:
    LookStyle();

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
    QIcon standardIcon(StandardPixmap icon, const QStyleOption* option,
                       const QWidget* widget) const override;
};

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProxyStyle>

namespace patina {

/// Draws as the Fusion style does, but in visible colours what Fusion draws too dark in a dark
/// look: outlines of check boxes and the buttons of docks. These follow the palette also when it
/// changes. Menus may have icons of a size of their own.
class LookStyle : public QProxyStyle {
    Q_OBJECT

  public:
    LookStyle();

    /// Names the property of a menu that says how large its icons are, in pixels.
    static constexpr const char* iconSize = "iconSize";

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
    int pixelMetric(PixelMetric metric, const QStyleOption* option,
                    const QWidget* widget) const override;
    QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents,
                           const QWidget* widget) const override;
    QIcon standardIcon(StandardPixmap icon, const QStyleOption* option,
                       const QWidget* widget) const override;
};

} // namespace patina

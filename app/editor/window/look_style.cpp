// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/look_style.h"

#include <optional>

#include <QApplication>
#include <QIconEngine>
#include <QMenu>
#include <QPainter>
#include <QStyleFactory>
#include <QStyleOption>

namespace patina {
namespace {

constexpr int outlineAlpha = 130; ///< 0 .. 255
constexpr qreal inset = 0.28;     ///< is the margin around a sign, as a share of the icon
constexpr qreal penShare = 0.09;
constexpr int rowMargin = 4; ///< pixels above and below a large icon, together

/// Returns the size that a menu has given its icons, in pixels; nothing where it has given none,
/// and for other widgets.
std::optional<int> ownIconSize(const QWidget* widget) {
    if (qobject_cast<const QMenu*>(widget) == nullptr) {
        return std::nullopt;
    }
    const QVariant size = widget->property(LookStyle::iconSize);
    return size.isValid() ? std::optional(size.toInt()) : std::nullopt;
}

/// Draws a sign of lines in the palette's current colour.
class LineIcon : public QIconEngine {
  public:
    explicit LineIcon(QStyle::StandardPixmap sign) : sign_(sign) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
        const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
        const qreal air = inset * rect.width();
        const QRectF box = QRectF(rect).adjusted(air, air, -air, -air);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setPen(QPen(QApplication::palette().color(group, QPalette::WindowText),
                             penShare * rect.width()));
        if (sign_ == QStyle::SP_TitleBarCloseButton) {
            painter->drawLine(box.topLeft(), box.bottomRight());
            painter->drawLine(box.topRight(), box.bottomLeft());
        } else {
            const qreal step = 0.3 * box.width();
            painter->drawRect(box.adjusted(0, step, -step, 0));
            painter->drawPolyline(QPolygonF{box.topLeft() + QPointF(step, 0), box.topRight(),
                                            box.bottomRight() - QPointF(0, step)});
        }
        painter->restore();
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect({}, size), mode, state);
        return pixmap;
    }

    QIconEngine* clone() const override { return new LineIcon(*this); }

  private:
    QStyle::StandardPixmap sign_;
};

} // namespace

LookStyle::LookStyle() : QProxyStyle(QStyleFactory::create("Fusion")) {}

void LookStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
                              QPainter* painter, const QWidget* widget) const {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    if (element == PE_IndicatorCheckBox) {
        QColor outline = option->palette.color(QPalette::Text);
        outline.setAlpha(outlineAlpha);
        painter->setPen(outline);
        painter->setBrush(Qt::NoBrush);
        painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
    }
}

int LookStyle::pixelMetric(PixelMetric metric, const QStyleOption* option,
                           const QWidget* widget) const {
    const std::optional<int> own = metric == PM_SmallIconSize ? ownIconSize(widget) : std::nullopt;
    return own ? *own : QProxyStyle::pixelMetric(metric, option, widget);
}

/// Makes rows of a menu as high as their icons; Fusion's are as high as their texts.
QSize LookStyle::sizeFromContents(ContentsType type, const QStyleOption* option,
                                  const QSize& contents, const QWidget* widget) const {
    const QSize size = QProxyStyle::sizeFromContents(type, option, contents, widget);
    const std::optional<int> own = type == CT_MenuItem ? ownIconSize(widget) : std::nullopt;
    return own ? size.expandedTo({0, *own + rowMargin}) : size;
}

QIcon LookStyle::standardIcon(StandardPixmap icon, const QStyleOption* option,
                              const QWidget* widget) const {
    if (icon == SP_TitleBarCloseButton || icon == SP_TitleBarNormalButton) {
        return QIcon(new LineIcon(icon));
    }
    return QProxyStyle::standardIcon(icon, option, widget);
}

} // namespace patina

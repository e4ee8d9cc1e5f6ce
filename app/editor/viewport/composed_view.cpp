// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/composed_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QCoreApplication>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include "viewport/view_links.h"

namespace patina {
namespace {

constexpr double grabbed = 7.0; ///< pixels; the line can be dragged from this near
constexpr double gripRadius = 9.0;
constexpr double knobRadius = 6.0;
constexpr double turnStep = 15.0; ///< degrees; the line turns in these steps with Shift
constexpr int labelMargin = 8;
constexpr int labelPadding = 6;
constexpr int linksGap = 4;
constexpr int labelOpacity = 225; ///< 0 .. 255

Side otherThan(Side side) {
    return side == Side::A ? Side::B : Side::A;
}

double distance(const QPointF& a, const QPointF& b) {
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

/// Strokes twice, so that lines are seen on bright and on dark pictures.
void strokeTwice(QPainter& painter, const auto& stroke) {
    painter.setPen(QPen(QColor(0, 0, 0, 150), 4.0));
    stroke();
    painter.setPen(QPen(QColor(0xf5, 0xf5, 0xf5), 2.0));
    stroke();
}

} // namespace

ComposedView::ComposedView(Document& document, EffectSwitches& switches, SideView& first,
                           SideView& second, QWidget* parent)
    : QWidget(parent), document_(document), first_(first), second_(second) {
    setMouseTracking(true);
    setAcceptDrops(true);
    reading_.setSingleShot(true);
    reading_.setInterval(0);
    connect(&reading_, &QTimer::timeout, this, &ComposedView::read);
    connect(&blink_, &QTimer::timeout, this, [this] {
        blinksSecond_ = !blinksSecond_;
        update();
    });
    for (const Side side : {Side::A, Side::B}) {
        connect(&view(side).viewport().frames(), &FrameLoop::frameDrawn, this,
                [this, side] { readSoon(side); });
        connect(&view(side), &SideView::captionChanged, this, qOverload<>(&QWidget::update));
        auto* links = new ViewLinks(document_, switches, side, this);
        links->setStyleSheet(QStringLiteral("QToolButton { color: #f0f0f0; background: rgba(0, 0, "
                                            "0, 60%); border: none; border-radius: 4px; padding: "
                                            "2px 14px 2px 6px; }"));
        links->setCursor(Qt::ArrowCursor);
        links_[indexOf(side)] = links;
    }
    const auto later = [this] { placeLinks(); };
    onChange(document, DocumentChange::OwnView | DocumentChange::Scene | DocumentChange::Value,
             this, later);
    onChange(document, DocumentChange::Current, this, qOverload<>(&QWidget::update));
}

void ComposedView::setLook(const CompareLook& look) {
    look_ = look;
    setAccessibleName(tr("A and B as one picture: %1").arg(rowOf(look.mode).shownLabel()));
    followBlink();
    placeLinks();
    update();
}

/// Tells whether side B is where the title of A stands otherwise.
bool ComposedView::hasTitlesSwapped() const {
    return look_.mode == CompareMode::Wipe && line().depthInB({0.0, 0.0}) > 0.0;
}

/// Puts the button of each side's links below the title of the side, also while the other side is
/// shown alone: what blinks could not be clicked.
void ComposedView::placeLinks() {
    const int top = labelMargin + fontMetrics().height() + labelPadding + linksGap;
    for (const Side side : {Side::A, Side::B}) {
        ViewLinks& links = *links_[indexOf(side)];
        links.adjustSize();
        const bool isAtRight = (side == Side::B) != hasTitlesSwapped();
        links.move(isAtRight ? width() - labelMargin - links.width() : labelMargin, top);
    }
}

void ComposedView::followBlink() {
    if (look_.mode == CompareMode::Blink && isVisible()) {
        blink_.start(static_cast<int>(std::lround(1000.0 * look_.blink)));
    } else {
        blink_.stop();
        blinksSecond_ = false;
    }
}

void ComposedView::setFlipped(bool on) {
    if (on != std::exchange(flipped_, on)) {
        update();
    }
}

WipeLine ComposedView::line() const {
    return {QSizeF(size()), look_.wipe, look_.wipeAngle};
}

/// Returns the only side that is to be seen; nothing where both are.
std::optional<Side> ComposedView::alone() const {
    if (flipped_) {
        return otherThan(document_.selection().side());
    }
    if (look_.mode == CompareMode::Flip) {
        return document_.selection().side();
    }
    if (look_.mode == CompareMode::Blink) {
        return blinksSecond_ ? Side::B : Side::A;
    }
    return std::nullopt;
}

Side ComposedView::sideAt(const QPointF& place) const {
    if (look_.mode == CompareMode::Wipe && !flipped_) {
        return line().depthInB(place) > 0.0 ? Side::B : Side::A;
    }
    // A click on what blinks would take a side by chance.
    return flipped_ ? otherThan(document_.selection().side()) : document_.selection().side();
}

ComposedView::Part ComposedView::partAt(const QPointF& place) const {
    if (look_.mode != CompareMode::Wipe || flipped_) {
        return Part::View;
    }
    const WipeLine now = line();
    if (distance(place, now.knob()) <= knobRadius + 3.0) {
        return Part::Knob;
    }
    const bool isNear =
        std::abs(now.depthInB(place)) <= grabbed || distance(place, now.grip()) <= gripRadius + 2.0;
    return isNear ? Part::Line : Part::View;
}

void ComposedView::readSoon(Side side) {
    isNew_[indexOf(side)] = true;
    if (isVisible() && !reading_.isActive()) {
        reading_.start();
    }
}

/// Reads the pictures back after the views' own painting, as it must not interrupt that.
void ComposedView::read() {
    for (const Side side : {Side::A, Side::B}) {
        if (std::exchange(isNew_[indexOf(side)], false)) {
            pictures_[indexOf(side)] = view(side).viewport().grabPicture();
        }
    }
    update();
}

void ComposedView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    placeLinks();
    for (const Side side : {Side::A, Side::B}) {
        if (view(side).viewport().frames().frameCount() > 0) {
            readSoon(side);
        }
    }
    followBlink();
}

void ComposedView::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    pictures_ = {};
    flipped_ = false;
    held_ = nullptr;
    under_ = nullptr;
    followBlink();
}

void ComposedView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    placeLinks();
    update();
}

QImage ComposedView::picture() const {
    if (pictures_[0].isNull() || pictures_[1].isNull()) {
        return {};
    }
    QImage composed(size() * devicePixelRatioF(), QImage::Format_RGB32);
    composed.setDevicePixelRatio(devicePixelRatioF());
    composed.fill(Qt::black);
    QPainter painter(&composed);
    drawPictures(painter);
    return composed;
}

void ComposedView::drawPictures(QPainter& painter) const {
    const auto draw = [&](Side side) { painter.drawImage(rect(), pictures_[indexOf(side)]); };
    if (const std::optional<Side> one = alone()) {
        draw(*one);
        return;
    }
    draw(Side::A);
    painter.save();
    if (look_.mode == CompareMode::Wipe) {
        QPainterPath part;
        part.addPolygon(line().partOfB());
        painter.setClipPath(part);
    } else {
        painter.setOpacity(look_.onion);
    }
    draw(Side::B);
    painter.restore();
}

void ComposedView::drawLine(QPainter& painter) const {
    const WipeLine now = line();
    const QPointF end = double(width() + height()) * now.along();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    strokeTwice(painter, [&] { painter.drawLine(now.grip() - end, now.grip() + end); });
    painter.setBrush(QColor(0x30, 0x30, 0x30));
    strokeTwice(painter, [&] { painter.drawEllipse(now.grip(), gripRadius, gripRadius); });
    strokeTwice(painter, [&] { painter.drawEllipse(now.knob(), knobRadius, knobRadius); });
    // Two arrow heads across the line say where the grip goes.
    const QPointF across(-now.along().y(), now.along().x());
    for (const double way : {-1.0, 1.0}) {
        const QPointF tip = now.grip() + 6.0 * way * across;
        const QPointF back = now.grip() + 2.5 * way * across;
        painter.drawPolyline(QPolygonF({back + 3.0 * now.along(), tip, back - 3.0 * now.along()}));
    }
}

QRect ComposedView::drawTitle(QPainter& painter, Side side, bool atRight) const {
    const bool active = document_.selection().side() == side;
    QFont bold = font();
    bold.setBold(true);
    const QFontMetrics metrics = fontMetrics();
    const int letter = QFontMetrics(bold).horizontalAdvance(letterOf(side)) + 2 * labelPadding;
    const QString state = active ? tr(" (being edited)") : QString();
    const int room =
        width() / 2 - 2 * labelMargin - letter - labelPadding - metrics.horizontalAdvance(state);
    const QString caption =
        metrics.elidedText(view(side).caption(), Qt::ElideRight, std::max(room, 0)) + state;
    const QSize size(letter + metrics.horizontalAdvance(caption) + 2 * labelPadding,
                     metrics.height() + labelPadding);
    const int left = atRight ? width() - labelMargin - size.width() : labelMargin;
    const QRect place({left, labelMargin}, size);
    QColor ground = active ? colourOf(side) : colourOf(side).darker(260);
    ground.setAlpha(labelOpacity);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    painter.drawRoundedRect(place, 4.0, 4.0);
    painter.setPen(active ? QColor(0x10, 0x10, 0x10) : QColor(0xf0, 0xf0, 0xf0));
    painter.setFont(bold);
    painter.drawText(QRect(left, labelMargin, letter, size.height()), Qt::AlignCenter,
                     letterOf(side));
    painter.setFont(font());
    painter.drawText(place.adjusted(letter, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft, caption);
    return place;
}

/// Draws the title of each side that is seen, over its own picture where both are.
void ComposedView::drawTitles(QPainter& painter) {
    painter.setRenderHint(QPainter::Antialiasing);
    const bool isAtRight = hasTitlesSwapped();
    const std::optional<Side> one = alone();
    titles_ = {};
    for (const Side side : {Side::A, Side::B}) {
        if (!one || *one == side) {
            titles_[indexOf(side)] = drawTitle(painter, side, (side == Side::B) != isAtRight);
        }
    }
}

void ComposedView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (pictures_[0].isNull() || pictures_[1].isNull()) {
        return; // the view below shows its own
    }
    drawPictures(painter);
    if (look_.mode == CompareMode::Wipe && !flipped_) {
        drawLine(painter);
    }
    drawTitles(painter);
}

bool ComposedView::press(const QMouseEvent& event) {
    for (const Side side : {Side::A, Side::B}) {
        if (titles_[indexOf(side)].contains(event.position().toPoint())) {
            document_.selection().setSide(side);
            return true;
        }
    }
    const bool isPlain = event.button() == Qt::LeftButton && held_ == nullptr &&
                         !event.modifiers().testAnyFlags(Qt::ControlModifier | Qt::AltModifier);
    dragged_ = isPlain ? partAt(event.position()) : Part::View;
    pivot_ = line().grip();
    if (dragged_ != Part::View) {
        view(document_.selection().side()).viewport().setFocus(Qt::MouseFocusReason);
    }
    return dragged_ != Part::View;
}

bool ComposedView::move(const QMouseEvent& event) {
    if (dragged_ != Part::View) {
        wishLine(event.position(), event.modifiers().testFlag(Qt::ShiftModifier));
        return true;
    }
    if (event.buttons() == Qt::NoButton) {
        const Part part = partAt(event.position());
        setCursor(part == Part::Knob   ? Qt::PointingHandCursor
                  : part == Part::Line ? Qt::SizeAllCursor
                                       : Qt::ArrowCursor);
    }
    return false;
}

void ComposedView::wishLine(const QPointF& place, bool inSteps) {
    CompareLook wished = look_;
    if (dragged_ == Part::Line) {
        wished.wipe = line().shareThrough(place);
    } else {
        const double angle = WipeLine::angleTowards(pivot_, place);
        wished.wipeAngle = wrappedAngle(inSteps ? turnStep * std::round(angle / turnStep) : angle);
        wished.wipe = WipeLine(QSizeF(size()), 0.5, wished.wipeAngle).shareThrough(pivot_);
    }
    Q_EMIT lookWished(wished);
}

/// Sends an event to the view of the side at a place, or to the one that got the press of the
/// mouse.
bool ComposedView::handOn(QEvent* event, const QPointF& place) {
    Viewport* to = held_ != nullptr ? held_ : &view(sideAt(place)).viewport();
    if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick) {
        held_ = to;
        to->setFocus(Qt::MouseFocusReason);
    }
    if (under_ != to) {
        QEvent left(QEvent::Leave);
        if (Viewport* before = std::exchange(under_, to)) {
            QCoreApplication::sendEvent(before, &left);
        }
        QEnterEvent entered(place, place, mapToGlobal(place));
        QCoreApplication::sendEvent(to, &entered);
    }
    return QCoreApplication::sendEvent(to, event);
}

bool ComposedView::event(QEvent* event) {
    switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick: {
        const auto& mouse = *static_cast<QMouseEvent*>(event);
        return press(mouse) || handOn(event, mouse.position());
    }
    case QEvent::MouseMove: {
        const auto& mouse = *static_cast<QMouseEvent*>(event);
        return move(mouse) || handOn(event, mouse.position());
    }
    case QEvent::MouseButtonRelease: {
        const auto& mouse = *static_cast<QMouseEvent*>(event);
        if (std::exchange(dragged_, Part::View) != Part::View) {
            return true;
        }
        const bool taken = handOn(event, mouse.position());
        if (mouse.buttons() == Qt::NoButton) {
            held_ = nullptr;
        }
        return taken;
    }
    case QEvent::Wheel:
        return handOn(event, static_cast<QWheelEvent*>(event)->position());
    case QEvent::DragEnter:
    case QEvent::DragMove:
    case QEvent::Drop:
        return handOn(event, static_cast<QDropEvent*>(event)->position());
    case QEvent::Leave:
        if (Viewport* before = std::exchange(under_, nullptr)) {
            QCoreApplication::sendEvent(before, event);
        }
        return true;
    case QEvent::WindowDeactivate:
        setFlipped(false); // the key may be released in another window
        return QWidget::event(event);
    default:
        return QWidget::event(event);
    }
}

} // namespace patina

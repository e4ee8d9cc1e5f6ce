// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include <QImage>
#include <QTimer>
#include <QWidget>

#include "session/compare_look.h"
#include "viewport/side_view.h"
#include "viewport/wipe_line.h"

namespace patina {

/// Lies over the views of A and B, which have the same place, and shows their pictures as one: each
/// is read back when its view has drawn it, and composing them draws nothing of the scene. Mouse
/// events go on to the view of the side under the pointer, except on the line of a wipe and on the
/// titles, below which each side has the button of its links.
class ComposedView : public QWidget {
    Q_OBJECT

  public:
    ComposedView(Document& document, EffectSwitches& switches, SideView& first, SideView& second,
                 QWidget* parent);

    void setLook(const CompareLook& look);

    /// Shows, while a key is held, only the side that is not edited.
    void setFlipped(bool on);

    /// Returns what it shows without the titles and the line, in pixels of the screen; null until
    /// both pictures are there.
    QImage picture() const;

    /// Tells whether picture() has what the views have drawn last.
    bool isUpToDate() const { return !reading_.isActive(); }

  Q_SIGNALS:
    void lookWished(patina::CompareLook look);

  protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    /// Tells what a drag of the mouse changes.
    enum class Part { View, Line, Knob };

    SideView& view(Side side) const { return side == Side::A ? first_ : second_; }
    WipeLine line() const;
    bool hasTitlesSwapped() const;
    void placeLinks();
    std::optional<Side> alone() const;
    Side sideAt(const QPointF& place) const;
    Part partAt(const QPointF& place) const;
    void readSoon(Side side);
    void read();
    void followBlink();
    void drawPictures(QPainter& painter) const;
    void drawLine(QPainter& painter) const;
    void drawTitles(QPainter& painter);
    QRect drawTitle(QPainter& painter, Side side, bool atRight) const;
    bool press(const QMouseEvent& event);
    bool move(const QMouseEvent& event);
    void wishLine(const QPointF& place, bool inSteps);
    bool handOn(QEvent* event, const QPointF& place);

    Document& document_;
    SideView& first_;
    SideView& second_;
    CompareLook look_;
    std::array<QImage, 2> pictures_; ///< holds one per side
    std::array<bool, 2> isNew_{};    ///< says for each side that its view has drawn another picture
    std::array<ViewLinks*, 2> links_{}; ///< holds one per side
    std::array<QRect, 2> titles_;       ///< holds one per side; empty where none is shown
    QTimer reading_;
    QTimer blink_;
    bool blinksSecond_ = false;
    bool flipped_ = false;
    Part dragged_ = Part::View;
    QPointF pivot_; ///< holds the point that the dragged line turns about
    /// Points to the view that got the press of the mouse; null while no button is down.
    Viewport* held_ = nullptr;
    Viewport* under_ = nullptr; ///< points to the view under the pointer; null where there is none
};

} // namespace patina

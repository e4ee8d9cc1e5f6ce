// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include <QWidget>

#include "session/compare_look.h"
#include "viewport/side_view.h"
#include "viewport/view_cameras.h"

class QSplitter;

namespace patina {

class ComparisonMeter;
class ComparisonReadout;
class ComposedView;
class DifferenceView;

/// Places the views in the middle of the window: one, or up to four while the document compares, in
/// a grid, a row or a column, or A and B composed at one place; and beside them the difference of
/// two where that is wanted.
class CompareArea : public QWidget {
    Q_OBJECT

  public:
    explicit CompareArea(const ViewSources& sources, QWidget* parent = nullptr);
    ~CompareArea() override;

    SideView& first() { return *view(Side::A); }
    SideView* second() { return view(Side::B); }
    SideView* view(Side side) { return views_[indexOf(side)]; } ///< null until it was needed once
    std::vector<SideView*> views();                             ///< that were needed once
    SideView& active();
    DifferenceView* difference() { return difference_; } ///< null until it was needed once
    ComposedView* composed() { return composed_; }       ///< the same
    ComparisonMeter* meter() { return meter_; }          ///< the same

    const CompareLook& look() const { return look_; }
    void setLook(const CompareLook& look);

    /// Shows the difference beside the views, while the document compares, or does not.
    void setDifferenceWanted(bool wanted);

    /// Sets how the mouse moves the cameras.
    void setMouseHabits(const MouseHabits& habits);

    /// Lets all views show something instead of the picture; nothing: the picture.
    void setInspected(std::optional<Inspected> shown);
    const std::optional<Inspected>& inspected() const { return inspected_; }

    /// Says which handles all views show.
    HandleModes& handleModes() { return modes_; }

    ViewTurntable& turntable() { return turntable_; }

    ViewCameras& cameras() { return cameras_; }

  Q_SIGNALS:
    void lookChanged(const patina::CompareLook& look);
    /// Passes on what ComparisonReadout::changed() tells.
    void numbersShown(const QString& text, const QString& details);
    void differenceWantedChanged(bool wanted);
    void filesDropped(QStringList files, patina::Side side);
    void viewAdded(patina::SideView* view);

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;

  private:
    SideView* addView(Side side);
    bool isShown(Side side) const;
    void showSides();
    bool makeMissingViews();
    bool placeViews();
    void shareRoom();
    void showFurtherSide();
    void makeMeter();
    void watch(Viewport& view);
    void showComposed(bool shown);
    void placeComposed();
    bool isComposed() const;
    void showDifference(bool shown);

    ViewSources sources_;
    Document& document_;
    CompareLook look_;
    ViewCameras cameras_;
    HandleModes modes_;
    ViewTurntable turntable_;
    MouseHabits habits_;
    QSplitter* rows_;
    QSplitter* upper_; ///< all but what is in the second row of a grid
    QSplitter* lower_;
    std::size_t sideCount_ = 1; ///< that are compared
    bool wantsDifference_ = false;
    std::optional<Inspected> inspected_; ///< nothing: the picture is shown
    std::array<SideView*, sides.size()> views_{};
    DifferenceView* difference_ = nullptr;
    ComposedView* composed_ = nullptr;
    ComparisonMeter* meter_ = nullptr;
    std::unique_ptr<ComparisonReadout> readout_; ///< comes with the meter
};

} // namespace patina

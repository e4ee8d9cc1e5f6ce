// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <QWidget>

#include "session/compare_look.h"
#include "viewport/camera_history.h"
#include "viewport/side_view.h"

class QSplitter;

namespace patina {

class ComparisonMeter;
class ComposedView;
class DifferenceView;

/// The middle of the window: one view, or up to four while the document compares, in a grid, a row
/// or a column, or A and B composed at one place; and beside them the difference of two where that
/// is wanted. Side A's camera is the document's, a step back where a view is narrower than high;
/// the others' is the same one until they are unlinked.
class CompareArea : public QWidget {
    Q_OBJECT

  public:
    explicit CompareArea(const ViewSources& sources, QWidget* parent = nullptr);

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

    /// The difference is shown beside the views, while the document compares.
    void setDifferenceWanted(bool wanted);

    void setCamerasLinked(bool linked);

    /// How the mouse moves the cameras.
    void setMouseHabits(const MouseHabits& habits);

    /// All views show the numerical check instead of the picture.
    void setInspecting(bool on);

    /// All sides look from where side A does.
    void realignCameras();

    /// Which handles all views show.
    HandleModes& handleModes() { return modes_; }

    ViewTurntable& turntable() { return turntable_; }

    /// The undo of the document's camera.
    CameraHistory& cameraHistory() { return history_; }

    /// The camera that the scene had when it was opened.
    void resetCamera(Side side);

  Q_SIGNALS:
    void linkChanged(bool linked);
    void lookChanged(const patina::CompareLook& look);
    /// How far A and another side are apart, and, while the pointer is over a picture, what both
    /// have there; empty while that is not known.
    void numbersShown(const QString& text, const QString& details);
    void differenceWantedChanged(bool wanted);
    void filesDropped(QStringList files, patina::Side side);
    void viewAdded(patina::SideView* view);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;

  private:
    SideView* addView(Side side);
    bool isShown(Side side) const;
    bool isLinked(Side side) const { return side == Side::A || linked_; }
    void showSides();
    bool makeMissingViews();
    bool placeViews();
    void shareRoom();
    void showFurtherSide();
    void makeMeter();
    void showNumbers();
    void showComposed(bool shown);
    void placeComposed();
    bool isComposed() const;
    void showDifference(bool shown);
    void fitNarrowViews();
    void moveCamera(Side side, const Camera& shown);
    void showCamera();
    Camera shownFrom(const Camera& camera) const;
    Camera heldFrom(const Camera& shown) const;

    ViewSources sources_;
    Document& document_;
    Camera home_;
    CompareLook look_;
    CameraHistory history_;
    HandleModes modes_;
    ViewTurntable turntable_;
    MouseHabits habits_;
    QSplitter* rows_;
    QSplitter* upper_; ///< all but what is in the second row of a grid
    QSplitter* lower_;
    std::size_t sideCount_ = 1; ///< that are compared
    bool linked_ = true;
    bool wantsDifference_ = false;
    bool inspecting_ = false;
    double stepBack_ = 1.0; ///< by so much farther away than the document has it
    std::array<SideView*, sides.size()> views_{};
    DifferenceView* difference_ = nullptr;
    ComposedView* composed_ = nullptr;
    ComparisonMeter* meter_ = nullptr;
    std::optional<QPointF> pointer_; ///< over a picture, as a share of its width and height
};

} // namespace patina

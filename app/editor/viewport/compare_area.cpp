// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/compare_area.h"

#include <algorithm>
#include <utility>

#include "viewport/camera_moves.h"
#include "viewport/difference_view.h"

namespace patina {

CompareArea::CompareArea(const ViewSources& sources, std::filesystem::path programCache,
                         QWidget* parent)
    : QSplitter(Qt::Horizontal, parent), sources_(sources), document_(sources.document),
      programCache_(std::move(programCache)), home_(document_.scene().camera),
      first_(addView(Side::A)) {
    setChildrenCollapsible(false);
    setHandleWidth(3);
    connect(&document_, &Document::comparingChanged, this, &CompareArea::showSides);
    connect(&document_, &Document::cameraChanged, this,
            [this] { moveCamera(Side::A, document_.scene().camera); });
    connect(&document_, &Document::sceneReplaced, this, [this] {
        home_ = document_.scene().camera;
        views_ = wantedViews();
        stepBack_ = 1.0;
        moveCamera(Side::A, home_);
        realignCameras();
        showSides();
    });
    showSides();
}

SideView& CompareArea::active() {
    return document_.activeSide() == Side::B && second_ ? *second_ : *first_;
}

void CompareArea::setCamerasLinked(bool linked) {
    if (linked != linked_) {
        linked_ = linked;
        if (linked) {
            realignCameras();
        }
        Q_EMIT linkChanged(linked);
    }
}

void CompareArea::setInspecting(bool on) {
    inspecting_ = on;
    first_->setInspecting(on);
    if (second_) {
        second_->setInspecting(on);
    }
}

void CompareArea::realignCameras() {
    if (second_) {
        second_->viewport().setCamera(first_->viewport().camera());
    }
}

void CompareArea::resetCamera(Side side) {
    moveCamera(side, home_);
}

SideView* CompareArea::addView(Side side) {
    auto* view = new SideView(sources_, side, programCache_, this);
    addWidget(view);
    connect(view, &SideView::cameraWished, this,
            [this, side](const Camera& camera) { moveCamera(side, camera); });
    connect(view, &SideView::resetWished, this, [this, side] { resetCamera(side); });
    connect(view, &SideView::filesDropped, this,
            [this, side](const QStringList& files) { Q_EMIT filesDropped(files, side); });
    return view;
}

int CompareArea::wantedViews() const {
    return !document_.isComparing() ? 1 : wantsDifference_ ? 3 : 2;
}

void CompareArea::setDifferenceWanted(bool wanted) {
    if (wanted != std::exchange(wantsDifference_, wanted)) {
        showSides();
        Q_EMIT differenceWantedChanged(wanted);
    }
}

void CompareArea::showSides() {
    const bool comparing = document_.isComparing();
    if (comparing && !second_) {
        second_ = addView(Side::B);
        second_->viewport().setCamera(first_->viewport().camera());
        second_->setInspecting(inspecting_);
        setSizes({1, 1});
        Q_EMIT viewAdded(second_);
    }
    first_->setTitleVisible(comparing);
    if (second_) {
        second_->setVisible(comparing);
    }
    showDifference(comparing && wantsDifference_);
    fitNarrowViews(wantedViews());
}

void CompareArea::showDifference(bool shown) {
    const bool was = difference_ && !difference_->isHidden();
    if (shown == was) {
        return;
    }
    if (!difference_) {
        difference_ = new DifferenceView(sources_, programCache_, this);
        addWidget(difference_);
    }
    difference_->setVisible(shown);
    setSizes({1, 1, shown ? 1 : 0});
}

/// A part of the area may be too narrow for what filled all of it: the camera steps back while the
/// document compares, so that nothing is cut off.
void CompareArea::fitNarrowViews(int views) {
    if (views == std::exchange(views_, views)) {
        return;
    }
    const double aspect = double(width()) / (views * std::max(height(), 1));
    const double wanted = views == 1 ? 1.0 : std::max(1.0, 1.0 / aspect);
    const double more = wanted / std::exchange(stepBack_, wanted);
    if (more != 1.0) {
        moveCamera(Side::A, dollied(first_->viewport().camera(), more));
    }
}

void CompareArea::moveCamera(Side side, const Camera& camera) {
    if (side == Side::A || linked_) {
        first_->viewport().setCamera(camera);
        document_.setCamera(camera);
    }
    if (second_ && (side == Side::B || linked_)) {
        second_->viewport().setCamera(camera);
    }
}

} // namespace patina

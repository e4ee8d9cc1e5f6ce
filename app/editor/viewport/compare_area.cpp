// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/compare_area.h"

#include <algorithm>
#include <utility>

#include <QShowEvent>

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
    onChange(document_, DocumentChange::Comparing, this, &CompareArea::showSides);
    onChange(document_, DocumentChange::Camera, this, &CompareArea::showCamera);
    onChange(document_, DocumentChange::Scene, this, [this] {
        home_ = document_.scene().camera;
        showSides();
        showCamera();
        realignCameras();
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
    moveCamera(side, shownFrom(home_));
}

SideView* CompareArea::addView(Side side) {
    auto* view = new SideView(sources_, side, programCache_, this);
    addWidget(view);
    connect(view, &SideView::cameraWished, this,
            [this, side](const Camera& shown) { moveCamera(side, shown); });
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
        difference_ = new DifferenceView(sources_, first_->viewport(), programCache_, this);
        addWidget(difference_);
    }
    difference_->setVisible(shown);
    setSizes({1, 1, shown ? 1 : 0});
}

/// Fits the views again: only now the area has its size.
void CompareArea::showEvent(QShowEvent* event) {
    QSplitter::showEvent(event);
    if (!event->spontaneous()) {
        views_ = 0;
        fitNarrowViews(wantedViews());
    }
}

/// A part of the area may be too narrow for what filled all of it: the views step back while the
/// document compares, so that nothing is cut off. The document's camera stays where it is.
void CompareArea::fitNarrowViews(int views) {
    if (views == std::exchange(views_, views)) {
        return;
    }
    const double aspect = double(width()) / (views * std::max(height(), 1));
    stepBack_ = views == 1 ? 1.0 : std::max(1.0, 1.0 / aspect);
    showCamera();
}

Camera CompareArea::shownFrom(const Camera& camera) const {
    return stepBack_ == 1.0 ? camera : dollied(camera, stepBack_);
}

/// The document's camera in the views that follow it.
void CompareArea::showCamera() {
    const Camera shown = shownFrom(document_.scene().camera);
    first_->viewport().setCamera(shown);
    if (second_ && linked_) {
        second_->viewport().setCamera(shown);
    }
}

/// To where a view shall show the scene from.
void CompareArea::moveCamera(Side side, const Camera& shown) {
    if (side == Side::B && !linked_) {
        second_->viewport().setCamera(shown);
        return;
    }
    document_.setCamera(stepBack_ == 1.0 ? shown : dollied(shown, 1.0 / stepBack_));
    showCamera();
}

} // namespace patina

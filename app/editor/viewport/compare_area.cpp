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
    connect(&view->viewport(), &Viewport::resized, this, &CompareArea::fitNarrowViews);
    connect(view, &SideView::resetWished, this, [this, side] { resetCamera(side); });
    connect(view, &SideView::filesDropped, this,
            [this, side](const QStringList& files) { Q_EMIT filesDropped(files, side); });
    return view;
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
    fitNarrowViews();
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

/// The field of view is the height's: where a view is narrower than high all step back, so that
/// what is in a square is not cut off. The document's camera stays where it is.
void CompareArea::fitNarrowViews() {
    double aspect = 1.0; // of the narrowest
    for (SideView* view : {first_, second_}) {
        if (view && !view->isHidden()) {
            const QSize size = view->viewport().size();
            aspect = std::min(aspect, std::max(size.width(), 1) / double(size.height()));
        }
    }
    const double stepBack = 1.0 / aspect;
    const double change = stepBack / std::exchange(stepBack_, stepBack);
    if (change != 1.0 && second_ && !linked_) {
        second_->viewport().setCamera(dollied(second_->viewport().camera(), change));
    }
    if (change != 1.0) {
        showCamera();
    }
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

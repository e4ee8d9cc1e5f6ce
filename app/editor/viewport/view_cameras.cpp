// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/view_cameras.h"

#include <algorithm>
#include <utility>

#include "document/scene_edits.h"
#include "viewport/camera_moves.h"

namespace patina {

ViewCameras::ViewCameras(Document& document)
    : document_(document), history_(document), home_(document.scene().camera) {
    onChange(document_, DocumentChange::Camera, this, &ViewCameras::show);
    onChange(document_, DocumentChange::Scene, this, [this] {
        home_ = document_.scene().camera;
        show();
        realign();
    });
}

void ViewCameras::add(SideView& view) {
    const Side side = view.side();
    views_.push_back(&view);
    if (side != Side::A) {
        view.viewport().setCamera(first().viewport().camera());
    }
    connect(&view, &SideView::cameraWished, this,
            [this, side](const Camera& shown) { move(side, shown); });
    connect(&view.viewport(), &Viewport::resized, this, &ViewCameras::fitNarrowViews);
    CameraNavigation& navigation = view.viewport().navigation();
    connect(&navigation, &CameraNavigation::dragBegan, &history_, &CameraHistory::beginDrag);
    connect(&navigation, &CameraNavigation::dragFinished, &history_, &CameraHistory::endDrag);
    connect(&navigation, &CameraNavigation::dragCancelled, &history_, &CameraHistory::endDrag);
    connect(&view, &SideView::bookmarkWished, this, [this, &view](int digit) {
        setBookmark(document_, digit, heldFrom(view.viewport().camera()));
        Q_EMIT said(tr("This view is kept as %1: press %1 to come back to it").arg(digit));
    });
    connect(&view, &SideView::bookmarkChosen, this,
            [this, side](const Camera& bookmark) { move(side, shownFrom(bookmark)); });
    connect(&view, &SideView::bookmarkMissed, this, [this](int digit) {
        Q_EMIT said(tr("No view is kept as %1 yet: Ctrl+%1 keeps this one").arg(digit));
    });
    connect(&view, &SideView::resetWished, this, [this, side] { reset(side); });
}

SideView* ViewCameras::view(Side side) const {
    const auto found = std::ranges::find(views_, side, &SideView::side);
    return found == views_.end() ? nullptr : *found;
}

void ViewCameras::setLinked(bool linked) {
    if (linked != linked_) {
        linked_ = linked;
        if (linked) {
            realign();
        }
        Q_EMIT linkChanged(linked);
    }
}

void ViewCameras::realign() {
    for (SideView* view : views_) {
        view->viewport().setCamera(first().viewport().camera());
    }
}

void ViewCameras::reset(Side side) {
    move(side, shownFrom(home_));
}

void ViewCameras::fitNarrowViews() {
    double narrowest = 1.0; // width by height
    for (SideView* view : views_) {
        if (!view->isHidden()) {
            const QSize size = view->viewport().size();
            narrowest = std::min(narrowest, std::max(size.width(), 1) / double(size.height()));
        }
    }
    const double stepBack = 1.0 / narrowest;
    const double change = stepBack / std::exchange(stepBack_, stepBack);
    if (change == 1.0) {
        return;
    }
    for (SideView* view : views_) {
        if (!isLinked(view->side())) {
            view->viewport().setCamera(dollied(view->viewport().camera(), change));
        }
    }
    show();
}

Camera ViewCameras::shownFrom(const Camera& camera) const {
    return stepBack_ == 1.0 ? camera : dollied(camera, stepBack_);
}

/// Returns the document's camera where a view shows it from there.
Camera ViewCameras::heldFrom(const Camera& shown) const {
    return stepBack_ == 1.0 ? shown : dollied(shown, 1.0 / stepBack_);
}

/// Shows the document's camera in the views that follow it.
void ViewCameras::show() {
    const Camera shown = shownFrom(document_.scene().camera);
    for (SideView* view : views_) {
        if (isLinked(view->side())) {
            view->viewport().setCamera(shown);
        }
    }
}

/// Moves a side to where its view shall show the scene from.
void ViewCameras::move(Side side, const Camera& shown) {
    if (isLinked(side)) {
        document_.setCamera(heldFrom(shown));
        show();
    } else if (SideView* moved = view(side)) {
        moved->viewport().setCamera(shown);
    }
}

} // namespace patina

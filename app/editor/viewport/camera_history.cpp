// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/camera_history.h"

#include <utility>

#include "viewport/camera_moves.h"

namespace patina {
namespace {

constexpr std::size_t maxMoves = 200;
constexpr int betweenMovesMs = 600; ///< a move that comes later begins a new step

} // namespace

CameraHistory::CameraHistory(Document& document, QObject* parent)
    : QObject(parent), document_(document), now_(document.scene().camera) {
    onChange(document, DocumentChange::Camera, this, &CameraHistory::follow);
    onChange(document, DocumentChange::Scene, this, &CameraHistory::forget);
    onChange(document, DocumentChange::Interaction, this,
             [this] { document_.interaction().isGoingOn() ? beginDrag() : endDrag(); });
}

void CameraHistory::follow() {
    if (document_.scene().camera == now_) {
        return;
    }
    const Camera before = std::exchange(now_, document_.scene().camera);
    const bool isNext = isDragging_ ? isOpen_ : isOpen_ && sinceMove_.elapsed() < betweenMovesMs;
    if (!isNext) {
        undo_.push_back(before);
        if (undo_.size() > maxMoves) {
            undo_.erase(undo_.begin());
        }
        isOpen_ = true;
    }
    redo_.clear();
    sinceMove_.start();
    Q_EMIT changed();
}

void CameraHistory::beginDrag() {
    isDragging_ = true;
    isOpen_ = false;
}

void CameraHistory::endDrag() {
    isDragging_ = false;
    if (std::exchange(isOpen_, false) && isSameView(undo_.back(), now_)) {
        undo_.pop_back();
        Q_EMIT changed();
    }
}

void CameraHistory::step(std::vector<Camera>& from, std::vector<Camera>& to) {
    if (from.empty()) {
        return;
    }
    const Camera wanted = from.back();
    from.pop_back();
    to.push_back(now_);
    now_ = wanted; // so that follow() sees no move
    isOpen_ = false;
    document_.setCamera(wanted);
    Q_EMIT changed();
}

void CameraHistory::forget() {
    now_ = document_.scene().camera;
    undo_.clear();
    redo_.clear();
    isOpen_ = false;
    Q_EMIT changed();
}

} // namespace patina

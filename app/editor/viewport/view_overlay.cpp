// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/view_overlay.h"

#include <utility>

#include <QPainter>

#include "viewport/handle_modes.h"
#include "viewport/view_handles.h"
#include "viewport/viewport.h"

namespace patina {
namespace {

/// Tells whether a change may move what is drawn over the picture: values of materials and of the
/// picture never do.
bool mayMove(const DocumentChange& change) {
    const DocumentChange::Aspects ofValues = DocumentChange::Value | DocumentChange::Texture;
    const bool isOfValue = !(change.aspects & ~ofValues);
    return !isOfValue || change.path.owner == BlockOwner::Light ||
           change.path.isAt(settings::object) || change.path.isAt(settings::camera) ||
           change.path.isAt(settings::scene); // whose ground lights have targets on
}

} // namespace

ViewOverlay::ViewOverlay(Viewport& viewport, Document& document, MeshLibrary& meshes,
                         const ViewHandles& handles, const HandleModes& modes)
    : QObject(&viewport), viewport_(viewport), document_(document), meshes_(meshes),
      handles_(handles) {
    viewport.frames().surface().setOverlay(*this);
    onChange(document, DocumentChange::Drawn | DocumentChange::Current, this,
             [this](const DocumentChange& change) {
                 if (mayMove(change)) {
                     follow();
                 }
             });
    connect(&viewport, &Viewport::cameraChanged, this, &ViewOverlay::follow);
    connect(&viewport, &Viewport::resized, this, &ViewOverlay::follow);
    connect(&meshes, &MeshLibrary::loaded, this, &ViewOverlay::follow);
    connect(&handles, &ViewHandles::changed, this, &ViewOverlay::follow);
    connect(&modes, &HandleModes::changed, this, &ViewOverlay::follow);
    follow();
}

bool ViewOverlay::isSeen() const {
    return !isSuspended_ && (!document_.selection().objects().empty() || handles_.isShown());
}

void ViewOverlay::follow() {
    const bool wasSeen = std::exchange(wasSeen_, isSeen());
    if (wasSeen || wasSeen_) {
        viewport_.frames().surface().noteOverlay();
    }
}

void ViewOverlay::setSuspended(bool suspended) {
    isSuspended_ = suspended;
    follow();
}

void ViewOverlay::draw(QPainter& painter) {
    if (!document_.selection().objects().empty()) {
        drawSelection(painter);
    }
    handles_.draw(painter);
}

void ViewOverlay::drawSelection(QPainter& painter) {
    const auto mesh = [this](const Object& object) { return meshes_.view(object); };
    const glm::ivec2 pixels = pixelsOf(viewport_, viewport_.size());
    const QImage& image = outline_.draw(document_.scene(), document_.selection().objects(),
                                        viewport_.camera(), {pixels.x, pixels.y}, mesh);
    painter.drawImage(viewport_.rect(), image);
}

} // namespace patina

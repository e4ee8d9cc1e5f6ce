// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "document/document_state.h"
#include "sheet/contact_sheet.h"

namespace patina {

/// Knows what a sheet in the window starts from: what the active side shows, except for cells that
/// were taken from the sheet, so that one can be taken after the other and the start again.
class SheetStart {
  public:
    /// Says whose sheet it is.
    struct Subject {
        Side side = Side::A;
        std::size_t object = 0;

        friend bool operator==(const Subject&, const Subject&) = default;
    };

    /// Takes note of what is shown now. The start becomes this where something else has changed
    /// than the camera and what a cell brought, and where the sheet goes through something else.
    void follow(const Scene& shown, const Subject& subject, const Sheet& sheet);

    /// Takes note that a cell was taken, after which this is shown.
    void noteTaken(const Scene& shown);

    /// Tells whether this is the start or a cell that was taken, wherever the camera stands.
    bool holds(const Scene& shown) const;

    /// Returns the start: null before anything is followed, and another object only where it has
    /// changed.
    const std::shared_ptr<const Scene>& scene() const { return scene_; }
    std::size_t object() const { return subject_.object; }

  private:
    std::shared_ptr<const Scene> scene_;
    std::vector<Scene> taken_;
    Subject subject_;
    std::vector<SheetAxis> axes_; ///< are what the sheet goes through, without steps
};

/// Returns the scene without what makes no difference to any picture of it: names and kept views.
Scene drawnScene(Scene scene);

} // namespace patina

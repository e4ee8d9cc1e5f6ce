// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "document/document_change.h"
#include "document/document_state.h"

namespace patina {

/// Says which object, light and side of a document are worked on, and which objects are selected.
/// It is view state, which is saved, but neither undone nor asked about.
class Selection {
  public:
    /// Follows the state, which outlives it, and tells `announce` of its own changes.
    Selection(const DocumentState& state,
              std::function<void(const DocumentChange& change)> announce);

    int object() const { return object_; } ///< index; -1: there is none
    int light() const { return light_; }   ///< index; -1: there is none
    Side side() const { return side_; }
    /// Returns the selected objects by rising index: none, or object() is among them.
    const std::vector<int>& objects() const { return objects_; }

    // Each takes the nearest that there is, and is announced where something changes.
    void setObject(int index);
    void setLight(int index);
    void setSide(Side side);
    /// Selects these objects; the last one becomes object(). Without one object() stays.
    void setObjects(std::vector<int> objects);

    /// Returns the objects that an edit of object() changes: the selected ones, or it alone.
    std::vector<int> editedObjects() const;

    /// Returns the path of a kind of block, or of settings, in what is worked on: the material of
    /// object() and side(), the light, the object, or the environment of the side's view where it
    /// has its own.
    BlockPath currentPath(std::string_view kind) const;

    /// Returns the paths that an edit at a path is for: its own first, then those of the other
    /// selected objects. Sides but A have a material of their own, which is on one object.
    std::vector<BlockPath> editedPaths(const BlockPath& path) const;

    /// Begins anew in another state: this object, the first light and side A. Announces nothing.
    void start(int object);

    /// Moves what is no longer there to what is.
    void keepInside();

  private:
    const DocumentState& state_;
    std::function<void(const DocumentChange& change)> announce_;
    int object_ = -1;
    int light_ = -1;
    Side side_ = Side::A;
    std::vector<int> objects_;
};

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <QFlags>

#include "document/document_state.h"

namespace patina {

/// Says what of a document has changed.
struct DocumentChange {
    enum Aspect : unsigned {
        Value = 1 << 0,   ///< a value at `path` has changed
        Texture = 1 << 1, ///< the image on a value at `path` has changed
        /// A model, part or whole material was replaced: a form's rows may differ.
        Material = 1 << 2,
        Block = 1 << 3,   ///< a part of the scene or of a light was replaced or removed, at `path`
        Lights = 1 << 4,  ///< a light was added, removed, renamed, switched or is of another kind
        Objects = 1 << 5, ///< an object was added, removed, renamed or has another mesh
        Comparing = 1 << 6, ///< comparing began or ended
        Camera = 1 << 7,
        Scene = 1 << 8, ///< another scene is there
        Catalog = 1 << 9,
        Rights = 1 << 10,      ///< files that were not read may be read
        Current = 1 << 11,     ///< another object, light or side is the current one
        Interaction = 1 << 12, ///< an interaction began or ended
        Snapshots = 1 << 13,   ///< one was taken, renamed or removed
        Bookmarks = 1 << 14,   ///< a view was kept
        Locks = 1 << 15,       ///< values at `path` were locked, or freed
        OwnView = 1 << 16,     ///< what the view of the path's side has of its own has changed
        /// Combines all aspects that may change a picture.
        Drawn = Value | Texture | Material | Block | Lights | Objects | Comparing | Camera | Scene |
                Catalog | Rights | OwnView
    };
    Q_DECLARE_FLAGS(Aspects, Aspect)

    Aspects aspects;
    BlockPath path{};          ///< leads to the value, image or block
    std::string parameterId{}; ///< is the id of the value, or of the value that the image lies on

    bool has(Aspects any) const { return aspects.testAnyFlags(any); }
};

Q_DECLARE_OPERATORS_FOR_FLAGS(DocumentChange::Aspects)

} // namespace patina

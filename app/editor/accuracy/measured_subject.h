// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "library/read_blocks.h"

namespace patina {

/// Holds all that numbers depend on, except the camera.
struct MeasuredSubject {
    Scene scene; ///< leaves out what does not change the numbers
    int object = -1;
    ReadBlocks blocks; ///< holds the blocks that the numbers depend on

    friend bool operator==(const MeasuredSubject&, const MeasuredSubject&) = default;
};

/// Selects the blocks that the numbers depend on: those in the scene, or the whole catalogue.
enum class SubjectBlocks { OfScene, All };

/// Returns the subject without the scene's name and camera, which do not change the numbers.
MeasuredSubject subjectOf(Scene scene, int object, const Catalog& catalog,
                          SubjectBlocks which = SubjectBlocks::OfScene);

} // namespace patina

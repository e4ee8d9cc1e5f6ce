// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "library/read_blocks.h"

namespace patina {

/// Holds what numbers were measured of, wherever it was seen from.
struct MeasuredSubject {
    Scene scene; ///< without what makes no difference to the numbers
    int object = -1;
    ReadBlocks blocks; ///< that the numbers depend on

    friend bool operator==(const MeasuredSubject&, const MeasuredSubject&) = default;
};

/// Tells which blocks the numbers depend on.
enum class SubjectBlocks { OfScene, All };

/// The numbers are the same whatever a scene is called and wherever its camera stands, and however
/// often its blocks were read.
MeasuredSubject subjectOf(Scene scene, int object, const Catalog& catalog,
                          SubjectBlocks which = SubjectBlocks::OfScene);

} // namespace patina

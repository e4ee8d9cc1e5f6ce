// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "measure/lobe/half_difference_slice.h"
#include "measure/lobe/lobe_lines.h"
#include "measure/lobe/lobe_solid.h"

namespace patina {

/// Returns lines as comma-separated values, a row per place: the material, the line, degrees or
/// nanometres and the three channels. What is reflected at an interface is followed by what is
/// transmitted.
std::string linesCsv(const std::vector<LobeSubject>& subjects, LobePlot plot);

/// Returns a slice as comma-separated values, a row per cell: degrees of the half vector and of the
/// difference, and the three channels in 1/sr.
std::string sliceCsv(const HalfDifferenceSlice& slice);

/// Is the slice of a material, or its lobe, with the material's name.
struct NamedSlice {
    std::string name;
    HalfDifferenceSlice slice;
};
struct NamedSolid {
    std::string name;
    LobeSolid solid;
};

/// Returns the same of several materials, with the material in front.
std::string slicesCsv(const std::vector<NamedSlice>& slices);

/// Returns lobes as comma-separated values, a row per direction: the material, the viewer's degrees
/// from the normal and from the tangent, and the three channels in 1/sr.
std::string solidsCsv(const std::vector<NamedSolid>& solids);

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "catalog/catalog.h"
#include "scene/scene.h"
#include "sheet/contact_sheet.h"

namespace patina {

/// Describes one thing that an axis of a sheet may go through.
struct AxisOffer {
    SheetAxis axis;    ///< has the slider's range of a number; else it goes through all steps
    std::string label; ///< is what users see
    std::optional<Parameter> of{}; ///< is the number that varies; empty for others
    bool counts = true;            ///< says whether the material reads the value now
};

/// Returns what a sheet of this object may go through: the values of its material that are numbers,
/// choices or switches, those of its model first; then each of its accuracy choices; then models,
/// all levels of its accuracy, lights and environments, where each has two steps at least. Empty
/// where the scene has no such object.
std::vector<AxisOffer> axisOffers(const Scene& scene, std::size_t object, const Catalog& catalog);

} // namespace patina

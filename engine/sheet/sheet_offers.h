// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "catalog/catalog.h"
#include "scene/scene.h"
#include "sheet/contact_sheet.h"

namespace patina {

/// Represents one thing that an axis of a sheet may be of.
struct AxisOffer {
    SheetAxis axis;                ///< of a number: with its slider's range; else of all there is
    std::string label;             ///< for people
    std::optional<Parameter> of{}; ///< the number that the range is of
    bool counts = true;            ///< the material as it is reads the value
};

/// Returns what a sheet of an object may go through: the values of its material that are numbers,
/// choices or switches, those of its model first, then each of its accuracy choices, then models,
/// all of its accuracy, lights and environments, where there are two at least.
std::vector<AxisOffer> axisOffers(const Scene& scene, std::size_t object, const Catalog& catalog);

} // namespace patina

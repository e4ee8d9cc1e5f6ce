// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "catalog/catalog.h"

namespace patina {

/// Returns the lighting models as a table in Markdown, a row each: what it claims of reciprocity
/// and energy, what it reflects with its defaults (least and most over the light's angle by the
/// strongest channel, and of a white sky), how much there is to set, its formula and its source.
std::string familyTable(const Catalog& catalog);

} // namespace patina

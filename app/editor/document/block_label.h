// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include <QString>

#include "catalog/block.h"

namespace patina {

/// Returns the label of an edit that chooses a block of a kind, or none (null), such as "Fog
/// Linear" and "Fog off".
QString blockLabel(std::string_view kind, const Block* block);

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "document/document.h"

namespace patina {

/// Returns how exactly a side is computed while the sides differ in nothing else: "Exact", or what
/// is not ("Grazing terms: Table"). Empty in any other case.
QString accuracyOfSide(const Document& document, Side side);

} // namespace patina

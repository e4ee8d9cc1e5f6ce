// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"

namespace patina {

/// Brings what choices of the picture change, and nothing else, from a scene into the document.
void setPicture(Document& document, const Scene& from);

} // namespace patina

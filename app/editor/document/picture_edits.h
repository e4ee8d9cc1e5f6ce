// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"

namespace patina {

/// Takes the picture settings of a scene, and nothing else, into the document.
void setPicture(Document& document, const Scene& from);

} // namespace patina

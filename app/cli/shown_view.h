// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/error.h"
#include "render/surfaces/inspected_view.h"
#include "scene/scene.h"

namespace patina {

/// Returns what a word of the command line shows in place of the picture: "normals", or
/// "light=key" for that light of the scene alone. An error names the words, or the lights.
Result<Inspected> shownView(const std::string& word, const Scene& scene);

/// Returns the words, as a help text lists them.
std::string shownViewWords();

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "measure/cost/cost_sweep.h"

namespace patina {

class Document;
class EnvironmentLibrary;
class MeshLibrary;
class TextureLibrary;

/// Returns the active side's scene and its current object, of which there must be one, with the
/// meshes and images that are loaded now, so that another thread can measure it.
CostSweep::Subject costSubject(const Document& document, MeshLibrary& meshes,
                               TextureLibrary& textures, EnvironmentLibrary& environments);

} // namespace patina

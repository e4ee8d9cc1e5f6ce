// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "measure/cost/cost_sweep.h"

namespace patina {

class Document;
class EnvironmentLibrary;
class MeshLibrary;
class TextureLibrary;

/// The active side's scene with its current object, of which there must be one, for a measurement
/// in another thread: what meshes and images there are now.
CostSweep::Subject costSubject(const Document& document, MeshLibrary& meshes,
                               TextureLibrary& textures, EnvironmentLibrary& environments);

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <QString>

#include "catalog/catalog.h"
#include "scene/scene.h"

namespace patina {

/// Returns the artist's name for an effect (EffectLine::effect): a block's label, what an image of
/// a material changes, or a word such as "Ambient". Images are looked up in `first`, which may be
/// null, then in the materials of the scene's objects.
QString effectLabel(const std::string& effect, const Material* first, const Scene& scene,
                    const Catalog& catalog);

} // namespace patina

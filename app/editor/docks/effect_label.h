// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <QString>

#include "catalog/catalog.h"
#include "scene/scene.h"

namespace patina {

/// Returns what an artist calls an effect (EffectLine::effect): a block's label, what an image of a
/// material changes, or a word such as "Ambient". `first` is the material whose images are meant
/// where it has such; else those of the scene's objects. Null: none.
QString effectLabel(const std::string& effect, const Material* first, const Scene& scene,
                    const Catalog& catalog);

} // namespace patina

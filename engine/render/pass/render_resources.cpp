// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/render_resources.h"

#include <utility>

namespace patina {

void RenderResources::setCatalog(std::shared_ptr<const Catalog> changed) {
    catalog = std::move(changed);
    pipelines.setCatalog(catalog);
    shadows.forget();
}

} // namespace patina

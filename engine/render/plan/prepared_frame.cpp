// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/plan/prepared_frame.h"

namespace patina {

void PreparedFrame::begin() {
    meshes.assign(plan.items.size(), nullptr);
    materials.assign(plan.materials.size(), DrawMaterial());
    ground.reset();
}

bool PreparedFrame::hasLines(std::size_t material) const {
    const Pipeline* pipeline = materials[material].pipeline.get();
    return plan.materials[material].isOutlined && pipeline != nullptr && pipeline->outline;
}

} // namespace patina

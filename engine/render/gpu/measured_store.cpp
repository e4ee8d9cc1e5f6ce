// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu/measured_store.h"

#include <algorithm>

#include <epoxy/gl.h>

#include "material/measured_preset.h"
#include "render/gpu/binding.h"

namespace patina {

SharedTable MeasuredStore::bind(const Block& model, const Values& values) {
    return tableParameter(model) != nullptr
               ? bind(measuredTableOf(model, values), binding::measuredTable)
               : nullptr;
}

SharedTable MeasuredStore::bind(int file, unsigned unit) {
    SharedTable table = source_(file);
    auto found = std::ranges::find(entries_, file, &Entry::file);
    if (found != entries_.end() && found->table != table) {
        entries_.erase(found);
        found = entries_.end();
    }
    if (found == entries_.end()) {
        if (entries_.size() >= maxTables) {
            entries_.erase(entries_.begin());
        }
        entries_.push_back(
            {file, table, gl::VolumeTexture::create(table->bins, &table->texels.front().x)});
    } else {
        std::rotate(found, found + 1, entries_.end());
    }
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_3D, entries_.back().texture.name());
    glActiveTexture(GL_TEXTURE0);
    return table;
}

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu/instanced_arrays.h"

#include <algorithm>
#include <cstdint>

#include <epoxy/gl.h>

namespace patina {

InstancedArrays::Array& InstancedArrays::arrayFor(const InstanceBuffer& instances,
                                                  const Make& make) {
    const auto known = std::ranges::find(arrays_, instances.buffer(), &Array::instances);
    if (known != arrays_.end()) {
        return *known;
    }
    // These buffers have no other owner left.
    std::erase_if(arrays_, [](const Array& array) { return array.instances.use_count() == 1; });
    arrays_.push_back({instances.buffer(), 0, 1, make()});
    Array& made = arrays_.back();
    made.array.instanced(Instance::firstAttribute, *made.instances, Instance::attributes, 0);
    return made;
}

/// Where the driver has no base instances, the attributes are set to begin at the first instance
/// instead.
void InstancedArrays::draw(unsigned mode, int corners, const InstanceBuffer& instances,
                           const DrawRange& range, const Make& make) {
    Array& held = arrayFor(instances, make);
    held.array.bind();
    const std::size_t start = instances.hasBase() ? 0 : range.firstInstance * sizeof(Instance);
    if (start != held.offset || range.copies != held.copies) {
        held.array.instanced(Instance::firstAttribute, *held.instances, Instance::attributes, start,
                             static_cast<unsigned>(range.copies));
        held.offset = start;
        held.copies = range.copies;
    }
    const int count = corners * range.triangles;
    const std::size_t before =
        static_cast<std::size_t>(corners) * static_cast<std::size_t>(range.firstTriangle);
    const auto* first = reinterpret_cast<const void*>( // NOLINT: GL passes offsets so
        sizeof(std::uint32_t) * before);
    const auto objects = static_cast<GLsizei>(range.instances) * range.copies;
    if (instances.hasBase()) {
        glDrawElementsInstancedBaseInstance(mode, count, GL_UNSIGNED_INT, first, objects,
                                            static_cast<GLuint>(range.firstInstance));
    } else {
        glDrawElementsInstanced(mode, count, GL_UNSIGNED_INT, first, objects);
    }
}

} // namespace patina

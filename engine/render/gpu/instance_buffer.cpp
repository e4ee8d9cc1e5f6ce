// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu/instance_buffer.h"

#include <algorithm>
#include <span>

#include <epoxy/gl.h>

namespace patina {
namespace {

bool isSame(const Instance& a, const Instance& b) {
    return a.world == b.world && a.normal == b.normal;
}

} // namespace

void InstanceBuffer::makeRoom() {
    if (staged_.size() > sent_.size()) {
        sent_.resize(std::max(staged_.size(), 2 * sent_.size()));
        buffer_->reserve(GL_ARRAY_BUFFER, sent_.size() * sizeof(Instance));
        sentCount_ = 0;
    }
}

bool InstanceBuffer::upload() {
    makeRoom();
    const auto end = static_cast<std::ptrdiff_t>(staged_.size());
    const auto known = static_cast<std::ptrdiff_t>(std::min(staged_.size(), sentCount_));
    const auto first = std::mismatch(staged_.begin(), staged_.begin() + known, sent_.begin(),
                                     isSame).first - staged_.begin();
    std::ptrdiff_t last = end;
    while (last > first && last <= known && isSame(staged_[std::size_t(last - 1)],
                                                   sent_[std::size_t(last - 1)])) {
        --last;
    }
    if (first == last) {
        return false;
    }
    const std::span<const Instance> changed(staged_.begin() + first, staged_.begin() + last);
    buffer_->write(GL_ARRAY_BUFFER, std::as_bytes(changed), std::size_t(first) * sizeof(Instance));
    std::copy(changed.begin(), changed.end(), sent_.begin() + first);
    sentCount_ = std::max(sentCount_, staged_.size());
    return true;
}

} // namespace patina

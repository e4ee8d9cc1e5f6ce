// SPDX-License-Identifier: GPL-3.0-or-later
// Everything the client believes only after a check: messages and the three kinds of block.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <span>
#include <vector>

#include "assets/image_block.h"
#include "assets/mesh_block.h"
#include "assets/message.h"
#include "assets/text_block.h"

namespace {

/// What passed the check must be usable: every index leads to a vertex.
void useMesh(const patina::MeshView& mesh) {
    for (const std::uint32_t index : mesh.indices) {
        if (!(mesh.vertices[index].position.x <= mesh.bounds.upper.x)) {
            std::abort();
        }
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::span input = std::as_bytes(std::span(data, size));
    if (const auto message = patina::decodedMessage(input)) {
        const std::string again = patina::encoded(*message);
        if (again.size() != size || std::memcmp(again.data(), data, size) != 0) {
            std::abort(); // a message has one encoding only
        }
    }
    // Blocks are aligned to pages in life.
    std::vector<std::uint64_t> words((size + 7) / 8);
    std::memcpy(words.data(), data, size);
    const std::span block = std::as_bytes(std::span(words)).first(size);
    if (const auto parts = patina::MeshBlock::checked(block)) {
        for (const patina::MeshPartView& part : *parts) {
            useMesh(part.view);
        }
    }
    [[maybe_unused]] const auto image = patina::ImageBlock::checked(block);
    [[maybe_unused]] const auto text = patina::TextBlock::checked(block);
    return 0;
}

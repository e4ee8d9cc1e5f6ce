// SPDX-License-Identifier: GPL-3.0-or-later
// Stands in for `patina-files` and misbehaves as the variable PATINA_FAKE tells it to.
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <thread>

#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

#include "assets/channel.h"
#include "assets/image_block.h"
#include "assets/mesh_block.h"
#include "assets/shared_block.h"
#include "assets/text_block.h"

namespace patina::tests {
namespace {

constexpr std::size_t headerBytes = 64; // of a mesh block

const MeshPart triangleSize{{"No material", {}, {}, {}, {}, {}, {}}, 3, 3};

/// A good triangle, for the lies to change.
SharedBlock triangle() {
    SharedBlock block = *SharedBlock::create(MeshBlock::sizeFor({&triangleSize, 1}));
    const MeshBlock mesh = MeshBlock::format(block.bytes(), {&triangleSize, 1});
    for (std::uint32_t i = 0; i < 3; ++i) {
        mesh.vertices[i] = Vertex{};
        mesh.vertices[i].position = {i == 1, i == 2, 0.0f};
        mesh.indices[i] = i;
    }
    return block;
}

template <class T>
SharedBlock changed(std::size_t offset, T value) {
    SharedBlock block = triangle();
    std::memcpy(block.bytes().data() + offset, &value, sizeof value);
    return block;
}

void answer(const Channel& channel, SharedBlock block) {
    const FileHandle handle = *SharedBlock::seal(std::move(block));
    channel.send({MessageKind::done, {}, {""}}, handle.get());
}

/// Memory that this process could still change after the client has checked it.
void answerUnsealed(const Channel& channel) {
    const FileHandle handle(::memfd_create("unsealed", MFD_ALLOW_SEALING));
    const std::size_t size = MeshBlock::sizeFor({&triangleSize, 1});
    const SharedBlock block = triangle();
    if (::write(handle.get(), block.bytes().data(), size) == static_cast<ssize_t>(size)) {
        channel.send({MessageKind::done, {}, {""}}, handle.get());
    }
}

void answerText(const Channel& channel) {
    SharedBlock block = *SharedBlock::create(TextBlock::sizeFor(100));
    TextBlock::write(block.bytes(), std::string(100, 'x'));
    answer(channel, std::move(block));
}

void misbehave(const std::string& how, const Channel& channel) {
    const std::uint64_t huge = std::numeric_limits<std::uint64_t>::max() / 48;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    if (how == "crash") {
        std::abort();
    } else if (how == "hang") {
        ::sleep(1000);
    } else if (how == "sleep") { // as one whose turn on the processor does not come
        std::this_thread::sleep_for(std::chrono::seconds(1));
        answer(channel, triangle());
    } else if (how == "spin") {
        while (std::clock() < 1000 * CLOCKS_PER_SEC) {
        }
    } else if (how == "noise") {
        ::send(STDIN_FILENO, "this is not a message", 21, 0);
    } else if (how == "progress of nan") {
        channel.send({MessageKind::progress, {nan}, {}});
        answer(channel, triangle());
    } else if (how == "wrong kind") {
        channel.send({MessageKind::readMesh, {}, {"x"}});
    } else if (how == "no block") {
        channel.send({MessageKind::done, {}, {""}});
    } else if (how == "unsealed block") {
        answerUnsealed(channel);
    } else if (how == "another kind of block") {
        answerText(channel);
    } else if (how == "short block") {
        answer(channel, *SharedBlock::create(8));
    } else if (how == "wrong magic") {
        answer(channel, changed(0, std::uint32_t(0x21212121)));
    } else if (how == "huge vertex count") {
        answer(channel, changed(8, huge));
    } else if (how == "huge index count") {
        answer(channel, changed(16, huge));
    } else if (how == "more vertices than bytes") {
        answer(channel, changed(8, std::uint64_t(4)));
    } else if (how == "index beyond the vertices") {
        answer(channel, changed(headerBytes + 3 * sizeof(Vertex), std::uint32_t(3)));
    } else if (how == "position that is not finite") {
        answer(channel, changed(headerBytes, nan));
    } else {
        answer(channel, triangle());
    }
}

} // namespace
} // namespace patina::tests

int main() {
    using namespace patina;
    const char* const how = std::getenv("PATINA_FAKE");
    if (how != nullptr && std::string_view(how) == "exit at once") {
        return 0;
    }
    const Channel channel{FileHandle(STDIN_FILENO)};
    while (const auto request = channel.receive(std::chrono::milliseconds(-1))) {
        tests::misbehave(how != nullptr ? how : "", channel);
    }
    return 0;
}

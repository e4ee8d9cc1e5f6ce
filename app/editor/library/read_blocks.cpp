// SPDX-License-Identifier: GPL-3.0-or-later
#include "library/read_blocks.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include <QDir>
#include <QFileInfo>

#include "core/ordinary_file.h"

namespace patina {
namespace {

constexpr std::uintmax_t maxBlockBytes = 8u << 20; // bytes; that of descriptors, the larger limit

std::uint64_t hashOf(const std::filesystem::path& file) {
    const Result<std::string> text = readFile(file, maxBlockBytes);
    return text ? qHash(QByteArrayView(*text)) : 0;
}

/// Hashes names, sizes and times of the files that all shaders share: they come with Patina, so
/// that their content seldom changes.
std::uint64_t sharedHash(const Catalog& catalog) {
    std::size_t hash = 0;
    for (const char* name : {"lib", "passes"}) {
        const std::filesystem::path root =
            catalog.roots.empty() ? std::filesystem::path() : catalog.roots.front().folder;
        const QDir folder(QString::fromStdString((root / name).string()));
        for (const QFileInfo& file : folder.entryInfoList(QDir::Files, QDir::Name)) {
            hash = qHashMulti(hash, file.fileName(), file.size(), file.lastModified());
        }
    }
    return hash;
}

/// Collects the blocks that a scene names, each once.
class BlocksOfScene {
  public:
    BlocksOfScene(const Scene& scene, const Catalog& catalog) : catalog_(catalog) {
        for (const Object& object : scene.objects) {
            add(kinds::models, object.material.model.id);
            add(object.material.parts);
        }
        for (const Light& light : scene.lights) {
            add(kinds::lights, light.block.id);
            add(light.parts);
        }
        add(scene.parts);
        for (const BlockValues& pass : scene.passes) {
            add(kinds::pass, pass.id);
        }
        if (scene.part(kinds::transparency)) { // any of its kind may be chosen in its place
            for (const Block* block : catalog.ofKind(kinds::transparency)) {
                add(block->kind, block->id);
            }
        }
    }

    std::vector<const Block*> found;

  private:
    void add(const BlockParts& parts) {
        for (const auto& [kind, values] : parts) {
            add(kind, values.id);
        }
    }

    void add(std::string_view kind, std::string_view id) {
        const Block* block = catalog_.find(kind, id);
        if (block == nullptr || std::ranges::find(found, block) != found.end()) {
            return;
        }
        found.push_back(block);
        for (const Slot& slot : block->slots) {
            add(slot.kind, slot.defaultBlock);
        }
    }

    const Catalog& catalog_;
};

std::vector<const Block*> allOf(const Catalog& catalog) {
    std::vector<const Block*> all;
    for (const Block& block : catalog.blocks) {
        all.push_back(&block);
    }
    return all;
}

ReadBlocks hashed(const std::vector<const Block*>& blocks, const Catalog& catalog) {
    ReadBlocks read;
    for (const Block* block : blocks) {
        read.blocks.push_back(*block);
        read.texts.push_back(hashOf(block->shaderFile));
        read.texts.push_back(hashOf(block->descriptorFile));
    }
    read.texts.push_back(sharedHash(catalog));
    return read;
}

} // namespace

ReadBlocks readBlocksOf(const Scene& scene, const Catalog& catalog) {
    return hashed(BlocksOfScene(scene, catalog).found, catalog);
}

ReadBlocks readBlocks(const Catalog& catalog) {
    return hashed(allOf(catalog), catalog);
}

KnownBlocks::KnownBlocks(std::shared_ptr<const Catalog> catalog, Scene scene)
    : catalog_(std::move(catalog)), scene_(std::move(scene)),
      blocks_(readBlocksOf(scene_, *catalog_)), asked_(catalog_), haveSame_(true) {}

bool KnownBlocks::areIn(const std::shared_ptr<const Catalog>& catalog) const {
    if (std::exchange(asked_, catalog) != catalog) {
        haveSame_ = catalog && blocks_ == readBlocksOf(scene_, *catalog);
    }
    return haveSame_;
}

} // namespace patina

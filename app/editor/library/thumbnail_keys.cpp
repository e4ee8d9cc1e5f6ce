// SPDX-License-Identifier: GPL-3.0-or-later
#include "library/thumbnail_keys.h"

#include <algorithm>
#include <vector>

#include <QCryptographicHash>

#include "core/ordinary_file.h"
#include "library/preset_entry.h"
#include "material/blocks_in_use.h"
#include "material/preset_file.h"
#include "scene/environment.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

/// Has to be raised when images are drawn differently.
constexpr int pictureVersion = 2;

/// Returns the JSON of what is visible of a material.
nlohmann::json lookOf(const Material& material) {
    nlohmann::json look = toJson(material);
    for (const char* text : {"name", "description", "author", "license", "tags", "extras"}) {
        look.erase(text);
    }
    return look;
}

/// Returns the files that blocks include, and the passes that call them.
std::vector<fs::path> sharedShaders(const Catalog& catalog) {
    std::vector<fs::path> files;
    if (catalog.roots.empty()) {
        return files;
    }
    for (const char* folder : {"lib", "passes"}) {
        std::error_code missing;
        for (const auto& file :
             fs::directory_iterator(catalog.roots.front().folder / folder, missing)) {
            files.push_back(file.path());
        }
    }
    std::ranges::sort(files);
    return files;
}

} // namespace

QByteArray ThumbnailKeys::of(const Material& material, const Catalog& catalog) {
    QCryptographicHash hash(QCryptographicHash::Sha1);
    hash.addData(QByteArray::number(pictureVersion));
    hash.addData(QByteArray::fromStdString(lookOf(material).dump()));
    for (const Block* block : blocksInUse(material, catalog)) {
        hash.addData(hashOf(block->descriptorFile));
        hash.addData(hashOf(block->shaderFile));
    }
    for (const auto& [key, use] : material.textures) {
        hash.addData(use.outside || isVertexColors(use.file) ? QByteArray() // nothing is read
                                                             : hashOf(use.file));
    }
    hash.addData(renderer(catalog));
    return hash.result().toHex();
}

QByteArray ThumbnailKeys::of(const BlockValues& environment, const Catalog& catalog) {
    QCryptographicHash hash(QCryptographicHash::Sha1);
    hash.addData(QByteArray::number(pictureVersion));
    if (const Block* block = catalog.find(kinds::environment, environment.id)) {
        hash.addData(hashOf(block->descriptorFile));
        hash.addData(hashOf(block->shaderFile));
        hash.addData(hashOf(pictureFile(environment, *block)));
    }
    hash.addData(renderer(catalog));
    return hash.result().toHex();
}

QByteArray ThumbnailKeys::of(const Scene& scene, const fs::path& file, const Catalog& catalog) {
    QCryptographicHash hash(QCryptographicHash::Sha1);
    hash.addData(hashOf(file));
    for (const Object& object : scene.objects) {
        hash.addData(of(object.material, catalog));
    }
    hash.addData(renderer(catalog));
    return hash.result().toHex();
}

/// Hashes what is the same for all materials: the scene, the blocks of other kinds than models, the
/// shared shaders and the program.
QByteArray ThumbnailKeys::renderer(const Catalog& catalog) {
    QCryptographicHash hash(QCryptographicHash::Sha1);
    hash.addData(hashOf(scene_));
    for (const Block& block : catalog.blocks) {
        if (block.kind != kinds::models) {
            hash.addData(hashOf(block.descriptorFile));
            hash.addData(hashOf(block.shaderFile));
        }
    }
    for (const fs::path& file : sharedShaders(catalog)) {
        hash.addData(hashOf(file));
    }
    const FileStamp program = stampOf("/proc/self/exe");
    hash.addData(QByteArray::number(qint64(program.bytes)));
    hash.addData(QByteArray::number(qint64(program.written)));
    return hash.result();
}

/// Returns the hash of a file's content; empty if it cannot be read or is no ordinary file.
QByteArray ThumbnailKeys::hashOf(const fs::path& file) {
    const FileStamp stamp = stampOf(file);
    Hashed& known = files_[file.string()];
    if (known.hash.isEmpty() || known.bytes != stamp.bytes || known.written != stamp.written) {
        QCryptographicHash hash(QCryptographicHash::Sha1);
        known = {stamp.bytes, stamp.written, {}};
        if (const Result<std::string> content = readFile(file, maxAssetBytes)) {
            hash.addData(QByteArrayView(content->data(), qsizetype(content->size())));
            known.hash = hash.result();
        }
    }
    return known.hash;
}

} // namespace patina

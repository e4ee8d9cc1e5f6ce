// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/withheld_files.h"

#include <algorithm>
#include <utility>

#include "document/commands/material_command.h"
#include "material/preset_file.h"

namespace patina {
namespace {

/// The reader of scenes keeps the path of a preset that it did not read under this key.
const char* const unreadPreset = "damagedPreset";

/// Returns every place of a material that a document has.
std::vector<MaterialPlace> materialPlaces(const DocumentState& state, int currentObject) {
    std::vector<MaterialPlace> places;
    for (int i = 0; i < static_cast<int>(state.scene.objects.size()); ++i) {
        places.push_back({i, Side::A});
    }
    for (const Side side : sides) {
        if (side != Side::A && indexOf(side) < shownSides(state)) {
            places.push_back({currentObject, side});
        }
    }
    return places;
}

bool hasOutsideImages(const Material& material) {
    return std::ranges::any_of(material.textures,
                               [](const auto& entry) { return entry.second.outside; });
}

} // namespace

WithheldFiles::WithheldFiles(Document& document, QObject* parent)
    : QObject(parent), document_(document) {
    connect(&document, &Document::fileNamed, this, &WithheldFiles::allow);
}

OutsideFiles WithheldFiles::all() const {
    OutsideFiles found = files_;
    for (const MaterialPlace& place :
         materialPlaces(document_.state(), document_.selection().object())) {
        const Material* material = materialAt(document_.state(), place.object, place.side);
        if (!material) {
            continue;
        }
        for (const auto& [key, use] : material->textures) {
            const OutsideFile image{OutsideFile::Kind::Image, use.file};
            if (use.outside && std::ranges::find(found, image) == found.end()) {
                found.push_back(image);
            }
        }
    }
    return found;
}

FileRights WithheldFiles::rights() const {
    FileRights rights{{}, links_};
    for (const OutsideFile& each : files_) {
        if (each.kind != OutsideFile::Kind::Link) {
            rights.withheld.insert(each.file);
        }
    }
    return rights;
}

void WithheldFiles::set(OutsideFiles files) {
    std::erase_if(files,
                  [](const OutsideFile& each) { return each.kind == OutsideFile::Kind::Image; });
    if (files != files_) {
        files_ = std::move(files);
        Q_EMIT changed();
    }
}

void WithheldFiles::allowLinks(FileSet links) {
    if (links != links_) {
        links_ = std::move(links);
        Q_EMIT changed();
    }
}

void WithheldFiles::add(const OutsideFiles& files) {
    OutsideFiles all = files_;
    for (const OutsideFile& file : files) {
        if (std::ranges::find(all, file) == all.end()) {
            all.push_back(file);
        }
    }
    set(std::move(all));
}

void WithheldFiles::addLinks(const std::vector<std::string>& places) {
    OutsideFiles links;
    for (const std::string& place : places) {
        links.push_back({OutsideFile::Kind::Link, place});
    }
    add(links);
}

void WithheldFiles::allow(const std::filesystem::path& file) {
    OutsideFiles left = files_;
    std::erase_if(left, [name = file.generic_string()](const OutsideFile& each) {
        return each.file == name;
    });
    set(std::move(left));
}

void WithheldFiles::allowAll(const std::filesystem::path& documentFile) {
    ReadingRights rights;
    const OutsideFiles withheld = all();
    for (const OutsideFile& each : withheld) {
        rights.allowed.insert(each.file);
        if (each.kind == OutsideFile::Kind::Link) {
            links_.insert(each.file);
        }
    }
    const bool isInMaterials = std::ranges::any_of(withheld, [](const OutsideFile& each) {
        return each.kind == OutsideFile::Kind::Image || each.kind == OutsideFile::Kind::Preset;
    });
    if (isInMaterials) {
        document_.editAsOneStep(tr("Allow files outside"), [&] {
            for (const MaterialPlace& place :
                 materialPlaces(document_.state(), document_.selection().object())) {
                allowIn(place, documentFile, rights);
            }
        });
    }
    set({});
    document_.announce({DocumentChange::Rights});
}

/// Reads the preset of a material where it was not read, and marks the material's images as
/// allowed.
void WithheldFiles::allowIn(const MaterialPlace& place, const std::filesystem::path& documentFile,
                            const ReadingRights& rights) {
    const Material* held = materialAt(document_.state(), place.object, place.side);
    if (!held) {
        return;
    }
    Material material = *held;
    const auto unread = material.extras.find(unreadPreset);
    if (unread != material.extras.end() && unread->is_string()) {
        const std::filesystem::path file =
            (referenceFolder(documentFile) / unread->get<std::string>()).lexically_normal();
        const auto reading = readPreset(file, document_.catalog(), rights);
        if (reading && rights.allowed.contains(file.generic_string())) {
            material = reading->material;
        }
    }
    if (hasOutsideImages(material)) {
        for (auto& [key, use] : material.textures) {
            use.outside = use.outside && !rights.allowed.contains(use.file);
        }
    }
    if (!(material == *held)) {
        document_.undoStack().push(
            new MaterialCommand(document_, place, material, tr("Allow files outside")));
    }
}

} // namespace patina

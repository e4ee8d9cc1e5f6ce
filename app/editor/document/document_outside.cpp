// SPDX-License-Identifier: GPL-3.0-or-later
// Files that the document names outside the folder of its file.
#include <algorithm>

#include "document/commands/material_command.h"
#include "document/document.h"
#include "material/preset_file.h"

namespace patina {
namespace {

/// Where the reader of scenes keeps the path of a preset that it did not read.
const char* const unreadPreset = "damagedPreset";

/// Every place of a material that a document has.
std::vector<MaterialPlace> materialPlaces(const DocumentState& state, int currentObject) {
    std::vector<MaterialPlace> places;
    for (int i = 0; i < static_cast<int>(state.scene.objects.size()); ++i) {
        places.push_back({i, Side::A});
    }
    if (state.second) {
        places.push_back({currentObject, Side::B});
    }
    return places;
}

bool hasOutsideImages(const Material& material) {
    return std::ranges::any_of(material.textures,
                               [](const auto& entry) { return entry.second.outside; });
}

} // namespace

OutsideFiles Document::outside() const {
    OutsideFiles all = outside_;
    for (const MaterialPlace& place : materialPlaces(state_, currentObject_)) {
        const Material* material = materialAt(state_, place.object, place.side);
        if (!material) {
            continue;
        }
        for (const auto& [key, use] : material->textures) {
            const OutsideFile image{OutsideFile::Kind::Image, use.file};
            if (use.outside && std::ranges::find(all, image) == all.end()) {
                all.push_back(image);
            }
        }
    }
    return all;
}

std::set<std::string, std::less<>> Document::withheld() const {
    std::set<std::string, std::less<>> files;
    for (const OutsideFile& each : outside_) {
        files.insert(each.file);
    }
    return files;
}

void Document::setOutside(OutsideFiles outside) {
    std::erase_if(outside,
                  [](const OutsideFile& each) { return each.kind == OutsideFile::Kind::Image; });
    if (outside != outside_) {
        outside_ = std::move(outside);
        Q_EMIT withheldChanged();
    }
}

void Document::allow(const std::filesystem::path& file) {
    OutsideFiles left = outside_;
    std::erase_if(left, [name = file.generic_string()](const OutsideFile& each) {
        return each.file == name;
    });
    setOutside(std::move(left));
}

void Document::allowOutside() {
    ReadingRights rights;
    const OutsideFiles all = outside();
    for (const OutsideFile& each : all) {
        rights.allowed.insert(each.file);
    }
    const bool isInMaterials = std::ranges::any_of(all, [](const OutsideFile& each) {
        return each.kind == OutsideFile::Kind::Image || each.kind == OutsideFile::Kind::Preset;
    });
    if (isInMaterials) {
        editAsOneStep(tr("Allow files outside"), [&] {
            for (const MaterialPlace& place : materialPlaces(state_, currentObject_)) {
                allowIn(place, rights);
            }
        });
    }
    setOutside({});
    announce({DocumentChange::Material});
}

/// Reads a material's preset that was not read, and shows its images.
void Document::allowIn(const MaterialPlace& place, const ReadingRights& rights) {
    const Material* held = materialAt(state_, place.object, place.side);
    if (!held) {
        return;
    }
    Material material = *held;
    const auto unread = material.extras.find(unreadPreset);
    if (unread != material.extras.end() && unread->is_string()) {
        const std::filesystem::path file =
            (referenceFolder(file_.path) / unread->get<std::string>()).lexically_normal();
        const auto reading = readPreset(file, *catalog_, rights);
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
        undoStack_.push(new MaterialCommand(*this, place, material, tr("Allow files outside")));
    }
}

} // namespace patina

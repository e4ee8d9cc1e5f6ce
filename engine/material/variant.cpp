// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/variant.h"

#include <algorithm>

#include <fmt/format.h>

#include "material/texture_path.h"

namespace patina {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

constexpr const char* parentKey = "parent";

/// Names the keys that a variant never inherits.
constexpr const char* notInherited[] = {"format", "version", "name", "parked", "extras", parentKey};

std::string namedParent(const Json& preset) {
    const auto found = preset.is_object() ? preset.find(parentKey) : preset.end();
    return found != preset.end() && found->is_string() ? found->get<std::string>() : std::string();
}

bool isSameFile(const fs::path& a, const fs::path& b) {
    std::error_code missing;
    return a == b || fs::equivalent(a, b, missing);
}

/// Returns the JSON that a variant of `parent` with this model patches. Values carry over to
/// another model as they do when an artist chooses it.
Json inherited(const Material& parent, const std::string& model, const fs::path& folder,
               const Catalog& catalog) {
    const Block* before = catalog.find(kinds::models, parent.model.id);
    const Block* after = catalog.find(kinds::models, model);
    const bool isOther = before && after && before != after;
    Json json = toJson(isOther ? withModel(parent, before, *after) : parent, folder);
    for (const char* key : notInherited) {
        json.erase(key);
    }
    return json;
}

/// Returns the merge patch that makes `to` from `from`.
Json patchBetween(const Json& from, const Json& to) {
    if (!from.is_object() || !to.is_object()) {
        return to;
    }
    Json patch = Json::object();
    for (const auto& [key, value] : to.items()) {
        const auto before = from.find(key);
        if (before == from.end()) {
            patch[key] = value;
        } else if (*before != value) {
            patch[key] = patchBetween(*before, value);
        }
    }
    for (const auto& [key, value] : from.items()) {
        if (!to.contains(key)) {
            patch[key] = Json();
        }
    }
    return patch;
}

/// Reads presets upwards, from a variant to the one that has no parent.
class VariantReader {
  public:
    VariantReader(const Catalog& catalog, std::vector<fs::path> below)
        : catalog_(catalog), below_(std::move(below)) {}

    Checked<PresetReading> read(const LocatedJson& variant, const ReadingRights& rights) {
        References references(variant.file, rights);
        const std::string named = namedParent(variant.value);
        const fs::path file = imageFromFile(named, references.base());
        if (const std::string why = whyNot(variant, file, named, references); !why.empty()) {
            return unread(variant, why);
        }
        const Result<LocatedJson> document = readJson(file);
        if (!document) {
            return unread(variant, fmt::format("the parent \"{}\" cannot be read: {}", named,
                                               document.error().problem));
        }
        below_.emplace_back(variant.file);
        const ReadingRights above = references.rightsOf(named);
        Checked<PresetReading> parent = document->value.contains(parentKey)
                                            ? read(*document, above)
                                            : materialFromJson(*document, "", catalog_, above);
        if (!parent) {
            Errors errors{mistake(variant, fmt::format("the parent \"{}\" has mistakes", named),
                                  "a preset that can be read")};
            errors.insert(errors.end(), parent.error().begin(), parent.error().end());
            return tl::unexpected(std::move(errors));
        }
        return merged(variant, *parent, file, rights);
    }

  private:
    static Error mistake(const LocatedJson& variant, std::string problem, std::string expected) {
        return variant.error(std::string("/") + parentKey, std::move(problem), std::move(expected));
    }

    /// Returns the error for a parent that is not read.
    static tl::unexpected<Errors> unread(const LocatedJson& variant, std::string problem) {
        return tl::unexpected(Errors{mistake(variant, std::move(problem),
                                             "the path of a preset from the folder of this one")});
    }

    std::string whyNot(const LocatedJson& variant, const fs::path& file, const std::string& named,
                       References& references) const {
        if (named.empty()) {
            return "the parent has no name";
        }
        if (!references.mayRead(named, OutsideFile::Kind::Preset)) {
            return fmt::format("the parent \"{}\" lies outside the folder of this preset and is "
                               "not read",
                               named);
        }
        if (isSameFile(file, variant.file) ||
            std::ranges::any_of(below_,
                                [&](const fs::path& each) { return isSameFile(file, each); })) {
            return fmt::format("the parent \"{}\" is a variant of this preset", named);
        }
        return below_.size() + 1 > maxParents
                   ? fmt::format("more than {} presets stand above each other", maxParents)
                   : std::string();
    }

    Checked<PresetReading> merged(const LocatedJson& variant, const PresetReading& parent,
                                  const fs::path& file, const ReadingRights& rights) const {
        const Json model = variant.value.value("model", Json::object());
        const std::string id = model.is_object() && model.contains("id") && model["id"].is_string()
                                   ? model["id"].get<std::string>()
                                   : parent.material.model.id;
        LocatedJson whole = variant;
        whole.value = inherited(parent.material, id, referenceFolder(variant.file), catalog_);
        whole.value.merge_patch(variant.value);
        ReadingRights withImages = rights;
        for (const auto& [key, use] : parent.material.textures) {
            if (!use.outside) {
                withImages.allowed.insert(use.file);
            }
        }
        Checked<PresetReading> reading = materialFromJson(whole, "", catalog_, withImages);
        if (reading) {
            setParent(reading->material, file.generic_string());
            reading->parents = parent.parents;
            reading->parents.insert(reading->parents.begin(), file);
        }
        return reading;
    }

    const Catalog& catalog_;
    std::vector<fs::path> below_; ///< are the variants that led here
};

} // namespace

std::string parentOf(const Material& material) {
    return namedParent(material.unknown);
}

void setParent(Material& material, const std::string& file) {
    if (file.empty()) {
        material.unknown.erase(parentKey);
    } else {
        material.unknown[parentKey] = file;
    }
}

Checked<PresetReading> readVariant(const LocatedJson& document, const Catalog& catalog,
                                   const ReadingRights& rights) {
    return VariantReader(catalog, {}).read(document, rights);
}

Json variantJson(const Material& material, const fs::path& file, const Catalog& catalog) {
    const fs::path folder = referenceFolder(file);
    Json whole = toJson(material, folder);
    whole.erase(parentKey);
    const fs::path parent = parentOf(material);
    ReadingRights all; // the user chose this parent, wherever it is
    all.everything = true;
    const auto reading =
        isSameFile(parent, file) ? tl::unexpected(Errors()) : readPreset(parent, catalog, all);
    const bool isAbove =
        reading && std::ranges::none_of(reading->parents, [&](const fs::path& each) {
            return isSameFile(each, file);
        });
    if (!isAbove) {
        return whole;
    }
    Json patch =
        patchBetween(inherited(reading->material, material.model.id, folder, catalog), whole);
    if (material.model.id != reading->material.model.id) {
        patch["model"] = whole["model"];
    }
    for (const char* key : notInherited) {
        if (whole.contains(key) && !whole[key].empty()) {
            patch[key] = whole[key];
        } else {
            patch.erase(key);
        }
    }
    patch[parentKey] = imageForFile(parent.generic_string(), folder);
    return patch;
}

OutsideFiles parentsOutside(const fs::path& file, const ReadingRights& rights) {
    fs::path at = file;
    ReadingRights held = rights;
    for (int above = 0; above < maxParents; ++above) {
        const Result<LocatedJson> document = readJson(at);
        const std::string named = document ? namedParent(document->value) : std::string();
        if (named.empty()) {
            return {};
        }
        const ReadingRights here = held;
        References references(at, here);
        if (!references.mayRead(named, OutsideFile::Kind::Preset)) {
            return references.outside();
        }
        held = references.rightsOf(named);
        at = imageFromFile(named, references.base());
    }
    return {};
}

} // namespace patina

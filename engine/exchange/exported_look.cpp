// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/exported_look.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "catalog/expression.h"
#include "exchange/image_settings.h"
#include "material/material_assignment.h"
#include "material/mesh_look.h"
#include "material/model_swap.h"
#include "material/preset_file.h"
#include "measure/match/model_matches.h"
#include "shading/effects/textures.h"

namespace patina {
namespace {

constexpr std::size_t fittedDirections = 1024;
/// Is how much less error a later look must have to be taken: the first ones say more.
constexpr double isNearer = 0.95;
constexpr double lostImage = 0.1; ///< is the error that an image counts as which a look has not
constexpr double lostHighlight = 0.05;                    ///< is that of a highlight
constexpr std::string_view transmission = "transmission"; ///< is the look of what refracts

/// Is a material with the look that it has.
struct Looking {
    Material material;
    MeshLook look;
};

/// Returns the value that an id of a look names ("fresnel.f0" of a part); null for none.
const Value* valueIn(const Material& material, const std::string& id) {
    for (const auto& [kind, part] : material.parts) {
        if (id.starts_with(kind + '.')) {
            const auto value = part.parameters.find(id.substr(kind.size() + 1));
            return value == part.parameters.end() ? nullptr : &value->second;
        }
    }
    const auto value = material.model.parameters.find(id);
    return value == material.model.parameters.end() ? nullptr : &value->second;
}

glm::dvec3 numbersOf(const Value& value) {
    if (const auto* color = std::get_if<glm::dvec3>(&value)) {
        return *color;
    }
    const auto* number = std::get_if<double>(&value);
    return glm::dvec3(number == nullptr ? 0.0 : *number);
}

bool isSaid(const MeshLook& look, const std::string& id) {
    return std::ranges::any_of(look.values, [&id](const auto& pair) { return pair.second == id; });
}

/// Tells whether a block's values are those of another material with the look, but for what the
/// look says and what does not count as the values stand.
bool isSame(const Block& block, const BlockValues& values, const BlockValues& others,
            const std::string& prefix, const MeshLook& look) {
    Values all = values.parameters;
    all.merge(defaultValues(block));
    Values wanted = others.parameters;
    wanted.merge(defaultValues(block));
    return std::ranges::all_of(block.parameters, [&](const Parameter& parameter) {
        const auto condition = Expression::parse(parameter.enabledWhen);
        return isSaid(look, prefix + parameter.id) ||
               all.at(parameter.id) == wanted.at(parameter.id) ||
               (condition && !condition->evaluate(all));
    });
}

/// Tells whether the look says all that a material's model and what fills its slots are.
bool hasLook(const Material& material, const ModelLook& look, const Catalog& catalog) {
    const auto start = look.start(catalog);
    if (!start || !isSame(*look.model, material.model, start->model, {}, look.look)) {
        return false;
    }
    return std::ranges::all_of(look.model->slots, [&](const Slot& slot) {
        const BlockValues* held = material.part(slot.kind);
        const BlockValues* wanted = start->part(slot.kind);
        const Block* block = blockOf(material.parts, slot.kind, catalog);
        if (held == nullptr || wanted == nullptr) {
            return held == wanted;
        }
        return block != nullptr && held->id == wanted->id &&
               isSame(*block, *held, *wanted, slot.kind + '.', look.look);
    });
}

/// Returns the material with its own look, if one of the wanted ones says it.
Result<std::optional<Looking>> asItIs(const Material& material, const Block& model,
                                      std::span<const std::string_view> looks,
                                      const Catalog& catalog) {
    const auto stated = meshLooksOf(model);
    if (!stated) {
        return tl::unexpected(stated.error());
    }
    for (const MeshLook& look : *stated) {
        if (std::ranges::find(looks, look.look) != looks.end() &&
            hasLook(material, {&model, look}, catalog)) {
            return Looking{material, look};
        }
    }
    return std::nullopt;
}

/// Returns what a material is without a fit: the values that have the same ids in another model.
Looking carriedOver(const Material& material, const ModelLook& to, const Catalog& catalog) {
    return {swappedModel(material, *to.model, catalog), to.look};
}

/// Is a look with the values that come nearest to a material.
struct FittedLook {
    Looking looking;
    double error = 0.0; ///< is that of the lightness
    bool losesHighlight = false;
};

/// Returns the image on a value of its model; null for none.
const TextureUse* imageOn(const Material& material, const std::string& id) {
    const auto image = material.textures.find(id);
    return image != material.textures.end() && image->second.enabled ? &image->second : nullptr;
}

/// Returns the values of a look that may change in a fit of `start`. One that an image replaces is
/// the material's own, and beside a colour with an image no other colour changes, or that would
/// take over what the image is seen by.
std::vector<std::string> freeValues(const Material& material, Material& start, const MeshLook& look,
                                    const Catalog& catalog) {
    std::vector<std::string> free;
    const bool hasImage = std::ranges::any_of(
        look.values, [&](const auto& pair) { return imageOn(material, pair.second) != nullptr; });
    for (const auto& [word, id] : look.values) {
        const TextureUse* image = imageOn(material, id);
        const Parameter* parameter = parameterIn(start, id, catalog);
        const auto own = material.model.parameters.find(id);
        if (image != nullptr && image->mode == TextureMode::Replace) {
            if (own != material.model.parameters.end()) {
                start.model.parameters[id] = own->second;
            }
        } else if (image != nullptr || !hasImage || parameter == nullptr ||
                   !infoOf(parameter->type).isColor) {
            free.push_back(id);
        }
    }
    return free;
}

/// Counts the images on values that a look does not have.
std::ptrdiff_t lostImages(const Material& material, const MeshLook& look) {
    return std::ranges::count_if(material.textures, [&look](const auto& each) {
        return each.second.enabled && textureRole(each.first) == TextureRole::Input &&
               !isSaid(look, each.first);
    });
}

/// Returns the width of a highlight that a value says, as the slope of its mirrors.
double slopeOf(HighlightWidth kind, double value) {
    return kind == HighlightWidth::Exponent ? std::sqrt(2.0 / (value + 2.0)) : value;
}

/// Returns how wide the highlight of a block is by its own value; nothing where it has none.
std::optional<double> widthIn(const Block& block, const BlockValues& values) {
    for (const Parameter& parameter : block.parameters) {
        const auto own = values.parameters.find(parameter.id);
        const Value& value = own == values.parameters.end() ? parameter.defaultValue : own->second;
        if (parameter.highlight != HighlightWidth::None && std::holds_alternative<double>(value)) {
            return slopeOf(parameter.highlight, std::get<double>(value));
        }
    }
    return std::nullopt;
}

/// Returns how wide the highlight of a material is, its model's or that in a slot; nothing where
/// no value says it.
std::optional<double> highlightWidth(const Material& material, const Catalog& catalog) {
    const Block* model = catalog.find(kinds::models, material.model.id);
    std::optional<double> width = model == nullptr ? std::nullopt : widthIn(*model, material.model);
    for (const auto& [kind, part] : material.parts) {
        const Block* block = catalog.find(kind, part.id);
        if (!width && block != nullptr && model != nullptr && model->slot(kind) != nullptr) {
            width = widthIn(*block, part);
        }
    }
    return width;
}

/// Returns the largest number of a look's value; 0 where the look has none of that word.
double largestOf(const Looking& looking, const std::string& word) {
    const auto id = looking.look.values.find(word);
    const Value* value =
        id == looking.look.values.end() ? nullptr : valueIn(looking.material, id->second);
    const glm::dvec3 numbers = value == nullptr ? glm::dvec3(0.0) : numbersOf(*value);
    return std::max({numbers.x, numbers.y, numbers.z});
}

/// Tells whether next to nothing of a highlight of a width is left, or it is so much wider that it
/// is none any more.
bool isHighlightLost(const Looking& looking, double width) {
    constexpr double faintest = 1e-3; // is a reflectance that nobody sees beside a base
    constexpr double muchWider = 3.0;
    return !looking.look.values.contains("specular") &&
           (largestOf(looking, "f0") < faintest ||
            largestOf(looking, "alpha") > muchWider * std::max(width, 0.02));
}

/// Fits models to a material.
class LookFitter {
  public:
    LookFitter(const Material& material, const MatchTarget& target, const Catalog& catalog,
               const Progress& progress)
        : material_(material), target_(target), catalog_(catalog), progress_(progress),
          width_(highlightWidth(material, catalog)) {}

    /// Returns the material with a look that is nearest; nothing where none can be fitted. Nearest
    /// to a rough base may be one that has a wide highlight for its rim, and none that shines: then
    /// the highlight keeps the material's own width.
    std::optional<ModelMatch> fit(const ModelLook& look) const {
        auto start = look.start(catalog_);
        if (!start) {
            return std::nullopt;
        }
        FitOptions options{.error = MatchError::Lightness};
        options.only = freeValues(material_, *start, look.look, catalog_);
        std::optional<ModelMatch> nearest = fit(*start, options);
        const auto alpha = look.look.values.find("alpha");
        if (nearest && width_ && alpha != look.look.values.end() &&
            isHighlightLost({nearest->material, look.look}, *width_)) {
            start->model.parameters[alpha->second] = std::clamp(*width_, 1e-3, 1.0);
            std::erase(options.only, alpha->second);
            if (const auto shining = fit(*start, options);
                shining && !isHighlightLost({shining->material, look.look}, *width_)) {
                return shining;
            }
        }
        return nearest;
    }

  private:
    std::optional<ModelMatch> fit(const Material& start, const FitOptions& options) const {
        ModelMatches matches =
            fittedMaterials({start}, target_, options, catalog_,
                            [this](double, const auto&) { return !progress_.cancelled; });
        return matches.rows.empty() ? std::nullopt : std::optional(std::move(matches.rows.front()));
    }

    const Material& material_;
    const MatchTarget& target_;
    const Catalog& catalog_;
    const Progress& progress_;
    std::optional<double> width_;
};

/// Returns the nearest of the looks; nothing where the material has no reflectance to be fitted.
std::optional<FittedLook> fittedLook(const Material& material, const std::vector<ModelLook>& looks,
                                     const Catalog& catalog, const Progress& progress) {
    const auto aim = matchAim(material, catalog, fittedDirections, MatchDirections::LitBall);
    if (!aim) {
        return std::nullopt;
    }
    const LookFitter fitter(material, aim->target, catalog, progress);
    std::vector<FittedLook> fitted;
    for (const ModelLook& look : looks) {
        const auto match = progress.cancelled ? std::nullopt : fitter.fit(look);
        if (match) {
            fitted.push_back({{match->material, look.look}, match->error});
        }
    }
    const std::optional<double> width = highlightWidth(material, catalog);
    const bool isShiny = width && std::ranges::any_of(fitted, [width](const FittedLook& each) {
                             return each.looking.look.values.contains("diffuse") &&
                                    !isHighlightLost(each.looking, *width);
                         });
    std::optional<FittedLook> best;
    double minCost = 0.0;
    for (FittedLook& each : fitted) {
        each.losesHighlight = isShiny && isHighlightLost(each.looking, *width);
        const double cost = each.error +
                            lostImage * double(lostImages(material, each.looking.look)) +
                            (each.losesHighlight ? lostHighlight : 0.0);
        if (!best || cost < isNearer * minCost) {
            best = each;
            minCost = cost;
        }
    }
    return best;
}

/// Gives a fitted material what a fit leaves: name, opacity, images, parts without a slot, and
/// glow.
Material withTheRest(Material fitted, const Material& from, const Catalog& catalog) {
    fitted.name = from.name;
    fitted.opacity = from.opacity;
    fitted.textures = from.textures;
    const Block* model = catalog.find(kinds::models, fitted.model.id);
    const Block* own = catalog.find(kinds::models, from.model.id);
    for (const auto& [kind, part] : from.parts) {
        if (model != nullptr && model->slot(kind) == nullptr && own->slot(kind) == nullptr) {
            setPart(fitted.parts, kind, part);
        }
    }
    for (const Parameter& parameter : own->parameters) {
        const auto glow = from.model.parameters.find(parameter.id);
        const Parameter* same = model == nullptr ? nullptr : model->parameter(parameter.id);
        if (parameter.emission && same != nullptr && same->emission &&
            glow != from.model.parameters.end()) {
            fitted.model.parameters[parameter.id] = glow->second;
        }
    }
    return fitted;
}

/// Finds the look of a material, and tells in `said` where it is not exactly that.
Result<Looking> lookingOf(const Material& material, std::span<const std::string_view> words,
                          const Catalog& catalog, const Progress& progress, ExportedLook& said) {
    const Block* model = catalog.find(kinds::models, material.model.id);
    if (model == nullptr) {
        return failure(fmt::format("there is no model \"{}\"", material.model.id));
    }
    auto own = asItIs(material, *model, words, catalog);
    if (!own || *own) {
        return own.map([](std::optional<Looking>& looking) { return std::move(*looking); });
    }
    std::vector<ModelLook> looks;
    const bool isIsotropic = model->hasClaim("isotropic");
    for (const std::string_view word : words) {
        auto look = importedLook(std::string(word), catalog);
        if (!look) {
            return tl::unexpected(look.error());
        }
        // A mix of two looks is fitted by the nearer one.
        const bool isMix = look->look.values.contains("metalness");
        if (!isMix && (!isIsotropic || !look->look.values.contains("grain"))) {
            looks.push_back(std::move(*look));
        }
    }
    auto fitted = fittedLook(material, looks, catalog, progress);
    if (!fitted) {
        said.tell(
            Kept::Approximated, model->label,
            "is no reflectance that could be fitted; its colours are those of a matte surface");
        Looking carried = carriedOver(material, looks.back(), catalog);
        carried.material = withTheRest(std::move(carried.material), material, catalog);
        return carried;
    }
    said.tell(Kept::Approximated, model->label,
              fmt::format("has no counterpart as it is set; {} was fitted to it, off by {:.2g} "
                          "of the 100 steps of lightness in the mean",
                          fitted->looking.look.look, 100.0 * fitted->error));
    if (fitted->losesHighlight) {
        said.tell(Kept::Dropped, "Highlight", "is too faint beside the rest to be kept by a fit");
    }
    fitted->looking.material = withTheRest(std::move(fitted->looking.material), material, catalog);
    return std::move(fitted->looking);
}

/// Notes which words have values that were fitted or carried over: all but the glow.
void noteFitted(ExportedLook& said, const Looking& looking, const Catalog& catalog) {
    for (const auto& [word, id] : looking.look.values) {
        const Parameter* parameter = parameterIn(looking.material, id, catalog);
        if (parameter == nullptr || !parameter->emission) {
            said.fitted.insert(word);
        }
    }
}

void sayValues(ExportedLook& said, const Looking& looking, const Catalog& catalog) {
    said.material.look = looking.look.look;
    for (const auto& [word, id] : looking.look.values) {
        const Parameter* parameter = parameterIn(looking.material, id, catalog);
        if (parameter != nullptr) {
            const Value* value = valueIn(looking.material, id);
            said.material.values[word] =
                numbersOf(value != nullptr ? *value : parameter->defaultValue);
            said.labels[word] = parameter->label;
        }
    }
    if (looking.material.opacity < 1.0) {
        said.material.values["opacity"] = glm::dvec3(looking.material.opacity);
        said.labels["opacity"] = "Opacity";
    }
}

/// Says the images whose words a look has, and tells of the others.
void sayImages(ExportedLook& said, const Looking& looking, const Catalog& catalog) {
    for (const auto& [key, use] : looking.material.textures) {
        const Parameter* parameter = parameterIn(looking.material, key, catalog);
        const std::string what = imageTitle(use);
        const auto word = std::ranges::find_if(
            looking.look.values, [&key = key](const auto& pair) { return pair.second == key; });
        if (!use.enabled) {
            said.tell(Kept::Dropped, what, "is switched off");
        } else if (isVertexColors(use.file)) {
            said.tell(Kept::Dropped, "Vertex colours", "belong to a mesh");
        } else if (use.outside) {
            said.tell(Kept::Dropped, what, "lies outside its folder and is not read");
        } else if (textureRole(key) != TextureRole::Input) {
            said.images[key] = use;
        } else if (word != looking.look.values.end()) {
            said.images[word->first] = use;
            said.channels[word->first] =
                channelOf(use, textureTarget(key, use, looking.material, catalog));
        } else {
            said.tell(Kept::Dropped, what,
                      fmt::format("drives {}, which is not said",
                                  parameter == nullptr ? key : parameter->label));
        }
    }
}

/// Returns the look of what lies over the model, by its descriptor, if the format has it.
std::optional<MeshLook> lookOfPart(const Block& block, const KnownLooks& known) {
    const auto looks = meshLooksOf(block);
    if (!known.hasTransmission || !looks) {
        return std::nullopt;
    }
    const auto found = std::ranges::find(*looks, transmission, &MeshLook::look);
    return found == looks->end() ? std::nullopt : std::optional(*found);
}

/// Tells whether a material has a part that refracts, which the format can say.
bool refracts(const Material& material, const KnownLooks& known, const Catalog& catalog) {
    return std::ranges::any_of(material.parts, [&](const auto& each) {
        const Block* block = catalog.find(each.first, each.second.id);
        return block != nullptr && lookOfPart(*block, known);
    });
}

/// Says the values of what lies over the model in the words of its look.
void sayPart(ExportedLook& said, const Block& block, const BlockValues& part,
             const MeshLook& look) {
    for (const auto& [word, id] : look.values) {
        if (const Parameter* parameter = block.parameter(id)) {
            const auto value = part.parameters.find(id);
            said.material.values[word] =
                numbersOf(value == part.parameters.end() ? parameter->defaultValue : value->second);
            said.labels[word] = parameter->label;
        }
    }
}

/// Says what lies over the model (an outline, refraction, fur), or tells that it is lost.
void sayParts(ExportedLook& said, const Material& material, const KnownLooks& known,
              const Catalog& catalog) {
    const Block* model = catalog.find(kinds::models, material.model.id);
    for (const auto& [kind, part] : material.parts) {
        const Block* block = catalog.find(kind, part.id);
        const auto look = block == nullptr ? std::nullopt : lookOfPart(*block, known);
        if (look) {
            sayPart(said, *block, part, *look);
        } else if (model == nullptr || model->slot(kind) == nullptr) {
            said.tell(Kept::Dropped, block == nullptr ? part.id : block->label, "is not written");
        }
    }
}

} // namespace

std::string_view wordOf(Kept kept) {
    constexpr std::array<std::string_view, 3> words{"exact", "approximated", "dropped"};
    return words[static_cast<std::size_t>(kept)];
}

TextureUse* ExportedLook::image(const std::string& word) {
    const auto found = images.find(word);
    return found == images.end() ? nullptr : &found->second;
}

const TextureUse* ExportedLook::image(const std::string& word) const {
    const auto found = images.find(word);
    return found == images.end() ? nullptr : &found->second;
}

void ExportedLook::tell(Kept kept, std::string what, std::string how) {
    lines.push_back({kept, std::move(what), std::move(how)});
}

void ExportedLook::tellOf(const std::string& word, Kept kept, std::string how) {
    const auto label = labels.find(word);
    if (label != labels.end()) {
        tell(fitted.contains(word) && kept == Kept::Exact ? Kept::Approximated : kept,
             label->second, std::move(how));
    }
}

glm::dvec3 ExportedLook::value(const std::string& word, const glm::dvec3& missing) const {
    const auto found = material.values.find(word);
    return found == material.values.end() ? missing : found->second;
}

Result<ExportedLook> exportedLook(const Material& material, const KnownLooks& looks,
                                  const Catalog& catalog, const Progress& progress) {
    constexpr std::array<std::string_view, 2> refracting{"dielectric", "grained-dielectric"};
    ExportedLook said;
    said.material.name = material.name;
    said.preset = toJson(material);
    const std::span<const std::string_view> words =
        refracts(material, looks, catalog) ? refracting : looks.ofModels;
    const auto looking = lookingOf(material, words, catalog, progress, said);
    if (!looking) {
        return tl::unexpected(looking.error());
    }
    if (!said.lines.empty()) { // it is not as it was
        noteFitted(said, *looking, catalog);
    }
    sayValues(said, *looking, catalog);
    sayParts(said, looking->material, looks, catalog);
    sayImages(said, *looking, catalog);
    return said;
}

} // namespace patina

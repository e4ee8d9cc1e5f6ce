// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/model_swap.h"

#include <algorithm>

#include "material/block_values.h"

namespace patina {
namespace {

using Json = nlohmann::json;

// These members of `parked` map kinds to what rests. They cannot be confused with parked values,
// which are never objects.
constexpr const char* inSlotKey = "inSlot";           ///< holds what fills the slot; null: nothing
constexpr const char* withoutSlotKey = "withoutSlot"; ///< holds what is on without the slot
constexpr const char* blackKey =
    "black"; ///< holds black colours by id while the model's own are used

/// Takes a member out of `parked`; an empty object where it is missing or no object.
Json take(Json& parked, const char* key) {
    const auto found = parked.find(key);
    if (found == parked.end() || !found->is_object()) {
        return Json::object();
    }
    Json taken = std::move(*found);
    parked.erase(found);
    return taken;
}

void put(Json resting, Json& parked, const char* key) {
    if (!resting.empty()) {
        parked[key] = std::move(resting);
    }
}

/// Moves the part of one kind between the material and what rests.
class PartSwap {
  public:
    PartSwap(Material& material, std::string kind, const Catalog& catalog)
        : material_(material), kind_(std::move(kind)), catalog_(catalog) {}

    void leaveSlot(Json& inSlot, Json& withoutSlot) {
        const Json filling = current();
        become(withoutSlot.value(kind_, Json()));
        withoutSlot.erase(kind_);
        if (current() != filling) {
            inSlot[kind_] = filling;
        }
    }

    void enterSlot(Json& inSlot, Json& withoutSlot) {
        if (const Json now = current(); !now.is_null()) {
            withoutSlot[kind_] = now;
        }
        if (const auto filling = inSlot.find(kind_); filling != inSlot.end()) {
            become(*filling);
            inSlot.erase(kind_);
        }
    }

  private:
    Json current() const {
        const BlockValues* part = material_.part(kind_);
        return part == nullptr ? Json() : toJson(*part);
    }

    void become(const Json& wanted) {
        material_.parts.erase(kind_);
        if (!wanted.is_object()) {
            return;
        }
        Errors problems; // of a file somebody wrote by hand: what can be read is used
        const LocatedJson document{{}, wanted, {}};
        JsonReader reader(document, "", problems);
        BlockValues values = BlockReader{catalog_, problems}.read(reader, kind_);
        values.unknown.update(reader.unknown());
        material_.parts[kind_] = std::move(values);
    }

    Material& material_;
    std::string kind_;
    const Catalog& catalog_;
};

void swapParts(Material& material, const Block& before, const Block& after,
               const Catalog& catalog) {
    Json inSlot = take(material.parked, inSlotKey);
    Json withoutSlot = take(material.parked, withoutSlotKey);
    for (const std::string_view kind : partKinds(BlockOwner::Material)) {
        const bool had = before.slot(kind) != nullptr;
        const bool has = after.slot(kind) != nullptr;
        PartSwap swap(material, std::string(kind), catalog);
        if (had && !has) {
            swap.leaveSlot(inSlot, withoutSlot);
        } else if (!had && has) {
            swap.enterSlot(inSlot, withoutSlot);
        }
    }
    put(std::move(inSlot), material.parked, inSlotKey);
    put(std::move(withoutSlot), material.parked, withoutSlotKey);
}

bool isBlack(const Material& material, const Parameter& parameter) {
    const auto found = material.model.parameters.find(parameter.id);
    return found != material.model.parameters.end() && found->second == Value(glm::dvec3(0.0));
}

/// Tells whether the material is black whatever the light: no colour of the model is above 0, and
/// no chosen part fills a slot that has no default.
bool isDark(const Material& material, const Block& model) {
    const auto shows = [&](const Parameter& parameter) {
        return infoOf(parameter.type).isColor && !isBlack(material, parameter);
    };
    const auto isFilled = [&](const Slot& slot) {
        return slot.defaultBlock.empty() && material.part(slot.kind) != nullptr;
    };
    return std::none_of(model.parameters.begin(), model.parameters.end(), shows) &&
           std::none_of(model.slots.begin(), model.slots.end(), isFilled);
}

/// Brings black colours back that rested, except where a colour was chosen meanwhile.
void bringBack(const Json& black, Material& material, const Block& model) {
    const Values usual = defaultBlockValues(model).parameters;
    for (const auto& [id, value] : black.items()) {
        const Parameter* parameter = model.parameter(id);
        if (parameter != nullptr && infoOf(parameter->type).isColor &&
            material.model.parameters[id] == usual.at(id)) {
            material.model.parameters[id] = glm::dvec3(0.0);
        }
    }
}

/// Replaces black colours, but no emission, with the model's own, and returns the black ones by id.
Json lighten(Material& material, const Block& model) {
    Json black = Json::object();
    for (const Parameter& parameter : model.parameters) {
        const Value usual = roundedToFloat(parameter.defaultValue);
        if (infoOf(parameter.type).isColor && !parameter.emission && isBlack(material, parameter) &&
            usual != Value(glm::dvec3(0.0))) {
            black[parameter.id] = {0.0, 0.0, 0.0};
            material.model.parameters[parameter.id] = usual;
        }
    }
    return black;
}

/// Tells whether a material has no base beside its highlight, as metals have none.
bool isBare(const Material& material, const Block& model) {
    constexpr double darkest = 0.04; // is what plastics reflect without a base
    const Parameter* base = model.withRole(roles::diffuse);
    if (base == nullptr || !material.model.parameters.contains(base->id)) {
        return false;
    }
    const auto* color = std::get_if<glm::dvec3>(&material.model.parameters.at(base->id));
    return color != nullptr && std::max({color->x, color->y, color->z}) < darkest;
}

/// Lets the reflectance of what fills a new slot be 1 for a metal, which has no base and whose
/// highlight has all of its colour: by the term's own, that of a plastic, hardly any were left.
void keepMetal(Material& material, const Block& before, const Block& after, const Material& metal,
               const Catalog& catalog) {
    if (!isBare(metal, before)) {
        return;
    }
    const Json resting = metal.parked.is_object() && metal.parked.contains(inSlotKey)
                             ? metal.parked.at(inSlotKey)
                             : Json::object();
    for (const Slot& slot : after.slots) {
        const Block* usual = catalog.find(slot.kind, slot.defaultBlock);
        const Parameter* f0 = usual == nullptr ? nullptr : usual->withRole(roles::f0);
        if (f0 != nullptr && material.part(slot.kind) == nullptr &&
            before.slot(slot.kind) == nullptr && !resting.contains(slot.kind)) {
            BlockValues values = defaultBlockValues(*usual);
            values.parameters[f0->id] = glm::dvec3(1.0);
            setPart(material.parts, slot.kind, std::move(values));
        }
    }
}

} // namespace

bool hasPlaceFor(const Block& model, std::string_view kind) {
    const BlockKind* row = findKind(kind);
    return model.slot(kind) != nullptr || (row != nullptr && !row->needsSlot);
}

Material swappedModel(const Material& material, const Block& newModel, const Catalog& catalog) {
    const Block* before = catalog.find(kinds::models, material.model.id);
    if (before == nullptr) {
        return withModel(material, before, newModel);
    }
    const bool wasDark = isDark(material, *before);
    Material current = material;
    bringBack(take(current.parked, blackKey), current, *before);
    Material next = withModel(current, before, newModel);
    swapParts(next, *before, newModel, catalog);
    keepMetal(next, *before, newModel, current, catalog);
    if (!wasDark && isDark(next, newModel)) {
        put(lighten(next, newModel), next.parked, blackKey);
    }
    return next;
}

} // namespace patina

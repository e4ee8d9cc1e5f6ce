// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/model_swap.h"

#include <optional>

#include "material/block_values.h"

namespace patina {
namespace {

using Json = nlohmann::json;

// Members of `parked`: kind -> what rests. No parameter's id can be either, for a parameter's value
// is never an object.
constexpr const char* inSlotKey = "inSlot";           ///< fills the slot; null: nothing chosen
constexpr const char* withoutSlotKey = "withoutSlot"; ///< is on in models without the slot

/// A member that is an object, taken out.
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

/// Moves one kind of part in and out of rest.
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
    for (const std::string_view kind : partKinds) {
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

} // namespace

Material swappedModel(const Material& material, const Block& newModel, const Catalog& catalog) {
    const Block* before = catalog.find("models", material.model.id);
    Material next = withModel(material, before, newModel);
    if (before != nullptr) {
        swapParts(next, *before, newModel, catalog);
    }
    return next;
}

} // namespace patina

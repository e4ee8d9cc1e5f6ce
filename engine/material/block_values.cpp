// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/block_values.h"

#include <optional>
#include <set>

#include "catalog/fills.h"
#include "catalog/value_json.h"

namespace patina {
namespace {

using Json = nlohmann::json;

/// Returns the key under which a value is parked whose plain id is taken by another block's value.
std::string ownKey(const std::string& blockId, const std::string& parameterId) {
    return blockId + '/' + parameterId;
}

/// Returns what a document holds for a value: in range, and rounded to float.
Value held(const Parameter& parameter, const Value& value) {
    return roundedToFloat(conformed(parameter, value));
}

/// Moves the values of one block to another.
class Carrier {
  public:
    Carrier(const BlockValues& values, const Block* from, const Block& to, Json& parked)
        : values_(values), from_(from), to_(to), parked_(parked) {}

    BlockValues run() {
        BlockValues next = defaultBlockValues(to_);
        next.unknown = values_.unknown;
        for (const Parameter& parameter : to_.parameters) {
            if (const auto value = valueFor(parameter)) {
                next.parameters[parameter.id] = held(parameter, *value);
                keepOriginal(parameter, *value);
            }
        }
        parkTheRest();
        settleShorthands(to_, next.parameters);
        return next;
    }

  private:
    /// Returns the current value under the parameter's id; null where there is none or the blocks
    /// give the parameter different types.
    const Value* sameMeaning(const Parameter& parameter) const {
        const auto found = values_.parameters.find(parameter.id);
        if (found == values_.parameters.end()) {
            return nullptr;
        }
        const Parameter* old = from_ == nullptr ? nullptr : from_->parameter(parameter.id);
        const bool differs = from_ != nullptr && (old == nullptr || old->type != parameter.type);
        return differs ? nullptr : &found->second;
    }

    /// Takes the parked value that fits out of the parked ones: it comes back or is superseded.
    std::optional<Value> takeParked(const Parameter& parameter) {
        for (const std::string& key : {ownKey(to_.id, parameter.id), parameter.id}) {
            const auto found = parked_.find(key);
            if (found == parked_.end()) {
                continue;
            }
            if (const ValueReading value = valueFromJson(parameter, *found)) {
                parked_.erase(key);
                return *value;
            }
        }
        return std::nullopt;
    }

    /// Tells whether the current value is only what the old block made of the parked one, and
    /// nobody has changed it since.
    bool standsFor(const Value& current, const Value& original, const Parameter& parameter) const {
        const Parameter* old = from_ == nullptr ? nullptr : from_->parameter(parameter.id);
        return old != nullptr && current == held(*old, original);
    }

    /// Returns the value that fits, not yet brought into range; nothing where there is none.
    std::optional<Value> valueFor(const Parameter& parameter) {
        std::optional<Value> original = takeParked(parameter);
        const Value* current = sameMeaning(parameter);
        if (current == nullptr) {
            return original;
        }
        if (original && standsFor(*current, *original, parameter)) {
            used_.insert(parameter.id);
            return original;
        }
        const ValueReading fitting = valueFromJson(parameter, toJson(*current));
        if (!fitting) {
            return original;
        }
        used_.insert(parameter.id);
        return *fitting;
    }

    void keepOriginal(const Parameter& parameter, const Value& original) {
        if (conformed(parameter, original) != original) {
            parked_[parameter.id] = toJson(original);
        }
    }

    void parkTheRest() {
        for (const auto& [id, value] : values_.parameters) {
            if (!used_.contains(id)) {
                const Json json = toJson(value);
                const bool taken = parked_.contains(id) && parked_[id] != json;
                parked_[taken ? ownKey(values_.id, id) : id] = json;
            }
        }
    }

    const BlockValues& values_;
    const Block* from_;
    const Block& to_;
    Json& parked_;
    std::set<std::string> used_;
};

} // namespace

BlockValues defaultBlockValues(const Block& block) {
    BlockValues values{block.id, block.version, defaultValues(block), Json::object()};
    for (auto& [id, value] : values.parameters) {
        value = roundedToFloat(value);
    }
    return values;
}

BlockValues carriedOver(const BlockValues& values, const Block* from, const Block& to,
                        nlohmann::json& parked) {
    return Carrier(values, from, to, parked).run();
}

void park(const Values& values, nlohmann::json& parked) {
    for (const auto& [id, value] : values) {
        parked[id] = toJson(value);
    }
}

} // namespace patina

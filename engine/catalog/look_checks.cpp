// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/look_checks.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "catalog/descriptor_checker.h"

namespace patina {
namespace {

class LookChecker : DescriptorChecker {
  public:
    explicit LookChecker(const Descriptor& descriptor) : DescriptorChecker(descriptor) {}

    Errors run() {
        const auto looks = document_.value.find("looks");
        if (looks == document_.value.end() || !looks->is_array()) {
            return {};
        }
        if (findKind(block_.kind)->owner != BlockOwner::Material) {
            add("/looks", "only what materials are made of looks like other programs' materials",
                "no such key");
        }
        std::set<std::string> stated;
        for (std::size_t i = 0; i < looks->size(); ++i) {
            check((*looks)[i], fmt::format("/looks/{}", i), stated);
        }
        return std::move(errors_);
    }

  private:
    /// Checks one look; what the schema reports is left alone.
    void check(const nlohmann::json& look, const std::string& pointer,
               std::set<std::string>& stated) {
        if (!look.is_object()) {
            return;
        }
        const auto word = look.find("look");
        if (word != look.end() && word->is_string() &&
            !stated.insert(word->get<std::string>()).second) {
            add(pointer + "/look", fmt::format("{} is stated twice", word->dump()),
                "each look once");
        }
        const auto values = look.find("values");
        if (values == look.end() || !values->is_object()) {
            return;
        }
        for (const auto& [key, id] : values->items()) {
            if (id.is_string() && !isKnown(id.get<std::string>())) {
                add(fmt::format("{}/values/{}", pointer, key),
                    fmt::format("{} is no parameter of the model or of its slots", id.dump()),
                    "the id of a parameter");
            }
        }
    }

    bool isKnown(const std::string& id) const {
        return block_.parameter(id) != nullptr ||
               std::ranges::any_of(block_.slots, [&id](const Slot& slot) {
                   return id.starts_with(slot.kind + '.');
               });
    }
};

} // namespace

Errors lookMistakes(const Descriptor& descriptor) {
    return LookChecker(descriptor).run();
}

} // namespace patina

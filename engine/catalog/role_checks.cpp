// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/role_checks.h"

#include <algorithm>

#include <fmt/format.h>

#include "catalog/descriptor_checker.h"
#include "catalog/picture_roles.h"
#include "catalog/suggestion.h"

namespace patina {

namespace {

/// Says why the parameter cannot be a transmitted share; empty when it can.
std::string transparencyMistake(const Parameter& parameter) {
    if (parameter.type != ParameterType::Float || parameter.min < 0.0 || parameter.max > 1.0) {
        return "only a float from 0 to 1 can be a share that passes";
    }
    return {};
}

bool canTellWidth(const Parameter& parameter) {
    return parameter.type == ParameterType::Float || parameter.type == ParameterType::Angle;
}

class RoleChecker : DescriptorChecker {
  public:
    explicit RoleChecker(const Descriptor& descriptor)
        : DescriptorChecker(descriptor), kind_(findKind(descriptor.block.kind)) {}

    Errors run() {
        for (std::size_t i = 0; i < block_.parameters.size(); ++i) {
            const std::string pointer = fmt::format("/parameters/{}", i);
            checkKeys(block_.parameters[i], pointer);
            if (!block_.parameters[i].role.empty()) {
                checkRole(block_.parameters[i], pointer);
            }
        }
        checkNeeded();
        return std::move(errors_);
    }

  private:
    std::span<const ParameterRole> roles() const {
        return kind_ == nullptr ? std::span<const ParameterRole>() : kind_->roles;
    }

    void checkKeys(const Parameter& parameter, const std::string& pointer) {
        const std::string mistake = transparencyMistake(parameter);
        if (parameter.transparency && !mistake.empty()) {
            add(pointer + "/transparency", mistake, "no such key");
        }
        if (parameter.highlight != HighlightWidth::None && !canTellWidth(parameter)) {
            add(pointer + "/highlight", "only a number can say how wide a highlight is",
                "no such key");
        }
    }

    void checkRole(const Parameter& parameter, const std::string& pointer) {
        const auto role = std::ranges::find(roles(), parameter.role, &ParameterRole::word);
        const std::string place = pointer + "/role";
        if (role == roles().end()) {
            add(place,
                fmt::format("{} have no role \"{}\"", kind_ ? kind_->plural : "these blocks",
                            parameter.role),
                roles().empty() ? "no such key" : oneOf(parameter.role, words()));
        } else if (parameter.type != role->type) {
            const std::string_view wanted = infoOf(role->type).word;
            add(place,
                fmt::format("a parameter of type {} cannot be the \"{}\"",
                            infoOf(parameter.type).word, role->word),
                fmt::format("the type \"{}\"", wanted));
        } else if (!role->mayRepeat && block_.withRole(role->word) != &parameter) {
            add(place,
                fmt::format("\"{}\" is the \"{}\" already", block_.withRole(role->word)->id,
                            role->word),
                "the role at one parameter");
        } else {
            checkChoices(parameter, *role, pointer);
            checkState(parameter, pointer);
        }
    }

    void checkChoices(const Parameter& parameter, const ParameterRole& role,
                      const std::string& pointer) {
        const std::vector<std::string> known(role.choices.begin(), role.choices.end());
        for (std::size_t i = 0; !known.empty() && i < parameter.values.size(); ++i) {
            const std::string& id = parameter.values[i].id;
            if (std::ranges::find(known, id) == known.end()) {
                add(fmt::format("{}/values/{}/id", pointer, i),
                    fmt::format("\"{}\" is no choice of the role \"{}\"", id, role.word),
                    oneOf(id, known));
            }
        }
    }

    /// Checks what is a state of a pass, which its program has in its text.
    void checkState(const Parameter& parameter, const std::string& pointer) {
        const bool isTest = parameter.role == patina::roles::depthTest;
        if ((isTest || parameter.role == patina::roles::blend) &&
            parameter.compiled == Compiled::No) {
            add(pointer, fmt::format("the \"{}\" of a pass is part of its program", parameter.role),
                "\"compiled\": true");
        }
        if (isTest && !block_.picture.readsSurfaces) {
            add(pointer + "/role", "without depths nothing can be tested by them",
                "\"surfaces\": true in \"picture\"");
        }
        if (parameter.role == patina::roles::blendAmount &&
            (parameter.min < 0.0 || parameter.max > 1.0)) {
            add(pointer, "an amount is a share", "a \"min\" and a \"max\" from 0 to 1");
        }
    }

    void checkNeeded() {
        for (const ParameterRole& role : roles()) {
            if (role.isNeeded && block_.withRole(role.word) == nullptr) {
                add("/parameters",
                    fmt::format("no parameter is the \"{}\", which all {} have", role.word,
                                kind_->plural),
                    fmt::format("\"role\": \"{}\" at a parameter of type {}", role.word,
                                infoOf(role.type).word));
            }
        }
    }

    std::vector<std::string> words() const {
        std::vector<std::string> all;
        for (const ParameterRole& role : roles()) {
            all.emplace_back(role.word);
        }
        return all;
    }

    const BlockKind* kind_;
};

} // namespace

Errors roleMistakes(const Descriptor& descriptor) {
    return RoleChecker(descriptor).run();
}

} // namespace patina

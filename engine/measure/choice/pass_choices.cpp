// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/choice/pass_choices.h"

#include <algorithm>

#include <fmt/format.h>

#include "catalog/expression.h"
#include "catalog/picture_roles.h"
#include "shading/effects/passes_effect.h"
#include "shading/program/given_value.h"

namespace patina {
namespace {

constexpr std::string_view passPrefix = "pass.";

std::string passChoiceId(const Block& block, const Parameter& parameter) {
    return fmt::format("{}{}.{}", passPrefix, block.id, parameter.id);
}

/// Tells whether the parameter is a choice of a pass with these values.
bool isPassChoice(const Parameter& parameter, const Block& block, Values values) {
    if (parameter.role != roles::accuracy || parameter.values.size() < 2) {
        return false;
    }
    const Result<Expression> condition = Expression::parse(parameter.enabledWhen);
    values.merge(defaultValues(block));
    return !condition || condition->evaluate(values);
}

/// Calls `act` with the values of each pass that has the choice, and the parameter that it is.
template <class PassList, class Act>
void forPasses(PassList& passes, const Choice& choice, const Catalog& catalog, const Act& act) {
    for (auto& pass : passes) {
        const Block* block = isOfPass(choice) ? catalog.find(kinds::pass, pass.id) : nullptr;
        if (block == nullptr) {
            continue;
        }
        const auto parameter = std::ranges::find_if(block->parameters, [&](const Parameter& each) {
            return isPassChoice(each, *block, pass.parameters) &&
                   passChoiceId(*block, each) == choice.id;
        });
        if (parameter != block->parameters.end()) {
            act(pass.parameters, *parameter);
        }
    }
}

} // namespace

std::vector<Choice> choicesOfPasses(const Scene& scene, const Catalog& catalog) {
    std::vector<Choice> choices;
    PassesEffect drawn;
    drawn.choose(scene, catalog);
    for (const PassUse& pass : drawn.passes) {
        const Block& block = pass.use.block();
        for (const Parameter& parameter : block.parameters) {
            const std::string id = passChoiceId(block, parameter);
            if (!isPassChoice(parameter, block, scene.passes[pass.place].parameters) ||
                std::ranges::find(choices, id, &Choice::id) != choices.end()) {
                continue;
            }
            Choice choice{Choice::Scope::Picture, id,          id, parameter.label,
                          parameter.doc,          block.label, {}};
            for (auto level = parameter.values.rbegin(); level != parameter.values.rend();
                 ++level) { // the finest one is the last
                choice.levels.push_back({level->id, level->label, level->doc});
            }
            choices.push_back(std::move(choice));
        }
    }
    return choices;
}

bool isOfPass(const Choice& choice) {
    return choice.scope == Choice::Scope::Picture && choice.id.starts_with(passPrefix);
}

bool hasPassLevel(const ChosenLevels& levels) {
    return std::ranges::any_of(
        levels, [](const auto& level) { return level.first.starts_with(passPrefix); });
}

std::string passLevel(const Scene& scene, const Choice& choice, const Catalog& catalog) {
    std::string found;
    forPasses(scene.passes, choice, catalog, [&](const Values& values, const Parameter& parameter) {
        if (found.empty() || found == choice.levels.front().id) {
            found = std::get<std::string>(conformed(parameter, givenValue(parameter, values)));
        }
    });
    return found;
}

void choosePass(Scene& scene, const Choice& choice, const std::string& level,
                const Catalog& catalog) {
    if (choice.level(level) == nullptr) {
        return;
    }
    forPasses(scene.passes, choice, catalog,
              [&](Values& values, const Parameter& parameter) { values[parameter.id] = level; });
}

} // namespace patina

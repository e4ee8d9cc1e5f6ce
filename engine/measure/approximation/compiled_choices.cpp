// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/compiled_choices.h"

#include <algorithm>

#include "catalog/parameter_layout.h"

namespace patina {
namespace {

using ChoiceKind = ShaderExpression::Kind;

bool isWholeOrCondition(const ShaderType& type) {
    return type.isScalar() &&
           (type.base == ShaderType::Base::Int || type.base == ShaderType::Base::Bool);
}

} // namespace

CompiledChoices::CompiledChoices(const ShaderSyntax& syntax, const Block& block)
    : syntax_(syntax), struct_(structName(block)) {
    for (const ParameterField& field : layoutOf(block).fields) {
        if (field.choice != nullptr) {
            levels_.insert(field.name);
            compiled_.insert(field.name);
        } else if (field.parameter->compiled == Compiled::Yes) {
            compiled_.insert(field.name);
        }
    }
    std::set<int> called;
    for (const ShaderExpression& each : syntax.expressions) {
        addWrites(each);
        called.insert(each.kind == ChoiceKind::Call ? each.function : -1);
    }
    for (std::size_t i = 0; i < syntax.functions.size(); ++i) {
        for (const ShaderVariable& argument : syntax.functions[i].arguments) {
            if (argument.isOut || !called.contains(static_cast<int>(i))) {
                varying_.insert({static_cast<int>(i), argument.place});
            }
        }
    }
    bool isChanged = true;
    while (isChanged) {
        isChanged = false;
        for (const ShaderExpression& each : syntax.expressions) {
            isChanged = spread(each) || isChanged;
        }
    }
}

bool CompiledChoices::isField(const ShaderExpression& expression,
                              const std::set<std::string>& names) const {
    if (expression.kind != ChoiceKind::Field) {
        return false;
    }
    const int structure = at(expression.operands.front()).type.structure;
    return structure >= 0 && syntax_.structs[static_cast<std::size_t>(structure)].name == struct_ &&
           names.contains(std::string(expression.sign));
}

/// Finds variables that are written to in two places, or in other ways than by a plain `=`.
void CompiledChoices::addWrites(const ShaderExpression& expression) {
    const auto add = [this](int target, bool isPlain) {
        const ShaderExpression& local = at(target);
        const Variable variable{local.owner, local.place};
        if (local.kind == ChoiceKind::Local && (!written_.insert(variable).second || !isPlain)) {
            varying_.insert(variable);
        }
    };
    if (expression.kind == ChoiceKind::Assign || expression.kind == ChoiceKind::Step) {
        add(expression.operands.front(), expression.sign == "=");
    } else if (expression.kind == ChoiceKind::Call) {
        const auto& arguments =
            syntax_.functions[static_cast<std::size_t>(expression.function)].arguments;
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            if (arguments[i].isOut) {
                add(expression.operands[i], false);
            }
        }
    }
}

/// Lets what a variable is given decide what it is. Returns whether that is new.
bool CompiledChoices::spread(const ShaderExpression& expression) {
    bool isNew = false;
    const auto give = [this, &isNew](const Variable& variable, int value) {
        isNew = (!isChoice(value) && varying_.insert(variable).second) || isNew;
        isNew = (asksLevel(value) && ofLevel_.insert(variable).second) || isNew;
    };
    if (expression.kind == ChoiceKind::Assign) {
        const ShaderExpression& target = at(expression.operands.front());
        if (target.kind == ChoiceKind::Local) {
            give({target.owner, target.place}, expression.operands[1]);
        }
    } else if (expression.kind == ChoiceKind::Call) {
        const auto& arguments =
            syntax_.functions[static_cast<std::size_t>(expression.function)].arguments;
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            give({expression.function, arguments[i].place}, expression.operands[i]);
        }
    }
    return isNew;
}

bool CompiledChoices::isChoice(int expression) const {
    const ShaderExpression& each = at(expression);
    if (!isWholeOrCondition(each.type)) {
        return false;
    }
    switch (each.kind) {
    case ChoiceKind::Literal:
    case ChoiceKind::Global:
        return true;
    case ChoiceKind::Local:
        return !varying_.contains({each.owner, each.place});
    case ChoiceKind::Field:
        return isField(each, compiled_);
    case ChoiceKind::Unary:
    case ChoiceKind::Binary:
    case ChoiceKind::Choice:
        return std::ranges::all_of(each.operands,
                                   [this](int operand) { return isChoice(operand); });
    default:
        return false;
    }
}

bool CompiledChoices::asksLevel(int condition) const {
    const ShaderExpression& each = at(condition);
    if (each.kind == ChoiceKind::Local) {
        return ofLevel_.contains({each.owner, each.place});
    }
    const bool isPartial = each.kind == ChoiceKind::Unary || each.kind == ChoiceKind::Binary ||
                           each.kind == ChoiceKind::Choice;
    return isField(each, levels_) ||
           (isPartial && isWholeOrCondition(each.type) &&
            std::ranges::any_of(each.operands, [this](int operand) { return asksLevel(operand); }));
}

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/direction_tables.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>

#include <fmt/format.h>

#include "catalog/block_kind.h"
#include "catalog/parameter_layout.h"
#include "catalog/table_source.h"
#include "measure/approximation/shader_price.h"
#include "measure/approximation/table_axis.h"
#include "shading/program/block_source.h"

namespace patina {
namespace {

using CallKind = ShaderExpression::Kind;

/// Says how a number of `Directions` follows from the cosine `c` of its direction.
struct DirectionNumber {
    std::string_view number;
    std::string_view cosine;
    std::string_view form;
};

constexpr DirectionNumber directionNumbers[] = {{"nl", "nl", "c"},
                                                {"sin2l", "nl", "max(1.0 - c * c, 0.0)"},
                                                {"versineL", "nl", "1.0 - c"},
                                                {"nv", "nv", "c"},
                                                {"sin2v", "nv", "max(1.0 - c * c, 0.0)"},
                                                {"lh", "lh", "c"},
                                                {"versineLh", "lh", "1.0 - c"},
                                                {"nh", "nh", "c"},
                                                {"rv", "rv", "c"},
                                                {"versineRv", "rv", "1.0 - c"}};

/// Is a call whose arguments follow from one cosine and the block's values.
struct DirectionCall {
    int expression = -1;
    int cosine = -1;    ///< is the argument that is the cosine itself
    std::string values; ///< is the name of the block's values where the call stands
    /// Is the call in a table's entry: of the cosine `c`, the values `p`, or `q`, a copy of those
    /// that it reads, which is what an entry may give to another function.
    std::string entry;
    bool givesValues = false;
    std::set<std::string> fields; ///< are those of the values that it reads
};

/// Reads calls.
class CallReader {
  public:
    CallReader(const ObservedShader& shader, const Block& block)
        : shader_(shader), values_(structName(block)), layout_(layoutOf(block)) {}

    std::optional<DirectionCall> read(int index) {
        const ShaderExpression& call = shader_.at(index);
        const bool isVector = call.type.isFloat() && call.type.columns == 1 && call.size <= 3;
        if (call.kind != CallKind::Call || !isVector) {
            return std::nullopt;
        }
        made_ = {index, -1, {}, std::string(call.sign) + '(', false, {}};
        for (std::size_t i = 0; i < call.operands.size(); ++i) {
            const auto given = argument(call.operands[i]);
            if (!given) {
                return std::nullopt;
            }
            made_.entry += (i > 0 ? ", " : "") + *given;
        }
        made_.entry += ')';
        if (made_.values.empty()) {
            made_.values = valuesOf(call.owner);
        }
        if (made_.cosine < 0 || made_.values.empty()) {
            return std::nullopt;
        }
        addFields(call.function);
        return areKnown() ? std::optional(std::move(made_)) : std::nullopt;
    }

  private:
    bool isOf(int index, std::string_view structure) const {
        const ShaderExpression& each = shader_.at(index);
        const int type = each.type.structure;
        return each.kind == CallKind::Local && each.first < each.last && type >= 0 &&
               shader_.syntax.structs[static_cast<std::size_t>(type)].name == structure;
    }

    /// Returns an argument as it stands in an entry; nothing where it varies in another way.
    std::optional<std::string> argument(int index) {
        const ShaderExpression& each = shader_.at(index);
        if (isOf(index, values_)) {
            made_.values = each.sign;
            made_.givesValues = true;
            return "q";
        }
        if (each.kind == CallKind::Literal && each.first < each.last) {
            return std::string(shader_.syntax.textOf(each));
        }
        if (each.kind != CallKind::Field) {
            return std::nullopt;
        }
        const int owner = each.operands.front();
        if (isOf(owner, values_)) {
            made_.values = shader_.at(owner).sign;
            made_.fields.insert(std::string(each.sign));
            return "p." + std::string(each.sign);
        }
        return isOf(owner, "Directions") ? ofDirection(index) : std::nullopt;
    }

    std::optional<std::string> ofDirection(int index) {
        const ShaderExpression& each = shader_.at(index);
        const auto known = std::ranges::find(directionNumbers, each.sign, &DirectionNumber::number);
        if (known == std::end(directionNumbers)) {
            return std::nullopt;
        }
        const std::string owner = std::string(shader_.at(each.operands.front()).sign);
        const std::string whose = owner + '.' + std::string(known->cosine);
        if (!whose_.empty() && whose_ != whose) {
            return std::nullopt;
        }
        whose_ = whose;
        if (known->number == known->cosine) {
            made_.cosine = index;
        }
        return std::string(known->form);
    }

    /// Returns the name of the block's values in a function; empty where it has none.
    std::string valuesOf(int function) const {
        for (const ShaderVariable& each :
             shader_.syntax.functions[static_cast<std::size_t>(function)].arguments) {
            const int type = each.type.structure;
            if (type >= 0 &&
                shader_.syntax.structs[static_cast<std::size_t>(type)].name == values_) {
                return std::string(each.name);
            }
        }
        return {};
    }

    /// Tells whether the program that fills tables has all that the call reads.
    bool areKnown() const {
        return std::ranges::all_of(made_.fields, [this](const std::string& name) {
            return std::ranges::find(layout_.fields, name, &ParameterField::name) !=
                   layout_.fields.end();
        });
    }

    /// Adds the fields of the values that a function reads, and those that it calls.
    void addFields(int function) {
        std::set<int> reached{function};
        std::vector<int> open{function};
        while (!open.empty()) {
            const auto& each = shader_.syntax.functions[static_cast<std::size_t>(open.back())];
            open.pop_back();
            for (const int called : each.calls) {
                if (reached.insert(called).second) {
                    open.push_back(called);
                }
            }
        }
        for (const ShaderExpression& each : shader_.syntax.expressions) {
            if (each.kind == CallKind::Field && reached.contains(each.owner) &&
                isOf(each.operands.front(), values_)) {
                made_.fields.insert(std::string(each.sign));
            }
        }
    }

    const ObservedShader& shader_;
    std::string values_;
    ParameterLayout layout_;
    std::string whose_;
    DirectionCall made_;
};

/// Writes the move of calls that have the same entries.
class CallTable {
  public:
    CallTable(const ObservedShader& shader, const Block& block,
              const std::vector<DirectionCall>& calls)
        : shader_(shader), block_(block), calls_(calls) {
        double low = 1.0;
        double high = -1.0;
        for (const DirectionCall& call : calls) {
            low = std::min(low, shader.valuesOf(call.cosine).min[0]);
            high = std::max(high, shader.valuesOf(call.cosine).max[0]);
        }
        axis_ = TableAxis::of("c", low, high);
    }

    bool isUsable() const { return axis_.isUsable(); }

    CheapMove move(TableSpread spread, std::size_t number) const {
        TableAxis axis = axis_;
        axis.spread = spread;
        const DirectionCall& first = calls_.front();
        const BlockTable table{fmt::format("found.table{}", number), {entriesOfLine, 1}, of()};
        const std::size_t size = shader_.at(first.expression).size;
        const std::string entry = fmt::format(
            "vec3 {}(vec2 u, {} p) {{\n{}    float c = {};\n    return vec3({}{});\n}}\n",
            entryFunction(block_, table), structName(block_), copied(first), axis.number("u.x"),
            first.entry,
            size == 1   ? ", 0.0, 0.0"
            : size == 2 ? ", 0.0"
                        : "");
        CheapMove made;
        for (const DirectionCall& call : calls_) {
            const ShaderExpression& each = shader_.at(call.expression);
            axis.variable = textOf(call.cosine);
            const std::string read =
                fmt::format("{}(vec2({}, 0.0), {}).{}", tableFunction(block_, table), axis.place(),
                            call.values, std::string_view("xyz").substr(0, size));
            made.edits.push_back({each.first, each.last, read, entry, each.owner,
                                  computedTable(block_, table), readingCode(block_, table)});
        }
        sortEdits(made.edits);
        made.words = words(axis);
        made.table = table;
        return made;
    }

  private:
    std::string copied(const DirectionCall& call) const {
        if (!call.givesValues) {
            return {};
        }
        std::string code = fmt::format("    {} q;\n", structName(block_));
        for (const std::string& field : call.fields) {
            code += fmt::format("    q.{0} = p.{0};\n", field);
        }
        return code;
    }

    std::string textOf(int index) const {
        return std::string(shader_.syntax.textOf(shader_.at(index)));
    }

    std::vector<std::string> of() const {
        std::vector<std::string> ids;
        const ParameterLayout layout = layoutOf(block_);
        for (const ParameterField& field : layout.fields) {
            if (field.parameter != nullptr && field.parameter->compiled != Compiled::Yes &&
                calls_.front().fields.contains(field.name)) {
                ids.push_back(field.parameter->id);
            }
        }
        return ids;
    }

    std::string words(const TableAxis& axis) const {
        std::string all;
        for (const DirectionCall& call : calls_) {
            all += fmt::format("{}`{}`", all.empty() ? "" : " and ",
                               shortCode(textOf(call.expression)));
        }
        return fmt::format("{} read from a table of {} numbers along the cosine{}", all,
                           entriesOfLine, axis.words());
    }

    const ObservedShader& shader_;
    const Block& block_;
    const std::vector<DirectionCall>& calls_;
    TableAxis axis_;
};

/// Tells whether a call does more than a look-up: it calls functions, roots or divisions.
bool isDear(const ObservedShader& shader, int function) {
    const ParsedFunction& called = shader.syntax.functions[static_cast<std::size_t>(function)];
    return !called.calls.empty() ||
           std::ranges::count_if(shader.syntax.expressions, [&](const ShaderExpression& each) {
               return each.owner == function &&
                      (each.kind == CallKind::Builtin || each.sign == "/");
           }) > 1;
}

} // namespace

std::vector<CheapMove> directionTables(const ObservedShader& shader, const Block& block,
                                       std::size_t first) {
    std::vector<CheapMove> moves;
    const BlockKind* kind = findKind(block.kind);
    if (kind == nullptr || !kind->hasTables) {
        return moves;
    }
    std::map<std::string, std::vector<DirectionCall>> calls; // by their entries
    for (const int index : changeableExpressions(shader)) {
        auto call = CallReader(shader, block).read(index);
        if (call && isDear(shader, shader.at(index).function)) {
            calls[call->entry].push_back(std::move(*call));
        }
    }
    for (const auto& [entry, alike] : calls) {
        const CallTable table(shader, block, alike);
        for (const TableSpread spread :
             {TableSpread::Even, TableSpread::Low, TableSpread::High, TableSpread::Faster}) {
            if (table.isUsable()) {
                moves.push_back(table.move(spread, first + moves.size()));
            }
        }
    }
    return moves;
}

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/tabled_terms.h"

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>

#include "catalog/block_kind.h"
#include "catalog/parameter_layout.h"
#include "catalog/table_source.h"
#include "measure/approximation/function_slice.h"
#include "measure/approximation/shader_price.h"
#include "measure/approximation/table_axis.h"
#include "measure/interpreter/shader_builtins.h"
#include "shading/program/block_source.h"

namespace patina {
namespace {

constexpr std::size_t maxTabledTerms = 12;
constexpr double costOfLoop = 8.0; ///< counts its rounds, as the driver guesses them
/// Are the least costs, in roots or divisions, that are worth a look-up by so many numbers.
constexpr std::array minCost{2.0, 3.0, 6.0};

/// Tells how much functions and expressions take, in roots or divisions.
class TermCost {
  public:
    explicit TermCost(const ObservedShader& shader) : shader_(shader) {
        for (std::size_t i = 0; i < shader.syntax.expressions.size(); ++i) {
            const ShaderExpression& each = shader.syntax.expressions[i];
            if (each.owner >= 0) {
                byOwner_[each.owner].push_back(static_cast<int>(i));
            }
        }
    }

    double of(int index) {
        double cost = alone(index);
        for (const int operand : shader_.at(index).operands) {
            cost += of(operand);
        }
        return cost;
    }

    double ofFunction(int function) {
        const auto [known, isNew] = functions_.emplace(function, 0.0); // 0 within itself
        if (!isNew) {
            return known->second;
        }
        double cost = 0.0;
        for (const int each : byOwner_[function]) {
            cost += alone(each);
        }
        const auto& called = shader_.syntax.functions[static_cast<std::size_t>(function)];
        return functions_[function] = cost * (hasLoop(called.body) ? costOfLoop : 1.0);
    }

    bool hasLoop(int statement) const {
        if (statement < 0) {
            return false;
        }
        const auto& each = shader_.syntax.statements[static_cast<std::size_t>(statement)];
        return each.kind == ShaderStatement::Kind::Loop ||
               std::ranges::any_of(each.statements, [this](int inner) { return hasLoop(inner); });
    }

    /// Returns what a statement takes, with what it contains.
    double ofStatement(int statement) {
        const auto& each = shader_.syntax.statements[static_cast<std::size_t>(statement)];
        double cost = (each.expression >= 0 ? of(each.expression) : 0.0) +
                      (each.step >= 0 ? of(each.step) : 0.0);
        for (const int inner : each.statements) {
            cost += ofStatement(inner);
        }
        return cost * (each.kind == ShaderStatement::Kind::Loop ? costOfLoop : 1.0);
    }

  private:
    double alone(int index) {
        const ShaderExpression& expression = shader_.at(index);
        if (expression.kind == NodeKindOf::Call) {
            return ofFunction(expression.function);
        }
        if (expression.kind == NodeKindOf::Builtin) {
            static constexpr std::array cheap{"abs",  "min", "max",   "clamp", "mix", "floor",
                                              "ceil", "dot", "fract", "sign",  "step"};
            const bool isCheap = std::ranges::find(cheap, expression.builtin->name) != cheap.end();
            const bool isTwo = expression.builtin->name == "pow";
            return isCheap ? 0.25 : (isTwo ? 2.0 : 1.0) * static_cast<double>(expression.size);
        }
        return expression.kind == NodeKindOf::Binary && expression.sign == "/" ? 1.0 : 0.1;
    }

    using NodeKindOf = ShaderExpression::Kind;
    const ObservedShader& shader_;
    std::map<int, std::vector<int>> byOwner_;
    std::map<int, double> functions_;
};

/// Is a term that a table may stand for.
struct TabledTerm {
    SlicedTerm slice;
    double cost = 0.0;
};

/// Finds the terms of a block that are worth a look-up.
class TabledTermFinder {
  public:
    TabledTermFinder(const ObservedShader& shader, const Block& block)
        : shader_(shader), block_(block), slicer_(shader.syntax, structName(block)), cost_(shader) {
    }

    std::vector<TabledTerm> run() {
        for (const int index : changeableExpressions(shader_)) {
            const ShaderExpression& expression = shader_.at(index);
            const bool isTerm = expression.type.isFloat() && expression.type.columns == 1 &&
                                expression.size <= 3 && !isWithoutWork(expression.kind) &&
                                !shader_.valuesOf(index).isConstant(expression.size);
            if (isTerm) {
                addAll(index);
            }
        }
        std::ranges::stable_sort(terms_, std::ranges::greater(), &TabledTerm::cost);
        if (terms_.size() > maxTabledTerms) {
            terms_.resize(maxTabledTerms);
        }
        return std::move(terms_);
    }

  private:
    static bool isWithoutWork(ShaderExpression::Kind kind) {
        using Kind = ShaderExpression::Kind;
        return kind == Kind::Literal || kind == Kind::Local || kind == Kind::Global ||
               kind == Kind::Field || kind == Kind::Assign || kind == Kind::Step;
    }

    void addAll(int index) {
        for (const TermLeaves leaves : {TermLeaves::Operands, TermLeaves::Near, TermLeaves::Far}) {
            if (auto slice = slicer_.slice(index, leaves)) {
                add(std::move(*slice));
            }
        }
    }

    void add(SlicedTerm slice) {
        const std::size_t numbers = slice.variables.size();
        if (numbers > 2 || !areKnown(slice)) {
            return;
        }
        double cost = cost_.of(slice.expression);
        for (const SlicedTerm::Variable& each : slice.variables) {
            cost -= cost_.of(each.expression);
        }
        for (const int statement : slice.removed) {
            cost += cost_.ofStatement(statement);
        }
        const auto isSame = [&slice](const TabledTerm& other) {
            return other.slice.expression == slice.expression && other.slice.entry == slice.entry;
        };
        if (cost >= minCost[numbers] && std::ranges::none_of(terms_, isSame)) {
            terms_.push_back({std::move(slice), cost});
        }
    }

    /// Tells whether the program that fills tables has all that the term reads.
    bool areKnown(const SlicedTerm& slice) const {
        const ParameterLayout layout = layoutOf(block_);
        return std::ranges::all_of(slice.fields, [&layout](const std::string& name) {
            return std::ranges::find(layout.fields, name, &ParameterField::name) !=
                   layout.fields.end();
        });
    }

    const ObservedShader& shader_;
    const Block& block_;
    FunctionSlicer slicer_;
    TermCost cost_;
    std::vector<TabledTerm> terms_;
};

/// Writes the moves of one term.
class TableMoves {
  public:
    TableMoves(const ObservedShader& shader, const Block& block, const TabledTerm& term)
        : shader_(shader), block_(block), term_(term) {
        const ParameterLayout layout = layoutOf(block);
        for (const ParameterField& field : layout.fields) {
            if (field.parameter != nullptr && field.parameter->compiled != Compiled::Yes &&
                term.slice.fields.contains(field.name)) {
                of_.push_back(field.parameter->id);
            }
        }
        for (const SlicedTerm::Variable& each : term.slice.variables) {
            const ObservedValues& range = shader.valuesOf(each.expression);
            axes_.push_back(TableAxis::of(each.text, range.min[0], range.max[0]));
        }
    }

    void addTo(std::vector<CheapMove>& moves) const {
        if (!std::ranges::all_of(axes_, &TableAxis::isUsable)) {
            return;
        }
        if (axes_.empty()) {
            moves.push_back(move({}, moves.size()));
            return;
        }
        for (const auto& [first, second] : spreads()) {
            std::vector<TableAxis> axes = axes_;
            axes.front().spread = first;
            if (axes.size() > 1) {
                axes.back().spread = second;
            } else if (first != second) {
                continue;
            }
            moves.push_back(move(axes, moves.size()));
        }
    }

  private:
    static constexpr std::array<std::pair<TableSpread, TableSpread>, 6> spreads() {
        return {{{TableSpread::Even, TableSpread::Even},
                 {TableSpread::Low, TableSpread::Low},
                 {TableSpread::High, TableSpread::High},
                 {TableSpread::Faster, TableSpread::Faster},
                 {TableSpread::Even, TableSpread::Faster},
                 {TableSpread::Faster, TableSpread::Even}}};
    }

    CheapMove move(const std::vector<TableAxis>& axes, std::size_t number) const {
        const SlicedTerm& slice = term_.slice;
        const ShaderExpression& expression = shader_.at(slice.expression);
        BlockTable table{fmt::format("found.table{}", number + 1), {2, 1}, of_};
        if (!axes.empty()) {
            table.size = axes.size() == 1 ? glm::ivec2{entriesOfLine, 1}
                                          : glm::ivec2{entriesOfPlane, entriesOfPlane};
        }
        const std::string read = fmt::format(
            "{}(vec2({}, {}), {}).{}", tableFunction(block_, table),
            axes.empty() ? "0.0" : axes[0].place(), axes.size() < 2 ? "0.0" : axes[1].place(),
            slice.parameters, std::string_view("xyz").substr(0, expression.size));
        CheapMove made;
        made.edits.push_back({expression.first, expression.last, read, entryCode(table, axes),
                              expression.owner, computedTable(block_, table),
                              readingCode(block_, table)});
        for (const auto& [first, last] : slice.removedText) {
            made.edits.push_back({first, last, {}, {}, expression.owner});
        }
        std::ranges::sort(made.edits, {}, &ShaderEdit::first);
        made.words = words(axes);
        made.table = std::move(table);
        return made;
    }

    std::string entryCode(const BlockTable& table, const std::vector<TableAxis>& axes) const {
        const SlicedTerm& slice = term_.slice;
        std::string code = fmt::format("vec3 {}(vec2 {}, {} p) {{\n", entryFunction(block_, table),
                                       slice.place, structName(block_));
        for (std::size_t i = 0; i < axes.size(); ++i) {
            code += fmt::format("    float {} = {};\n", slice.variables[i].name,
                                axes[i].number(slice.place + (i == 0 ? ".x" : ".y")));
        }
        code += slice.entry;
        const std::size_t size = shader_.at(slice.expression).size;
        return code + fmt::format("    return vec3({}{});\n}}\n", slice.term,
                                  size == 1   ? ", 0.0, 0.0"
                                  : size == 2 ? ", 0.0"
                                              : "");
    }

    std::string words(const std::vector<TableAxis>& axes) const {
        const std::string term =
            shortCode(shader_.syntax.textOf(shader_.at(term_.slice.expression)));
        if (axes.empty()) {
            return fmt::format("`{}` computed once for all pixels", term);
        }
        std::string text = fmt::format("`{}` read from a table of ", term);
        text += axes.size() == 1 ? fmt::format("{} numbers", entriesOfLine)
                                 : fmt::format("{} x {} numbers", entriesOfPlane, entriesOfPlane);
        for (const TableAxis& axis : axes) {
            text += fmt::format("{} along `{}`{}", &axis == axes.data() ? "" : ", and",
                                shortCode(axis.variable), axis.words());
        }
        return text;
    }

    const ObservedShader& shader_;
    const Block& block_;
    const TabledTerm& term_;
    std::vector<std::string> of_;
    std::vector<TableAxis> axes_;
};

} // namespace

std::vector<CheapMove> tabledTerms(const ObservedShader& shader, const Block& block) {
    const BlockKind* kind = findKind(block.kind);
    std::vector<CheapMove> moves;
    if (kind == nullptr || !kind->hasTables) { // nothing would read its tables
        return moves;
    }
    for (const TabledTerm& term : TabledTermFinder(shader, block).run()) {
        TableMoves(shader, block, term).addTo(moves);
    }
    return moves;
}

} // namespace patina

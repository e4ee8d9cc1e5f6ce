// SPDX-License-Identifier: GPL-3.0-or-later
// Cheaper ways to compute a term, of small texts that are evaluated on the CPU.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "catalog/block_kind.h"
#include "measure/approximation/approximated_block.h"
#include "measure/approximation/cheap_moves.h"
#include "measure/approximation/direction_tables.h"
#include "measure/approximation/geometry_moves.h"
#include "measure/approximation/measured_text.h"
#include "measure/approximation/tabled_terms.h"
#include "measure/approximation/tidied_text.h"
#include "measure/approximation/written_block.h"
#include "measure/interpreter/shader_parser.h"
#include "measure/stability/sweep_cases.h"
#include "support/program.h"

namespace patina::tests::cheap_moves_test {
namespace {

/// Is a text whose function f was evaluated where its first two numbers are 0 .. 1, as far as it
/// has them, and all others are 0.5 or 0.6.
class Observed {
  public:
    explicit Observed(std::string text) : source_{std::move(text), {"generated"}, {}} {
        syntax_ = parsedShader(source_, "f").value();
        for (std::size_t i = 0; i < syntax_.functions.size(); ++i) {
            functions_.insert(static_cast<int>(i));
        }
        ShaderEvaluator evaluator(syntax_, ShaderPrecision::Double);
        evaluator.observe(&values_);
        for (int i = 0; i <= 400; ++i) {
            evaluate(evaluator, syntax_, (i % 21) / 20.0, (i / 21) / 20.0, i % 2 ? 0.5 : 0.6);
        }
    }

    ObservedShader shader() const { return {syntax_, values_, functions_}; }

    double exact(double x, double y) const {
        ShaderEvaluator evaluator(syntax_, ShaderPrecision::Double);
        return evaluate(evaluator, syntax_, x, y);
    }

    /// Returns what the text with a move gives; NaN where that does not parse.
    double with(const CheapMove& move, double x, double y = 0.5) const {
        const ShaderSource edited = editedSource(source_, syntax_, move.edits);
        const auto syntax = parsedShader(edited, "f");
        if (!syntax) {
            ADD_FAILURE() << syntax.error().text() << edited.text;
            return NAN;
        }
        ShaderEvaluator evaluator(*syntax, ShaderPrecision::Double);
        return evaluate(evaluator, *syntax, x, y);
    }

    std::string textWith(const CheapMove& move) const {
        return editedSource(source_, syntax_, move.edits).text;
    }

    std::string textWith(const CheapMove& first, const CheapMove& second) const {
        const CheapMove* const both[] = {&first, &second};
        return editedSource(source_, syntax_, editsOf(both)).text;
    }

  private:
    static double evaluate(ShaderEvaluator& evaluator, const ShaderSyntax& syntax, double x,
                           double y, double others = 0.5) {
        const int f = syntax.functionNamed("f");
        std::vector<double> numbers;
        for (const ShaderVariable& each : syntax.functions[static_cast<std::size_t>(f)].arguments) {
            numbers.push_back(numbers.empty() ? x : numbers.size() == 1 ? y : others);
            EXPECT_EQ(each.size, 1u);
        }
        double result = NAN;
        evaluator.call(f, numbers, {}, {&result, 1});
        return result;
    }

    ShaderSource source_;
    ShaderSyntax syntax_;
    std::vector<ObservedValues> values_;
    std::set<int> functions_;
};

const CheapMove* saying(const std::vector<CheapMove>& moves, std::string_view words) {
    const auto found = std::ranges::find_if(
        moves, [&](const CheapMove& move) { return move.words.find(words) != std::string::npos; });
    return found == moves.end() ? nullptr : &*found;
}

TEST(BranchMove, Branch_IsTakenAlwaysAndNever) {
    const Observed text("float f(float x) {\n    if (x > 0.5) {\n        return 2.0;\n    }\n"
                        "    return 3.0;\n}\n");
    const auto moves = droppedTerms(text.shader());
    const CheapMove* always = saying(moves, "as if `x > 0.5` always held");
    const CheapMove* never = saying(moves, "as if `x > 0.5` never held");
    ASSERT_TRUE(always != nullptr && never != nullptr);
    EXPECT_EQ(text.with(*always, 0.1), 2.0);
    EXPECT_EQ(text.with(*never, 0.9), 3.0);
}

TEST(BranchMove, SwapInABranch_ComesWithItsConditionAndWithoutIt) {
    const Observed text("float f(float x) {\n    float y = 0.0;\n    if (x > 0.25) {\n"
                        "        y = pow(x, 4.0);\n    }\n    return y;\n}\n");
    const auto moves = knownSwaps(text.shader());
    const CheapMove* unasked = saying(moves, "as the power of 4, as if `x > 0.25` always held");
    const auto asked = std::ranges::find_if(
        moves, [](const CheapMove& move) { return move.words.ends_with("as the power of 4"); });
    ASSERT_TRUE(unasked != nullptr && asked != moves.end());
    EXPECT_NEAR(text.with(*unasked, 0.2), std::pow(0.2, 4.0), 1e-12);
    EXPECT_EQ(text.with(*asked, 0.2), 0.0);
}

TEST(BranchMove, SwapBehindABranchThatReturns_ComesAsIfItNeverHeld) {
    const Observed text("float f(float x) {\n    if (x <= 0.25) {\n        return 0.0;\n    }\n"
                        "    return pow(x, 4.0);\n}\n");
    const auto moves = knownSwaps(text.shader());
    const CheapMove* unasked = saying(moves, "as the power of 4, as if `x <= 0.25` never held");
    ASSERT_NE(unasked, nullptr);
    EXPECT_NEAR(text.with(*unasked, 0.2), std::pow(0.2, 4.0), 1e-12);
}

TEST(BranchMove, SwapBehindABranchThatGoesOn_KeepsTheQuestion) {
    const Observed text("float f(float x) {\n    float y = 1.0;\n    if (x <= 0.25) {\n"
                        "        y = 2.0;\n    }\n    return y * pow(x, 4.0);\n}\n");
    for (const CheapMove& move : knownSwaps(text.shader())) {
        EXPECT_EQ(move.words.find("never held"), std::string::npos) << move.words;
    }
}

TEST(BranchMove, SwapInAnotherFunction_KeepsTheQuestion) {
    const Observed text("float g(float x) {\n    return pow(x, 4.0);\n}\n"
                        "float f(float x) {\n    if (x <= 0.25) {\n        return 0.0;\n    }\n"
                        "    return g(x);\n}\n");
    for (const CheapMove& move : knownSwaps(text.shader())) {
        EXPECT_EQ(move.edits.size(), 1u) << move.words;
    }
}

TEST(NestedMoves, PartThatASwapKeeps_IsChangedWithin) {
    const Observed text("float f(float x, float y) {\n    return pow(x * y, 4.0);\n}\n");
    const auto swaps = knownSwaps(text.shader());
    const auto drops = droppedTerms(text.shader());
    const CheapMove* products = saying(swaps, "as the power of 4");
    const CheapMove* alone = saying(drops, "`x` alone");
    ASSERT_TRUE(products != nullptr && alone != nullptr);
    ASSERT_TRUE(areCompatible(*products, *alone) && areCompatible(*alone, *products));
    const CheapMove* const both[] = {alone, products};
    const CheapMove together{editsOf(both), "together"};
    EXPECT_NEAR(text.with(together, 0.7, 0.3), std::pow(0.7, 4.0), 1e-12);
    EXPECT_EQ(text.textWith(*products, *alone), text.textWith(*alone, *products));
}

TEST(NestedMoves, PartThatIsLeftOut_IsNotChangedAsWell) {
    const Observed text("float f(float x, float y) {\n    return x + pow(y, 4.0);\n}\n");
    const auto swaps = knownSwaps(text.shader());
    const auto drops = droppedTerms(text.shader());
    const CheapMove* products = saying(swaps, "as the power of 4");
    const CheapMove* alone = saying(drops, "`x` alone");
    const CheapMove* other = saying(drops, "`pow(y, 4.0)` alone");
    ASSERT_TRUE(products != nullptr && alone != nullptr && other != nullptr);
    EXPECT_FALSE(areCompatible(*products, *alone)) << "nothing of it would be left";
    EXPECT_TRUE(areCompatible(*products, *other));
    EXPECT_FALSE(areCompatible(*alone, *other));
}

constexpr const char* geometry = "struct Directions {\n    float nl;\n    float nh;\n"
                                 "    float sin2l;\n    float sin2h;\n    float cos2h;\n"
                                 "    float HH;\n};\n"
                                 "Directions at(float x) {\n    Directions d;\n    d.nl = x;\n"
                                 "    d.nh = x;\n    d.sin2l = 1.0 - x * x;\n    d.HH = 3.0;\n"
                                 "    d.cos2h = 3.0 * x * x;\n    d.sin2h = 3.0 - d.cos2h;\n"
                                 "    return d;\n}\n";

TEST(GeometryMove, NumberThatIsReadTwice_ComesFromTheRoundedCosineInBoth) {
    const Observed text(std::string(geometry) + "float f(float x) {\n    Directions d = at(x);\n"
                                                "    return sqrt(d.sin2l) + d.sin2l;\n}\n");
    const auto moves = geometryMoves(text.shader());
    const CheapMove* sine = saying(moves, "squared sine of n and l");
    ASSERT_NE(sine, nullptr);
    EXPECT_EQ(sine->edits.size(), 2u);
    EXPECT_NEAR(text.with(*sine, 0.4), text.exact(0.4, 0.5), 1e-12);
    EXPECT_EQ(saying(moves, "n.h"), nullptr) << "it is not read";
}

TEST(GeometryMove, ShareOfTheSquaredSine_NeedsNoDivision) {
    const Observed text(std::string(geometry) + "float f(float x) {\n    Directions d = at(x);\n"
                                                "    return d.sin2h / (d.sin2h + d.cos2h);\n}\n");
    const auto moves = geometryMoves(text.shader());
    const CheapMove* share = saying(moves, "without a division");
    ASSERT_NE(share, nullptr);
    EXPECT_NEAR(text.with(*share, 0.4), 0.84, 1e-12);
    EXPECT_EQ(text.textWith(*share).find('/', text.textWith(*share).find("float f(")),
              std::string::npos);
}

Block wax() {
    Block block;
    block.kind = kinds::models;
    block.id = "wax";
    Parameter width;
    width.id = "width";
    width.type = ParameterType::Float;
    block.parameters.push_back(width);
    return block;
}

constexpr const char* waxStruct = "struct Wax {\n    float width;\n};\n";

/// The best of the moves that say this is at most so far off.
double smallestError(const Observed& text, const std::vector<CheapMove>& moves,
                     std::string_view words) {
    double best = INFINITY;
    for (const CheapMove& move : moves) {
        double worst = 0.0;
        for (int i = 0; i <= 20 && move.words.find(words) != std::string::npos; ++i) {
            const double x = 0.013 + 0.0487 * i;
            const double y = 1.0 - 0.9 * x * x;
            worst = std::max(worst, std::abs(text.with(move, x, y) - text.exact(x, y)));
        }
        best = worst > 0.0 ? std::min(best, worst) : best;
    }
    return best;
}

TEST(TabledTerm, LoopOfOneNumber_GoesIntoTheEntries) {
    const Observed text(std::string(waxStruct) +
                        "float f(float x, float y, Wax p) {\n    float sum = 0.0;\n#line 20\n"
                        "    for (int i = 1; i < 9; ++i) {\n"
                        "        sum += exp(-p.width * x * float(i)) / float(i);\n    }\n"
                        "    float scaled = 2.0 * sum;\n    return scaled * scaled + y;\n}\n");
    const auto moves = tabledTerms(text.shader(), wax());
    EXPECT_LT(smallestError(text, moves, "table of 256 numbers along `x`"), 5e-4);
    const CheapMove& best = moves.front();
    ASSERT_TRUE(best.table);
    EXPECT_EQ(best.table->of, std::vector<std::string>{"width"});
    const std::string edited = text.textWith(best);
    EXPECT_EQ(edited.find("for ("), edited.rfind("for (")) << "only the entries compute it:\n"
                                                           << edited;
}

TEST(TabledTerm, TermOfTwoNumbers_IsATableOfTwoAxes) {
    const Observed text(std::string(waxStruct) +
                        "float g(float x, float y, float w) {\n"
                        "    return exp(-w * x) * pow(y + 0.1, 1.7) / (1.0 + sqrt(x * y))"
                        " * cos(x - y);\n}\n"
                        "float f(float x, float y, Wax p) {\n    return g(x, y, p.width);\n}\n");
    const auto moves = tabledTerms(text.shader(), wax());
    EXPECT_LT(smallestError(text, moves, "table of 128 x 128 numbers along `x`, and along `y`"),
              1e-3);
}

TEST(TabledTerm, TermOfTheValues_IsComputedOnce) {
    const Observed text(std::string(waxStruct) +
                        "float f(float x, float y, Wax p) {\n"
                        "    float strength = pow(p.width, 2.2) / exp(p.width);\n"
                        "    return strength * x + y;\n}\n");
    const auto moves = tabledTerms(text.shader(), wax());
    const CheapMove* once = saying(moves, "computed once for all pixels");
    ASSERT_NE(once, nullptr);
    EXPECT_NEAR(text.with(*once, 0.3), text.exact(0.3, 0.5), 1e-12);
}

TEST(TabledTerm, VariableThatIsGivenTwoValues_IsRead) {
    const Observed text(std::string(waxStruct) +
                        "float f(float x, float y, Wax p) {\n    float s = x;\n"
                        "    if (x > y) {\n        s = y;\n    }\n"
                        "    return exp(-s) * pow(s + p.width, 3.3) / (s + 1.0) * cos(s)"
                        " * sqrt(s + 0.1) * sin(s + 1.0);\n}\n");
    const auto moves = tabledTerms(text.shader(), wax());
    EXPECT_LT(smallestError(text, moves, "numbers along `s`"), 1e-4);
    EXPECT_LT(smallestError(text, moves, "along `x`, and along `y`"), 0.05)
        << "or what leads to it";
}

TEST(TabledTerm, TermOfThreeNumbers_IsLeftOut) {
    const Observed text("struct Wax {\n    float width;\n};\n"
                        "float f(float x, float y, float z, Wax p) {\n"
                        "    return pow(exp(x) * p.width, sin(y) / cos(z) + x);\n}\n");
    for (const CheapMove& move : tabledTerms(text.shader(), wax())) {
        EXPECT_EQ(move.words.find("`pow("), std::string::npos) << move.words;
    }
}

TEST(TabledTerm, FunctionWithoutTheValues_HasNone) {
    const Observed text("float f(float x, float y) {\n"
                        "    return exp(-x) * pow(x, 3.3) / (x + 1.0) + y;\n}\n");
    EXPECT_TRUE(tabledTerms(text.shader(), wax()).empty());
    Block light = wax();
    light.kind = kinds::lights;
    const Observed lit(std::string(waxStruct) +
                       "float f(float x, float y, Wax p) {\n"
                       "    return exp(-x) * pow(x, 3.3) / (x + 1.0) + y * p.width;\n}\n");
    EXPECT_TRUE(tabledTerms(lit.shader(), light).empty()) << "lights have no tables";
    EXPECT_FALSE(tabledTerms(lit.shader(), wax()).empty());
}

constexpr const char* termOfADirection =
    "float bend(Wax p, float c, float s2) {\n"
    "    return exp(-p.width * c) * sqrt(0.1 + s2) + pow(c, 1.7);\n}\n";

TEST(DirectionTable, FunctionOfTwoDirections_IsReadFromOneTableOfOneNumber) {
    const Observed text(std::string(waxStruct) + geometry + termOfADirection +
                        "float f(float x, float y, Wax p) {\n    Directions d = at(x);\n"
                        "    Directions e = at(y);\n"
                        "    return bend(p, d.nl, d.sin2l) * bend(p, e.nl, e.sin2l);\n}\n");
    const auto moves = directionTables(text.shader(), wax(), 1);
    EXPECT_LT(smallestError(text, moves, "along the cosine"), 1e-3);
    ASSERT_FALSE(moves.empty());
    EXPECT_EQ(moves.front().edits.size(), 2u);
    EXPECT_EQ(moves.front().table->of, std::vector<std::string>{"width"});
    EXPECT_EQ(moves.front().table->size, (glm::ivec2{256, 1}));
}

TEST(DirectionTable, FunctionOfTwoCosines_IsLeftOut) {
    const Observed text(std::string(waxStruct) + geometry + termOfADirection +
                        "float f(float x, float y, Wax p) {\n    Directions d = at(x);\n"
                        "    Directions e = at(y);\n"
                        "    return bend(p, d.nl, e.sin2l) + bend(p, d.nh, d.sin2l);\n}\n");
    EXPECT_TRUE(directionTables(text.shader(), wax(), 1).empty());
}

/// Levels that a block's author declared are no ways that a search has found; that of Phong reaches
/// the library as an argument.
TEST(DroppedTerms, BranchOfADeclaredLevel_StaysAsItIs) {
    const std::filesystem::path shaders = PATINA_SOURCE_DIR "/shaders";
    const Catalog catalog = loadCatalog(std::vector<BlockRoot>{{shaders, true}});
    for (const auto& [model, condition] :
         {std::pair("strauss", "p.terms == "), std::pair("phong", "level == ")}) {
        const EvalCase exact =
            *sweepVariant(catalog, defaultMaterial(*catalog.find(kinds::models, model)));
        const auto text = MeasuredText::of(exact, shaders);
        ASSERT_TRUE(text) << patina::text(text.error());
        const auto values =
            text->observed(texelsOfCases(commonCases(exact, {.count = 20, .rows = 4})));
        const CompiledChoices choices(text->syntax(), *exact.block.block);
        ObservedShader shader{text->syntax(), values, text->ownFunctions()};
        EXPECT_NE(saying(droppedTerms(shader), condition), nullptr) << "it would be taken else";
        shader.choices = &choices;
        const auto dropped = droppedTerms(shader);
        EXPECT_EQ(saying(dropped, condition), nullptr) << saying(dropped, condition)->words;
        EXPECT_EQ(saying(knownSwaps(shader), condition), nullptr);
        EXPECT_FALSE(dropped.empty());
    }
}

/// Numbers in the place of values are put into functions whose values a table holds, too: its
/// entries stay those of the exact function, which stands before them.
TEST(FoundLevel, TableOfAFunctionThatIsChanged_HoldsTheExactOne) {
    const std::filesystem::path shaders = PATINA_SOURCE_DIR "/shaders";
    const Catalog catalog = loadCatalog(std::vector<BlockRoot>{{shaders, true}});
    const Block& strauss = *catalog.find(kinds::models, "strauss");
    const EvalCase exact = *sweepVariant(catalog, defaultMaterial(strauss));
    auto text = MeasuredText::of(exact, shaders);
    ASSERT_TRUE(text) << patina::text(text.error());
    CheaperWays ways;
    ways.text = std::make_shared<const MeasuredText>(std::move(*text));
    const auto values =
        ways.text->observed(texelsOfCases(commonCases(exact, {.count = 50, .hasOwnValues = true})));
    const ObservedShader shader{ways.text->syntax(), values, ways.text->ownFunctions()};
    const auto tables = directionTables(shader, strauss, 1);
    const auto folded = foldedValues(shader);
    ASSERT_FALSE(tables.empty());
    ASSERT_FALSE(folded.empty());
    const std::array moves{&tables.front(), &folded.front()};
    ways.ways.push_back({.edits = editsOf(moves), .words = {"Both"}, .table = moves[0]->table});

    const auto made = approximatedBlock(exact, ways, usualNaming(strauss));
    ASSERT_TRUE(made) << made.error().text();
    const TemporaryFolder folder;
    ASSERT_TRUE(writeApproximatedBlock(*made, folder / "models"));
    const Catalog with =
        loadCatalog(std::vector<BlockRoot>{{shaders, true}, {folder.path(), false}});
    EXPECT_EQ(with.errors, Errors()) << patina::text(with.errors);
    const Block* const cheaper = with.find(kinds::models, made->id);
    ASSERT_NE(cheaper, nullptr);
    EvalCase level = *sweepVariant(with, defaultMaterial(*cheaper));
    level.block.accuracy[made->choice] = foundLevelId(0);
    const auto found = MeasuredText::of(level, shaders);
    EXPECT_TRUE(found) << patina::text(found.error()) << made->glsl;
}

TEST(TabledTerm, TwoTables_AreNotReadTogether) {
    CheapMove first{{{0, 1, "a"}}, "a"};
    CheapMove second{{{2, 3, "b"}}, "b"};
    EXPECT_TRUE(areCompatible(first, second));
    first.table = BlockTable{"one", {2, 1}, {}};
    EXPECT_TRUE(areCompatible(first, second));
    second.table = BlockTable{"other", {2, 1}, {}};
    EXPECT_FALSE(areCompatible(first, second));
}

TEST(TidiedText, WhatDoesNothing_IsGoneAndTheValueIsTheSame) {
    const ShaderSource raw{"float f(float x, float y) {\n    (1.0);\n    float unused = x;\n"
                           "    if ((true)) {\n        return (1.0 * (x)) + 0.0;\n    }\n"
                           "    return y;\n}\n",
                           {"generated"},
                           {}};
    const ShaderSource tidied = tidiedSource(raw, "f", {"f"});
    EXPECT_EQ(tidied.text, "float f(float x, float y) {\n    return x;\n}\n");
    const ShaderSource broken{"float f(float x) { return x +; }\n", {"generated"}, {}};
    EXPECT_EQ(tidiedSource(broken, "f", {"f"}).text, broken.text);
}

TEST(TidiedText, CopiesAndUnusedArguments_AreGoneFromFunctionAndCalls) {
    const ShaderSource raw{"float g(float a, float b, float c) {\n    float copy = b;\n"
                           "    return copy * copy;\n}\n"
                           "float h(float x) {\n    return g(1.0, (x), x * 2.0);\n}\n"
                           "float f(float x, float y) {\n    return h(x) + g(y, g(x, y, x), x);\n"
                           "}\n",
                           {"generated"},
                           {}};
    EXPECT_EQ(tidiedSource(raw, "f", {"f", "g", "h"}).text,
              "float g(float b) {\n    return b * b;\n}\n"
              "float h(float x) {\n    return g(x);\n}\n"
              "float f(float x, float y) {\n    return h(x) + g(g(y));\n}\n");
    const std::string kept = tidiedSource(raw, "f", {"f", "g"}).text;
    EXPECT_NE(kept.find("float g(float a, float b, float c)"), std::string::npos)
        << "another function calls it:\n"
        << kept;
}

TEST(TidiedText, CopyOfWhatChanges_Stays) {
    const std::string text = "float f(float x, float y) {\n    float before = x;\n"
                             "    x = y * 2.0;\n    return before + x;\n}\n";
    EXPECT_EQ(tidiedSource({text, {"generated"}, {}}, "f", {"f"}).text, text);
}

} // namespace
} // namespace patina::tests::cheap_moves_test

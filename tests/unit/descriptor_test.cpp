// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>

#include <gtest/gtest.h>

#include "catalog_fixture.h"

namespace patina::descriptor_test {
namespace {

using nlohmann::json;
using tests::BlockFolder;
using tests::plainDescriptor;

/// Everything that is wrong with a descriptor whose first parameter is changed.
class Mistakes : public testing::Test {
  protected:
    std::string of(const json& descriptor) {
        folder_.add("models", descriptor);
        std::string messages = text(folder_.load().errors);
        const std::string folder = folder_.root().string() + "/models/";
        for (auto at = messages.find(folder); at != std::string::npos; at = messages.find(folder)) {
            messages.erase(at, folder.size());
        }
        return messages;
    }

    std::string ofParameter(const json& changes) {
        json descriptor = plainDescriptor("a");
        descriptor["parameters"][0].merge_patch(changes);
        return of(descriptor);
    }

    /// The same without file, line and column.
    std::string problem(const json& changes) {
        const std::string message = ofParameter(changes);
        const auto at = message.find(": ");
        return at == std::string::npos ? message : message.substr(at + 2);
    }

    BlockFolder folder_;
};

TEST_F(Mistakes, PlainDescriptor_HasNone) {
    EXPECT_EQ(of(plainDescriptor("a")), "");
}

TEST_F(Mistakes, SeveralInOneFile_AreAllReported) {
    folder_.addText("models", "a", R"({
  "id": "b",
  "version": "one",
  "label": "A",
  "parameters": [
    {"id": "x", "label": "X", "type": "float", "default": 5},
    {"id": "y", "label": "Y", "type": "flaot", "default": 1, "colour": 1}
  ]
})");
    const std::string file = folder_.file("models", "a").string();
    EXPECT_EQ(text(folder_.load().errors),
              file + ":2:9: the id \"b\" is not the file's name; expected \"a\"\n" + file +
                  ":3:14: \"one\" is not allowed here; expected a whole number from 1; raise it "
                  "when old values mean something else\n" +
                  file + ":6:59: the default is outside the hard range; expected 0 to 1\n" + file +
                  ":7:39: \"flaot\" is not allowed here; expected one of float, int, bool, "
                  "color, vec2, vec3, angle, enum, texture, measured, curve, ramp\n" +
                  file +
                  ":7:72: the key \"colour\" is not known; expected one of advanced, "
                  "compiled, components, decimals, default, doc, emission, enabledWhen, group, "
                  "highlight, id, label, max, migrations, min, physical, role, scale, softMax, "
                  "softMin, space, step, texture, transparency, type, unit, values, zeroText\n");
}

/// One mistake per line from line 3 on; every one of them is another one.
constexpr const char* manyMistakes = R"({
  "id": "a", "label": "A",
  "version": 0,
  "labl": "A",
  "summary": 3,
  "claims": ["finite", "shiny"],
  "exemptions": {"finite": "It is claimed too."},
  "gates": ["light", "lihgt"],
  "slots": [{"kind": "fresnel", "default": "plain"},
    {"kind": "fresnel", "default": "other"}],
  "parameters": [
    {"id": "a b", "label": "A", "type": "float", "default": 0},
    {"id": "empty", "label": "", "type": "float", "default": 0},
    {"id": "typo", "label": "A", "type": "flaot", "default": 0},
    {"id": "far", "label": "A", "type": "float", "default": 5},
    {"id": "far", "label": "A", "type": "float", "default": 0},
    {"id": "word", "label": "A", "type": "float", "default": "five"},
    {"id": "while", "label": "A", "type": "float", "default": 0},
    {"id": "fresnel", "label": "A", "type": "float", "default": 0},
    {"id": "turned", "label": "A", "type": "float", "default": 0, "min": 2, "max": 1},
    {"id": "short", "label": "A", "type": "color", "default": [1, 2]},
    {"id": "half", "label": "A", "type": "int", "default": 1.5, "min": 0, "max": 3},
    {"id": "wide", "label": "A", "type": "int", "default": 0, "min": 0, "max": 3e9},
    {"id": "none", "label": "A", "type": "enum", "default": "x"},
    {"id": "log", "label": "A", "type": "float", "default": 0, "scale": "log"},
    {"id": "step", "label": "A", "type": "float", "default": 0, "step": 0},
    {"id": "when", "label": "A", "type": "float", "default": 0, "enabledWhen": "nosuch > 1"},
    {"id": "baked", "label": "A", "type": "float", "default": 0, "compiled": true},
    {"id": "where", "label": "A", "type": "float", "default": 0, "space": "worldPoint"},
    {"id": "warn", "label": "A", "type": "float", "default": 0, "physical": {"min": 2, "max": 1}},
    {"id": "old", "label": "A", "type": "float", "default": 0,
      "migrations": [{"from": "log", "until": 1}]},
    {"id": "soft", "label": "A", "type": "float", "default": 0, "softMin": -1}
  ]
})";

TEST_F(Mistakes, EveryKind_IsReportedAtItsLineInOneGo) {
    folder_.addText("models", "a", manyMistakes);
    std::set<int> lines;
    for (const Error& error : folder_.load().errors) {
        lines.insert(error.line);
        EXPECT_NE(error.expected, "") << error.text();
    }
    const std::set<int> expected{3,  4,  5,  6,  7,  8,  10, 12, 13, 14, 15, 16, 17, 18,
                                 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 32, 33};
    EXPECT_EQ(lines, expected) << text(folder_.load().errors);
}

TEST_F(Mistakes, IdThatMakesAWordOfGlsl_IsOne) {
    for (const char* id : {"float", "main", "for"}) {
        EXPECT_NE(of(plainDescriptor(id)).find("which is taken"), std::string::npos) << id;
    }
}

TEST_F(Mistakes, UnknownKey_SuggestsTheOneThatWasMeant) {
    EXPECT_EQ(problem({{"lable", "x"}}).substr(0, 50),
              "the key \"lable\" is not known; expected 'label', or");
}

TEST_F(Mistakes, SeveralUnknownKeys_AreAllReported) {
    const std::string messages = ofParameter({{"one", 1}, {"two", 2}});
    EXPECT_NE(messages.find("\"one\" is not known"), std::string::npos);
    EXPECT_NE(messages.find("\"two\" is not known"), std::string::npos);
}

TEST_F(Mistakes, MissingKey_IsNamed) {
    json descriptor = plainDescriptor("a");
    descriptor.erase("label");
    EXPECT_EQ(of(descriptor), "a.json:1:1: the key \"label\" is missing; expected the name the "
                              "user sees, as text\n");
}

TEST_F(Mistakes, SchemaKey_IsAllowed) {
    json descriptor = plainDescriptor("a");
    descriptor["$schema"] = "https://example.org/descriptor.schema.json";
    EXPECT_EQ(of(descriptor), "");
}

TEST_F(Mistakes, NotAnObject_IsOne) {
    folder_.addText("models", "a", "[]");
    EXPECT_NE(text(folder_.load().errors).find("a.json:1:1: "), std::string::npos);
}

TEST_F(Mistakes, MissingShader_IsOne) {
    tests::writeFile(folder_.file("models", "a"), plainDescriptor("a").dump());
    EXPECT_NE(text(folder_.load().errors)
                  .find("a.json:1:1: the block has no shader; expected a "
                        "file a.glsl beside this one"),
              std::string::npos);
}

TEST_F(Mistakes, DefaultOfTheWrongType_IsOne) {
    EXPECT_EQ(problem({{"default", "half"}}), "the text \"half\" stands here; expected a number\n");
}

TEST_F(Mistakes, DefaultOutsideTheHardRange_IsOne) {
    EXPECT_EQ(problem({{"min", 1}, {"max", 2}}),
              "the default is outside the hard range; expected 1 to 2\n");
}

TEST_F(Mistakes, PointAndStopOfADefault_AreNamedAtTheirPlaces) {
    folder_.addText("models", "a", R"({
  "id": "a", "version": 1, "label": "A",
  "parameters": [
    {"id": "x", "label": "X", "type": "curve", "default": {"points": [[0, 0],
       [0.5, 0], [0.5, 1]]}},
    {"id": "y", "label": "Y", "type": "ramp", "default": {"stops": [
       {"at": 0, "color": [2, 0, 0]}]}}
  ]
})");
    const std::string file = folder_.file("models", "a").string();
    const std::string messages = text(folder_.load().errors);
    for (const char* message : {":5:18: point 3 of the curve has x = 0.5 after 0.5",
                                ":7:8: stop 1 of the default is outside the hard range"}) {
        EXPECT_NE(messages.find(file + message), std::string::npos) << messages;
    }
}

TEST_F(Mistakes, SoftRangeOutsideTheHardRange_IsOne) {
    EXPECT_EQ(problem({{"softMax", 2}}), "the soft range is not inside the hard range; expected 0 "
                                         "<= softMin <= softMax <= 1\n");
}

TEST_F(Mistakes, RangeUpsideDown_IsOne) {
    EXPECT_EQ(problem({{"min", 2}, {"max", 1}}), "min is above max; expected a number up to 1\n");
}

TEST_F(Mistakes, WholeNumberWithoutARange_IsTwo) {
    EXPECT_EQ(ofParameter({{"type", "int"}, {"default", 1}}),
              "a.json:5:3: the key \"min\" is missing; expected a number\n"
              "a.json:5:3: the key \"max\" is missing; expected a number\n");
}

TEST_F(Mistakes, LogSliderFromZero_IsOne) {
    EXPECT_EQ(problem({{"scale", "log"}}),
              "a log slider cannot reach 0; expected a softMin above 0\n");
}

TEST_F(Mistakes, DefaultNotAmongTheChoices_IsOne) {
    EXPECT_EQ(
        problem({{"type", "enum"},
                 {"default", "c"},
                 {"values", {{{"id", "aa"}, {"label", "A"}}, {{"id", "bb"}, {"label", "B"}}}}}),
        "the text \"c\" stands here; expected one of aa, bb\n");
}

TEST_F(Mistakes, ChoiceTwice_IsOne) {
    EXPECT_EQ(problem({{"type", "enum"},
                       {"default", "a"},
                       {"values", {{{"id", "a"}, {"label", "A"}}, {{"id", "a"}, {"label", "B"}}}}}),
              "the id \"a\" occurs twice; expected each id once\n");
}

TEST_F(Mistakes, ChoicesOfANumber_AreOne) {
    EXPECT_EQ(problem({{"values", {{{"id", "a"}, {"label", "A"}}}}}),
              "only an enum has values; expected no such key\n");
}

TEST_F(Mistakes, CompiledNumber_IsOne) {
    EXPECT_EQ(problem({{"compiled", true}}), "only an enum or a bool can be compiled in; expected "
                                             "false, or \"whenZero\" for a float\n");
}

TEST_F(Mistakes, CompiledWhenZero_IsForFloats) {
    EXPECT_EQ(ofParameter({{"compiled", "whenZero"}}), "");
}

TEST_F(Mistakes, CompiledWhenEqualToNothing_IsOne) {
    EXPECT_EQ(problem({{"compiled", {{"whenEqual", "no.such"}}}}),
              "only two floats of a block can be the same; expected the id of another float\n");
}

TEST_F(Mistakes, SpaceOfANumber_IsOne) {
    EXPECT_EQ(problem({{"space", "worldPoint"}}),
              "only a vec3 lies in a space; expected no such key\n");
}

TEST_F(Mistakes, TransparencyOfWhatIsNoShare_IsOne) {
    EXPECT_EQ(problem({{"transparency", true}}), "");
    EXPECT_EQ(problem({{"transparency", true}, {"max", 2.0}}),
              "only a float from 0 to 1 can be a share that passes; expected no such key\n");
}

TEST_F(Mistakes, ShadowProjectionOfAModel_IsOne) {
    json descriptor = plainDescriptor("a");
    descriptor["shadowProjection"] = "none";
    EXPECT_EQ(of(descriptor), "");
    descriptor["shadowProjection"] = "parallel";
    EXPECT_NE(of(descriptor).find("only a light casts shadows"), std::string::npos);
    EXPECT_NE(of(descriptor).find("the light has no direction"), std::string::npos);
}

TEST_F(Mistakes, LightingOfWhatIsNoModel_IsOne) {
    json descriptor = plainDescriptor("a");
    descriptor["lighting"] = "key";
    EXPECT_EQ(of(descriptor), "");
    folder_.add("fog", descriptor);
    EXPECT_NE(text(folder_.load().errors).find("only a model is lit"), std::string::npos);
}

TEST_F(Mistakes, ConditionThatDoesNotParse_IsOne) {
    EXPECT_EQ(problem({{"enabledWhen", "gloss >"}}),
              "the expression ends here (column 8 of the text); expected a parameter, a number or "
              "a choice\n");
}

TEST_F(Mistakes, ConditionOverItself_IsOne) {
    EXPECT_EQ(problem({{"enabledWhen", "gloss > 0"}}),
              "'gloss' is no other parameter of this block; expected nothing here\n");
}

json withCondition(const std::string& condition) {
    json descriptor = plainDescriptor("a");
    descriptor["parameters"].push_back(
        {{"id", "lobe"},
         {"label", "Lobe"},
         {"type", "enum"},
         {"default", "wide"},
         {"values", {{{"id", "wide"}, {"label", "W"}}, {{"id", "narrow"}, {"label", "N"}}}}});
    descriptor["parameters"][0]["enabledWhen"] = condition;
    return descriptor;
}

TEST_F(Mistakes, ConditionOverASibling_HasNone) {
    EXPECT_EQ(of(withCondition("lobe == narrow")), "");
}

TEST_F(Mistakes, ConditionOverAMisspeltSibling_SuggestsIt) {
    EXPECT_NE(of(withCondition("lobes == narrow")).find("expected 'lobe'"), std::string::npos);
}

TEST_F(Mistakes, ConditionOverAMisspeltChoice_SuggestsIt) {
    EXPECT_NE(of(withCondition("lobe == narow")).find("expected 'narrow'"), std::string::npos);
}

TEST_F(Mistakes, ParameterTwice_IsOne) {
    json descriptor = plainDescriptor("a");
    descriptor["parameters"].push_back(descriptor["parameters"][0]);
    EXPECT_NE(of(descriptor).find("the id \"gloss\" occurs twice"), std::string::npos);
}

TEST_F(Mistakes, IdsThatMakeOneField_AreOne) {
    json descriptor = plainDescriptor("a");
    descriptor["parameters"].push_back(descriptor["parameters"][0]);
    descriptor["parameters"][0]["id"] = "gloss.x";
    descriptor["parameters"][1]["id"] = "glossX";
    EXPECT_NE(of(descriptor).find("another id also makes the field \"glossX\""), std::string::npos);
}

TEST_F(Mistakes, IdThatIsAWordOfGlsl_IsOne) {
    EXPECT_EQ(problem({{"id", "sample"}}),
              "\"sample\" is a word of GLSL or C++; expected another id\n");
}

json withLevels(bool first, bool second) {
    json descriptor = plainDescriptor("a");
    descriptor["accuracy"] = {{{"id", "lobe"},
                               {"label", "Lobe"},
                               {"values",
                                {{{"id", "one"}, {"label", "1"}, {"exact", first}},
                                 {{"id", "two"}, {"label", "2"}, {"exact", second}}}}}};
    return descriptor;
}

TEST_F(Mistakes, FirstLevelExact_HasNone) {
    EXPECT_EQ(of(withLevels(true, false)), "");
}

TEST_F(Mistakes, NoLevelExact_IsOne) {
    EXPECT_NE(of(withLevels(false, false)).find("the first level is not marked as exact"),
              std::string::npos);
}

TEST_F(Mistakes, TwoLevelsExact_AreOne) {
    EXPECT_NE(of(withLevels(true, true)).find("a level after the first is marked as exact"),
              std::string::npos);
}

TEST_F(Mistakes, ClaimWithAnExemption_IsOne) {
    json descriptor = plainDescriptor("a");
    descriptor["claims"] = {"finite"};
    descriptor["exemptions"] = {{"finite", "because"}};
    EXPECT_NE(of(descriptor).find("\"finite\" is also claimed"), std::string::npos);
}

TEST_F(Mistakes, SlotWithoutItsBlock_IsOne) {
    json descriptor = plainDescriptor("a");
    descriptor["slots"] = {{{"kind", "fresnel"}, {"default", "none"}}};
    EXPECT_NE(of(descriptor).find("there is no fresnel block \"none\""), std::string::npos);
}

TEST(DescriptorJson, OfABlock_IsADescriptorOfTheSameBlock) {
    BlockFolder folder;
    json descriptor = withLevels(true, false);
    descriptor["parameters"][0].merge_patch({{"scale", "log"},
                                             {"softMin", 0.1},
                                             {"physical", {{"min", 0}, {"max", 0.5}}},
                                             {"migrations", {{{"from", "old"}, {"until", 1}}}},
                                             {"texture", true}});
    folder.add("models", descriptor);
    const Catalog before = folder.load();
    ASSERT_EQ(before.blocks.size(), 1u) << text(before.errors);
    json again = toJson(before.blocks[0]);
    EXPECT_EQ(again["kind"], "models");
    again.erase("kind");
    folder.add("models", again);
    EXPECT_EQ(folder.load(), before);
}

/// A descriptor whose second parameter is shorthand for the first.
json shorthandDescriptor() {
    json descriptor = plainDescriptor("a");
    descriptor["parameters"].push_back(
        {{"id", "kind"},
         {"label", "Kind"},
         {"type", "enum"},
         {"default", "matt"},
         {"values",
          {{{"id", "matt"}, {"label", "Matt"}, {"fills", {{"gloss", 0.5}}}},
           {{"id", "shiny"}, {"label", "Shiny"}, {"fills", {{"gloss", 1.0}}}},
           {{"id", "custom"}, {"label", "Your own"}}}}});
    return descriptor;
}

TEST_F(Mistakes, ChoicesThatSetAnotherParameter_AreNone) {
    EXPECT_EQ(of(shorthandDescriptor()), "");
}

TEST_F(Mistakes, WhatAChoiceSets_IsAllChecked) {
    json descriptor = shorthandDescriptor();
    json& parameter = descriptor["parameters"][1];
    parameter["compiled"] = true;
    parameter["default"] = "shiny";
    parameter["values"][0]["fills"] = {{"gloss", "much"}, {"glos", 1.0}};
    parameter["values"][1]["fills"] = {{"gloss", 2.0}};
    const std::string messages = of(descriptor);
    for (const char* expected :
         {"'glos' is no other parameter of this block", "the value is outside the range of 'gloss'",
          "a choice that sets other parameters is in no shader",
          "another choice sets 'glos', this one does not",
          "the default choice sets values that are not the defaults"}) {
        EXPECT_NE(messages.find(expected), std::string::npos) << expected << "\n" << messages;
    }
}

TEST_F(Mistakes, WhatAChoiceSetsByTheWavelength_IsChecked) {
    json descriptor = shorthandDescriptor();
    descriptor["parameters"].push_back({{"id", "eta"},
                                        {"label", "Index"},
                                        {"type", "vec3"},
                                        {"default", {1.0, 1.0, 1.0}},
                                        {"min", 0.0},
                                        {"max", 10.0}});
    json& choices = descriptor["parameters"][1]["values"];
    const json even{{"nm", {400.0, 700.0}}, {"values", {1.0, 1.0}}};
    choices[0]["fills"]["eta"] = even;
    choices[1]["fills"]["eta"] = even;
    EXPECT_EQ(of(descriptor), "");
    choices[1]["fills"]["eta"]["nm"][1] = 300.0;
    EXPECT_NE(of(descriptor).find("the wavelengths do not rise"), std::string::npos);
    choices[1]["fills"]["gloss"] = even;
    EXPECT_NE(of(descriptor).find("expected a number"), std::string::npos) << of(descriptor);
}

TEST_F(Mistakes, NoChoiceForOnesOwnValues_IsFound) {
    json descriptor = shorthandDescriptor();
    descriptor["parameters"][1]["values"].erase(2);
    EXPECT_NE(of(descriptor).find("every choice sets other parameters"), std::string::npos);
}

} // namespace
} // namespace patina::descriptor_test

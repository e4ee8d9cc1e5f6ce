// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/approximated_block.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "catalog/function_source.h"
#include "catalog/json_text.h"
#include "catalog/parameter_layout.h"
#include "catalog/table_source.h"
#include "core/text.h"
#include "material/accuracy_text.h"
#include "measure/approximation/compiled_choices.h"
#include "measure/approximation/tidied_text.h"
#include "measure/interpreter/shader_parser.h"
#include "shading/glsl/glsl_declarations.h"
#include "shading/glsl/shader_file.h"
#include "shading/glsl/tokens.h"

namespace patina {
namespace {

constexpr const char* evaluatedFunction = "evaluated";
constexpr std::size_t casesOfChoices = 32;           ///< tell what compiled choices are
constexpr std::string_view foundPrefix = "cheaper."; ///< begins the id of a choice of found ways

constexpr double statedMargin = 1.25; ///< is how much more is stated than was measured
constexpr double minStated = 1e-7;    ///< is about the rounding of a float
/// Is the share of a level's error from which on it is said what floats lose in the exact way.
constexpr double notableShare = 0.1;
constexpr double roundingSlack = 1e-9;

/// Returns what the second digit of a number counts: 0.01 for 0.25.
double secondDigitOf(double number) {
    return std::pow(10.0, std::floor(std::log10(number) + roundingSlack) - 1.0);
}

/// Returns the names with the right letter first: "blinn-phong" -> "BlinnPhong".
std::string pascalCase(std::string_view id) {
    std::string name;
    bool isFirst = true;
    for (const char c : id) {
        if (c == '-') {
            isFirst = true;
            continue;
        }
        name += isFirst ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
        isFirst = false;
    }
    return name;
}

/// Returns a text with names replaced.
std::string renamed(std::string_view text, const std::map<std::string, std::string>& names) {
    const std::string code = withoutComments(text);
    std::string out;
    std::size_t done = 0;
    for (const GlslToken& token : opened(glslTokens(code))) {
        const auto found = names.find(std::string(token.text));
        if (found != names.end()) {
            const auto first = static_cast<std::size_t>(token.text.data() - code.data());
            out += text.substr(done, first - done);
            out += found->second;
            done = first + token.text.size();
        }
    }
    return out.append(text.substr(done));
}

/// Leaves out the lines that say where a text came from.
std::string withoutPlaces(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size() - 1);
        if (!text.starts_with("#line")) {
            out += text.substr(0, end + 1);
        }
        text.remove_prefix(end + 1);
    }
    return out;
}

/// Breaks words into lines of a comment.
std::string commented(std::string_view words) {
    constexpr std::size_t width = 96;
    std::string out = "//";
    std::size_t column = 2;
    while (!words.empty()) {
        const std::size_t end = std::min(words.find(' '), words.size());
        if (column + 1 + end > width) {
            out += "\n//";
            column = 2;
        }
        out += ' ';
        out += words.substr(0, end);
        column += 1 + end;
        words.remove_prefix(std::min(end + 1, words.size()));
    }
    return out + '\n';
}

/// Returns the tables that ways read and the block has not, each once.
std::vector<BlockTable> newTables(const CheaperWays& ways, const Block& block) {
    std::vector<BlockTable> tables;
    for (const CheaperWay& way : ways.ways) {
        if (way.table && block.table(way.table->id) == nullptr &&
            std::ranges::find(tables, *way.table) == tables.end()) {
            tables.push_back(*way.table);
        }
    }
    return tables;
}

/// Writes the GLSL of the levels.
class LevelWriter {
  public:
    LevelWriter(const EvalCase& subject, const CheaperWays& ways, std::string choiceField)
        : subject_(subject), ways_(ways), block_(*subject.block.block),
          syntax_(ways.text->syntax()), source_(ways.text->source()),
          main_(functionName(block_) + std::string(calledFunction(subject).suffix)),
          choiceField_(std::move(choiceField)), choices_(syntax_, block_),
          seen_(ways.text->observed(texelsOfCases(
              commonCases(subject, {.count = casesOfChoices, .hasOwnValues = true})))) {}

    /// Returns the block's text with the levels beside its function.
    std::string written(const std::string& glsl) const {
        const std::string code = withoutComments(glsl);
        const GlslTokens tokens = glslTokens(code);
        const std::vector<GlslFunction> functions = functionsIn(tokens);
        const auto main = std::ranges::find_if(
            functions, [this](const GlslFunction& f) { return f.name.text == main_; });
        if (main == functions.end()) {
            return glsl;
        }
        const auto name = static_cast<std::size_t>(main->name.text.data() - code.data());
        const std::size_t end = endOfBody(code, name);
        std::string out = glsl.substr(0, name) + main_ + "Exact" +
                          glsl.substr(name + main_.size(), end - name - main_.size());
        out += "\n\n";
        std::map<std::string, std::string> helpers;
        std::string levels;
        for (std::size_t i = 0; i < ways_.ways.size(); ++i) {
            Level made = level(i);
            helpers.merge(made.helpers);
            levels += made.code;
        }
        for (const auto& named : helpers) {
            out += named.second;
        }
        return out + levels + dispatcher(*main) + glsl.substr(std::min(end + 1, glsl.size()));
    }

  private:
    static std::size_t endOfBody(std::string_view code, std::size_t from) {
        int open = 0;
        for (std::size_t i = code.find('{', from); i < code.size(); ++i) {
            open += code[i] == '{' ? 1 : code[i] == '}' ? -1 : 0;
            if (open == 0) {
                return i + 1;
            }
        }
        return code.size();
    }

    /// Tells whether a function is edited, or calls one that is.
    bool isChanged(int function, const std::set<int>& edited) const {
        if (!ways_.text->ownFunctions().contains(function)) {
            return false;
        }
        return edited.contains(function) ||
               std::ranges::any_of(syntax_.functions[static_cast<std::size_t>(function)].calls,
                                   [&](int called) { return isChanged(called, edited); });
    }

    /// Returns the edits of a way, and those that put true and false in the place of what the
    /// program's choices decide: a level computes only what was searched.
    std::vector<ShaderEdit> decidedEdits(const CheaperWay& way,
                                         const std::set<int>& changed) const {
        std::vector<ShaderEdit> edits = way.edits;
        const auto add = [&edits](const ShaderEdit& edit) {
            if (std::ranges::none_of(edits, [&edit](const ShaderEdit& other) {
                    return edit.first <= other.first && other.last <= edit.last;
                })) {
                edits.push_back(edit);
            }
        };
        for (std::size_t i = syntax_.expressions.size(); i-- > 0;) { // a whole is behind its parts
            const ShaderExpression& each = syntax_.expressions[i];
            const bool isCondition = each.type == ShaderType{ShaderType::Base::Bool} &&
                                     each.kind != ShaderExpression::Kind::Literal &&
                                     each.first < each.last && changed.contains(each.owner);
            if (isCondition && seen_[i].count > 0 && choices_.isChoice(static_cast<int>(i))) {
                add({each.first,
                     each.last,
                     seen_[i].max[0] != 0.0 ? "true" : "false",
                     {},
                     each.owner});
            }
        }
        sortEdits(edits);
        return edits;
    }

    /// Is the text of a way: new functions that it calls, by name, and those of its level.
    struct Level {
        std::map<std::string, std::string> helpers;
        std::string code;
    };

    Level level(std::size_t index) const {
        const CheaperWay& way = ways_.ways[index];
        std::set<int> edited;
        for (const ShaderEdit& edit : way.edits) {
            edited.insert(edit.function);
        }
        std::set<int> changed;
        std::set<std::string> known; // functions that the block has without the way
        std::map<std::string, std::string> names;
        for (std::size_t i = 0; i < syntax_.functions.size(); ++i) {
            const std::string name(syntax_.functions[i].name);
            known.insert(name);
            if (isChanged(static_cast<int>(i), edited)) {
                changed.insert(static_cast<int>(i));
                names[name] = fmt::format("{}Found{}", name, index + 1);
            }
        }
        const ShaderSource raw = editedSource(source_, syntax_, decidedEdits(way, changed));
        Level exact; // the entries of tables that call what the way changes: of the exact functions
        std::set<std::string> written;
        if (const auto syntax = parsedShader(raw, evaluatedFunction)) {
            const std::set<std::string> called = calledFrom(*syntax, evaluatedFunction);
            for (const std::string& name : called) {
                if (names.contains(name) || !known.contains(name)) {
                    written.insert(name);
                }
            }
            for (const ShaderEdit& edit : way.edits) {
                const std::string entry = entryOf(edit);
                const std::set<std::string> needed = calledFrom(*syntax, entry);
                if (std::ranges::any_of(
                        needed, [&](const std::string& name) { return names.contains(name); })) {
                    exact.helpers[entry] = edit.helper + "\n";
                } else if (!entry.empty()) {
                    written.insert(entry);
                }
            }
        }
        for (const BlockTable& table : newTables(ways_, block_)) {
            written.erase(tableFunction(block_, table)); // the engine writes it
        }
        Level made = levelOf(tidiedSource(raw, evaluatedFunction, written), written, names,
                             foundLevelDoc(ways_, index));
        made.helpers.merge(exact.helpers);
        return made;
    }

    /// Returns the name of the function whose values a table holds that an edit reads; empty where
    /// it reads none.
    std::string entryOf(const ShaderEdit& edit) const {
        for (const BlockTable& table : newTables(ways_, block_)) {
            const std::string name = entryFunction(block_, table);
            if (!edit.tableRead.empty() &&
                edit.helper.find(' ' + name + '(') != std::string::npos) {
                return name;
            }
        }
        return {};
    }

    /// Returns the names of a function and of those that it calls, but for what only the entries of
    /// tables call: these are computed beforehand.
    std::set<std::string> calledFrom(const ShaderSyntax& syntax, std::string_view from) const {
        std::set<std::string> entries;
        for (const auto& tables : {block_.tables, newTables(ways_, block_)}) {
            for (const BlockTable& table : tables) {
                entries.insert(entryFunction(block_, table));
            }
        }
        std::set<std::string> called;
        std::vector<int> open{syntax.functionNamed(from)};
        while (!open.empty()) {
            const int function = open.back();
            open.pop_back();
            if (function < 0) {
                continue;
            }
            const ParsedFunction& each = syntax.functions[static_cast<std::size_t>(function)];
            const std::string name(each.name);
            if ((name == from || !entries.contains(name)) && called.insert(name).second) {
                open.insert(open.end(), each.calls.begin(), each.calls.end());
            }
        }
        return called;
    }

    /// Cuts the written functions out of a way's program, as far as it still calls them.
    static Level levelOf(const ShaderSource& source, const std::set<std::string>& written,
                         const std::map<std::string, std::string>& names, std::string_view doc) {
        Level made{{}, commented(doc)};
        const auto syntax = parsedShader(source, evaluatedFunction);
        std::vector<const ParsedFunction*> functions;
        for (std::size_t i = 0; syntax && i < syntax->functions.size(); ++i) {
            const ParsedFunction& function = syntax->functions[i];
            if (function.body >= 0 && written.contains(std::string(function.name))) {
                functions.push_back(&function);
            }
        }
        std::ranges::sort(functions, {}, &ParsedFunction::first);
        for (const ParsedFunction* function : functions) {
            const std::string raw =
                source.text.substr(function->first, function->last - function->first);
            const std::string text = renamed(withoutPlaces(raw), names);
            if (names.contains(std::string(function->name))) {
                made.code += text + "\n\n";
            } else {
                made.helpers[std::string(function->name)] = text + "\n\n";
            }
        }
        return made;
    }

    /// Returns the condition under which the search holds; empty where it always does.
    std::string condition() const {
        std::string all;
        const auto add = [&all](const std::string& one) {
            all += (all.empty() ? "" : "\n        && ") + one;
        };
        for (const ParameterField& field : layoutOf(block_).fields) {
            const std::string prefix =
                constantCase(structName(block_)) + '_' + constantCase(field.name) + '_';
            if (field.choice != nullptr) {
                const auto level = subject_.block.accuracy.find(field.choice->id);
                add(fmt::format("p.{} == {}{}", field.name, prefix,
                                constantCase(level == subject_.block.accuracy.end()
                                                 ? field.choice->values.front().id
                                                 : level->second)));
            } else if (field.parameter->compiled == Compiled::Yes) {
                addCompiled(field, prefix, add);
            }
        }
        return all;
    }

    template <class Add>
    void addCompiled(const ParameterField& field, const std::string& prefix, const Add& add) const {
        const auto given = subject_.block.values.find(field.parameter->id);
        const Value& value =
            given == subject_.block.values.end() ? field.parameter->defaultValue : given->second;
        if (const auto* word = std::get_if<std::string>(&value);
            word != nullptr && !field.parameter->values.empty()) {
            add(fmt::format("p.{} == {}{}", field.name, prefix, constantCase(*word)));
        } else if (const auto* flag = std::get_if<bool>(&value)) {
            add(fmt::format("{}p.{}", *flag ? "" : "!", field.name));
        } else if (const std::string plain = plainField(field); !plain.empty()) {
            add("p." + plain);
        }
    }

    std::string dispatcher(const GlslFunction& main) const {
        std::string arguments;
        std::string given;
        for (const GlslVariable& argument : main.arguments) {
            arguments +=
                fmt::format("{}{} {}", arguments.empty() ? "" : ", ", argument.type, argument.name);
            given += fmt::format("{}{}", given.empty() ? "" : ", ", argument.name);
        }
        const std::string values(main.arguments.empty() ? "p" : main.arguments.back().name);
        const std::string prefix =
            constantCase(structName(block_)) + '_' + constantCase(choiceField_) + '_';
        std::string out = fmt::format("{} {}({}) {{\n", main.result, main_, arguments);
        std::string searched = condition();
        if (!searched.empty()) {
            std::map<std::string, std::string> names{{"p", values}};
            out += fmt::format("    bool isSearched = {};\n", renamed(searched, names));
        }
        for (std::size_t i = 0; i < ways_.ways.size(); ++i) {
            out +=
                fmt::format("    if ({}{}.{} == {}{}) {{\n        return {}Found{}({});\n    }}\n",
                            searched.empty() ? "" : "isSearched && ", values, choiceField_, prefix,
                            constantCase(foundLevelId(i)), main_, i + 1, given);
        }
        return out + fmt::format("    return {}Exact({});\n}}\n", main_, given);
    }

    const EvalCase& subject_;
    const CheaperWays& ways_;
    const Block& block_;
    const ShaderSyntax& syntax_;
    const ShaderSource& source_;
    std::string main_;
    std::string choiceField_;
    CompiledChoices choices_;
    std::vector<ObservedValues> seen_; ///< are the values of expressions in a few cases
};

/// Maps the names of a block's own functions, struct and constants to those of a block with
/// another id.
std::map<std::string, std::string> ownNames(const Block& block, const Block& copy,
                                            std::string_view glsl) {
    const std::string from = structName(block);
    const std::string to = structName(copy);
    std::map<std::string, std::string> names{{from, to}};
    const std::string code = withoutComments(glsl);
    for (const GlslFunction& function : functionsIn(glslTokens(code))) {
        const std::string name(function.name.text);
        if (name.starts_with(functionName(block))) {
            names[name] = functionName(copy) + name.substr(functionName(block).size());
        }
    }
    for (std::size_t i = 0; i < block.tables.size(); ++i) { // their functions are not in the text
        names[tableFunction(block, block.tables[i])] = tableFunction(copy, copy.tables[i]);
    }
    for (const ParameterField& field : layoutOf(copy).fields) {
        const auto& values =
            field.parameter == nullptr ? field.choice->values : field.parameter->values;
        for (const EnumValue& value : values) {
            const std::string rest = '_' + constantCase(field.name) + '_' + constantCase(value.id);
            names[constantCase(from) + rest] = constantCase(to) + rest;
        }
        if (functionOf(field) != nullptr) {
            names[functionOfField(block, field.name)] = functionOfField(copy, field.name);
        }
    }
    return names;
}

nlohmann::json tableJson(const BlockTable& table) {
    nlohmann::json size{table.size.x};
    if (table.size.y > 1) {
        size.push_back(table.size.y);
    }
    return {{"id", table.id}, {"size", size}, {"of", table.of}};
}

nlohmann::json choiceJson(const CheaperWays& ways, const std::string& id, const Block& block) {
    std::string howTo = howToUseLevels(block);
    howTo = howTo.empty() ? howTo : ' ' + capitalised(howTo) + '.';
    nlohmann::json levels = nlohmann::json::array();
    levels.push_back({{"id", "exact"},
                      {"label", "Exact"},
                      {"doc", "As the block computes it."},
                      {"exact", true}});
    for (std::size_t i = 0; i < ways.ways.size(); ++i) {
        levels.push_back({{"id", foundLevelId(i)},
                          {"label", fmt::format("At most {:.2g} off", statedError(ways.ways[i]))},
                          {"doc", foundLevelDoc(ways, i)}});
        if (ways.ways[i].table) {
            levels.back()["table"] = ways.ways[i].table->id;
        }
    }
    return {{"id", id},
            {"label", "Cheaper ways"},
            {"doc", "Ways to compute it that were found by a search." + howTo},
            {"values", std::move(levels)}};
}

/// Returns "phong-cheaper" for 1 and "phong-cheaper-2" for 2, also for what has such a name
/// already.
BlockNaming numberedNaming(const Block& block, int number) {
    const std::string of = number == 1 ? "" : fmt::format("{}", number);
    return {fmt::format("{}-cheaper{}", block.id.substr(0, block.id.find("-cheaper")),
                        of.empty() ? of : '-' + of),
            fmt::format("{} (cheaper ways{})",
                        block.label.substr(0, block.label.find(" (cheaper ways")),
                        of.empty() ? of : ' ' + of)};
}

} // namespace

std::string wordsOf(const CheaperWay& way) {
    std::string text;
    for (const std::string& each : way.words) {
        text += (text.empty() ? "" : "; ") + each;
    }
    return text;
}

std::string foundChoiceId(const Block& block) {
    std::string name = pascalCase(block.id);
    name.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(name.front())));
    return std::string(foundPrefix) + name;
}

Errors whyNotSearched(const Block& block) {
    if (std::ranges::any_of(block.parameters, [](const Parameter& parameter) {
            return infoOf(parameter.type).isTable;
        })) {
        return oneError({block.descriptorFile.string(), 0, 0,
                         "it reads a file of measured numbers, and hardly computes anything: there "
                         "is no formula to search",
                         "a block that computes what it gives"});
    }
    const auto found = std::ranges::find_if(block.accuracy, [](const AccuracyChoice& choice) {
        return choice.id.starts_with(foundPrefix);
    });
    return found == block.accuracy.end()
               ? Errors()
               : oneError({block.descriptorFile.string(), 0, 0,
                           fmt::format("it has found ways already, \"{}\"", found->id),
                           "the block without them"});
}

std::string foundLevelId(std::size_t way) {
    return fmt::format("found-{}", way + 1);
}

double statedError(const CheaperWay& way) {
    const double error = std::max(statedMargin * way.error, minStated);
    const double digit = secondDigitOf(error);
    return std::ceil(error / digit - roundingSlack) * digit;
}

double greatestErrorStatedAs(double stated) {
    if (stated < minStated) {
        return 0.0;
    }
    const double digit = secondDigitOf(stated);
    return std::floor(stated / digit + roundingSlack) * digit / statedMargin;
}

std::string valuesInWords(const CheaperWays& ways) {
    return ways.isOfValues        ? ", with the values of its preset"
           : ways.sliders.empty() ? ", with any values"
                                  : ", with values that sliders reach: " + ways.sliders;
}

std::string foundLevelDoc(const CheaperWays& ways, std::size_t index) {
    const CheaperWay& way = ways.ways[index];
    const bool isOfFloats = ways.exact.error > notableShare * way.error;
    return fmt::format(
        "{}. At most {:.2g} off where white is 1{}, {:.2g} on the mean, for {}{}. {:.0f} in place "
        "of {:.0f} {} (predicted).",
        capitalised(wordsOf(way)), statedError(way),
        isOfFloats
            ? fmt::format(" (floats alone are up to {:.2g} off in the exact way)", ways.exact.error)
            : std::string(),
        way.meanError, ways.places,
        way.isForValues ? ", and for the values of its preset only" : valuesInWords(ways), way.cost,
        ways.exact.cost, ways.unit);
}

std::string howToUseLevels(const Block& block) {
    return hasChosenLevels(block.kind)
               ? std::string()
               : fmt::format(
                     "nothing chooses a level of a {}: to use one, let the block's function "
                     "return it in place of the exact way, in the GLSL file",
                     findKind(block.kind)->singular);
}

BlockNaming usualNaming(const Block& block) {
    return block.shipped ? numberedNaming(block, 1) : BlockNaming{block.id, block.label};
}

BlockNaming freeNaming(const Block& block, const Catalog& catalog,
                       const std::filesystem::path& folder) {
    for (int number = 1;; ++number) {
        BlockNaming naming = numberedNaming(block, number);
        std::error_code unknown; // what cannot be looked at is not there
        if (catalog.find(block.kind, naming.id) == nullptr &&
            !std::filesystem::exists(folder / (naming.id + ".glsl"), unknown) &&
            !std::filesystem::exists(folder / (naming.id + ".json"), unknown)) {
            return naming;
        }
    }
}

Result<ApproximatedBlock> approximatedBlock(const EvalCase& subject, const CheaperWays& ways,
                                            const BlockNaming& naming) {
    const Block& block = *subject.block.block;
    const auto glsl = readShaderFile(block.shaderFile);
    if (!glsl) {
        return tl::unexpected(glsl.error());
    }
    auto descriptor = readJson(block.descriptorFile);
    if (!descriptor) {
        return tl::unexpected(descriptor.error());
    }
    ApproximatedBlock made;
    made.choice = foundChoiceId(block);
    made.id = block.id;
    made.glsl = LevelWriter(subject, ways, fieldName(made.choice)).written(*glsl);
    made.descriptor = std::move(descriptor->value);
    made.descriptor["accuracy"].push_back(choiceJson(ways, made.choice, block));
    const std::vector<BlockTable> tables = newTables(ways, block);
    for (const BlockTable& table : tables) {
        made.descriptor["tables"].push_back(tableJson(table));
    }
    if (naming.id == block.id) {
        return made;
    }
    made.id = naming.id;
    Block copy = block;
    copy.id = made.id;
    AccuracyChoice choice{made.choice, {}, {}, {{"exact", {}, {}}}};
    for (std::size_t i = 0; i < ways.ways.size(); ++i) {
        choice.values.push_back({foundLevelId(i), {}, {}});
    }
    copy.accuracy.push_back(std::move(choice));
    Block read = block;
    read.tables.insert(read.tables.end(), tables.begin(), tables.end());
    copy.tables = read.tables;
    made.glsl = renamed(made.glsl, ownNames(read, copy, made.glsl));
    made.descriptor["id"] = made.id;
    made.descriptor["label"] = naming.label;
    made.descriptor.erase("formerIds");
    return made;
}

} // namespace patina

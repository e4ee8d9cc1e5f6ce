// SPDX-License-Identifier: GPL-3.0-or-later
// Proofs by machine of the errors that shaders and their descriptors state: Sollya bounds what a
// fit is off, Gappa what float adds. They read the shaders that ship: a line
//
//   // uses FILE FUNCTION [as NAME]; "OLD" is "NEW"; ...
//
// of a script makes a function of a shader known to it, with what is said of its text on the
// proof's interval replaced,
//
//   // uses FILE.json
//
// makes the metals of a descriptor known, and
//
//   // states FILE FILE ...: SENTENCE
//
// is an error unless each of the files has that sentence. Further lines of these are indented.
// Without the tools proofs are skipped; where PATINA_TOOLS_INSTALLED is set, as packaging/test does
// when it has installed what tests need, that is a failure.
#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <regex>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "catalog/catalog.h"
#include "catalog/fills.h"
#include "catalog/spectrum.h"
#include "support/program.h"

namespace patina::tests::proofs_test {
namespace {

namespace fs = std::filesystem;

fs::path proofsFolder() {
    return fs::path(PATINA_SOURCE_DIR) / "tests/proofs";
}

fs::path shaderFile(const std::string& name) {
    return fs::path(PATINA_SOURCE_DIR) / "shaders" / name;
}

/// Returns a text with one space where it has white space, and without the marks of comments.
std::string inOneLine(const std::string& text, bool keepsComments) {
    static const std::regex comment("//[^\n]*");
    static const std::regex mark("\n[ \t]*//[ \t]*");
    static const std::regex space("\\s+");
    const std::string bare =
        keepsComments ? std::regex_replace(text, mark, " ") : std::regex_replace(text, comment, "");
    return std::regex_replace(bare, space, " ");
}

/// Is a function of a shader as a proof needs it.
struct ShippedFunction {
    std::vector<std::string> arguments;
    /// Are the variables, in order, with what each is; the last one is what is returned.
    std::vector<std::pair<std::string, std::string>> lines;
};

/// Is one "uses" line of a script.
struct Use {
    std::string file;
    std::string function;
    std::string name;                  ///< is what the proof calls it
    std::vector<std::string> values{}; ///< are its arguments in a script of Gappa
    std::vector<std::pair<std::string, std::string>> replaced{};
};

std::optional<Use> useIn(const std::string& line) {
    static const std::regex form(
        R"(^(?://|#) uses (\S+) (\w+)(?:\(([^)]*)\))?(?: as (\w+))?(;.*)?$)");
    static const std::regex replacement("\"([^\"]*)\" is \"([^\"]*)\"");
    std::smatch found;
    if (!std::regex_match(line, found, form)) {
        return std::nullopt;
    }
    Use use{.file = found[1], .function = found[2], .name = found[4].matched ? found[4] : found[2]};
    std::istringstream values(found[3].str());
    for (std::string value; std::getline(values >> std::ws, value, ',');) {
        use.values.push_back(value);
    }
    const std::string rest = found[5];
    for (std::sregex_iterator at(rest.begin(), rest.end(), replacement), end; at != end; ++at) {
        use.replaced.emplace_back((*at)[1], (*at)[2]);
    }
    return use;
}

std::vector<std::string> argumentsOf(const std::string& list) {
    static const std::regex argument(R"((\w+) (\w+))");
    std::vector<std::string> names;
    for (std::sregex_iterator at(list.begin(), list.end(), argument), end; at != end; ++at) {
        const std::string type = (*at)[1];
        const std::string name = (*at)[2];
        if (type == "Incidence") {
            names.push_back(name + "_c");
            names.push_back(name + "_versine");
        } else {
            names.push_back(name);
        }
    }
    return names;
}

/// Writes out mix() as the GLSL specification has it: x (1 - a) + y a.
void writeOutMeans(std::string& text) {
    const std::string call = "mix(";
    for (std::size_t at = text.find(call); at != std::string::npos; at = text.find(call)) {
        std::vector<std::string> arguments(1);
        std::size_t end = at + call.size();
        for (int depth = 1; depth > 0; ++end) {
            depth += text.at(end) == '(' ? 1 : text[end] == ')' ? -1 : 0;
            if (depth == 1 && text[end] == ',') {
                arguments.emplace_back();
            } else if (depth > 0) {
                arguments.back() += text[end];
            }
        }
        text.replace(at, end - at,
                     fmt::format("(({0}) * (1.0 - ({2})) + ({1}) * ({2}))", arguments.at(0),
                                 arguments.at(1), arguments.at(2)));
    }
}

/// Reads a function of straight-line code whose numbers are floats, or colours of which each
/// channel is computed alike; throws what is wrong with it.
ShippedFunction shippedFunction(const Use& use) {
    const std::string text = inOneLine(readFile(shaderFile(use.file)), false);
    std::smatch head;
    if (!std::regex_search(text, head, std::regex("\\b(float|vec3) " + use.function + "\\("))) {
        throw std::runtime_error(use.file + " has no function " + use.function);
    }
    const auto first = static_cast<std::size_t>(head.position() + head.length());
    const std::size_t close = text.find(')', first);
    const std::size_t open = text.find('{', close);
    std::size_t last = open + 1;
    for (int depth = 1; depth > 0; ++last) {
        depth += text[last] == '{' ? 1 : text[last] == '}' ? -1 : 0;
    }
    std::string body = text.substr(open + 1, last - open - 2);
    for (const auto& [from, to] : use.replaced) {
        std::size_t at = body.find(from);
        if (at == std::string::npos) {
            throw std::runtime_error(use.function + " has no " + from);
        }
        for (; at != std::string::npos; at = body.find(from, at + to.size())) {
            body.replace(at, from.size(), to);
        }
    }
    writeOutMeans(body);
    static const std::regex field(R"(\b(i)\.(c|versine)\b)");
    body = std::regex_replace(body, field, "$1_$2");
    static const std::regex statement(R"(^\s*(?:(?:float|vec3) (\w+) =|return) (.*)$)");
    ShippedFunction function{argumentsOf(text.substr(first, close - first)), {}};
    std::istringstream statements(body);
    for (std::string part; std::getline(statements, part, ';');) {
        if (part.find_first_not_of(' ') == std::string::npos) {
            continue;
        }
        std::smatch found;
        if (!std::regex_match(part, found, statement)) {
            throw std::runtime_error(use.function + " is no straight line: " + part);
        }
        function.lines.emplace_back(found[1].matched ? found[1].str() : use.name, found[2].str());
    }
    return function;
}

/// Returns an expression with `rename` put around the names and `number` around the numbers.
std::string rewritten(const std::string& expression, const auto& rename, const auto& number) {
    static const std::regex word(R"([A-Za-z_]\w*|\d+\.?\d*(?:e[-+]?\d+)?)");
    std::string text;
    std::size_t at = 0;
    for (std::sregex_iterator found(expression.begin(), expression.end(), word), end; found != end;
         ++found) {
        const std::string token = found->str();
        text += expression.substr(at, static_cast<std::size_t>(found->position()) - at);
        text +=
            std::isdigit(static_cast<unsigned char>(token[0])) != 0 ? number(token) : rename(token);
        at = static_cast<std::size_t>(found->position()) + token.size();
    }
    return text + expression.substr(at);
}

std::string plain(const std::string& token) {
    return token;
}

/// Returns a procedure of Sollya.
std::string sollyaText(const Use& use) {
    const ShippedFunction function = shippedFunction(use);
    std::set<std::string> own(function.arguments.begin(), function.arguments.end());
    for (const auto& [name, expression] : function.lines) {
        own.insert(name);
    }
    const auto rename = [&own](const std::string& name) {
        return own.contains(name) ? "v_" + name : name;
    };
    std::string arguments;
    for (const std::string& name : function.arguments) {
        arguments += (arguments.empty() ? "" : ", ") + rename(name);
    }
    std::string variables;
    std::string text;
    for (const auto& [name, expression] : function.lines) {
        const std::string value = rewritten(expression, rename, plain);
        const bool isLast = &expression == &function.lines.back().second;
        variables += isLast ? "" : (variables.empty() ? "var " : ", ") + rename(name);
        text += isLast ? "return " + value + "; " : rename(name) + " = " + value + "; ";
    }
    return fmt::format("{} = proc({}) {{ {}{}}};\n", use.name, arguments,
                       variables.empty() ? "" : variables + "; ", text);
}

/// Returns definitions for Gappa: NAME with every operation and number rounded, and MNAME without.
std::string gappaText(const Use& use, std::set<std::string>& exact) {
    const ShippedFunction function = shippedFunction(use);
    const auto rename = [&](const std::string& name) {
        const auto at = std::find(function.arguments.begin(), function.arguments.end(), name);
        if (at != function.arguments.end()) {
            return use.values.at(static_cast<std::size_t>(at - function.arguments.begin()));
        }
        const bool isLocal = std::ranges::any_of(
            function.lines, [&](const auto& line) { return line.first == name; });
        return isLocal && name != use.name ? use.name + "_" + name : name;
    };
    std::string text;
    for (const auto& [variable, expression] : function.lines) {
        const std::string name = rename(variable);
        text += fmt::format(
            "{} rnd= {};\n", name,
            rewritten(expression, rename, [](const std::string& n) { return "rnd(" + n + ")"; }));
        text += fmt::format("M{} = {};\n", name,
                            rewritten(
                                expression,
                                [&](const std::string& n) {
                                    const std::string to = rename(n);
                                    return exact.contains(to) ? "M" + to : to;
                                },
                                plain));
        exact.insert(name);
    }
    return text;
}

/// Returns the metals of a descriptor, a number or a name per channel.
std::string metalsText(const fs::path& file) {
    const Catalog catalog =
        loadCatalog(std::vector<BlockRoot>{{fs::path(PATINA_SOURCE_DIR) / "shaders", true}});
    const Block* block = catalog.find(file.parent_path().string(), file.stem().string());
    if (block == nullptr) {
        throw std::runtime_error("there is no block of " + file.string());
    }
    std::string names;
    std::string eta;
    std::string k;
    const auto shorthand = std::ranges::find_if(block->parameters, isShorthand);
    for (const EnumValue& metal : shorthand->values) {
        for (int i = 0; !metal.fills.empty() && i < 3; ++i) {
            const auto channel = [&](const std::string& id) {
                return std::get<glm::dvec3>(atSrgbWavelengths(metal.fills.at(id)))[i];
            };
            const std::string comma = names.empty() ? "" : ", ";
            names += fmt::format("{}\"{}\"", comma, metal.id);
            eta += fmt::format("{}{}", comma, channel("eta"));
            k += fmt::format("{}{}", comma, channel("k"));
        }
    }
    return fmt::format("names = [|{}|];\neta = [|{}|];\nk = [|{}|];\n", names, eta, k);
}

/// Returns a script with what it uses in it; throws what is wrong with it.
std::string completed(const fs::path& script) {
    static const std::regex states(R"(^(?://|#) states ([^:]+): (.*)$)");
    static const std::regex metals(R"(^// uses (\S+\.json)$)");
    const bool isGappa = script.extension() == ".gappa";
    std::set<std::string> exact;
    static const std::regex continued("\n(?://|#)     +");
    std::istringstream lines(std::regex_replace(readFile(script), continued, " "));
    std::string text = isGappa ? "" : readFile(proofsFolder() / "bounds.sollya");
    for (std::string line; std::getline(lines, line);) {
        std::smatch found;
        if (const std::optional<Use> use = useIn(line)) {
            text += isGappa ? gappaText(*use, exact) : sollyaText(*use);
        } else if (std::regex_match(line, found, metals)) {
            text += metalsText(found[1].str());
        } else if (std::regex_match(line, found, states)) {
            std::istringstream files(found[1].str());
            for (std::string file; files >> file;) {
                const std::string shipped = inOneLine(readFile(shaderFile(file)), true);
                if (shipped.find(found[2].str()) == std::string::npos) {
                    throw std::runtime_error(file + " does not state: " + found[2].str());
                }
            }
        } else {
            text += line + '\n';
        }
    }
    return text;
}

std::optional<fs::path> installed(const std::string& program) {
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');) {
        if (fs::exists(fs::path(folder) / program)) {
            return fs::path(folder) / program;
        }
    }
    return std::nullopt;
}

Outcome outcomeOf(const fs::path& script, const std::string& text) {
    const std::string program = script.extension().string().substr(1);
    const TemporaryFolder folder;
    writeFile(folder / "script", text + (program == "sollya" ? "quit;\n" : ""));
    Start start;
    start.arguments = {(folder / "script").string()};
    start.timeLimitSeconds = 600.0; // the longest takes half a minute where nothing else runs
    return run(*installed(program), start);
}

bool isMissing(const fs::path& script) {
    return !installed(script.extension().string().substr(1));
}

/// Ends a test whose tool is missing.
void endWithoutTool() {
    constexpr const char* what = "no proof without it: apt-get install sollya gappa, or run "
                                 "./packaging/test, which installs them";
    if (std::getenv("PATINA_TOOLS_INSTALLED") != nullptr) {
        FAIL() << what;
    }
    GTEST_SKIP() << what;
}

class Proof : public testing::TestWithParam<fs::path> {};

TEST_P(Proof, HoldsForTheShadersThatShip) {
    if (isMissing(GetParam())) {
        return endWithoutTool();
    }
    const Outcome outcome = outcomeOf(GetParam(), completed(GetParam()));
    EXPECT_EQ(outcome.exitCode, 0) << outcome.out << outcome.err;
    EXPECT_EQ(outcome.out.find("not proved"), std::string::npos) << outcome.out;
    if (GetParam().extension() == ".sollya") {
        const std::string script = readFile(GetParam());
        static const std::regex claims("(^|\n)claim\\(");
        static const std::regex proofs("(^|\n)proved: ");
        const auto count = [](const std::string& text, const std::regex& what) {
            return std::distance(std::sregex_iterator(text.begin(), text.end(), what), {});
        };
        EXPECT_EQ(count(outcome.out, proofs), count(script, claims)) << outcome.out << outcome.err;
    }
}

std::vector<fs::path> scripts() {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(proofsFolder())) {
        const fs::path& path = entry.path();
        if ((path.extension() == ".sollya" && path.stem() != "bounds") ||
            path.extension() == ".gappa") {
            found.push_back(path);
        }
    }
    std::ranges::sort(found);
    return found;
}

INSTANTIATE_TEST_SUITE_P(, Proof, testing::ValuesIn(scripts()), [](const auto& test) {
    return test.param.stem().string() + '_' + test.param.extension().string().substr(1);
});

/// A proof must fail where a coefficient is one millionth off.
TEST(Proofs, OfAWrongCoefficient_Fail) {
    const std::vector<std::array<std::string, 3>> wrong{
        {"elementary.sollya", "0.9999999669", "0.9999989669"},
        {"fresnel.gappa", "rnd(5.55473)", "rnd(5.55474)"}};
    for (const auto& [name, from, to] : wrong) {
        const fs::path script = proofsFolder() / name;
        if (isMissing(script)) {
            return endWithoutTool();
        }
        std::string text = completed(script);
        const std::size_t at = text.find(from);
        ASSERT_NE(at, std::string::npos) << name;
        text.replace(at, from.size(), to);
        const std::size_t further = text.find("claim(\"acos2 of small angles");
        text.erase(std::min(further, text.size()));
        const Outcome outcome = outcomeOf(script, text);
        const bool isRefused = outcome.out.find("not proved: acos2") != std::string::npos;
        EXPECT_TRUE(script.extension() == ".gappa" ? outcome.exitCode == 1 : isRefused)
            << outcome.out << outcome.err;
    }
}

/// Runs a proof where no tool is in the path, and PATINA_TOOLS_INSTALLED is this; "": not set.
Outcome withoutTools(const std::string& toolsInstalled) {
    Start start;
    start.arguments = {"--gtest_filter=*horner_gappa"};
    start.environment = {{"PATH", "/nowhere"},
                         {"PATINA_TOOLS_INSTALLED", toolsInstalled},
                         {"GTEST_TOTAL_SHARDS", ""},
                         {"GTEST_SHARD_INDEX", ""}};
    return run(fs::read_symlink("/proc/self/exe"), start);
}

TEST(Proofs, WithoutTheirTools_AreSkippedUntilTheseWereInstalled) {
    const Outcome fresh = withoutTools("");
    EXPECT_EQ(fresh.exitCode, 0) << fresh.out;
    EXPECT_NE(fresh.out.find("apt-get install sollya gappa"), std::string::npos) << fresh.out;
    const Outcome installedOnce = withoutTools("1");
    EXPECT_EQ(installedOnce.exitCode, 1) << installedOnce.out;
}

} // namespace
} // namespace patina::tests::proofs_test

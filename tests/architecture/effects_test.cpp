// SPDX-License-Identifier: GPL-3.0-or-later
// An effect is a file and a row: what effects/ declares as one is in the list of all.
#include <regex>
#include <set>

#include <gtest/gtest.h>

#include "source_tree.h"

namespace patina::tests::effects_test {
namespace {

const std::string folder = "engine/shading/effects";

/// Returns what the lists of all effects name: those of surfaces and those of the display.
std::set<std::string> listed() {
    std::set<std::string> names;
    for (const auto& [file, list] : {std::pair{"effect_set.h", "using AllEffects"},
                                     std::pair{"display_set.h", "using AllDisplayEffects"}}) {
        const std::string text = readText(projectRoot() / folder / file);
        const std::size_t begin = text.find(list);
        const std::string rows = text.substr(begin, text.find(';', begin) - begin);
        static const std::regex row(R"(\b\w+Effect\b)");
        for (std::sregex_iterator it(rows.begin(), rows.end(), row), end; it != end; ++it) {
            names.insert(it->str());
        }
    }
    return names;
}

TEST(Effects, EveryEffect_HasARow) {
    const std::set<std::string> rows = listed();
    std::set<std::string> declared;
    static const std::regex effect(R"(\nstruct (\w+Effect) \{)");
    for (const SourceFile& file : filesUnder({folder}, {".h"})) {
        std::sregex_iterator it(file.text.begin(), file.text.end(), effect);
        for (const std::sregex_iterator end; it != end; ++it) {
            declared.insert((*it)[1]);
        }
    }
    EXPECT_EQ(declared, rows);
}

} // namespace
} // namespace patina::tests::effects_test

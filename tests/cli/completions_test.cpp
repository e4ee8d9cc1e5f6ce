// SPDX-License-Identifier: GPL-3.0-or-later
// `patina completions` prints what a shell completes with.
#include <gtest/gtest.h>

#include "cli/patina_program.h"

namespace patina::tests::completions_test {
namespace {

/// Returns what bash completes the last of these words to, with the script loaded.
std::string completed(const std::string& words) {
    const TemporaryFolder folder;
    writeFile(folder / "script", patina({"completions", "bash"}).out);
    const std::string line = ". '" + (folder / "script").string() + "'; COMP_WORDS=(" + words +
                             "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _patina; "
                             "echo \"${COMPREPLY[*]}\"";
    return run("/bin/bash", Start{.arguments = {"-c", line}, .environment = {}, .input = {}}).out;
}

TEST(Completions, Bash_CompletesCommandsAndTheirOptions) {
    EXPECT_EQ(completed("patina valid"), "validate\n");
    EXPECT_EQ(completed("patina render --turnt"), "--turntable\n");
    EXPECT_EQ(completed("patina validate --turnt"), "\n");
}

TEST(Completions, Fish_DescribesEachCommand) {
    const Outcome outcome = patina({"completions", "fish"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("-n __fish_use_subcommand -a render -d 'Draw"), std::string::npos)
        << outcome.out.substr(0, 400);
}

TEST(Completions, UnknownShell_SaysWhichAreKnown) {
    const Outcome outcome = patina({"completions", "csh"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("fish"), std::string::npos) << outcome.err;
}

} // namespace
} // namespace patina::tests::completions_test

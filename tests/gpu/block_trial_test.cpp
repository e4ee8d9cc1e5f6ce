// SPDX-License-Identifier: GPL-3.0-or-later
// A block tried alone, as the editor does with the user's when they come or change.
#include "shading/effects/block_trial.h"

#include <algorithm>
#include <set>

#include "gpu_fixture.h"
#include "shading/effects/neutral_values.h"
#include "shading/program/program_cache.h"
#include "support/program.h"

namespace patina::block_trial_test {
namespace {

using tests::readFile;
using tests::TemporaryFolder;
using tests::writeFile;

class BlockTrial : public GpuTest {
  protected:
    static Errors mistakesIn(const Block& block, const Catalog& catalog) {
        const Checked<ProgramSource> source = trialProgram(block, catalog);
        if (!source) {
            return source.error();
        }
        const auto program = compileProgram(*source);
        return program ? Errors() : program.error();
    }

    /// The first block of each kind.
    static std::vector<Block*> oneOfEach(Catalog& catalog) {
        std::vector<Block*> blocks;
        for (Block& block : catalog.blocks) {
            if (blocks.empty() || blocks.back()->kind != block.kind) {
                blocks.push_back(&block);
            }
        }
        return blocks;
    }
};

TEST_F(BlockTrial, ShippedBlocks_AreInTheirProgramsAndCompile) {
    for (const Block& block : catalog->blocks) {
        const auto source = trialProgram(block, *catalog);
        ASSERT_TRUE(source) << text(source.error());
        const std::string call = functionName(block) + "(";
        const std::string all = source->vertex.text + source->fragment.text +
                                (source->geometry ? source->geometry->text : std::string());
        EXPECT_NE(all.find(call), std::string::npos) << block.id;
        EXPECT_EQ(text(mistakesIn(block, *catalog)), "") << block.id;
    }
}

TEST_F(BlockTrial, BlockWhoseDefaultsDoNothing_IsInItsProgramAllTheSame) {
    Catalog changed = *catalog;
    std::set<std::string> kinds;
    for (Block& block : changed.blocks) {
        const Block shipped = block;
        for (Parameter& parameter : block.parameters) {
            if (std::holds_alternative<double>(parameter.defaultValue) && parameter.min <= 0.0) {
                parameter.defaultValue = 0.0;
            }
        }
        if (isNeutral(block, defaultValues(block)) && !findKind(block.kind)->needsSlot) {
            const auto source = trialProgram(block, changed);
            ASSERT_TRUE(source) << text(source.error());
            EXPECT_NE(source->fragment.text.find(functionName(block) + "("), std::string::npos)
                << block.id;
            kinds.insert(block.kind);
        }
        block = shipped;
    }
    EXPECT_GE(kinds.size(), 3u);
}

TEST_F(BlockTrial, SlipInAnyKindOfBlock_IsToldAtItsLine) {
    Catalog broken = *catalog;
    for (Block* block : oneOfEach(broken)) {
        const TemporaryFolder folder;
        const std::string glsl = readFile(block->shaderFile);
        const std::size_t body = glsl.find('{', glsl.find(functionName(*block) + "("));
        const Block sound = *block;
        block->shaderFile = folder / "tried.glsl";
        writeFile(block->shaderFile,
                  glsl.substr(0, body + 1) + " undeclared = 1.0;" + glsl.substr(body + 1));
        const Errors mistakes = mistakesIn(*block, broken);
        ASSERT_FALSE(mistakes.empty()) << block->kind;
        EXPECT_EQ(mistakes.front().file, block->shaderFile.string()) << block->kind;
        EXPECT_EQ(mistakes.front().line,
                  1 + std::count(glsl.begin(), glsl.begin() + std::ptrdiff_t(body), '\n'))
            << block->kind;
        *block = sound;
    }
}

} // namespace
} // namespace patina::block_trial_test

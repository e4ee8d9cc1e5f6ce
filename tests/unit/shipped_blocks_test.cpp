// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"

#include <map>
#include <regex>

#include <gtest/gtest.h>

namespace patina::shipped_blocks_test {
namespace {

Catalog shipped() {
    return loadCatalog(std::vector<BlockRoot>{{PATINA_SOURCE_DIR "/shaders", true}});
}

TEST(ShippedBlocks, Loaded_HaveNoMistakes) {
    EXPECT_EQ(text(shipped().errors), "");
}

TEST(ShippedBlocks, OfEveryKind_AreThere) {
    const Catalog catalog = shipped();
    for (const char* kind : {"models", "fresnel", "lights", "fog", "environment"}) {
        EXPECT_FALSE(catalog.ofKind(kind).empty()) << kind;
    }
}

TEST(ShippedBlocks, EveryParameter_HasATooltip) {
    for (const Block& block : shipped().blocks) {
        for (const Parameter& parameter : block.parameters) {
            EXPECT_FALSE(parameter.doc.empty()) << block.id << ' ' << parameter.id;
        }
    }
}

TEST(ShippedBlocks, EveryBlock_SaysWhatItIsAndWhereItIsFrom) {
    for (const Block& block : shipped().blocks) {
        EXPECT_FALSE(block.summary.empty() || block.source.empty() || block.applications.empty())
            << block.id;
    }
}

/// What keeps its size on the screen has another unit than what keeps its share of the picture.
TEST(ShippedBlocks, Lengths_OnThePictureAndOnTheScreenHaveUnitsOfTheirOwn) {
    int ofScreen = 0;
    int ofPicture = 0;
    for (const Block& block : shipped().blocks) {
        const bool isOverPicture = block.kind == kinds::pass || block.kind == kinds::strokes;
        for (const Parameter& parameter : block.parameters) {
            const bool isOnScreen =
                parameter.role == roles::screenLength ||
                (block.kind == kinds::outline && parameter.role == roles::width);
            EXPECT_EQ(parameter.unit == "px", isOnScreen) << block.id << ' ' << parameter.id;
            if (parameter.unit == "px") {
                ++ofScreen;
                EXPECT_NE(parameter.doc.find("ixels of the screen"), std::string::npos)
                    << block.id << ' ' << parameter.id;
            }
            if (parameter.unit == "px/512") {
                ++ofPicture;
                EXPECT_TRUE(isOverPicture) << block.id << ' ' << parameter.id;
                EXPECT_NE(parameter.doc.find("a picture that is 512"), std::string::npos)
                    << block.id << ' ' << parameter.id;
            }
        }
    }
    EXPECT_GE(ofScreen, 10);
    EXPECT_GE(ofPicture, 15);
}

TEST(ShippedBlocks, EveryGlow_MayOutshineAWhiteSurface) {
    int glows = 0;
    for (const Block& block : shipped().blocks) {
        for (const Parameter& parameter : block.parameters) {
            if (parameter.emission) {
                ++glows;
                EXPECT_GE(parameter.max, 100.0) << block.id;
                EXPECT_EQ(parameter.softMax, 1.0) << block.id;
            }
        }
    }
    EXPECT_GE(glows, 20);
}

TEST(ShippedBlocks, EveryAccuracyLevel_SaysWhatItIs) {
    for (const Block& block : shipped().blocks) {
        for (const AccuracyChoice& choice : block.accuracy) {
            EXPECT_GE(choice.values.size(), 2U) << block.id << ' ' << choice.id;
            EXPECT_FALSE(choice.doc.empty()) << block.id << ' ' << choice.id;
            for (const EnumValue& level : choice.values) {
                EXPECT_FALSE(level.label.empty() || level.doc.empty())
                    << block.id << ' ' << choice.id << ' ' << level.id;
            }
        }
    }
}

/// How long a level takes is another matter on each device: a tip names the one that was measured.
TEST(ShippedBlocks, AccuracyLevelThatPromisesTime_NamesTheDevice) {
    const std::regex promise("quick|fast|cheap|slow|of the (exact )?time|'s time|as long",
                             std::regex::icase);
    const std::regex device("llvmpipe|NVIDIA|AMD|Intel|Apple");
    for (const Block& block : shipped().blocks) {
        for (const AccuracyChoice& choice : block.accuracy) {
            for (const EnumValue& level : choice.values) {
                EXPECT_TRUE(!std::regex_search(level.doc, promise) ||
                            std::regex_search(level.doc, device))
                    << block.id << ' ' << choice.id << '=' << level.id << ": " << level.doc;
            }
        }
    }
}

/// Materials keep one level for each id, and lib/ counts on the order.
TEST(ShippedBlocks, AccuracyChoicesOfOneId_HaveTheSameLevels) {
    std::map<std::string, std::vector<std::string>> known;
    for (const Block& block : shipped().blocks) {
        for (const AccuracyChoice& choice : block.accuracy) {
            std::vector<std::string> levels;
            for (const EnumValue& level : choice.values) {
                levels.push_back(level.id);
            }
            EXPECT_EQ(known.emplace(choice.id, levels).first->second, levels)
                << block.id << ' ' << choice.id;
        }
    }
}

} // namespace
} // namespace patina::shipped_blocks_test

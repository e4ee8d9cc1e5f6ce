// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include "measure/approximation/cheaper_ways.h"

namespace patina {

/// Are the two files of a block with an accuracy choice whose levels are found ways.
struct ApproximatedBlock {
    std::string id;
    std::string glsl;
    nlohmann::json descriptor;

    /// Is the id of the choice.
    std::string choice;
};

/// Returns the id of the choice that a block gets, "cheaper.blinnPhong".
std::string foundChoiceId(const Block& block);

/// Returns why a block cannot be searched: it shows tables of measured surfaces, or it has ways
/// that were found already, under its own name or under that of the block that it is a copy of.
/// Empty where it can be.
Errors whyNotSearched(const Block& block);

/// Returns the id of the level of a way, "found-1" for the first.
std::string foundLevelId(std::size_t way);

/// Returns what the moves of a way do, one after the other.
std::string wordsOf(const CheaperWay& way);

/// Returns an error that holds for the way also where it was not measured: rounded up to two
/// digits, and a quarter more.
double statedError(const CheaperWay& way);

/// Returns the largest error of a way that is stated as `stated` at most.
double greatestErrorStatedAs(double stated);

/// Says with which values the errors of ways are what they are, behind which places: ", with the
/// values of its preset".
std::string valuesInWords(const CheaperWays& ways);

/// Returns what a level is, in plain words, with its error, what it is stated for, and its cost.
std::string foundLevelDoc(const CheaperWays& ways, std::size_t way);

/// Says what to do with the levels of a written block that nothing chooses (hasChosenLevels());
/// empty for other blocks.
std::string howToUseLevels(const Block& block);

/// Is what a written block is called.
struct BlockNaming {
    std::string id;
    std::string label;
};

/// Returns the block's own id and label, and for a block that ships others, because a user's block
/// may not have the id of another one: "phong-cheaper", "Phong (cheaper ways)".
BlockNaming usualNaming(const Block& block);

/// Returns an id and a label like those that no block of the catalogue has, and of whose id there
/// is no file in `folder`: "phong-cheaper", "phong-cheaper-2" ...
BlockNaming freeNaming(const Block& block, const Catalog& catalog,
                       const std::filesystem::path& folder);

/// Writes the block of a case with the ways that were found for it. The ways are functions beside
/// the block's own, which stays as it is under another name; what the program was not searched for,
/// such as another choice of a compiled enum, is computed exactly. With another id than the block's
/// all names that it shares with others get the new one. It is an error where a file of the block
/// cannot be read.
Result<ApproximatedBlock> approximatedBlock(const EvalCase& subject, const CheaperWays& ways,
                                            const BlockNaming& naming);

} // namespace patina

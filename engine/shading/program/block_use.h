// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <boost/container/small_vector.hpp>

#include "catalog/block.h"
#include "catalog/parameter_layout.h"

namespace patina {

/// Is a choice that is part of the program instead of its data. It points into the block.
struct CompiledValue {
    std::string_view id; ///< is the id of the parameter or the accuracy choice
    /// Is the id of the enum value or level; or "true", "false"; "zero", "nonzero"; "equal",
    /// "unequal".
    std::string_view value;

    friend bool operator==(const CompiledValue&, const CompiledValue&) = default;
};

/// Is a block in a program, with its compiled values. Copies allocate nothing unless it has more
/// compiled values than any block that ships.
class BlockUse {
  public:
    /// Keeps a pointer to the block, which must outlive it, but none to the values.
    BlockUse(const Block& block, const Values& values, const AccuracyLevels& levels = {});

    const Block& block() const { return *block_; }

    /// Returns the compiled parameters, then the accuracy choices, in the descriptor's order.
    std::vector<CompiledValue> compiled() const;

    /// Returns the chosen level of an accuracy choice of the block.
    const EnumValue& level(const AccuracyChoice& choice) const;

    /// Tells whether the program assumes that the parameter and its `equalTo` are equal everywhere.
    bool isEqual(const Parameter& parameter) const;

    /// Makes the program assume nothing about them; setExact chooses the exact level.
    void setUnequal(const Parameter& parameter);
    void setExact(const AccuracyChoice& choice);

    /// Lists the compiled states in the order of compiled(). For two uses of one block, equal
    /// states mean the same.
    using States = boost::container::small_vector<std::uint16_t, 16>;
    const States& states() const { return states_; }

    /// Orders by id, then by the words of what is compiled.
    static bool isBefore(const BlockUse& a, const BlockUse& b);

    friend bool operator==(const BlockUse&, const BlockUse&) = default;

  private:
    std::size_t placeOf(const Parameter& parameter) const;
    std::size_t placeOf(const AccuracyChoice& choice) const;

    const Block* block_;
    States states_;
};

} // namespace patina

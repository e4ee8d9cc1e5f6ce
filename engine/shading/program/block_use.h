// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <boost/container/small_vector.hpp>

#include "catalog/block.h"
#include "catalog/parameter_layout.h"

namespace patina {

/// A choice that is part of the program instead of its data. Points into the block.
struct CompiledValue {
    std::string_view id;    ///< of the parameter or the accuracy choice
    std::string_view value; ///< id of the enum value or level; "true", "false"; "zero", "nonzero";
                            ///< "equal", "unequal"

    friend bool operator==(const CompiledValue&, const CompiledValue&) = default;
};

/// A block that a program is made of, with what of its values is compiled. Copies of it allocate
/// nothing unless there is more of that than in any block that ships.
class BlockUse {
  public:
    /// Keeps a pointer to the block, and nothing of the values.
    BlockUse(const Block& block, const Values& values, const AccuracyLevels& levels = {});

    const Block& block() const { return *block_; }

    /// The compiled parameters, then the accuracy choices, in the descriptor's order.
    std::vector<CompiledValue> compiled() const;

    /// Returns the level of an accuracy choice of the block.
    const EnumValue& level(const AccuracyChoice& choice) const;

    /// Tells whether two compiled floats are taken to be the same everywhere.
    bool isEqual(const Parameter& parameter) const;

    /// Makes them differ; makes a level the exact one.
    void setUnequal(const Parameter& parameter);
    void setExact(const AccuracyChoice& choice);

    /// Compiled states by place: a state says the same of two uses of one block.
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

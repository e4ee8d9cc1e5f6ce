// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "document/json_clipboard.h"
#include "parameters/parameter_source.h"

namespace patina {

/// Names a block whose values are copied or pasted.
struct NamedBlock {
    std::string kind;
    std::string id;
    std::string label;
};

/// Returns the JSON of values of a block, with the images that lie on them: {"format", "version",
/// "kind", "block", "parameters", "textures"}.
nlohmann::json copiedValues(const NamedBlock& block, std::span<const Parameter* const> parameters,
                            const ParameterSource& source);

/// Tells whether a window of Patina may read all images that lie on the values.
bool mayReadAll(std::span<const Parameter* const> parameters, const ParameterSource& source);

/// Tells whether JSON says that it is values of a block.
bool areCopiedValues(const CopiedJson& copied);

/// Holds the edits that copied values make, and messages about what had to be left out.
struct PastedValues {
    ValueEdits edits;
    Errors problems;
};

/// Pastes onto one value whatever single value was copied, if it is of its type.
PastedValues pastedOnto(const Parameter& target, const CopiedJson& copied,
                        const ParameterSource& source);

/// Pastes onto those of a block's values that have the same ids; the block must be of the same
/// kind.
PastedValues pastedOnto(const NamedBlock& block, std::span<const Parameter* const> targets,
                        const CopiedJson& copied, const ParameterSource& source);

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "catalog/block_table.h"
#include "measure/interpreter/shader_syntax.h"
#include "shading/glsl/shader_source.h"

namespace patina {

/// Replaces a part of a shader's text.
struct ShaderEdit {
    std::size_t first = 0; ///< are the offsets in the text before all edits
    std::size_t last = 0;
    std::string replacement; ///< has parts that stay by keptPart(), so that other edits reach them
    std::string helper{};    ///< is a function that the replacement calls, with its name in front
    int function = -1;       ///< is that in which the place is
    /// Is the function that reads a table, whose entries `helper` computes: as it computes them on
    /// the spot, and as it reads a texture (table_source.h).
    std::string tableComputed{};
    std::string tableRead{};
};

/// Is one way to compute a part of a block more cheaply: edits that belong together.
struct CheapMove {
    std::vector<ShaderEdit> edits;
    std::string words;        ///< say what it does, as "exponential by a polynomial of degree 4"
    bool isForValues = false; ///< holds for the values of a preset only
    std::optional<BlockTable> table{}; ///< is one that it reads
    bool gainsBeside = false; ///< may gain only beside others, as what it saves is read twice
};

/// Returns what stands in a replacement for a part of the text before all edits, with the edits
/// that others make in it.
std::string keptPart(std::size_t first, std::size_t last);

/// Tells whether two moves can be made together: where both change the same text, one of them keeps
/// what the other changes, or leaves out some of it; and a level reads one table.
bool areCompatible(const CheapMove& a, const CheapMove& b);

/// Puts edits into the order of the text, a whole before its parts.
void sortEdits(std::vector<ShaderEdit>& edits);

/// Returns the edits of several moves, in the order of the text.
std::vector<ShaderEdit> editsOf(std::span<const CheapMove* const> moves);

/// Returns a stretch of a text, from offset `first` to before `last`, with the edits within it,
/// which are in the order of the text. Helpers are left out.
std::string editedPart(std::string_view text, std::size_t first, std::size_t last,
                       std::span<const ShaderEdit> edits);

/// Returns the source with edits. Their helpers, and the functions that read tables, precede the
/// functions that are edited.
ShaderSource editedSource(const ShaderSource& source, const ShaderSyntax& syntax,
                          std::span<const ShaderEdit> edits);

/// Returns a number as GLSL writes it, to the nearest float: "0.25", "-1.0", "1e-30".
std::string floatText(double x);

} // namespace patina

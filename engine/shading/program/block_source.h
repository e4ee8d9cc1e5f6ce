// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "catalog/block.h"
#include "shading/program/block_use.h"

namespace patina {

/// Writes `const int <BLOCK>_<FIELD>_<VALUE> = <index>;` for every enum value and accuracy level.
std::string constantsSource(const Block& block);

/// Writes the parameter struct: parameters, accuracy choices, then one field per slot of type
/// `<Kind>Slot`, named after the kind. After it follow the functions of curves and ramps, which
/// read `PARAMETER_DATA(i)`; those that `compiled` says to be plain read nothing.
std::string structSource(const Block& block, std::span<const CompiledValue> compiled = {});

/// Says which slot is filled, and how many vec4s the block in it takes.
struct SlotFill {
    std::string_view kind;
    int vec4s = 0;
};

/// Says how an unpack function is written.
struct UnpackRequest {
    std::string function;                      ///< is the function's name, such as "unpackModel"
    std::span<const CompiledValue> compiled{}; ///< are assigned from a #define instead of read
    std::span<const SlotFill> slots{};         ///< are the filled slots; the others stay empty
};

/// Writes `<Struct> <function>(int base)`. It reads `PARAMETER_DATA(i)`, a vec4, for i from 0; the
/// program defines that macro and may use `base` in it. The data of the blocks in the slots follow
/// the block's own, in the descriptor's order; slot structs come from `unpack<Kind>Slot(int base)`,
/// which must be declared before.
std::string unpackSource(const Block& block, const UnpackRequest& request);

/// Defines `PARAMETER_DATA`, so that the following unpack functions and functions of structs read
/// an array.
std::string unpackedFrom(std::string_view array);

/// Returns the number of vec4s that a block's own values take (without its slots).
int vec4Count(const Block& block);

/// Writes what replaces a block in an empty slot: a struct without values, and a call that is
/// black.
std::string emptySlotSource(std::string_view kind);

/// Defines the names by which a model knows the block that fills its slot.
std::string slotNamesSource(const Block& block);

/// Returns "FresnelSlot", or "slotFresnel", for the kind "fresnel".
std::string slotStructName(std::string_view kind);
std::string slotFunctionName(std::string_view kind);

} // namespace patina

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

/// The parameter struct: parameters, accuracy choices, then one field per slot of type
/// `<Kind>Slot`, named after the kind. Behind it the functions that curves and ramps are, which
/// read `PARAMETER_DATA(i)`; what `compiled` says to be plain reads nothing.
std::string structSource(const Block& block, std::span<const CompiledValue> compiled = {});

/// A slot that is filled, and the vec4s that the block in it takes.
struct SlotFill {
    std::string_view kind;
    int vec4s = 0;
};

/// Says how an unpack function is written.
struct UnpackRequest {
    std::string function;                      ///< its name, "unpackModel"
    std::span<const CompiledValue> compiled{}; ///< assigned from a #define instead of read
    std::span<const SlotFill> slots{};         ///< what fills the slots; the others stay empty
};

/// `<Struct> <function>(int base)`: reads `PARAMETER_DATA(i)`, a vec4, for i from 0; the program
/// defines that macro and may use `base` in it. The data of what fills the slots follow the
/// block's own, in the descriptor's order; slot structs come from `unpack<Kind>Slot(int base)`,
/// which must be declared before.
std::string unpackSource(const Block& block, const UnpackRequest& request);

/// Has unpack functions and what stands behind structs read an array from here on.
std::string unpackedFrom(std::string_view array);

/// The number of vec4s a block's own values take (without its slots).
int vec4Count(const Block& block);

/// Returns what stands for an empty slot: a struct without values, and a call that is black.
std::string emptySlotSource(std::string_view kind);

/// The names by which a model knows the block that fills its slot.
std::string slotNamesSource(const Block& block);

/// Makes "FresnelSlot" from the kind "fresnel", and "slotFresnel".
std::string slotStructName(std::string_view kind);
std::string slotFunctionName(std::string_view kind);

} // namespace patina

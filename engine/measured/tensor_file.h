// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace patina {

/// Is one array of a tensor file.
struct TensorField {
    enum class Type : std::uint8_t { Bytes, Floats, Other };
    Type type = Type::Floats;
    std::vector<std::size_t> shape; ///< slowest index first
    std::string bytes{};            ///< holds the numbers of an array of bytes
    std::vector<float> floats{};    ///< holds those of an array of floats, all finite
    std::size_t offset = 0;         ///< is the byte of the file where its numbers begin
    std::size_t typePlace = 0;      ///< is the byte that says its type
    int typeNumber = 0;             ///< is what that byte says
};

using TensorFields = std::map<std::string, TensorField, std::less<>>;

/// Tells by its first bytes whether a file is a tensor file.
bool isTensorFile(std::string_view bytes);

/// Returns what the format calls the numbers of an array: "float64".
std::string typeText(const TensorField& field);

/// Reads the arrays of bytes and of 32-bit floats of a tensor file; of others the numbers are left
/// out. Errors name the array and the byte.
Result<TensorFields> tensorFields(std::string_view bytes);

} // namespace patina

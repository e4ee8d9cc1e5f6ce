// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace patina {

/// Tells what an axis of a sheet goes through, in the order in which a cell takes it on: values
/// come last, since another model or light brings its own.
enum class AxisKind { Models, Environments, Lights, Accuracy, Value };

/// Holds numbers from one to another, both included: at even distances, or at even ratios where the
/// parameter's slider is logarithmic and both are above 0.
struct SheetRange {
    double from = 0.0;
    double to = 1.0;
    int steps = 2; ///< 1 .. maxSheetSteps

    friend bool operator==(const SheetRange&, const SheetRange&) = default;
};

/// Represents one axis of a sheet.
struct SheetAxis {
    AxisKind kind = AxisKind::Value;
    std::string value{};               ///< of AxisKind::Value: its id, as for --set
    std::optional<SheetRange> range{}; ///< of a value that is one number
    /// Are the steps where there is no range: values as they are typed for --set; ids of models;
    /// levels as levelsText() writes them, or "exact"; names of the scene's lights, each alone,
    /// "all", "none", or the id of a light in place of them; ids of environments, panoramas' files,
    /// "none". Empty: all that there are.
    std::vector<std::string> entries{};

    friend bool operator==(const SheetAxis&, const SheetAxis&) = default;
};

/// Tells what a cell may say beside its picture.
enum class CellNumber { Time, Error, Albedo };

/// Says what was measured of a cell; nothing: it was not, or cannot be.
struct CellNumbers {
    std::optional<double> milliseconds{}; ///< of a frame
    std::optional<double> error{};        ///< relative, which 99 of 100 pixels keep
    std::optional<double> albedo{};       ///< share of an even white sky's light that comes back

    friend bool operator==(const CellNumbers&, const CellNumbers&) = default;
};

inline constexpr int maxSheetSteps = 32;  ///< of an axis
inline constexpr int usualSheetSteps = 5; ///< of a number's axis that nobody gave a range
inline constexpr int minCellPixels = 16;  ///< of a side of a cell
inline constexpr int maxCellPixels = 1024;
inline constexpr double maxSheetPixels = double(1 << 25); ///< of all cells together

/// Represents a contact sheet: pictures of one object, whose axes are what varies. A value.
struct Sheet {
    std::string name{};
    std::string preset{}; ///< a full path of what it starts from; empty: whoever draws it knows
    SheetAxis x{};        ///< from left to right
    std::optional<SheetAxis> y{}; ///< from top to bottom
    bool hasControlRow = true;    ///< a last row shows what the sheet starts from
    int cellPixels = 128;         ///< of a side of a cell
    std::vector<CellNumber> numbers{};
    nlohmann::json unknown = nlohmann::json::object(); ///< keys the reader did not know

    friend bool operator==(const Sheet&, const Sheet&) = default;
};

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace patina {

/// Tells what an axis of a sheet goes through, in the order in which a cell applies its axes:
/// values come last, since another model or light brings its own.
enum class AxisKind { Models, Environments, Lights, Accuracy, Value };

/// Describes numbers from one to another, both included. They lie at even distances, or at even
/// ratios where the parameter's slider is logarithmic and both ends are above 0.
struct SheetRange {
    double from = 0.0;
    double to = 1.0;
    int steps = 2; ///< 1 .. maxSheetSteps

    friend bool operator==(const SheetRange&, const SheetRange&) = default;
};

/// Says what varies along one axis of a sheet, and in which steps.
struct SheetAxis {
    AxisKind kind = AxisKind::Value;
    std::string value{};               ///< is the id as for --set; empty for other kinds
    std::optional<SheetRange> range{}; ///< is only for a value that is one number
    /// Holds the steps where there is no range: values as they are typed for --set; ids of models;
    /// levels as levelsText() writes them, or "exact"; names of the scene's lights, each alone,
    /// "all", "none", or the id of a light in place of them; ids of environments, panoramas' files,
    /// "none". Where it is empty, the axis goes through all that there are.
    std::vector<std::string> entries{};

    friend bool operator==(const SheetAxis&, const SheetAxis&) = default;
};

/// Tells which numbers a cell may show below its picture.
enum class CellNumber { Time, Error, Albedo };

/// Holds what was measured for a cell. A member is empty where it was not or cannot be measured.
struct CellNumbers {
    std::optional<double> milliseconds{}; ///< is the time of one frame
    std::optional<double> error{};        ///< is the relative error that 99 of 100 pixels keep
    std::optional<double> albedo{}; ///< is the share of a uniform white sky's light that comes back

    friend bool operator==(const CellNumbers&, const CellNumbers&) = default;
};

inline constexpr int maxSheetSteps = 32;  ///< limits one axis
inline constexpr int usualSheetSteps = 5; ///< is for a number without a given range
inline constexpr int minCellPixels = 16;  ///< limits a cell's side, as the next one
inline constexpr int maxCellPixels = 1024;
inline constexpr double maxSheetPixels = double(1 << 25); ///< limits all cells together

/// Describes a contact sheet: pictures of one object in columns and rows, along which something
/// varies. It is a value.
struct Sheet {
    std::string name{};
    std::string preset{};         ///< is the full path of the start; empty where the caller has it
    SheetAxis x{};                ///< varies from left to right
    std::optional<SheetAxis> y{}; ///< varies from top to bottom
    bool hasControlRow = true;    ///< adds a last row that shows the start
    int cellPixels = 128;         ///< pixels along a cell's side
    std::vector<CellNumber> numbers{};
    nlohmann::json unknown = nlohmann::json::object(); ///< holds keys that the reader did not know

    friend bool operator==(const Sheet&, const Sheet&) = default;
};

} // namespace patina

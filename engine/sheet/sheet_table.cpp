// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet/sheet_table.h"

#include <fmt/format.h>

namespace patina {
namespace {

/// Returns a text as a field of a CSV file, quoted where RFC 4180 needs that.
std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) {
        return text;
    }
    std::string field = "\"";
    for (const char c : text) {
        field += c == '"' ? "\"\"" : std::string(1, c);
    }
    return field + '"';
}

std::string numberField(const std::optional<double>& number) {
    return number ? fmt::format("{:.6g}", *number) : std::string();
}

std::string entryOf(const PlannedAxis& axis, int step) {
    return quoted(axis.steps[static_cast<std::size_t>(step)].entry);
}

const std::optional<double>& numberOf(const CellNumbers& numbers, CellNumber kind) {
    switch (kind) {
    case CellNumber::Time:
        return numbers.milliseconds;
    case CellNumber::Error:
        return numbers.error;
    case CellNumber::Albedo:
        break;
    }
    return numbers.albedo;
}

std::string shortText(double number, CellNumber kind) {
    switch (kind) {
    case CellNumber::Time:
        return fmt::format("{:.3g} ms", number);
    case CellNumber::Error:
        return fmt::format("error {:.2g}", number);
    case CellNumber::Albedo:
        break;
    }
    return fmt::format("albedo {:.3f}", number);
}

} // namespace

std::string sheetCsv(const SheetPlan& plan, const std::vector<CellRow>& cells) {
    const std::string yTitle = plan.y() ? plan.y()->title : std::string("y");
    std::string csv = fmt::format("column,row,{},{},milliseconds,error,albedo,problem\n",
                                  quoted(plan.x().title), quoted(yTitle));
    for (const CellRow& cell : cells) {
        const bool isStart = plan.isControl(cell.row);
        const std::string x = isStart ? "start" : entryOf(plan.x(), cell.column);
        const std::string y = isStart    ? "start"
                              : plan.y() ? entryOf(*plan.y(), cell.row)
                                         : std::string();
        csv += fmt::format("{},{},{},{},{},{},{},{}\n", cell.column + 1, cell.row + 1, x, y,
                           numberField(cell.numbers.milliseconds), numberField(cell.numbers.error),
                           numberField(cell.numbers.albedo), quoted(cell.problem));
    }
    return csv;
}

std::vector<std::string> captionOf(const CellNumbers& numbers,
                                   const std::vector<CellNumber>& kinds) {
    std::vector<std::string> lines;
    for (const CellNumber kind : kinds) {
        const std::optional<double>& number = numberOf(numbers, kind);
        lines.push_back(number ? shortText(*number, kind) : std::string());
    }
    return lines;
}

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/lobe/lobe_table.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include <fmt/format.h>

namespace patina {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// Returns a text as a cell: in quotes where it would end the cell.
std::string csvCell(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) {
        return text;
    }
    std::string quoted = "\"";
    for (const char letter : text) {
        quoted += letter == '"' ? "\"\"" : std::string(1, letter);
    }
    return quoted + '"';
}

void addRow(std::string& csv, const std::string& start, double degrees, const glm::dvec3& v) {
    fmt::format_to(std::back_inserter(csv), "{},{:.10g},{:.10g},{:.10g},{:.10g}\n", start, degrees,
                   v.x, v.y, v.z);
}

void addSlice(std::string& csv, const std::string& start, const HalfDifferenceSlice& slice) {
    for (int row = 0; row < slice.size; ++row) {
        for (int column = 0; column < slice.size; ++column) {
            addRow(csv, fmt::format("{}{:.10g}", start, slice.angleOf(column) / degree),
                   slice.angleOf(row) / degree, slice.at(column, row));
        }
    }
}

void addRows(std::string& csv, const std::string& material, const LobeLine& line) {
    const std::string start = csvCell(material) + ',' + csvCell(line.name);
    for (std::size_t i = 0; i < line.values.size(); ++i) {
        addRow(csv, start, line.at[i], line.values[i]);
    }
}

} // namespace

std::string linesCsv(const std::vector<LobeSubject>& subjects, LobePlot plot) {
    std::string csv = fmt::format("material,line,{},red,green,blue\n", abscissaOf(plot));
    for (const LobeSubject& subject : subjects) {
        for (const LobeLine& line : subject.lines.lines) {
            addRows(csv, subject.name, line);
            if (const auto passed = transmittedLine(line)) {
                addRows(csv, subject.name, *passed);
            }
        }
    }
    return csv;
}

std::string sliceCsv(const HalfDifferenceSlice& slice) {
    std::string csv = "half_degrees,difference_degrees,red,green,blue\n";
    addSlice(csv, {}, slice);
    return csv;
}

std::string slicesCsv(const std::vector<NamedSlice>& slices) {
    std::string csv = "material,half_degrees,difference_degrees,red,green,blue\n";
    for (const NamedSlice& each : slices) {
        addSlice(csv, csvCell(each.name) + ',', each.slice);
    }
    return csv;
}

std::string solidsCsv(const std::vector<NamedSolid>& solids) {
    std::string csv = "material,viewer_degrees,azimuth_degrees,red,green,blue\n";
    for (const NamedSolid& each : solids) {
        for (std::size_t i = 0; i < each.solid.f.size(); ++i) {
            const glm::dvec3& v = each.solid.directions[i];
            addRow(csv,
                   fmt::format("{},{:.10g}", csvCell(each.name),
                               std::acos(std::min(v.z, 1.0)) / degree),
                   std::atan2(v.y, v.x) / degree, each.solid.f[i]);
        }
    }
    return csv;
}

} // namespace patina

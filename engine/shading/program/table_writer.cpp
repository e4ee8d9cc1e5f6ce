// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/program/table_writer.h"

#include <algorithm>

#include <fmt/format.h>

#include "catalog/table_source.h"
#include "shading/program/block_source.h"

namespace patina {
namespace {

std::string lookUp(const TablePlace& place) {
    const glm::ivec2 size = place.table->size;
    const std::string call =
        size.y < 2 ? fmt::format("readTableLine(x.x, {}, {})", size.x, place.row)
                   : fmt::format("readTablePlane(x, ivec2({}, {}), {})", size.x, size.y, place.row);
    return fmt::format("vec3 {}(vec2 x, {} p) {{\n    return {};\n}}\n",
                       tableFunction(*place.block, *place.table), structName(*place.block), call);
}

/// Returns the call that unpacks the values of a block, in the program that fills its tables.
std::string unpacked(const TablePlace& place) {
    switch (place.reader) {
    case TableReader::Slot:
        return fmt::format("unpack{}({})", slotStructName(place.block->kind), place.first);
    case TableReader::Blend:
        return fmt::format("unpackBlend({})", place.first);
    default:
        return fmt::format("unpackModel({})", place.first);
    }
}

/// Returns where an entry lies on an axis, 0 .. 1, as an expression.
std::string coordinate(const char* axis, int first, int entries) {
    return entries < 2
               ? std::string("0.0")
               : fmt::format("min(float(cell.{} - {}) / {}.0, 1.0)", axis, first, entries - 1);
}

} // namespace

bool looksUp(const Block& block, const TableLayout& tables, SurfaceOutput output) {
    return output == SurfaceOutput::Picture &&
           std::ranges::any_of(tables.places,
                               [&block](const TablePlace& place) { return place.block == &block; });
}

std::string textBeforeBlock(const Block& block, const TableLayout& tables, SurfaceOutput output) {
    std::string text;
    for (const BlockTable& table : block.tables) {
        const bool isRead = tables.has(table) && output != SurfaceOutput::Tables;
        text += isRead ? tableDeclaration(block, table)
                       : fmt::format("#define {}(x, p) vec3(0.0)\n", tableFunction(block, table));
    }
    return text;
}

std::string textBehindBlock(const Block& block, const TableLayout& tables, SurfaceOutput output) {
    std::string text;
    for (const TablePlace& place : tables.places) {
        if (place.block == &block && output != SurfaceOutput::Tables) {
            text += output == SurfaceOutput::Picture ? lookUp(place)
                                                     : computedTable(block, *place.table);
        }
    }
    return text;
}

std::string fillingSource(const TableLayout& tables) {
    std::string text = "layout(location = 0) out vec4 storedEntry;\n"
                       "void main() {\n    ivec2 cell = ivec2(gl_FragCoord.xy);\n"
                       "    vec3 entry = vec3(0.0);\n";
    for (const TablePlace& place : tables.places) {
        const glm::ivec2 size = place.table->size;
        text += fmt::format("    if (cell.y >= {} && cell.y < {}) {{\n"
                            "        entry = {}(vec2({}, {}), {});\n    }}\n",
                            place.row, place.row + size.y,
                            entryFunction(*place.block, *place.table), coordinate("x", 0, size.x),
                            coordinate("y", place.row, size.y), unpacked(place));
    }
    return text + "    storedEntry = vec4(entry, 1.0);\n}\n";
}

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/table_source.h"

#include <cctype>

#include <fmt/format.h>

namespace patina {
namespace {

std::string signature(const Block& block, const BlockTable& table) {
    return fmt::format("vec3 {}(vec2 x, {} p)", tableFunction(block, table), structName(block));
}

/// Is the source of one coordinate's position among the entries: {0} is x or y, {1} the last
/// entry's index, {2} the last but one's.
constexpr const char* placeSource = "    float {0}At = clamp(x.{0}, 0.0, 1.0) * {1}.0;\n"
                                    "    float {0}Low = min(floor({0}At), {2}.0);\n";

std::string place(const char* axis, int entries) {
    return fmt::format(fmt::runtime(placeSource), axis, entries - 1, entries - 2);
}

/// Is the source of the mean of two entries along the first axis: {0} is the entry's function, {1}
/// the index of the last one, {2} the position along the second axis, {3} the name of the result.
constexpr const char* rowSource =
    "    vec3 {3} = mix({0}(vec2(xLow / {1}.0, {2}), p),\n"
    "                   {0}(vec2((xLow + 1.0) / {1}.0, {2}), p), xAt - xLow);\n";

std::string row(const std::string& entry, const BlockTable& table, const std::string& second,
                const char* result) {
    return fmt::format(fmt::runtime(rowSource), entry, table.size.x - 1, second, result);
}

template <class Make>
std::string ofAll(const Block& block, const Make& make) {
    std::string text;
    for (const BlockTable& table : block.tables) {
        text += make(block, table);
    }
    return text;
}

} // namespace

std::string tableFunction(const Block& block, const BlockTable& table) {
    std::string name = fieldName(table.id);
    if (!name.empty()) {
        name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
    }
    return functionName(block) + name;
}

std::string entryFunction(const Block& block, const BlockTable& table) {
    return tableFunction(block, table) + "Entry";
}

std::string tableDeclaration(const Block& block, const BlockTable& table) {
    return signature(block, table) + ";\n";
}

std::string computedTable(const Block& block, const BlockTable& table, const std::string& entry) {
    std::string text = signature(block, table) + " {\n" + place("x", table.size.x);
    if (table.size.y < 2) {
        return text + row(entry, table, "0.0", "entry") + "    return entry;\n}\n";
    }
    const int last = table.size.y - 1;
    return text + place("y", table.size.y) +
           row(entry, table, fmt::format("yLow / {}.0", last), "below") +
           row(entry, table, fmt::format("(yLow + 1.0) / {}.0", last), "above") +
           "    return mix(below, above, yAt - yLow);\n}\n";
}

std::string computedTable(const Block& block, const BlockTable& table) {
    return computedTable(block, table, entryFunction(block, table));
}

std::string tableDeclarations(const Block& block) {
    return ofAll(block, tableDeclaration);
}

std::string computedTables(const Block& block) {
    return ofAll(
        block, [](const Block& its, const BlockTable& table) { return computedTable(its, table); });
}

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/measured_values.h"

#include "measured/kept_tables.h"

namespace patina::reference {
namespace {

/// Returns the table of a file. Each thread holds the one that it read last, since a value asks for
/// nine things of it.
const HalfDifferenceTable& tableOf(double file) {
    struct Held {
        int number = -1;
        unsigned version = 0;
        SharedTable table;
    };
    thread_local Held held;
    const int number = static_cast<int>(file);
    const unsigned version = keptTablesVersion();
    if (held.number != number || held.version != version) {
        held = {number, version, keptTable(number)};
    }
    return *held.table;
}

} // namespace

glm::ivec3 measuredBins(double file) {
    return tableOf(file).bins;
}

glm::dvec3 measuredValue(double file, const glm::ivec3& bin) {
    const HalfDifferenceTable& table = tableOf(file);
    return glm::dvec3(table.texels[static_cast<std::size_t>(
        (bin.z * table.bins.y + bin.y) * table.bins.x + bin.x)]);
}

} // namespace patina::reference

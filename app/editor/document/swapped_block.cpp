// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/swapped_block.h"

namespace patina {
namespace {

const char* const parkedKey = "parked";

} // namespace

BlockValues defaultsOf(const Block& block) {
    BlockValues values;
    values.id = block.id;
    values.version = block.version;
    values.parameters = defaultValues(block);
    return values;
}

BlockValues swappedBlock(const BlockValues* values, const Block* before, const Block& after) {
    if (!values) {
        return defaultsOf(after);
    }
    Material carrier;
    carrier.model = *values;
    if (const auto parked = values->unknown.find(parkedKey); parked != values->unknown.end()) {
        carrier.parked = *parked;
    }
    carrier = withModel(carrier, before, after);
    if (!carrier.parked.empty()) {
        carrier.model.unknown[parkedKey] = carrier.parked;
    }
    return carrier.model;
}

} // namespace patina

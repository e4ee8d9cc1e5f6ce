// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "catalog/json_schema.h"

namespace patina {

/// Returns every violation of the schema that ships as schemas/<name>.schema.json.
inline Errors checkSchema(const LocatedJson& document, const std::string& name) {
    const Result<JsonSchema> schema = JsonSchema::load(name);
    return schema ? schema->check(document) : Errors{schema.error()};
}

} // namespace patina

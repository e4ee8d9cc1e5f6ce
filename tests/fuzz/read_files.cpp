// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/read_files.h"

#include <cstdlib>
#include <iostream>

#include "catalog/catalog.h"
#include "catalog/expression.h"
#include "catalog/json_schema.h"
#include "material/preset_file.h"

namespace patina::tests {
namespace {

void require(bool holds, const char* what) {
    if (!holds) {
        std::cerr << what << '\n';
        std::abort();
    }
}

const Catalog& catalog() {
    static const Catalog shipped = loadCatalog(standardBlockRoots());
    return shipped;
}

const JsonSchema& descriptorSchema() {
    static const Result<JsonSchema> schema = JsonSchema::load("descriptor");
    require(schema.has_value(), "the schema of descriptors cannot be read");
    return *schema;
}

void readAsPreset(const LocatedJson& document) {
    const auto reading = materialFromJson(document, "", catalog());
    if (!reading) {
        require(!reading.error().empty(), "a preset was refused without a reason");
        return;
    }
    const std::string written = writeJson(toJson(reading->material));
    const auto again = materialFromJson(*parseJson(written, "again"), "", catalog());
    require(again.has_value(), "a written preset cannot be read");
    require(writeJson(toJson(again->material)) == written, "a preset changes when read again");
}

} // namespace

void readAsFiles(std::string_view bytes) {
    if (const auto expression = Expression::parse(bytes)) {
        expression->evaluate({});
    }
    const auto document = parseJson(bytes, "fuzz");
    if (!document) {
        require(document.error().line > 0, "a refused text has no place");
        return;
    }
    const std::string written = writeJson(document->value);
    const auto again = parseJson(written, "again", {written.size(), 64});
    require(again.has_value(), "written JSON cannot be read");
    require(writeJson(again->value) == written, "JSON changes when read again");
    descriptorSchema().check(*document);
    readAsPreset(*document);
}

} // namespace patina::tests

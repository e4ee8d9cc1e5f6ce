// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "catalog/json_text.h"

namespace patina {

/// Is one of the JSON Schemas (draft 7) that ship in schemas/, ready to check many documents.
class JsonSchema {
  public:
    /// Reads schemas/<name>.schema.json of the data folder. A file that is missing or no schema is
    /// an error.
    static Result<JsonSchema> load(const std::string& name);

    JsonSchema(JsonSchema&&) noexcept;
    JsonSchema& operator=(JsonSchema&&) noexcept;
    ~JsonSchema();

    /// Returns every violation, at its place in the document; what was expected is the
    /// `description` of the part of the schema that applies to the value.
    Errors check(const LocatedJson& document) const;

  private:
    struct Implementation;
    explicit JsonSchema(std::unique_ptr<Implementation> implementation);
    std::unique_ptr<Implementation> implementation_;
};

} // namespace patina

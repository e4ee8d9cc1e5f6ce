// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>

#include "catalog/json_text.h"
#include "catalog/value_error.h"

namespace patina {

/// Reads the members of one object of a document. A member that is missing leaves the default; one
/// of the wrong type is an error at its place and leaves the default. What was never asked for is
/// `unknown()`, so that it can be written back untouched.
class JsonReader {
  public:
    /// The document and the list of errors must outlive the reader. A value at the pointer that is
    /// not an object is an error, and the reader acts as if it were empty.
    JsonReader(const LocatedJson& document, std::string pointer, Errors& errors);

    const LocatedJson& document() const { return document_; }
    const std::string& pointer() const { return pointer_; }
    std::string pointer(std::string_view key) const;

    /// False when the value is missing or something else.
    bool isObject() const { return object_ != nullptr; }

    /// The member, or null; asking makes it known.
    const nlohmann::json* find(std::string_view key);
    bool has(std::string_view key) { return find(key) != nullptr; }

    void read(std::string_view key, std::string& into);
    void read(std::string_view key, bool& into);
    void read(std::string_view key, int& into);
    void read(std::string_view key, double& into);     ///< rounded to float
    void read(std::string_view key, glm::dvec3& into); ///< rounded to float

    /// A member that is kept whole; it must be an object.
    void readObject(std::string_view key, nlohmann::json& into);

    /// A member that must be an array; null when it is missing or something else.
    const nlohmann::json* array(std::string_view key);

    /// A reader of the member, which acts as empty when it is missing.
    JsonReader child(std::string_view key);

    /// All members that were never asked for.
    nlohmann::json unknown() const;

    void addError(std::string_view key, std::string problem, std::string expected = {});
    /// Adds a mistake in the value of a member, at its place within.
    void addError(std::string_view key, const ValueError& error);

  private:
    struct Missing {};
    JsonReader(const LocatedJson& document, std::string pointer, Errors& errors, Missing);
    void addWrongType(std::string_view key, const nlohmann::json& found, std::string expected);

    const LocatedJson& document_;
    std::string pointer_;
    Errors& errors_;
    const nlohmann::json* object_ = nullptr; ///< null: acts as empty
    std::set<std::string, std::less<>> known_;
};

/// Returns a reference token of a JSON pointer (RFC 6901): "~" and "/" escaped.
std::string escapedToken(std::string_view key);

/// Returns how a value is called in a message: "the number 5", "an array of 3",
/// "an array of 3 with the text "x" at place 2" where the others are numbers.
std::string described(const nlohmann::json& json);

} // namespace patina

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
/// of the wrong type is an error at its place and leaves the default. Members that were never asked
/// for are `unknown()`, so that they can be written back unchanged.
class JsonReader {
  public:
    /// The document and the list of errors must outlive the reader. A value at the pointer that is
    /// not an object is an error, and the reader acts as if it were empty.
    JsonReader(const LocatedJson& document, std::string pointer, Errors& errors);

    const LocatedJson& document() const { return document_; }
    const std::string& pointer() const { return pointer_; }
    std::string pointer(std::string_view key) const;

    /// Tells whether the value is an object; false also when it is missing.
    bool isObject() const { return object_ != nullptr; }

    /// Returns the member, or null. Asking for it makes it known.
    const nlohmann::json* find(std::string_view key);
    bool has(std::string_view key) { return find(key) != nullptr; }

    void read(std::string_view key, std::string& into);
    void read(std::string_view key, bool& into);
    void read(std::string_view key, int& into);
    void read(std::string_view key, double& into);     ///< rounds to float
    void read(std::string_view key, glm::dvec3& into); ///< rounds to float

    /// Reads a member that is kept whole; it must be an object.
    void readObject(std::string_view key, nlohmann::json& into);

    /// Returns a member that must be an array; null when it is missing or something else.
    const nlohmann::json* array(std::string_view key);

    /// Returns a reader of the member, which acts as if it were empty when it is missing.
    JsonReader child(std::string_view key);

    /// Returns all members that were never asked for.
    nlohmann::json unknown() const;

    void addError(std::string_view key, std::string problem, std::string expected = {});
    /// Adds a mistake inside the value of a member, at its place.
    void addError(std::string_view key, const ValueError& error);

  private:
    struct Missing {};
    JsonReader(const LocatedJson& document, std::string pointer, Errors& errors, Missing);
    void addWrongType(std::string_view key, const nlohmann::json& found, std::string expected);

    const LocatedJson& document_;
    std::string pointer_;
    Errors& errors_;
    const nlohmann::json* object_ = nullptr; ///< is null when the reader acts as if it were empty
    std::set<std::string, std::less<>> known_;
};

/// Returns a reference token of a JSON pointer (RFC 6901), with "~" and "/" escaped.
std::string escapedToken(std::string_view key);

/// Returns a value as messages call it: "the number 5", "an array of 3", "an array of 3 with the
/// text "x" at place 2" where the others are numbers.
std::string described(const nlohmann::json& json);

} // namespace patina

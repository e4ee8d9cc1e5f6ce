// SPDX-License-Identifier: GPL-3.0-or-later
// JSON on the clipboard: text for everybody, and the same once more under a name of our own for
// windows of Patina.
#pragma once

#include <string>

#include "catalog/json_text.h"

namespace patina {

/// Represents a JSON text that was copied.
struct CopiedJson {
    LocatedJson json; ///< of no file

    /// It comes from a window of Patina that reads what it names. Of another text nobody knows who
    /// wrote it.
    bool isTrusted = false;

    /// Returns what it says that it is; empty: nothing.
    std::string format() const;
};

/// Copies JSON; `isTrusted`: all files that it names are read here.
void copyJson(const nlohmann::json& json, bool isTrusted);

/// Returns what was copied; the error says where it is no JSON.
Result<CopiedJson> copiedJson();

/// Tells whether it looks like JSON, at no cost.
bool hasCopiedJson();

/// Returns an error, or errors, in what was copied: it is called the clipboard.
Error inClipboard(Error error);
Errors inClipboard(Errors errors);

} // namespace patina

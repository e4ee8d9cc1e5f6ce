// SPDX-License-Identifier: GPL-3.0-or-later
// Copies JSON to the clipboard and reads it from there: as text for every program, and once more
// under a MIME type of Patina's own for its other windows.
#pragma once

#include <string>

#include "catalog/json_text.h"

namespace patina {

/// Holds a JSON text that was copied, and says where it comes from.
struct CopiedJson {
    LocatedJson json; ///< comes from no file, so its name is empty

    /// Says that it comes from a window of Patina that reads the files it names. Other text may
    /// come from anyone.
    bool isTrusted = false;

    /// Returns the "format" that it names; empty where it names none.
    std::string format() const;
};

/// Copies JSON. `isTrusted` says that this window reads all files that the JSON names.
void copyJson(const nlohmann::json& json, bool isTrusted);

/// Returns what was copied; the error says where it is not JSON.
Result<CopiedJson> copiedJson();

/// Tells whether the clipboard's text starts like a JSON object, without parsing it.
bool hasCopiedJson();

/// Returns an error, or errors, in which "Clipboard" stands for the name of the file that is
/// missing.
Error inClipboard(Error error);
Errors inClipboard(Errors errors);

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/json_reader.h"

namespace patina {

/// Holds what the first lines of one of Patina's own files say.
struct FileFormat {
    const char* name;   ///< the value of "format"
    int version;        ///< the newest that can be read
    const char* called; ///< what a user calls such a file
};

enum class FileAge { Readable, Newer };

/// Reads "format" and "version". Another format is an error; a newer version is a note, and the
/// file is read as well as it can be.
FileAge readHeader(JsonReader& reader, const FileFormat& format, Errors& notes);

/// Returns what reading gave: a file of a newer version may mean something else by a key, so there
/// a wrong type is no reason to refuse the file.
template <class Reading>
Checked<Reading> settled(Reading reading, Errors errors) {
    if (errors.empty()) {
        return reading;
    }
    if (!reading.readOnly) {
        errors.insert(errors.end(), reading.notes.begin(), reading.notes.end());
        sortByPlace(errors);
        return tl::unexpected(std::move(errors));
    }
    reading.notes.insert(reading.notes.end(), errors.begin(), errors.end());
    return reading;
}

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/json_reader.h"

namespace patina {

/// Describes one of Patina's own file formats as its first lines name it.
struct FileFormat {
    const char* name;   ///< is the value of "format"
    int version;        ///< is the newest version that can be read
    const char* called; ///< is the word for such a file in messages
};

enum class FileAge { Readable, Newer };

/// Reads "format" and "version". Another format is an error; a newer version is a note, and the
/// file is read as well as it can be.
FileAge readHeader(JsonReader& reader, const FileFormat& format, Errors& notes);

/// Returns what reading gave, or its errors and notes where there are errors. In a file of a newer
/// version errors count as notes, since it may mean something else by a key.
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

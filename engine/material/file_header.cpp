// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/file_header.h"

#include <fmt/format.h>

namespace patina {

FileAge readHeader(JsonReader& reader, const FileFormat& format, Errors& notes) {
    if (!reader.isObject()) {
        return FileAge::Readable; // which is an error already
    }
    const std::string expected =
        fmt::format("\"format\": \"{}\", as every {} has it", format.name, format.called);
    std::string name = format.name;
    reader.read("format", name);
    if (!reader.has("format")) {
        reader.addError("format", "the key \"format\" is missing", expected);
    } else if (name != format.name) {
        reader.addError("format", fmt::format("this is no {}", format.called), expected);
    }
    int version = 1;
    reader.read("version", version);
    if (!reader.has("version") || version < 1) {
        reader.addError("version", fmt::format("the {} has no version", format.called),
                        "a whole number from 1");
    }
    if (version <= format.version) {
        return FileAge::Readable;
    }
    notes.push_back(reader.document().error(
        reader.pointer("version"),
        fmt::format("the {} was written by a newer Patina (version {}); it is opened read-only",
                    format.called, version),
        fmt::format("up to version {}", format.version)));
    return FileAge::Newer;
}

} // namespace patina

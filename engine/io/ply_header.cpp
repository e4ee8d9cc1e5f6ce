// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ply_header.h"

#include <string>

#include "io/text_file.h"

namespace patina {
namespace {

constexpr std::size_t longestHeader = 1 << 20; // comments may be long, but not a megabyte

} // namespace

bool hasWholePlyHeader(const std::filesystem::path& file) {
    std::string start = startOf(file, longestHeader);
    if (start.starts_with(byteOrderMark)) {
        start.erase(0, byteOrderMark.size());
    }
    const std::size_t end = start.find("end_header");
    return start.starts_with("ply") && end != std::string::npos &&
           start.find_first_of("\r\n", end) != std::string::npos;
}

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/program/program_file.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include <boost/crc.hpp>
#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>

#include "core/atomic_file.h"
#include "core/ordinary_file.h"
#include "gl/driver.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t maxFiles = 1000;
constexpr std::uintmax_t maxBytes = 64u << 20;

/// Is what lies between the key and the binary.
struct Header {
    std::uint32_t format = 0;
    std::uint32_t checksum = 0;
    std::uint64_t size = 0;
};

std::uint32_t checksumOf(const void* bytes, std::size_t size) {
    boost::crc_32_type crc;
    crc.process_bytes(bytes, size);
    return crc.checksum();
}

void removeOldest(const fs::path& folder) {
    std::error_code error;
    std::vector<std::pair<fs::file_time_type, fs::path>> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
        if (entry.path().extension() == ".program") {
            files.emplace_back(entry.last_write_time(error), entry.path());
        }
    }
    if (files.size() <= maxFiles) {
        return;
    }
    std::sort(files.begin(), files.end());
    for (std::size_t i = 0; i < files.size() - maxFiles; ++i) {
        fs::remove(files[i].second, error);
    }
}

} // namespace

ProgramFile::ProgramFile(const fs::path& folder, const std::string& hash) {
    if (folder.empty()) {
        return;
    }
    key_ = "patina program 1\n" + hash + '\n' + gl::driverText() + '\n';
    const boost::uuids::name_generator_sha1 generate(boost::uuids::ns::oid());
    path_ = folder / (boost::uuids::to_string(generate(key_)) + ".program");
}

std::optional<gl::ProgramBinary> ProgramFile::read() const {
    const Result<std::string> content = readFile(path_, maxBytes); // without a folder: no file
    if (!content || content->size() < key_.size() + sizeof(Header) || !content->starts_with(key_)) {
        return std::nullopt;
    }
    Header header;
    std::memcpy(&header, content->data() + key_.size(), sizeof(Header));
    const char* bytes = content->data() + key_.size() + sizeof(Header);
    const std::size_t size = content->size() - key_.size() - sizeof(Header);
    if (header.size != size || header.checksum != checksumOf(bytes, size)) {
        return std::nullopt;
    }
    gl::ProgramBinary binary;
    binary.format = header.format;
    binary.bytes.resize(size);
    std::memcpy(binary.bytes.data(), bytes, size);
    return binary;
}

void ProgramFile::write(const gl::ProgramBinary& binary) const {
    if (path_.empty()) {
        return;
    }
    const Header header{binary.format, checksumOf(binary.bytes.data(), binary.bytes.size()),
                        binary.bytes.size()};
    std::string content = key_;
    content.append(reinterpret_cast<const char*>(&header), sizeof(Header));
    content.append(reinterpret_cast<const char*>(binary.bytes.data()), binary.bytes.size());
    std::error_code error;
    fs::create_directories(path_.parent_path(), error);
    if (writeFileAtomically(path_, content)) {
        removeOldest(path_.parent_path());
    }
}

} // namespace patina

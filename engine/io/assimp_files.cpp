// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/assimp_files.h"

#include <cstdio>
#include <string_view>

#include <assimp/IOStream.hpp>

namespace patina {
namespace {

/// Reads an ordinary file for Assimp through the C library's buffer. It cannot be written.
class Stream final : public Assimp::IOStream {
  public:
    explicit Stream(OrdinaryFile file)
        : size_(file.size()), stream_(::fdopen(file.descriptor(), "rb")) {
        if (stream_ != nullptr) {
            file.release();
        }
    }
    ~Stream() override {
        if (stream_ != nullptr) {
            std::fclose(stream_);
        }
    }

    bool isOpen() const { return stream_ != nullptr; }

    std::size_t Read(void* buffer, std::size_t size, std::size_t count) override {
        return std::fread(buffer, size, count, stream_);
    }
    std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }
    aiReturn Seek(std::size_t offset, aiOrigin origin) override {
        const int from = origin == aiOrigin_SET   ? SEEK_SET
                         : origin == aiOrigin_CUR ? SEEK_CUR
                                                  : SEEK_END;
        return std::fseek(stream_, static_cast<long>(offset), from) == 0 ? aiReturn_SUCCESS
                                                                         : aiReturn_FAILURE;
    }
    std::size_t Tell() const override { return static_cast<std::size_t>(std::ftell(stream_)); }
    std::size_t FileSize() const override { return size_; }
    void Flush() override {}

  private:
    std::size_t size_;
    std::FILE* stream_;
};

} // namespace

bool AssimpFiles::Exists(const char* file) const {
    return folder_->open(file).has_value();
}

Assimp::IOStream* AssimpFiles::Open(const char* file, const char* mode) {
    auto opened =
        std::string_view(mode).starts_with('r') ? folder_->open(file) : failure("is only read");
    if (!opened) {
        return nullptr;
    }
    auto stream = std::make_unique<Stream>(std::move(*opened));
    return stream->isOpen() ? stream.release() : nullptr;
}

void AssimpFiles::Close(Assimp::IOStream* stream) {
    delete stream;
}

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/image_module.h"

#include <filesystem>
#include <string>
#include <system_error>

#include <dlfcn.h>

namespace patina {
namespace {

Result<const ImageCodec*> load() {
    std::error_code ignored;
    const auto here = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
    void* const module = ::dlopen((here / "patina-files-images.so").c_str(), RTLD_NOW | RTLD_LOCAL);
    void* const symbol = module != nullptr ? ::dlsym(module, imageCodecSymbol) : nullptr;
    if (symbol == nullptr) {
        const char* const why = ::dlerror();
        return failure(std::string("cannot load the image formats: ") +
                       (why != nullptr ? why : "unknown cause"));
    }
    return reinterpret_cast<const ImageCodec* (*)()>(symbol)();
}

} // namespace

void ImageModule::prefetch() {
    if (!codec_.valid()) {
        codec_ = std::async(std::launch::async, load).share();
    }
}

Result<const ImageCodec*> ImageModule::codec() {
    prefetch();
    return codec_.get();
}

} // namespace patina

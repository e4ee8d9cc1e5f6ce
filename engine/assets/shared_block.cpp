// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/shared_block.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>

namespace patina {
namespace {

namespace ipc = boost::interprocess;

constexpr int allSeals = F_SEAL_SEAL | F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_WRITE;

bool isSealed(int descriptor) {
    const int seals = ::fcntl(descriptor, F_GET_SEALS);
    return seals >= 0 && (seals & allSeals) == allSeals;
}

/// Gives mapped_region the one function that it needs of an object to map.
class Mappable {
  public:
    explicit Mappable(int descriptor) : descriptor_(descriptor) {}
    ipc::mapping_handle_t get_mapping_handle() const { return {descriptor_, false}; }

  private:
    int descriptor_;
};

Result<ipc::mapped_region> mapped(int descriptor, ipc::mode_t mode, std::size_t size) {
    try {
        // Populated at once: one fault per 4 KiB page would cost more than the reading itself.
        return ipc::mapped_region(Mappable(descriptor), mode, 0, size, nullptr, MAP_POPULATE);
    } catch (const ipc::interprocess_exception& problem) {
        return failure(std::string("cannot map shared memory: ") + problem.what());
    }
}

} // namespace

SharedBlock::SharedBlock(FileHandle handle, ipc::mapped_region region)
    : handle_(std::move(handle)), region_(std::move(region)) {}

Result<SharedBlock> SharedBlock::create(std::size_t size) {
    FileHandle handle(::memfd_create("patina", MFD_CLOEXEC | MFD_ALLOW_SEALING));
    if (!handle || size == 0 || ::ftruncate(handle.get(), static_cast<off_t>(size)) != 0) {
        return failure("cannot get " + std::to_string(size) + " bytes of shared memory");
    }
    auto region = mapped(handle.get(), ipc::read_write, size);
    if (!region) {
        return tl::unexpected(region.error());
    }
    return SharedBlock(std::move(handle), std::move(*region));
}

Result<SharedBlock> SharedBlock::open(FileHandle handle) {
    struct stat facts {};
    if (!handle || !isSealed(handle.get()) || ::fstat(handle.get(), &facts) != 0 ||
        facts.st_size <= 0) {
        return failure("the shared memory is missing or can still be changed");
    }
    // Private: Linux before 6.7 refuses to map sealed memory as shared, even for reading.
    auto region = mapped(handle.get(), ipc::read_private, static_cast<std::size_t>(facts.st_size));
    if (!region) {
        return tl::unexpected(region.error());
    }
    return SharedBlock(std::move(handle), std::move(*region));
}

std::span<std::byte> SharedBlock::bytes() {
    return {static_cast<std::byte*>(region_.get_address()), region_.get_size()};
}

std::span<const std::byte> SharedBlock::bytes() const {
    return {static_cast<const std::byte*>(region_.get_address()), region_.get_size()};
}

Result<FileHandle> SharedBlock::seal(SharedBlock block) {
    FileHandle handle = std::move(block.handle_);
    block.region_ = ipc::mapped_region();
    if (::fcntl(handle.get(), F_ADD_SEALS, allSeals) != 0) {
        return failure("cannot seal shared memory");
    }
    return handle;
}

} // namespace patina

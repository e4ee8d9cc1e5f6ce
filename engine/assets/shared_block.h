// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include <boost/interprocess/mapped_region.hpp>

#include "assets/file_handle.h"
#include "core/error.h"

namespace patina {

/// Owns memory that two processes share. It has no name, so nothing is left behind when either
/// process dies. Once it is sealed nobody can write or shrink it, so that what was checked stays
/// true.
class SharedBlock {
  public:
    /// Returns new zeroed memory of this size, writable until sealed.
    static Result<SharedBlock> create(std::size_t size);

    /// Maps what another process sent, for reading. Memory that is not sealed is refused.
    static Result<SharedBlock> open(FileHandle handle);

    std::span<std::byte> bytes();
    std::span<const std::byte> bytes() const;

    /// Unmaps the memory and gives the descriptor to send; after this nobody can change it.
    static Result<FileHandle> seal(SharedBlock block);

  private:
    SharedBlock(FileHandle handle, boost::interprocess::mapped_region region);

    FileHandle handle_;
    boost::interprocess::mapped_region region_;
};

} // namespace patina

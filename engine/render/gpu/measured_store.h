// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "catalog/block.h"
#include "gl/volume_texture.h"
#include "measured/kept_tables.h"

namespace patina {

/// Owns the tables of measured files in the GPU's memory: the four that were bound last, of which
/// each takes 12 bytes for a bin.
class MeasuredStore {
  public:
    /// Finds a table by its number, as keptTable() does.
    using Source = std::function<SharedTable(int)>;

    /// Sets where tables come from; by default that is keptTable().
    void setSource(Source source) { source_ = std::move(source); }

    /// Binds the table of a model that has one for the program's sampler, and returns it; null for
    /// another model. Leaves texture unit 0 active.
    SharedTable bind(const Block& model, const Values& values);

    /// Binds a table, by its number, to a texture unit, and returns it.
    SharedTable bind(int file, unsigned unit);

  private:
    static constexpr std::size_t maxTables = 4;

    struct Entry {
        int file = 0;
        SharedTable table; ///< is what the texture holds
        gl::VolumeTexture texture;
    };
    Source source_ = keptTable;
    std::vector<Entry> entries_; ///< end with the one that was bound last
};

} // namespace patina

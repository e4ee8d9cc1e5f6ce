// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace patina {

/// Remembers which blocks passed their trial, as empty files in a cache folder that are named by
/// keys. Where the folder cannot be written to, blocks are merely tried again.
class GoodBlocks {
  public:
    /// Keeps nothing where `folder` is empty.
    explicit GoodBlocks(std::filesystem::path folder) : folder_(std::move(folder)) {}

    bool has(const std::string& key) const;

    /// Adds a key, and removes the oldest ones when there are more than 1000.
    void add(const std::string& key) const;

  private:
    std::filesystem::path folder_;
};

} // namespace patina

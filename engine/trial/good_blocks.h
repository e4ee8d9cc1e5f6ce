// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace patina {

/// Remembers what did no harm when it was tried, as empty files of a cache folder that bear its
/// keys. A folder that cannot be written to costs nothing but the time to try again.
class GoodBlocks {
  public:
    /// Keeps nothing where the folder is empty.
    explicit GoodBlocks(std::filesystem::path folder) : folder_(std::move(folder)) {}

    bool has(const std::string& key) const;

    /// The oldest go when there are more than 1000.
    void add(const std::string& key) const;

  private:
    std::filesystem::path folder_;
};

} // namespace patina

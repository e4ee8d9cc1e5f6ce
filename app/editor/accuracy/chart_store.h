// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "accuracy/measured_chart.h"
#include "accuracy/measured_subject.h"
#include "core/error.h"

namespace patina {

/// Identifies a stored chart: by its page, the document's file and the object's index.
struct ChartKey {
    std::string page;
    std::string file; ///< is empty while the document has no file
    int object = -1;

    friend auto operator<=>(const ChartKey&, const ChartKey&) = default;
};

/// Holds a chart as it is written to a file, with its subject only as a hash.
struct StoredChart {
    MeasuredChart measured;
    bool complete = false;
    std::string problem; ///< says why the measurement ended early; empty if it did not
    std::string hash;    ///< identifies the subject; see hashOf()
};

/// Keeps charts in the files of a folder, one for each key, across restarts of Patina.
class ChartStore {
  public:
    explicit ChartStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Replaces the chart of that key, and removes the oldest files where there are very many.
    /// Returns an error if the folder or the file cannot be written.
    Result<void> write(const ChartKey& key, const StoredChart& stored) const;

    /// Reads the chart of a key; empty if none was written. Renames a damaged file, and returns an
    /// error that says where it is now.
    Result<std::optional<StoredChart>> read(const ChartKey& key) const;

    std::filesystem::path fileOf(const ChartKey& key) const;

  private:
    void removeOldest() const;

    std::filesystem::path folder_;
};

/// Returns a hash of the scene, the object, the blocks and the device's name, which tells subjects
/// apart across restarts.
std::string hashOf(const MeasuredSubject& subject, const std::string& device);

} // namespace patina

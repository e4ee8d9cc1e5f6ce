// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "accuracy/measured_chart.h"
#include "accuracy/measured_subject.h"
#include "core/error.h"

namespace patina {

/// Says which document a chart is of, on which page.
struct ChartKey {
    std::string page;
    std::string file; ///< empty: the document has none yet
    int object = -1;

    friend auto operator<=>(const ChartKey&, const ChartKey&) = default;
};

/// A chart as it is written: its subject is known by its hash alone.
struct StoredChart {
    MeasuredChart measured;
    bool complete = false;
    std::string problem; ///< why it ended before its time; else empty
    std::string hash;    ///< of its subject; see hashOf()
};

/// Charts in files of a folder, one for each key, so that who starts Patina again finds them.
class ChartStore {
  public:
    explicit ChartStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Writes in place of what was written for that key. The oldest of very many files goes.
    Result<void> write(const ChartKey& key, const StoredChart& stored) const;

    /// Reads the chart of a key: nothing where none was written. A file that is damaged is put
    /// aside, and the error names where it is then.
    Result<std::optional<StoredChart>> read(const ChartKey& key) const;

    std::filesystem::path fileOf(const ChartKey& key) const;

  private:
    void removeOldest() const;

    std::filesystem::path folder_;
};

/// Tells subjects apart over many starts of the program: a hash of the scene, the blocks and the
/// name of the device.
std::string hashOf(const MeasuredSubject& subject, const std::string& device);

} // namespace patina

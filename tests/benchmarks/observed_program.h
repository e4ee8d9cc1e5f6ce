// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace patina::benchmarks {

/// Runs a program until the object is destroyed, and reports what the system says about it.
class ObservedProgram {
  public:
    explicit ObservedProgram(const std::filesystem::path& program,
                             const std::vector<std::string>& arguments = {});
    ~ObservedProgram();

    /// Returns the seconds from the start until the program printed "first frame" on standard
    /// error, or a negative number when it ended or `limitSeconds` passed before.
    double secondsToFirstFrame(double limitSeconds = 30.0);

    /// Returns the same until it printed "sketch" or "first frame", whichever came first.
    double secondsToFirstPicture(double limitSeconds = 30.0);

    double residentMegabytes() const;
    long cpuTicks() const; ///< returns user and system time so far, in clock ticks

  private:
    class Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace patina::benchmarks

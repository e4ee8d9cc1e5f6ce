// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace patina::tests {

/// Says what a program did.
struct Outcome {
    int exitCode = 0; ///< is 128 + n when signal n ended it, -1 when it ran out of time
    std::string out;
    std::string err;
    double seconds = 0.0;
};

/// Says how to start a program.
struct Start {
    std::vector<std::string> arguments;
    std::map<std::string, std::string> environment; ///< is added to our own; "" removes a variable
    std::string input;                              ///< is given on the standard input
    double timeLimitSeconds = 60.0;
};

/// Runs a program until it ends or its time is over, and collects what it wrote.
Outcome run(const std::filesystem::path& program, const Start& start);

/// Makes a new, empty folder, which is removed with the object.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

  private:
    std::filesystem::path path_;
};

/// Makes a user's cache folder that shares the openness of meshes and the pictures of presets with
/// all tests: finding the openness of the default mesh takes as long as the rest of a short test,
/// and every window with presets in it draws those that are in sight.
void makeCacheFolder(const std::filesystem::path& cache);

std::string readFile(const std::filesystem::path& path);
void writeFile(const std::filesystem::path& path, const std::string& text);

} // namespace patina::tests

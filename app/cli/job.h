// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "catalog/catalog.h"
#include "cli/long_work.h"
#include "core/error.h"

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace patina {

/// Says where a command's results go, and which presets are its share.
struct JobOptions {
    std::string results; ///< is a file; empty where results are printed instead
    std::size_t shard = 1;
    std::size_t shards = 1;

    bool isWanted() const { return !results.empty(); }
};

/// Adds --results and --shard, and returns the first of them.
CLI::Option* addJobOptions(CLI::App& command, JobOptions& options);

/// Is what a command does with each preset of a job.
class JobWork {
  public:
    virtual ~JobWork() = default;

    /// Does the work on one preset and returns its result.
    virtual Checked<nlohmann::json> resultOf(const std::string& preset) = 0;

    /// Tells whether what an earlier result speaks of is still there, as a picture is.
    virtual bool isThere(const nlohmann::json&) const { return true; }

    /// Tells whether the command succeeds with this result.
    virtual bool isGood(const nlohmann::json&) const { return true; }
};

/// Holds what a job is of.
struct JobSubject {
    const CLI::App& command; ///< has the options as they were given
    const JobOptions& options;
    const std::vector<std::string>& presets; ///< are those of all shards
    const Catalog& catalog;
    bool allowsOutside = false;
};

/// Works on each preset of the shard that has no result yet, or one of another content, and adds
/// its result to the file before the next is begun. Returns the exit status of the command: 1 where
/// a preset failed or its result is not good.
Checked<int> runJob(const JobSubject& subject, JobWork& work, LongWork& longWork);

} // namespace patina

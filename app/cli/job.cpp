// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/job.h"

#include <array>
#include <charconv>
#include <filesystem>
#include <iostream>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/command.h"
#include "cli/content_hash.h"
#include "cli/result_file.h"

namespace patina {
namespace {

constexpr std::size_t maxShards = 1'000'000;

/// Reads a number of digits alone, from 1 to maxShards.
std::optional<std::size_t> shardNumber(std::string_view text) {
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool isRead = error == std::errc() && end == text.data() + text.size();
    return isRead && number >= 1 && number <= maxShards ? std::optional(number) : std::nullopt;
}

void readShard(const std::string& text, JobOptions& options) {
    const std::size_t line = std::min(text.find('/'), text.size());
    const auto shard = shardNumber(std::string_view(text).substr(0, line));
    const auto shards = shardNumber(std::string_view(text).substr(std::min(line + 1, text.size())));
    if (!shard || !shards || *shard > *shards) {
        throw CLI::ValidationError(
            "--shard", fmt::format("not a shard: \"{}\"; expected i/n with whole numbers, i from 1 "
                                   "to n and n up to {}, such as 2/8",
                                   text, maxShards));
    }
    options.shard = *shard;
    options.shards = *shards;
}

/// Tells whether an option decides what a result is; the others say where it goes and whose it is.
bool isOfResults(const CLI::Option& option) {
    constexpr std::array<std::string_view, 3> others{"--results", "--shard", "--output"};
    return option.count() > 0 && option.nonpositional() &&
           std::ranges::find(others, option.get_name()) == others.end();
}

/// Adds the hash of the file that a value such as "scene.json" or "color=wood.png" names.
void addFileOf(const std::string& value, nlohmann::json& files) {
    for (const std::string& name : {value, value.substr(value.find('=') + 1)}) {
        std::error_code unknown; // a path that cannot be examined is not a file
        if (std::filesystem::is_regular_file(name, unknown)) {
            files[name] = fileHash(name);
        }
    }
}

ResultHead headOf(const JobSubject& subject) {
    nlohmann::json options = nlohmann::json::object();
    nlohmann::json files = nlohmann::json::object();
    for (const CLI::Option* option : subject.command.get_options()) {
        if (!isOfResults(*option)) {
            continue;
        }
        options[option->get_name()] = option->results();
        for (const std::string& value : option->results()) {
            addFileOf(value, files);
        }
    }
    return {subject.command.get_name(),
            subject.presets.size(),
            subject.options.shard,
            subject.options.shards,
            {{"program", PATINA_VERSION},
             {"options", options},
             {"files", files},
             {"blocks", blocksHash(subject.catalog.roots)},
             {"list", textsHash(subject.presets)}}};
}

/// Counts what became of presets.
struct JobTally {
    std::size_t done = 0;
    std::size_t before = 0;
    std::size_t failed = 0;
    std::size_t bad = 0;
};

/// Does the work of one shard.
class ShardRun {
  public:
    ShardRun(const JobSubject& subject, JobWork& work, LongWork& longWork, ResultFile file)
        : subject_(subject), work_(work), longWork_(longWork), file_(std::move(file)) {}

    /// Has the result of a preset in the file, unless it is stopped meanwhile.
    Result<void> finish(std::size_t number) {
        const std::string& preset = subject_.presets[number - 1];
        ResultLine line{
            number, preset, presetHash(preset, subject_.catalog, subject_.allowsOutside), {}, {}};
        const ResultLine* before = file_.find(number);
        if (isDone(before, line.content)) {
            ++tally_.before;
            judge(*before);
            return {};
        }
        longWork_.report(fmt::format("{} of {}: {}", number, subject_.presets.size(), preset));
        const auto result = work_.resultOf(preset);
        if (longWork_.isStopped()) {
            return {};
        }
        if (result) {
            line.result = *result;
        } else {
            line.failure = text(result.error());
            report(result.error());
        }
        ++tally_.done;
        judge(line);
        const bool isKnown = before != nullptr && before->text() == line.text();
        return isKnown ? Result<void>() : file_.add(std::move(line));
    }

    const JobTally& tally() const { return tally_; }

  private:
    bool isDone(const ResultLine* before, const std::string& content) const {
        return before != nullptr && !before->hasFailed() && before->content == content &&
               work_.isThere(before->result);
    }

    void judge(const ResultLine& line) {
        tally_.failed += line.hasFailed() ? 1 : 0;
        tally_.bad += !line.hasFailed() && !work_.isGood(line.result) ? 1 : 0;
    }

    const JobSubject& subject_;
    JobWork& work_;
    LongWork& longWork_;
    ResultFile file_;
    JobTally tally_;
};

} // namespace

CLI::Option* addJobOptions(CLI::App& command, JobOptions& options) {
    CLI::Option* results = command.add_option(
        "--results", options.results,
        "Write a line of JSON for each preset into this file as soon as it is done. Started\n"
        "again, the command goes on with those that the file does not have. `patina merge` joins\n"
        "such files");
    command
        .add_option_function<std::string>(
            "--shard", [&options](const std::string& text) { readShard(text, options); },
            "Work on the i-th of n shares of the presets only: i/n, such as 2/8")
        ->needs(results);
    return results;
}

Checked<int> runJob(const JobSubject& subject, JobWork& work, LongWork& longWork) {
    if (subject.presets.empty()) {
        return tl::unexpected(
            oneError(failure("--results is of presets, and none is given", "presets").value()));
    }
    const ResultHead head = headOf(subject);
    auto file = ResultFile::open(subject.options.results, head);
    if (!file) {
        return tl::unexpected(oneError(file.error()));
    }
    ShardRun run(subject, work, longWork, std::move(*file));
    for (std::size_t number = head.shard; number <= head.presets && !longWork.isStopped();
         number += head.shards) {
        if (auto finished = run.finish(number); !finished) {
            return tl::unexpected(oneError(finished.error()));
        }
    }
    longWork.report({});
    const JobTally& tally = run.tally();
    std::cout << fmt::format("{}: {} of {} presets: {} done now, {} before; {} failed{}\n",
                             subject.options.results, head.count(), head.presets, tally.done,
                             tally.before, tally.failed,
                             tally.bad > 0 ? fmt::format(", {} found wanting", tally.bad) : "");
    if (longWork.isStopped()) {
        return LongWork::stoppedStatus;
    }
    return tally.failed + tally.bad > 0 ? 1 : 0;
}

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <set>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/command.h"
#include "cli/result_text.h"
#include "core/atomic_file.h"
#include "core/ordinary_file.h"

namespace patina {
namespace {

struct MergeOptions {
    std::vector<std::string> files;
    std::string output;
};

/// Joins the results of shards, one file after the other.
class Merger {
  public:
    Result<void> add(const std::string& file) {
        const auto text = readFile(file, maxAssetBytes);
        if (!text) {
            return tl::unexpected(text.error());
        }
        const auto read = readResults(*text, file);
        if (!read) {
            return tl::unexpected(read.error());
        }
        if (read->isCut) {
            const int last = static_cast<int>(std::ranges::count(*text, '\n')) + 1;
            return tl::unexpected(Error{file, last, 1, "the line is cut off",
                                        "the shard's command again, which does what is missing"});
        }
        if (auto fits = takeHead(read->head, file); !fits) {
            return fits;
        }
        return takeLines(*read, file);
    }

    /// Fails where a preset has no result.
    Result<void> checkWhole() const {
        for (std::size_t number = 1; number <= head_.presets; ++number) {
            if (!lines_.contains(number)) {
                return tl::unexpected(missing(number));
            }
        }
        return {};
    }

    std::string text() const {
        ResultHead whole = head_;
        whole.shard = whole.shards = 1;
        std::string text = whole.text();
        for (const auto& numbered : lines_) {
            text += numbered.second.line.text();
        }
        return text;
    }

    /// Says how many presets there are and which failed.
    std::string summary() const {
        std::size_t failed = 0;
        const ResultLine* first = nullptr;
        for (const auto& numbered : lines_) {
            const ResultLine& line = numbered.second.line;
            if (line.hasFailed() && failed++ == 0) {
                first = &line;
            }
        }
        return first == nullptr ? fmt::format("{} presets", lines_.size())
                                : fmt::format("{} presets; {} failed, the first is {}",
                                              lines_.size(), failed, first->preset);
    }

  private:
    struct Origin {
        ResultLine line;
        std::string file;
        int place = 0;
    };

    Result<void> takeHead(const ResultHead& head, const std::string& file) {
        if (shards_.empty()) {
            head_ = head;
            firstFile_ = file;
        } else if (const std::string differing = differenceOf(head_, head); !differing.empty()) {
            return tl::unexpected(Error{
                file, 1, 1,
                fmt::format("these are results of other work than those of {}: they differ in: {}",
                            firstFile_, differing),
                "shards of one work"});
        }
        shards_.insert(head.shard);
        return {};
    }

    Result<void> takeLines(const ResultText& read, const std::string& file) {
        std::map<std::size_t, Origin> own;
        for (const PlacedLine& each : read.lines) {
            own.insert_or_assign(each.line.number, Origin{each.line, file, each.place});
        }
        for (auto& numbered : own) {
            const auto [known, isNew] = lines_.try_emplace(numbered.first, numbered.second);
            const Origin& there = known->second;
            if (!isNew && there.line.text() != numbered.second.line.text()) {
                return tl::unexpected(Error{file, numbered.second.place, 1,
                                            fmt::format("{} has another result at {}:{}",
                                                        there.line.preset, there.file, there.place),
                                            "one result for each preset"});
            }
        }
        return {};
    }

    Error missing(std::size_t number) const {
        const std::size_t shard = (number - 1) % head_.shards + 1;
        const std::string share = fmt::format("shard {}/{}", shard, head_.shards);
        return failure(shards_.contains(shard) ? fmt::format("{} has no result of preset {} of {}",
                                                             share, number, head_.presets)
                                               : fmt::format("{} is missing", share),
                       "every shard, run to its end")
            .value();
    }

    ResultHead head_;
    std::string firstFile_;
    std::set<std::size_t> shards_; ///< are those that were added
    std::map<std::size_t, Origin> lines_;
};

Result<void> merge(const MergeOptions& options) {
    Merger merger;
    for (const std::string& file : options.files) {
        std::error_code missing; // a file that is not there is no other one
        if (std::filesystem::equivalent(file, options.output, missing) && !missing) {
            return tl::unexpected(Error{file, 0, 0, "it is a shard, and would be lost",
                                        "another file after -o"});
        }
    }
    for (const std::string& file : options.files) {
        if (auto added = merger.add(file); !added) {
            return added;
        }
    }
    if (auto whole = merger.checkWhole(); !whole) {
        return whole;
    }
    if (auto written = writeFileAtomically(options.output, merger.text()); !written) {
        return written;
    }
    std::cerr << merger.summary() << '\n';
    return {};
}

} // namespace

void addMerge(CLI::App& program, int& status) {
    CLI::App* command = program.add_subcommand(
        "merge", "Join the results of shards (--shard, --results) in the order of the presets, as\n"
                 "one process would have written them. Nothing is written where a shard is "
                 "missing,\nnot run to its end, or of other presets, options or blocks");
    auto options = std::make_shared<MergeOptions>();
    command->add_option("files", options->files, "Files of results")->required();
    command->add_option("-o,--output", options->output, "The file with all results")->required();
    command->callback([options, &status] {
        const auto done = merge(*options);
        status = done ? 0 : 1;
        if (!done) {
            report({done.error()});
        }
    });
}

} // namespace patina

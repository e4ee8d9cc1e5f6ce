// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "cli/result_text.h"
#include "core/error.h"

namespace patina {

/// Is a file of results that grows by one line for each preset. Each line is on the disk before the
/// next is begun, so that a process that is killed loses the one in work only.
class ResultFile {
  public:
    /// Opens the file for this process alone; makes it where there is none. What is in it is kept,
    /// but for a line that was being written, which is cut off. Fails where it holds anything else
    /// than results of the same work and shard.
    static Result<ResultFile> open(const std::string& file, const ResultHead& head);

    ResultFile(ResultFile&& other) noexcept
        : file_(std::move(other.file_)), descriptor_(std::exchange(other.descriptor_, -1)),
          size_(other.size_), lines_(std::move(other.lines_)) {}
    ResultFile& operator=(ResultFile&&) = delete;
    ~ResultFile();

    /// Returns what is known of the preset of a 1-based number; null where nothing is.
    const ResultLine* find(std::size_t number) const;

    /// Adds a line, which takes the place of an earlier one of the same preset. Where the disk does
    /// not take it whole, nothing of it is left in the file.
    Result<void> add(ResultLine line);

  private:
    ResultFile(std::string file, int descriptor)
        : file_(std::move(file)), descriptor_(descriptor) {}

    Result<void> take(ResultText text);
    Result<void> append(std::string_view text);
    Result<void> cutAt(std::size_t size);
    tl::unexpected<Error> cannotBeWritten() const; ///< says why by `errno`

    std::string file_;
    int descriptor_ = -1;
    std::size_t size_ = 0; ///< counts the bytes of whole lines
    std::map<std::size_t, ResultLine> lines_;
};

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/result_file.h"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include "cli/command.h"
#include "core/ordinary_file.h"

namespace patina {

Result<ResultFile> ResultFile::open(const std::string& file, const ResultHead& head) {
    constexpr int how = O_RDWR | O_CREAT | O_APPEND | O_NONBLOCK | O_CLOEXEC;
    ResultFile opened(file, ::open(file.c_str(), how, 0666));
    struct stat status {};
    if (opened.descriptor_ < 0 || ::fstat(opened.descriptor_, &status) != 0) {
        return opened.cannotBeWritten();
    }
    if (!S_ISREG(status.st_mode)) {
        return tl::unexpected(Error{file, 0, 0, "is not an ordinary file", "a file"});
    }
    // Some network file systems know no locks; there the user has to see to it.
    if (::flock(opened.descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        return tl::unexpected(Error{file, 0, 0, "another process is writing these results",
                                    "a file of its own for each process"});
    }
    const auto text = readFile(file, maxAssetBytes);
    if (!text) {
        return tl::unexpected(text.error());
    }
    const std::string start = head.text();
    if (text->size() < start.size() && start.starts_with(*text)) { // new, or killed just then
        const auto begun = opened.cutAt(0).and_then([&] { return opened.append(start); });
        return begun ? Result<ResultFile>(std::move(opened)) : tl::unexpected(begun.error());
    }
    auto read = readResults(*text, file);
    if (!read) {
        return tl::unexpected(read.error());
    }
    std::string differing = differenceOf(read->head, head);
    if (differing.empty() && read->head.shard != head.shard) {
        differing = "shard";
    }
    if (!differing.empty()) {
        return tl::unexpected(
            Error{file, 1, 1,
                  fmt::format("these are results of other work, which differs in: {}", differing),
                  "the same command as before, or another file"});
    }
    const auto taken = opened.take(std::move(*read));
    return taken ? Result<ResultFile>(std::move(opened)) : tl::unexpected(taken.error());
}

ResultFile::~ResultFile() {
    if (descriptor_ >= 0) {
        ::close(descriptor_);
    }
}

const ResultLine* ResultFile::find(std::size_t number) const {
    const auto found = lines_.find(number);
    return found == lines_.end() ? nullptr : &found->second;
}

Result<void> ResultFile::add(ResultLine line) {
    auto added = append(line.text());
    if (added) {
        lines_.insert_or_assign(line.number, std::move(line));
    }
    return added;
}

Result<void> ResultFile::take(ResultText text) {
    if (text.isCut) {
        report({Error{file_, 0, 0, "the last line was cut off; its preset is done again", {}}});
        if (auto cut = cutAt(text.wholeBytes); !cut) {
            return cut;
        }
    }
    size_ = text.wholeBytes;
    for (PlacedLine& each : text.lines) {
        lines_.insert_or_assign(each.line.number, std::move(each.line));
    }
    return {};
}

Result<void> ResultFile::append(std::string_view text) {
    const std::size_t size = size_ + text.size();
    while (!text.empty()) {
        const ssize_t written = ::write(descriptor_, text.data(), text.size());
        if (written < 0 && errno != EINTR) {
            break;
        }
        text.remove_prefix(written < 0 ? 0 : static_cast<std::size_t>(written));
    }
    if (!text.empty() || ::fdatasync(descriptor_) != 0) {
        const auto error = cannotBeWritten();
        // Where not even this succeeds, the next start finds a line that is cut off.
        static_cast<void>(cutAt(size_));
        return error;
    }
    size_ = size;
    return {};
}

Result<void> ResultFile::cutAt(std::size_t size) {
    if (::ftruncate(descriptor_, static_cast<off_t>(size)) != 0) {
        return cannotBeWritten();
    }
    return {};
}

tl::unexpected<Error> ResultFile::cannotBeWritten() const {
    return tl::unexpected(
        Error{file_, 0, 0, "cannot be written: " + std::generic_category().message(errno), {}});
}

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/files_session.h"

#include <chrono>
#include <utility>

#include <fmt/format.h>

namespace patina {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds pollInterval{10};

Error errorFrom(const FilesSession::Request& request, const Message& message) {
    Error error;
    error.file = request.file.string();
    const auto text = [&](std::size_t i) {
        return i < message.texts.size() ? message.texts[i] : std::string();
    };
    const auto number = [&](std::size_t i) {
        const double value = i < message.numbers.size() ? message.numbers[i] : 0.0;
        return value >= 1.0 && value <= 1e9 ? static_cast<int>(value) : 0;
    };
    error.problem = text(0).empty() ? "cannot be used" : text(0);
    error.expected = text(1);
    error.line = number(0);
    error.column = number(1);
    return error;
}

void report(Progress* progress, double done) {
    if (progress != nullptr && done >= 0.0 && done <= 1.0) { // false for NaN
        progress->done = static_cast<float>(done);
    }
}

} // namespace

FilesSession::FilesSession(AssetClient::Options options) : options_(std::move(options)) {}

Error FilesSession::ended(const Request& request, std::string problem) {
    process_.reset();
    return Error{request.file.string(), 0, 0, std::move(problem), {}};
}

Error FilesSession::refuse(const Request& request, const std::string& why) {
    return ended(request, fmt::format("the files process gave a wrong answer while {} ({})",
                                      request.doing, why));
}

void FilesSession::warmUp(bool images) {
    if (!process_) {
        if (auto started = FilesProcess::start(options_.program, options_.memoryLimitBytes)) {
            process_.emplace(std::move(*started));
        }
    }
    if (process_ && images) {
        process_->channel().send({MessageKind::warmImages, {}, {}});
    }
}

/// Sends the request. The process may have died since the last answer; then a new one is started,
/// once.
Result<void> FilesSession::begin(const Request& request) {
    const auto sent = [&] {
        return process_ && process_->channel().send(request.message, request.attachment.get());
    };
    if (sent()) {
        return {};
    }
    process_.reset();
    auto started = FilesProcess::start(options_.program, options_.memoryLimitBytes);
    if (!started) {
        started.error().file = request.file.string();
        return tl::unexpected(started.error());
    }
    process_.emplace(std::move(*started));
    if (!sent()) {
        return tl::unexpected(
            ended(request, "the files process stopped unexpectedly before " + request.doing));
    }
    return {};
}

Result<FilesSession::Answer> FilesSession::ask(const Request& request) {
    report(request.progress, 0.0);
    refusedLinks_.clear();
    if (const auto begun = begin(request); !begun) {
        return tl::unexpected(begun.error());
    }
    auto answer = await(request);
    if (answer) {
        report(request.progress, 1.0);
    }
    return answer;
}

/// Says when an answer takes too long. It counts the process' CPU time rather than time by the
/// clock, since other programs may need the machine. Work on several processors counts once: an
/// answer may always take the limit by the clock.
class FilesSession::Patience {
  public:
    Patience(const AssetClient::Options& options, const FilesProcess& process)
        : options_(options), process_(process) {}

    /// Returns the limit that is exceeded, in seconds; nothing before that.
    std::optional<double> end() const {
        const double waited = std::chrono::duration<double>(Clock::now() - begin_).count();
        if (waited > options_.waitLimitSeconds) {
            return options_.waitLimitSeconds;
        }
        const bool isLong = waited > options_.timeLimitSeconds &&
                            process_.workSeconds() - workBefore_ > options_.timeLimitSeconds;
        return isLong ? std::optional(options_.timeLimitSeconds) : std::nullopt;
    }

  private:
    const AssetClient::Options& options_;
    const FilesProcess& process_;
    Clock::time_point begin_ = Clock::now();
    double workBefore_ = process_.workSeconds();
};

Result<FilesSession::Answer> FilesSession::await(const Request& request) {
    const Patience patience(options_, *process_);
    while (true) {
        if (request.progress != nullptr && request.progress->cancelled) {
            return tl::unexpected(ended(request, "cancelled while " + request.doing));
        }
        if (const auto limit = patience.end()) {
            return tl::unexpected(ended(
                request, fmt::format("stopped after {:g} seconds of {}", *limit, request.doing)));
        }
        auto received = process_->channel().receive(pollInterval);
        if (!received && received.error() == Channel::Fault::closed) {
            return tl::unexpected(
                ended(request, "the files process stopped unexpectedly while " + request.doing));
        }
        if (!received) {
            return tl::unexpected(refuse(request, "not a message"));
        }
        if (received->has_value() && (*received)->message.kind == MessageKind::progress) {
            const auto& numbers = (*received)->message.numbers;
            report(request.progress, numbers.empty() ? -1.0 : numbers.front());
        } else if (received->has_value()) {
            return interpreted(request, std::move(**received));
        }
    }
}

Result<FilesSession::Answer> FilesSession::interpreted(const Request& request,
                                                       Channel::Delivery delivery) {
    const Message& message = delivery.message;
    const std::size_t before = message.kind == MessageKind::failed ? 2 : 1;
    if (message.texts.size() > before) {
        refusedLinks_ = splitPaths(message.texts[before]);
    }
    if (message.kind == MessageKind::failed) {
        return tl::unexpected(errorFrom(request, message));
    }
    if (message.kind != MessageKind::done) {
        return tl::unexpected(refuse(request, "an answer of the wrong kind"));
    }
    return Answer{message.texts.empty() ? std::string() : message.texts.front(),
                  std::move(delivery.attachment)};
}

} // namespace patina

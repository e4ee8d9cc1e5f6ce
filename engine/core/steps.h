// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <coroutine>
#include <exception>
#include <memory>
#include <utility>

namespace patina {

/// Is long work written from top to bottom: a coroutine that says `co_yield Pause()` wherever it
/// may be left for a while, and `co_await` of other steps for a part of it. Its local variables are
/// what a hand-written state machine would have as members. Its owner asks for one step after the
/// other, and may destroy it at any pause.
///
/// Arguments of the coroutine are kept by value or must outlive it; a lambda's captures do not live
/// as long as its coroutine, so steps are functions.
class [[nodiscard]] Steps {
  public:
    /// Ends a step.
    struct Pause {};

    class promise_type {
      public:
        Steps get_return_object() { return Steps(Handle::from_promise(*this)); }
        std::suspend_always initial_suspend() noexcept { return {}; }
        std::suspend_always final_suspend() noexcept { return {}; }
        std::suspend_always yield_value(Pause) noexcept { return {}; }
        void return_void() noexcept {}
        void unhandled_exception() noexcept { thrown_ = std::current_exception(); }

        /// Runs a part's steps as steps of the whole.
        std::suspend_always await_transform(Steps part) {
            part_ = std::make_unique<Steps>(std::move(part));
            return {};
        }

      private:
        friend class Steps;

        std::unique_ptr<Steps> part_;
        std::exception_ptr thrown_;
    };

    /// Creates steps that are done from the start.
    Steps() = default;

    Steps(Steps&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
    Steps& operator=(Steps&& other) noexcept {
        std::swap(handle_, other.handle_);
        return *this;
    }
    Steps(const Steps&) = delete;
    Steps& operator=(const Steps&) = delete;

    ~Steps() {
        if (handle_) {
            handle_.destroy();
        }
    }

    /// Continues to the next pause. Rethrows what the work throws, which ends it.
    void step() {
        while (!isDone()) {
            promise_type& promise = handle_.promise();
            if (promise.part_) {
                stepPart();
                if (!promise.part_->isDone()) {
                    return;
                }
                promise.part_.reset();
            }
            handle_.resume();
            if (promise.thrown_) {
                std::rethrow_exception(std::exchange(promise.thrown_, nullptr));
            }
            if (!promise.part_) {
                return;
            }
        }
    }

    bool isDone() const { return !handle_ || handle_.done(); }

  private:
    using Handle = std::coroutine_handle<promise_type>;
    explicit Steps(Handle handle) : handle_(handle) {}

    /// Runs a step of the part; what it throws ends the whole.
    void stepPart() {
        try {
            handle_.promise().part_->step();
        } catch (...) {
            std::exchange(handle_, nullptr).destroy();
            throw;
        }
    }

    Handle handle_;
};

} // namespace patina

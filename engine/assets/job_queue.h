// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <thread>

namespace patina {

/// Runs jobs on one thread in the order they came. The thread lives as long as the queue.
class JobQueue {
  public:
    JobQueue();
    ~JobQueue(); ///< waits for the job that runs; drops those that have not started

    /// Runs the job and waits for its end. Returns false, without running it, when `cancelled`
    /// becomes true before it has started; `cancelled` may be null.
    bool run(std::function<void()> work, const std::atomic<bool>* cancelled);

    /// Adds the job and returns at once.
    void post(std::function<void()> work);

  private:
    struct Job {
        std::function<void()> work;
        bool started = false;
        bool done = false;
    };

    std::shared_ptr<Job> append(std::function<void()> work);
    void doJobs(const std::stop_token& stop);

    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::list<std::shared_ptr<Job>> waiting_;
    std::jthread thread_;
};

} // namespace patina

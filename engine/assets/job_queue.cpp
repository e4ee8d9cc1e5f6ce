// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/job_queue.h"

#include <chrono>

namespace patina {

JobQueue::JobQueue() : thread_([this](const std::stop_token& stop) { doJobs(stop); }) {}

JobQueue::~JobQueue() = default;

std::shared_ptr<JobQueue::Job> JobQueue::append(std::function<void()> work) {
    auto job = std::make_shared<Job>();
    job->work = std::move(work);
    const std::lock_guard lock(mutex_);
    waiting_.push_back(job);
    changed_.notify_all();
    return job;
}

void JobQueue::post(std::function<void()> work) { append(std::move(work)); }

bool JobQueue::run(std::function<void()> work, const std::atomic<bool>* cancelled) {
    using namespace std::chrono_literals;
    const auto job = append(std::move(work));
    std::unique_lock lock(mutex_);
    while (!changed_.wait_for(lock, 10ms, [&] { return job->done; })) {
        if (!job->started && cancelled != nullptr && *cancelled) {
            waiting_.remove(job);
            return false;
        }
    }
    return true;
}

void JobQueue::doJobs(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, stop, [this] { return !waiting_.empty(); }) &&
           !stop.stop_requested()) {
        const auto job = waiting_.front();
        waiting_.pop_front();
        job->started = true;
        lock.unlock();
        job->work();
        lock.lock();
        job->done = true;
        changed_.notify_all();
    }
}

} // namespace patina

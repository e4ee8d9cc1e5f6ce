// SPDX-License-Identifier: GPL-3.0-or-later
#include "background/worker.h"

#include <algorithm>
#include <exception>

#include <QPointer>

#include "background/free_memory.h"

namespace patina {
namespace {

constexpr qint64 tellEveryMs = 50;
constexpr int idleThreadMs = 100;

} // namespace

Worker::Control::Control(Worker& worker, std::shared_ptr<Task> task)
    : worker_(worker), task_(std::move(task)) {
    sinceTold_.start();
}

Progress& Worker::Control::progress() const {
    return task_->progress;
}

bool Worker::Control::isSuperseded() const {
    const std::lock_guard lock(worker_.mutex_);
    return !task_->key.isEmpty() && std::ranges::any_of(worker_.waiting_, [this](const auto& task) {
        return task->key == task_->key;
    });
}

void Worker::Control::report(double share, const QString& doing, bool isAnother) {
    if (isAnother || sinceTold_.elapsed() >= tellEveryMs) {
        sinceTold_.restart();
        show([worker = &worker_, share, doing] {
            worker->told_ = {share, doing};
            Q_EMIT worker->progressed(share, doing);
        });
    }
}

void Worker::Control::show(std::function<void()> news) const {
    worker_.handOver(task_, std::move(news), false);
}

Result<void> Worker::Control::openContext() const {
    auto& context = worker_.context_;
    if (!context) {
        context = gl::HeadlessContext::create();
    }
    return *context ? Result<void>() : tl::unexpected(context->error());
}

Worker::Worker(Options options) : options_(std::move(options)), isPaused_(options_.isPaused) {
    pool_.setMaxThreadCount(1);
    pool_.setExpiryTimeout(idleThreadMs);
    pool_.setThreadPriority(options_.priority);
}

Worker::~Worker() {
    {
        const std::lock_guard lock(mutex_);
        if (thread_ != nullptr) {
            thread_->setPriority(QThread::NormalPriority); // it is waited for from now on
        }
    }
    options_.atEnd == AtEnd::Finish ? finish() : forget();
    open_.clear();
    report();
    {
        const std::lock_guard lock(mutex_);
        isEnding_ = true;
    }
    changed_.notify_all();
    pool_.waitForDone();
}

std::shared_ptr<Progress> Worker::add(const QString& key, const QString& what, Job work) {
    auto task = std::make_shared<Task>();
    task->key = key;
    task->what = what;
    task->work = std::move(work);
    open_.push_back(task);
    {
        const std::lock_guard lock(mutex_);
        const auto older = std::ranges::find_if(
            waiting_, [&](const auto& other) { return !key.isEmpty() && other->key == key; });
        if (older != waiting_.end()) {
            std::erase(open_, std::exchange(*older, task));
        } else {
            waiting_.push_back(task);
        }
    }
    report();
    startThread();
    return {task, &task->progress};
}

/// Tells LongTasks that there is something to do, or that there is nothing more.
void Worker::report() {
    if (options_.name.isEmpty() || open_.empty() == (reported_ == 0)) {
        return;
    }
    if (open_.empty()) {
        LongTasks::all().end(std::exchange(reported_, 0));
        return;
    }
    ended_ = 0;
    told_ = {};
    LongTask task{options_.name, [this] { return state(); }, {}};
    if (options_.canCancel) {
        task.cancel = [this] { cancel(); };
    }
    reported_ = LongTasks::all().begin(std::move(task));
}

TaskState Worker::state() {
    std::shared_ptr<Task> running;
    {
        const std::lock_guard lock(mutex_);
        running = running_;
    }
    const double done = running ? double(running->progress.done.load()) : 0.0;
    const double share = std::max(told_.share, done);
    const auto all = static_cast<double>(open_.size()) + ended_;
    TaskState state{all > 1.0 || share > 0.0 ? (ended_ + std::max(share, 0.0)) / all : -1.0,
                    told_.doing};
    if (state.doing.isEmpty() && running) {
        state.doing = running->what;
    }
    if (open_.size() > 1) {
        const QString more = tr("%n left", nullptr, static_cast<int>(open_.size()));
        state.doing = state.doing.isEmpty() ? more : tr("%1, %2").arg(state.doing, more);
    }
    return state;
}

void Worker::resume() {
    isPaused_ = false;
    startThread();
}

/// Starts a thread if requests wait and no thread takes them.
void Worker::startThread() {
    const std::lock_guard lock(mutex_);
    if (!isPaused_ && !waiting_.empty() && !std::exchange(hasThread_, true)) {
        pool_.start([this] { run(); });
    }
    changed_.notify_all();
}

void Worker::cancel() {
    for (const auto& task : open_) {
        task->progress.cancelled = true;
    }
    if (options_.atCancel) {
        options_.atCancel();
    }
}

void Worker::forget() {
    cancel();
    {
        const std::lock_guard lock(mutex_);
        waiting_.clear();
    }
    open_.clear();
    report();
}

void Worker::finish() {
    resume();
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return waiting_.empty() && !running_; });
}

/// Runs in the worker's thread, as do the functions below.
void Worker::run() {
    {
        const std::lock_guard lock(mutex_);
        thread_ = QThread::currentThread();
    }
    while (const std::shared_ptr<Task> task = next()) {
        Control control(*this, task);
        Delivery delivery = task->work(control);
        task->work = nullptr; // frees what it holds
        handOver(task, std::move(delivery), true);
    }
    if (options_.atRest) {
        options_.atRest();
    }
    closeContext();
    const std::lock_guard lock(mutex_);
    thread_ = nullptr;
}

/// Returns the next request; null when the thread has to end. A request that comes after that
/// starts the thread again, which the pool does once this one has ended.
std::shared_ptr<Worker::Task> Worker::next() {
    std::unique_lock lock(mutex_);
    running_.reset();
    changed_.notify_all();
    changed_.wait_for(lock, options_.patience, [this] { return isEnding_ || !waiting_.empty(); });
    if (waiting_.empty()) {
        hasThread_ = false;
        return nullptr;
    }
    running_ = std::move(waiting_.front());
    waiting_.pop_front();
    return running_;
}

/// Calls `delivery` in the asking thread, unless the request was forgotten by then.
void Worker::handOver(const std::shared_ptr<Task>& task, Delivery delivery, bool isLast) {
    const auto deliver = [this, task, delivery = std::move(delivery), isLast] {
        const auto found = std::ranges::find(open_, task);
        if (found == open_.end()) {
            return;
        }
        if (isLast) {
            open_.erase(found);
            ++ended_;
            told_ = {};
        }
        const QPointer alive(this);
        delivery(); // it may ask for more, or destroy the worker
        if (alive) {
            report();
        }
    };
    QMetaObject::invokeMethod(this, deliver, Qt::QueuedConnection);
}

void Worker::closeContext() {
    if (std::exchange(context_, std::nullopt)) {
        returnFreeMemory(); // compiling leaves much of it
    }
}

/// Returns the exception that is being handled as an error.
Error Worker::currentError() {
    try {
        throw;
    } catch (const std::exception& thrown) {
        return {{}, 0, 0, thrown.what(), {}};
    } catch (...) {
        return {{}, 0, 0, "it failed for an unknown reason", {}};
    }
}

} // namespace patina

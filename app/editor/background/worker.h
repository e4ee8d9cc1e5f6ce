// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QThread>
#include <QThreadPool>

#include "background/long_tasks.h"
#include "core/error.h"
#include "core/progress.h"
#include "gl/headless_context.h"

namespace patina {

/// Runs requests in a thread of its own, one after the other, and delivers each result in the
/// thread that asked. Its public functions belong to that thread.
///
/// Its destructor waits for the thread, so it has to be the last member of a class that owns what
/// the work uses. Results that are not delivered by then are dropped.
class Worker : public QObject {
    Q_OBJECT

    struct Task;

  public:
    /// Says what happens to waiting requests when the worker is destroyed.
    enum class AtEnd {
        Drop,  ///< they are not begun, and the running one is cancelled
        Finish ///< they are done first
    };

    struct Options {
        /// Names the work in LongTasks; it is not listed there if this is empty.
        QString name{};
        bool canCancel = false; ///< lets it be cancelled there

        /// Is called, in the thread that asked, when all requests are told to stop: for work that
        /// cannot look at its Progress.
        std::function<void()> atCancel{};

        QThread::Priority priority = QThread::InheritPriority;

        /// Is how long the thread waits for a further request before it ends and closes its
        /// context.
        std::chrono::milliseconds patience{0};

        /// Is called in the worker's thread before that ends, to free what work left for the next
        /// one.
        std::function<void()> atRest{};

        bool isPaused = false; ///< lets nothing begin before resume()
        AtEnd atEnd = AtEnd::Drop;
    };

    /// Lets work report to the thread that asked. Must be used in the worker's thread.
    class Control {
      public:
        Progress& progress() const;
        bool isCancelled() const { return progress().cancelled; }

        /// Returns whether a newer request with the same key waits.
        bool isSuperseded() const;

        /// Emits progressed() if 50 ms have passed since the last time, or if `isAnother` says that
        /// something else is done now.
        void report(double share, const QString& doing = {}, bool isAnother = false);

        /// Calls a function in the thread that asked, unless the request is forgotten by then.
        void show(std::function<void()> news) const;

        /// Makes a context without a window current, if there is none yet. It stays for further
        /// requests until the thread ends. Returns an error if no context can be made.
        Result<void> openContext() const;
        void closeContext() const { worker_.closeContext(); }

      private:
        friend class Worker;
        Control(Worker& worker, std::shared_ptr<Task> task);

        Worker& worker_;
        std::shared_ptr<Task> task_;
        QElapsedTimer sinceTold_;
    };

    Worker() : Worker(Options{}) {}
    explicit Worker(Options options);
    ~Worker() override;

    /// Asks for work(control), whose outcome is passed to done(): a Result, or a Checked if work
    /// returns one itself. An exception becomes an error in it. A request replaces a waiting one
    /// with the same key, whose done() is never called; without a key it replaces none. `what` is
    /// shown beside the worker's name, such as a file. Returns the request's progress, which can
    /// cancel it.
    template <class Work, class Done>
    std::shared_ptr<Progress> ask(Work work, Done done, const QString& key = {},
                                  const QString& what = {}) {
        using Outcome = typename OutcomeOf<std::invoke_result_t<Work&, Control&>>::Type;
        return add(
            key, what, [work = std::move(work), done = std::move(done)](Control& control) mutable {
                auto outcome = std::make_shared<const Outcome>(outcomeOf<Outcome>(work, control));
                return [done, outcome]() mutable { done(*outcome); };
            });
    }

    /// Begins what was asked for, if the worker was made paused.
    void resume();

    /// Tells all requests to stop. What they have by then is delivered.
    void cancel();

    /// Cancels all requests and delivers none of them.
    void forget();

    /// Waits until all requests are done. Their results are delivered later.
    void finish();

    /// Returns whether every request was delivered.
    bool isIdle() const { return open_.empty(); }

  Q_SIGNALS:
    void progressed(double share, const QString& doing); ///< `share` is 0 .. 1

  private:
    using Context = Result<std::unique_ptr<gl::HeadlessContext>>;
    using Delivery = std::function<void()>;
    using Job = std::function<Delivery(Control&)>;

    struct Task {
        QString key;
        QString what;
        Job work;
        Progress progress;
    };

    template <class T>
    struct OutcomeOf {
        using Type = Result<T>;
    };
    template <class T, class E>
    struct OutcomeOf<tl::expected<T, E>> {
        using Type = tl::expected<T, E>;
    };

    template <class Outcome, class Work>
    static Outcome outcomeOf(Work& work, Control& control) {
        try {
            if constexpr (std::is_void_v<std::invoke_result_t<Work&, Control&>>) {
                work(control);
                return {};
            } else {
                return work(control);
            }
        } catch (...) {
            return tl::unexpected(typename Outcome::error_type{currentError()});
        }
    }

    static Error currentError();
    std::shared_ptr<Progress> add(const QString& key, const QString& what, Job work);
    void report();
    TaskState state();
    void startThread();
    void run();
    std::shared_ptr<Task> next();
    void handOver(const std::shared_ptr<Task>& task, Delivery delivery, bool isLast);
    void closeContext();

    const Options options_;
    bool isPaused_; ///< belongs to the thread that asks, as do the four members below
    std::vector<std::shared_ptr<Task>> open_; ///< were asked for and are not delivered yet
    quint64 reported_ = 0;           ///< is the number in LongTasks; 0 if it is not listed there
    int ended_ = 0;                  ///< counts requests that ended since there was something to do
    TaskState told_{};               ///< is what the running request told last
    std::optional<Context> context_; ///< belongs to the worker's thread; empty before the first try
    std::mutex mutex_;               ///< guards the members below, except the pool
    std::condition_variable changed_;
    std::deque<std::shared_ptr<Task>> waiting_;
    std::shared_ptr<Task> running_;
    QThread* thread_ = nullptr; ///< runs requests now; null where none does
    bool hasThread_ = false; ///< tells whether a thread will look at waiting_ again before it ends
    bool isEnding_ = false;
    QThreadPool pool_; ///< has one thread
};

} // namespace patina

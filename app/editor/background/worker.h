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

/// Does what it is asked for in a thread of its own, one request after the other, and hands each
/// result over in the thread that asked. Its public functions are that thread's.
///
/// Its destructor waits for the thread, so it is the last member of whoever owns what the work
/// uses; results that are not handed over by then are dropped.
class Worker : public QObject {
    Q_OBJECT

    struct Task;

  public:
    /// What becomes of requests that wait when the worker is destroyed.
    enum class AtEnd {
        Drop,  ///< they are not begun, and the one that runs is cancelled
        Finish ///< they are done
    };

    struct Options {
        /// Names the work where all that takes long is shown (LongTasks); empty: it is not shown.
        QString name{};
        bool canCancel = false; ///< it may be stopped there

        QThread::Priority priority = QThread::InheritPriority;

        /// How long the thread waits for a further request before it rests: the context goes then.
        std::chrono::milliseconds patience{0};

        /// Is called in the worker's thread when it rests, for what work left there for the next.
        std::function<void()> atRest{};

        bool isPaused = false; ///< nothing is begun before resume()
        AtEnd atEnd = AtEnd::Drop;
    };

    /// Is what work knows of who waits for it. Used in the worker's thread.
    class Control {
      public:
        Progress& progress() const;
        bool isCancelled() const { return progress().cancelled; }

        /// A newer request with the same key waits.
        bool isSuperseded() const;

        /// Has progressed() emitted where some time has passed since the last time, or where what
        /// is being done is another thing than then.
        void tell(double share, const QString& doing = {}, bool isAnother = false);

        /// Has a function called in the thread that asked, unless the request is forgotten.
        void show(std::function<void()> news) const;

        /// Makes a context without a window current, if there is none yet. It stays for the next
        /// requests, until the thread rests.
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

    /// Asks for work(control), whose value done(result) is given: a Result, or a Checked where the
    /// work itself returns one. An exception is an error in it. A request takes the place of the
    /// one with the same key that was not begun, which is dropped; without a key it takes none.
    /// `what` is shown beside the worker's name: a file, say.
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

    /// Begins what was asked for so far, where it was made paused.
    void resume();

    /// Tells all work that is asked for to stop. What it has by then is handed over.
    void cancel();

    /// Cancels, and hands nothing over of what was asked for so far.
    void forget();

    /// Waits until everything is done that is asked for. Results are handed over later.
    void finish();

    /// Everything that was asked for was handed over.
    bool isIdle() const { return open_.empty(); }

  Q_SIGNALS:
    void progressed(double share, const QString& doing); ///< share: 0 .. 1

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
    bool isPaused_;                           ///< of the thread that asks, as is the next
    std::vector<std::shared_ptr<Task>> open_; ///< were asked for and are not handed over
    quint64 reported_ = 0;                    ///< where it is shown; 0: nowhere
    int ended_ = 0;                           ///< requests since there was something to do
    TaskState told_{};                        ///< of the one that runs
    std::optional<Context> context_;          ///< of the worker's thread; empty: not tried
    std::mutex mutex_;                        ///< guards what follows but the pool
    std::condition_variable changed_;
    std::deque<std::shared_ptr<Task>> waiting_;
    std::shared_ptr<Task> running_;
    bool hasThread_ = false; ///< that looks at waiting_ again before it rests
    bool isEnding_ = false;
    QThreadPool pool_; ///< of one thread
};

} // namespace patina

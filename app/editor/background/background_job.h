// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QThread>

#include "background/single_thread.h"
#include "core/error.h"

namespace patina {

/// Runs one piece of work at a time in a thread of its own, which runs straight through and asks
/// now and then whether it shall end.
class BackgroundJob : public QObject {
    Q_OBJECT

  public:
    /// Is what work knows of who waits for it. Used in the worker's thread.
    class Control {
      public:
        bool isCancelled() const { return job_.cancelled_; }

        /// Emits progressed() where some time has passed since the last time, or where what is
        /// being done is another thing than then.
        void tell(double share, const QString& doing = {}, bool isAnother = false);

        /// Has the job's thread call a function that shows what is new, unless the job is gone.
        void show(std::function<void()> news);

      private:
        friend class BackgroundJob;
        explicit Control(BackgroundJob& job) : job_(job) { sinceTold_.start(); }

        BackgroundJob& job_;
        QElapsedTimer sinceTold_;
    };

    struct End {
        bool complete = false;
        QString problem; ///< why it ended before its time; else empty
    };
    using Work = std::function<End(Control&)>;

    explicit BackgroundJob(QObject* parent = nullptr);

    /// The priority of the thread, from the next start on.
    void setPriority(QThread::Priority priority) { worker_.setThreadPriority(priority); }

    /// Cancels, and waits until the work has ended.
    ~BackgroundJob() override;

    /// Nothing happens while something is going on.
    void start(Work work);
    void cancel();
    bool isRunning() const { return running_; }

  Q_SIGNALS:
    void progressed(double share, const QString& doing);  ///< share: 0 .. 1
    void finished(bool complete, const QString& problem); ///< also after cancel()

  private:
    std::atomic<bool> cancelled_{false};
    bool running_ = false;
    SingleThread worker_{100};
};

/// Work with an OpenGL context of its own current; it ends at once where none can be had.
BackgroundJob::Work withContext(BackgroundJob::Work work);

/// How work ends that was finished, or cancelled before, with these problems.
BackgroundJob::End endOf(bool finished, const Errors& problems);

} // namespace patina

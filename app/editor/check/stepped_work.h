// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <memory>

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QThreadPool>

#include "core/error.h"

namespace patina {

/// Work that goes on in steps, in a thread with an OpenGL context of its own, and can be cancelled.
class SteppedWork : public QObject {
    Q_OBJECT

  public:
    /// What is done. Made, used and destroyed in the thread, with the context current.
    class Job {
      public:
        virtual ~Job() = default;
        virtual void step() = 0;
        virtual bool finished() const = 0;
        virtual double progress() const = 0; ///< 0 .. 1
        virtual QString doing() const = 0;   ///< "model 3 of 20: Phong"
        virtual const Errors& problems() const = 0;

        /// What there is to show since the last call, as a function that this object's thread
        /// calls; empty: nothing new.
        virtual std::function<void()> news() = 0;
    };
    using Maker = std::function<Result<std::unique_ptr<Job>>()>;

    explicit SteppedWork(QObject* parent = nullptr);
    ~SteppedWork() override;

    /// Nothing happens while something is going on.
    void start(Maker make);
    void cancel();
    bool isRunning() const { return running_; }

  Q_SIGNALS:
    void progressed(double share, const QString& doing); ///< see Job
    /// Also after cancel(); `problem`: why it ended before its time, else empty.
    void finished(bool complete, QString problem);

  private:
    struct End {
        bool complete = false;
        QString problem;
    };

    End work(const Maker& make);
    void tell(Job& job, QElapsedTimer& sinceTold);

    std::atomic<bool> cancelled_{false};
    bool running_ = false;
    QThreadPool worker_;
};

} // namespace patina

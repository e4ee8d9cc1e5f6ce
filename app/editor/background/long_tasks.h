// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <vector>

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>

namespace patina {

/// How far work is that goes on beside the window.
struct TaskState {
    double share = -1.0; ///< 0 .. 1; below 0 while it is not known
    QString doing{};     ///< what of it is done now; may be empty
};

/// Work that takes long, as whoever does it tells of it.
struct LongTask {
    QString name;
    std::function<TaskState()> state{}; ///< empty: nothing is known
    std::function<void()> cancel{};     ///< empty: it cannot be stopped
};

/// All that takes long in the program, in one place: whoever works beside the window reports to it.
/// What ends soon is not shown. Used in the window's thread.
class LongTasks : public QObject {
    Q_OBJECT

  public:
    /// The program's.
    static LongTasks& all();

    explicit LongTasks(QObject* parent = nullptr);

    /// Returns a number for end(); never 0.
    quint64 begin(LongTask task);
    void end(quint64 number);

    struct Row {
        quint64 number = 0;
        QString name;
        TaskState state;
        bool canCancel = false;
    };
    /// All that goes on, the oldest first; and what has gone on for a while.
    std::vector<Row> running() const;
    std::vector<Row> shown() const;

    void cancel(quint64 number);

  Q_SIGNALS:
    /// Now and then, while something is shown.
    void changed();

  private:
    struct Running {
        LongTask task;
        QElapsedTimer since;
        bool isShown = false;
    };

    void look();
    std::vector<Row> rows(bool all) const;

    std::map<quint64, Running> running_;
    quint64 last_ = 0;
    QTimer timer_;
};

} // namespace patina

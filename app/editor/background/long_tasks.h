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

/// Says how far work in the background is.
struct TaskState {
    double share = -1.0; ///< 0 .. 1; below 0 while it is unknown
    QString doing{};     ///< says what is being done now; may be empty
};

/// Describes work that takes long, for those who show it.
struct LongTask {
    QString name;
    std::function<TaskState()> state{}; ///< is empty if nothing is known
    std::function<void()> cancel{};     ///< is empty if it cannot be cancelled
};

/// Collects all work in the background in one place, for those who show it. Work that ends soon is
/// not shown. Must be used in the window's thread.
class LongTasks : public QObject {
    Q_OBJECT

  public:
    /// Returns the one of the program, which the application object owns.
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
    /// Return all work that goes on, oldest first, and of that what has gone on for 300 ms and
    /// more.
    std::vector<Row> running() const;
    std::vector<Row> shown() const;

    void cancel(quint64 number);

  Q_SIGNALS:
    /// Is emitted every 100 ms while something is shown, and when that ends.
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

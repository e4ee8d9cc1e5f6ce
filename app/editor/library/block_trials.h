// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <string>

#include <QObject>
#include <QThreadPool>

#include "catalog/catalog.h"
#include "shading/program_source.h"

namespace patina {

/// Compiles the user's blocks in a thread with a context of its own, so that a mistake is told when
/// it is made and not first when the block is chosen. What was compiled once is not again.
class BlockTrials : public QObject {
    Q_OBJECT

  public:
    explicit BlockTrials(QObject* parent = nullptr);

    /// Waits for the block that it works on.
    ~BlockTrials() override;

    /// finished() follows, unless another run is wished meanwhile.
    void run(std::shared_ptr<const Catalog> catalog);

  Q_SIGNALS:
    /// All mistakes in the user's shaders, at their files' own lines.
    void finished(const patina::Errors& mistakes);

  private:
    class Compiler;

    Errors mistakesIn(const Catalog& catalog, quint64 number);
    Errors mistakesIn(const Checked<ProgramSource>& source, Compiler& compiler);

    std::map<std::string, Errors> known_; ///< by the hash of the program; the thread's
    std::atomic<quint64> wished_ = 0;     ///< the number of the last run
    QThreadPool thread_;
};

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <QImage>
#include <QObject>

#include "background/worker.h"
#include "measure/cells/sheet_maker.h"

namespace patina {

/// Represents one cell as far as it is made.
struct SheetCell {
    QImage picture{}; ///< null: it is not drawn yet, or cannot be
    CellNumbers numbers{};
    QString problem{};    ///< why it cannot be; empty: it can
    bool isDue = true;    ///< what is shown here is older than what was asked for
    bool isShown = false; ///< it is what the document shows
};

/// Represents a plan with its cells, row by row.
struct PlannedSheet {
    std::shared_ptr<const SheetPlan> plan;
    Sheet sheet; ///< that was asked for
    std::vector<SheetCell> cells;
};

/// Why there is no plan.
struct SheetRefusal {
    QString text;
    bool isXDead = false; ///< there is nothing that the axis could be of
    bool isYDead = false;
};

/// Tells how a sheet ended.
struct SheetEnd {
    int drawn = 0; ///< cells, but for those that were there
    bool isWhole = false;
    QString problem{}; ///< why nothing could be drawn
};

/// Plans, draws and measures sheets in a thread with a context of its own, cell by cell: pictures
/// before numbers, in the fitted light of an environment. Cells whose scene is the same as before
/// are not drawn again.
class SheetDrawing : public QObject {
    Q_OBJECT

  public:
    struct Request {
        Sheet sheet;
        std::shared_ptr<const Scene> start;
        Scene shown;            ///< by the document; a cell that shows it is marked
        std::size_t object = 0; ///< that the sheet is of
        std::shared_ptr<const Catalog> catalog;
        MeshSource meshes; ///< for other threads, as are the next
        TextureSource textures;
        std::string panoramaFile; ///< of the start's environment; empty: none
        CellMaker::Panorama panorama;
        int revision = 0; ///< another one where meshes or pictures have changed
    };

    explicit SheetDrawing(std::filesystem::path programCache, QObject* parent = nullptr);
    ~SheetDrawing() override;

    /// Asks in place of what was asked for before. planned() or refused() follows, then drawn() for
    /// each cell that is made or measured, and finished().
    void ask(Request request);

    /// Gives up what is being drawn; finished() follows.
    void cancel();

    /// Draws the sheet as `patina sheet` does, into a file; written() follows, unless it was
    /// cancelled.
    void write(Request request, const std::filesystem::path& file);
    void cancelWriting();

    bool isDrawing() const { return drawing_ != nullptr; }
    bool isWriting() const { return writing_ != nullptr; }

  Q_SIGNALS:
    void planned(const patina::PlannedSheet& sheet);
    void refused(const patina::SheetRefusal& why);
    void drawn(int index, const patina::SheetCell& cell);
    void finished(const patina::SheetEnd& end);
    void progressed(double share, const QString& doing); ///< share: 0 .. 1
    /// Tells where the sheet is. An empty file: it was cancelled, and nothing is written.
    void written(const QString& file, const patina::Errors& problems);

  private:
    class Studio;
    class Work;

    std::shared_ptr<Progress> drawing_; ///< null while nothing is drawn
    std::shared_ptr<Progress> writing_;
    int asked_ = 0;              ///< how often
    std::unique_ptr<Work> work_; ///< of the worker's thread
    Worker worker_;
};

} // namespace patina

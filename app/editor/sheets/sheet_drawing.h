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

/// Holds one cell as far as it is made.
struct SheetCell {
    QImage picture{}; ///< is null while it is not drawn, or cannot be
    CellNumbers numbers{};
    QString problem{};    ///< says why it cannot be drawn; empty where it can
    bool isDue = true;    ///< says that the picture is older than what was asked for
    bool isShown = false; ///< says that it is what the document shows
};

/// Holds a plan with its cells, row by row.
struct PlannedSheet {
    std::shared_ptr<const SheetPlan> plan;
    Sheet sheet; ///< is the one that was asked for
    std::vector<SheetCell> cells;
};

/// Says why there is no plan.
struct SheetRefusal {
    QString text;
    bool isXDead = false; ///< says that there is nothing the axis could be of
    bool isYDead = false;
};

/// Says how the drawing of a sheet ended.
struct SheetEnd {
    int drawn = 0; ///< counts the cells that were drawn, not those kept
    bool isWhole = false;
    QString problem{}; ///< says what could not be drawn or measured, and why
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
        Scene shown;            ///< is what the document shows; a cell that shows it is marked
        std::size_t object = 0; ///< is the object that the sheet is of
        std::shared_ptr<const Catalog> catalog;
        MeshSource meshes; ///< may be called in other threads, as may the next
        TextureSource textures;
        std::string panoramaFile; ///< is that of the start's environment; empty where it has none
        CellMaker::Panorama panorama;
        int revision = 0; ///< is another one where meshes or pictures have changed
    };

    explicit SheetDrawing(std::filesystem::path programCache, QObject* parent = nullptr);
    ~SheetDrawing() override;

    /// Asks in place of what was asked for before. planned() or refused() follows, then drawn() for
    /// each cell that is made or measured, and finished().
    void ask(Request request);

    /// Gives up what is being drawn; finished() follows.
    void cancel();

    /// Draws the sheet as `patina sheet` does, into a file; written() follows.
    void write(Request request, const std::filesystem::path& file);
    void cancelWriting();

    bool isDrawing() const { return drawing_ != nullptr; }
    bool isWriting() const { return writing_ != nullptr; }

  Q_SIGNALS:
    void planned(const patina::PlannedSheet& sheet);
    void refused(const patina::SheetRefusal& why);
    void drawn(int index, const patina::SheetCell& cell);
    void finished(const patina::SheetEnd& end);
    void progressed(double share, const QString& doing); ///< `share` is 0 .. 1
    /// Writing has ended. The file is empty where it was cancelled and nothing was written.
    void written(const QString& file, const patina::Errors& problems);

  private:
    class Studio;
    class Work;

    std::shared_ptr<Progress> drawing_; ///< is null while nothing is drawn
    std::shared_ptr<Progress> writing_;
    int asked_ = 0;              ///< counts the calls of ask()
    std::unique_ptr<Work> work_; ///< is used in the worker's thread only
    Worker worker_;
};

} // namespace patina

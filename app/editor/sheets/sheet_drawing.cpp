// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheets/sheet_drawing.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include "library/as_picture.h"
#include "render/lights/environment_image.h"
#include "scene/environment.h"
#include "text/as_text.h"

namespace patina {
namespace {

/// The context is kept for so long, for the next edit.
constexpr std::chrono::seconds patience{3};

bool haveSameSteps(const Sheet& a, const Sheet& b) {
    return a.x == b.x && a.y == b.y && a.hasControlRow == b.hasControlRow;
}

/// Says why a sheet cannot be planned, and which of its axes go through nothing that there is.
SheetRefusal refusalOf(const SheetDrawing::Request& request, const Errors& errors) {
    SheetRefusal refusal{asText(text(errors)).trimmed()};
    const auto isAlive = [&request](const SheetAxis& axis) {
        return SheetPlan::of(Sheet{.x = axis}, *request.start, request.object, request.catalog)
            .has_value();
    };
    refusal.isXDead = !isAlive(request.sheet.x);
    refusal.isYDead = request.sheet.y && !isAlive(*request.sheet.y);
    return refusal;
}

} // namespace

/// Draws the cells of sheets with one renderer, which is kept until the worker rests.
class SheetDrawing::Studio {
  public:
    /// Makes a studio; the worker's context must be current.
    static Result<std::unique_ptr<Studio>> open(const std::filesystem::path& programCache) {
        return Renderer::create({programCache}).map([&](std::unique_ptr<Renderer> renderer) {
            return std::make_unique<Studio>(programCache, std::move(renderer));
        });
    }

    Studio(std::filesystem::path programCache, std::unique_ptr<Renderer> renderer)
        : programCache_(std::move(programCache)), renderer_(std::move(renderer)) {}

    /// Returns the maker of a request's cells: for a file of this form, or without a form for the
    /// window.
    CellMaker& cellsOf(const Request& request, std::optional<SheetForm> form) {
        if (!cells_ || request.catalog != catalog_) {
            catalog_ = request.catalog;
            renderer_->setCatalog(catalog_);
            cells_.reset();
        }
        meshes_ = request.meshes;
        textures_ = request.textures;
        panoramaFile_ = request.panoramaFile;
        panorama_ = request.panorama;
        pixels_ = request.sheet.cellPixels;
        form_ = form;
        renderer_->setTextures(textures_);
        if (!cells_ || request.revision != revision_) {
            revision_ = request.revision;
            cells_.emplace(supplies());
        }
        return *cells_;
    }

  private:
    CellMaker::Supplies supplies() {
        return {{catalog_, [this](const Object& object) { return meshes_(object); },
                 [this](const TextureUse& use, TextureDecoding decoding) {
                     return textures_(use, decoding);
                 }},
                programCache_,
                [this](const Scene& scene) { return panoramaOf(scene); },
                [this](const Scene& scene, const CellMaker::Panorama& panorama) {
                    return picture(scene, panorama);
                }};
    }

    /// Returns the picture of a scene's environment. Sheets name no files, so any picture but the
    /// document's is missing.
    Result<CellMaker::Panorama> panoramaOf(const Scene& scene) const {
        const Block* block = blockOf(scene.parts, kinds::environment, *catalog_);
        const std::string_view file = block == nullptr
                                          ? std::string_view()
                                          : pictureFile(*scene.part(kinds::environment), *block);
        return file.empty()            ? CellMaker::Panorama()
               : file == panoramaFile_ ? panorama_
                                       : EnvironmentImage::missing();
    }

    Checked<Image> picture(const Scene& scene, const CellMaker::Panorama& panorama) {
        View view;
        view.size = glm::ivec2(pixels_);
        view.camera = scene.camera;
        view.environmentImage = panorama;
        view.isMoving = !form_;
        view.environmentSamples = form_ ? unaskedDirections(scene, *catalog_) : 0;
        auto image = renderer_->capture(scene, view, meshes_, form_ != SheetForm::Linear);
        const FrameReport& report = renderer_->report();
        if (!image || report.messages.size() > report.warnings) {
            return tl::unexpected(image ? report.messages : oneError(image.error()));
        }
        return std::move(*image);
    }

    std::filesystem::path programCache_;
    std::unique_ptr<Renderer> renderer_;
    std::shared_ptr<const Catalog> catalog_;
    MeshSource meshes_;
    TextureSource textures_;
    std::string panoramaFile_;
    CellMaker::Panorama panorama_;
    int pixels_ = 0;
    std::optional<SheetForm> form_;
    int revision_ = 0;
    std::optional<CellMaker> cells_; ///< is destroyed first, because it uses the members above
};

/// Holds what the worker's thread knows: the last sheet with its cells, and what draws them.
class SheetDrawing::Work {
  public:
    Work(SheetDrawing& drawing, std::filesystem::path programCache)
        : drawing_(drawing), programCache_(std::move(programCache)) {}

    SheetEnd draw(const Request& request, Worker::Control& control);
    Checked<bool> write(const Request& request, const std::filesystem::path& file,
                        Worker::Control& control);
    void rest() { studio_.reset(); }

  private:
    struct Cell {
        SheetCell look;
        bool isDrawn = false;
        std::vector<CellNumber> measured{};
    };

    bool plan(const Request& request, const Worker::Control& control);
    Cell planned(const SheetPlan& plan, const Request& request, int column, int row) const;
    const Cell* before(const SheetPlan& plan, const Request& request, int column, int row) const;
    bool isSameAsBefore(const Scene& scene, const SheetPlan& plan, int column, int row) const;
    std::vector<int> ownCells() const;
    std::vector<CellNumber> missingOf(const Cell& cell) const;
    void drawCell(int index, CellMaker& cells);
    void measureCell(int index, CellMaker& cells, const Worker::Control& control);
    void show(int index, const Worker::Control& control);
    Result<Studio*> studio(const Worker::Control& control);

    SheetDrawing& drawing_;
    std::filesystem::path programCache_;
    Request request_; ///< is the one that the cells were planned for
    std::shared_ptr<const SheetPlan> plan_;
    std::vector<Cell> cells_;
    std::unique_ptr<Studio> studio_;
};

/// Plans the cells and hands the sheet over; returns false where there is no plan.
bool SheetDrawing::Work::plan(const Request& request, const Worker::Control& control) {
    std::shared_ptr<const SheetPlan> plan = plan_;
    const bool isSame = plan_ && request_.start == request.start &&
                        request_.object == request.object && request_.catalog == request.catalog &&
                        haveSameSteps(request_.sheet, request.sheet);
    if (!isSame) {
        auto fresh = SheetPlan::of(request.sheet, *request.start, request.object, request.catalog);
        if (!fresh) {
            control.show([drawing = &drawing_, why = refusalOf(request, fresh.error())] {
                Q_EMIT drawing->refused(why);
            });
            return false;
        }
        plan = std::make_shared<const SheetPlan>(std::move(*fresh));
    }
    std::vector<Cell> cells;
    PlannedSheet sheet{plan, request.sheet, {}};
    for (int i = 0; i < plan->columns() * plan->rows(); ++i) {
        cells.push_back(planned(*plan, request, i % plan->columns(), i / plan->columns()));
        sheet.cells.push_back(cells.back().look);
    }
    plan_ = std::move(plan);
    cells_ = std::move(cells);
    request_ = request;
    control.show(
        [drawing = &drawing_, sheet = std::move(sheet)] { Q_EMIT drawing->planned(sheet); });
    return true;
}

/// Returns a cell as it is before anything is drawn: one whose scene is as before keeps its
/// picture, one in the place of another shows that one's until its own is there.
SheetDrawing::Work::Cell SheetDrawing::Work::planned(const SheetPlan& plan, const Request& request,
                                                     int column, int row) const {
    const Result<Scene> scene = plan.scene(column, row);
    Cell cell;
    if (!scene) {
        cell.look.problem = asText(scene.error().problem);
        cell.look.isDue = false;
        return cell;
    }
    if (const Cell* former = before(plan, request, column, row)) {
        const bool isKept = former->isDrawn && request_.catalog == request.catalog &&
                            request_.revision == request.revision &&
                            request_.sheet.cellPixels == request.sheet.cellPixels &&
                            isSameAsBefore(*scene, plan, column, row);
        cell.look.picture = former->look.picture;
        if (isKept) {
            cell = *former;
        }
    }
    cell.look.isDue = !cell.isDrawn;
    cell.look.isShown = *scene == request.shown;
    return cell;
}

/// Returns the cell that was in this place; null where there was none, or one of something else.
const SheetDrawing::Work::Cell* SheetDrawing::Work::before(const SheetPlan& plan,
                                                           const Request& request, int column,
                                                           int row) const {
    const bool isAlike = plan_ && plan_->columns() == plan.columns() &&
                         plan_->rows() == plan.rows() &&
                         plan_->isControl(row) == plan.isControl(row) &&
                         request_.sheet.x.kind == request.sheet.x.kind;
    return isAlike ? &cells_[static_cast<std::size_t>(row * plan.columns() + column)] : nullptr;
}

bool SheetDrawing::Work::isSameAsBefore(const Scene& scene, const SheetPlan& plan, int column,
                                        int row) const {
    if (&plan == plan_.get()) {
        return true;
    }
    const Result<Scene> former = plan_->scene(column, row);
    return former && *former == scene;
}

/// Returns the indices of cells that have a picture of their own: all of the control row share one.
std::vector<int> SheetDrawing::Work::ownCells() const {
    std::vector<int> own;
    for (int i = 0; i < static_cast<int>(cells_.size()); ++i) {
        const bool isFirst = i % plan_->columns() == 0;
        const bool isOwn = isFirst || !plan_->isControl(i / plan_->columns());
        if (isOwn && cells_[static_cast<std::size_t>(i)].look.problem.isEmpty()) {
            own.push_back(i);
        }
    }
    return own;
}

std::vector<CellNumber> SheetDrawing::Work::missingOf(const Cell& cell) const {
    std::vector<CellNumber> numbers = request_.sheet.numbers;
    std::erase_if(numbers, [&cell](CellNumber number) {
        return std::ranges::find(cell.measured, number) != cell.measured.end();
    });
    return numbers;
}

SheetEnd SheetDrawing::Work::draw(const Request& request, Worker::Control& control) {
    SheetEnd end;
    if (!plan(request, control)) {
        return end;
    }
    std::vector<int> due = ownCells();
    std::vector<int> unmeasured = due;
    std::erase_if(due, [this](int i) { return cells_[static_cast<std::size_t>(i)].isDrawn; });
    std::erase_if(unmeasured,
                  [this](int i) { return missingOf(cells_[static_cast<std::size_t>(i)]).empty(); });
    if (due.empty() && unmeasured.empty()) {
        end.isWhole = true;
        return end;
    }
    const Result<Studio*> studio = this->studio(control);
    if (!studio) {
        end.problem = asText(studio.error().text());
        return end;
    }
    CellMaker& cells = (*studio)->cellsOf(request_, std::nullopt);
    const double all = double(due.size() + unmeasured.size());
    for (std::size_t i = 0; i < due.size() && !control.isCancelled(); ++i) {
        control.report(double(i) / all,
                       SheetDrawing::tr("Cell %1 of %2").arg(i + 1).arg(due.size()));
        drawCell(due[i], cells);
        show(due[i], control);
        ++end.drawn;
    }
    for (std::size_t i = 0; i < unmeasured.size() && !control.isCancelled(); ++i) {
        control.report(double(due.size() + i) / all,
                       SheetDrawing::tr("Measuring %1 of %2").arg(i + 1).arg(unmeasured.size()));
        measureCell(unmeasured[i], cells, control);
        show(unmeasured[i], control);
    }
    if (const auto& problem = cells.meterProblem()) {
        end.problem = asText(problem->text());
    }
    end.isWhole = !control.isCancelled();
    return end;
}

void SheetDrawing::Work::drawCell(int index, CellMaker& cells) {
    Cell& cell = cells_[static_cast<std::size_t>(index)];
    const Result<Scene> scene = plan_->scene(index % plan_->columns(), index / plan_->columns());
    if (!scene) {
        return;
    }
    const Checked<Image> image = cells.draw(*scene);
    cell.isDrawn = true;
    cell.measured.clear();
    cell.look.numbers = {};
    cell.look.isDue = false;
    cell.look.picture = image ? asPicture(*image) : QImage();
    cell.look.problem = image ? QString() : asText(text(image.error())).trimmed();
}

void SheetDrawing::Work::measureCell(int index, CellMaker& cells, const Worker::Control& control) {
    Cell& cell = cells_[static_cast<std::size_t>(index)];
    const Result<Scene> scene = plan_->scene(index % plan_->columns(), index / plan_->columns());
    if (!scene || !cell.look.problem.isEmpty()) {
        return;
    }
    const std::vector<CellNumber> kinds = missingOf(cell);
    const CellNumbers fresh =
        cells.measure(*scene, plan_->object(), kinds, request_.sheet.cellPixels,
                      [&control] { return control.isCancelled(); });
    if (control.isCancelled()) {
        return;
    }
    CellNumbers& held = cell.look.numbers;
    held.milliseconds = fresh.milliseconds ? fresh.milliseconds : held.milliseconds;
    held.error = fresh.error ? fresh.error : held.error;
    held.albedo = fresh.albedo ? fresh.albedo : held.albedo;
    cell.measured.insert(cell.measured.end(), kinds.begin(), kinds.end());
}

/// Hands a cell over; the first one of the control row stands for that whole row.
void SheetDrawing::Work::show(int index, const Worker::Control& control) {
    const int columns = plan_->columns();
    const int last = plan_->isControl(index / columns) ? index + columns : index + 1;
    const Cell& made = cells_[static_cast<std::size_t>(index)];
    for (int i = index; i < last; ++i) {
        cells_[static_cast<std::size_t>(i)] = made;
        control.show(
            [drawing = &drawing_, i, look = made.look] { Q_EMIT drawing->drawn(i, look); });
    }
}

Result<SheetDrawing::Studio*> SheetDrawing::Work::studio(const Worker::Control& control) {
    if (!studio_) {
        auto opened =
            control.openContext().and_then([this] { return Studio::open(programCache_); });
        if (!opened) {
            return tl::unexpected(opened.error());
        }
        studio_ = std::move(*opened);
    }
    return studio_.get();
}

/// Returns false where it was stopped before its end.
Checked<bool> SheetDrawing::Work::write(const Request& request, const std::filesystem::path& file,
                                        Worker::Control& control) {
    const auto plan = SheetPlan::of(request.sheet, *request.start, request.object, request.catalog);
    if (!plan) {
        return tl::unexpected(plan.error());
    }
    const Result<Studio*> studio = this->studio(control);
    if (!studio) {
        return tl::unexpected(oneError(studio.error()));
    }
    const SheetForm form = sheetFormOf(file);
    SheetMaker maker(*plan, request.sheet, form, (*studio)->cellsOf(request, form));
    const auto isWhole = maker.run([&control](int done, int cells) {
        control.report(double(done) / double(cells),
                       SheetDrawing::tr("Writing: cell %1 of %2").arg(done + 1).arg(cells));
        return !control.isCancelled();
    });
    if (!isWhole || !*isWhole) {
        return isWhole;
    }
    AssetClient client;
    const auto written = maker.write(file, client);
    return written ? isWhole : tl::unexpected(oneError(written.error()));
}

SheetDrawing::SheetDrawing(std::filesystem::path programCache, QObject* parent)
    : QObject(parent), work_(std::make_unique<Work>(*this, std::move(programCache))),
      worker_({.priority = QThread::LowPriority, // the views come first
               .patience = patience,
               .atRest = [this] { work_->rest(); }}) {
    connect(&worker_, &Worker::progressed, this, &SheetDrawing::progressed);
}

SheetDrawing::~SheetDrawing() = default;

void SheetDrawing::ask(Request request) {
    cancel();
    drawing_ = worker_.ask(
        [this, request = std::move(request)](Worker::Control& control) {
            return work_->draw(request, control);
        },
        [this, number = ++asked_](const Result<SheetEnd>& end) {
            if (number == asked_) { // else it was given up for the next one
                drawing_.reset();
                Q_EMIT finished(end ? *end : SheetEnd{0, false, asText(end.error().text())});
            }
        },
        QStringLiteral("sheet"));
}

void SheetDrawing::cancel() {
    if (drawing_) {
        drawing_->cancelled = true;
    }
}

void SheetDrawing::write(Request request, const std::filesystem::path& file) {
    cancelWriting();
    writing_ =
        worker_.ask([this, request = std::move(request), file](
                        Worker::Control& control) { return work_->write(request, file, control); },
                    [this, file](const Checked<bool>& isWhole) {
                        writing_.reset();
                        const bool isThere = isWhole && *isWhole;
                        Q_EMIT written(isThere || !isWhole ? asText(file.string()) : QString(),
                                       isWhole ? Errors() : isWhole.error());
                    },
                    QStringLiteral("file"));
}

void SheetDrawing::cancelWriting() {
    if (writing_) {
        writing_->cancelled = true;
    }
}

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lobe/lobe_dock.h"

#include <algorithm>
#include <initializer_list>
#include <numbers>

#include <QAction>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

#include "accuracy/chart_export.h"
#include "docks/elided_label.h"
#include "docks/panel.h"
#include "lobe/lobe_plots.h"
#include "material/preset_file.h"
#include "measure/error/parallel.h"
#include "measure/eval/eval_gpu.h"
#include "parameters/dropped_files.h"
#include "session/message_log.h"
#include "shading/effects/key_light.h"
#include "text/as_text.h"
#include "text/display_number.h"
#include "viewport/compare_area.h"

namespace patina {
namespace {

constexpr int maxNoteLines = 2;
constexpr int restMs = 200; ///< is how long values rest before the sketch becomes the plot

/// Is what the worker found for materials of which nothing was known.
struct Found {
    std::vector<SharedAnswer> answers;
    bool isWanted = true; ///< is false where the answers ended early
};

/// Computes what is null among the answers. It runs in the worker's thread. The device is asked
/// when values rest, as its context takes a while.
Found completed(std::vector<SharedAnswer> answers, const std::vector<LobeMaterial>& materials,
                const LobeQuestion& question, const Catalog& catalog, Worker::Control& control) {
    const bool isSketch = question.lines.isSketch;
    // Every sketch is shown, so that ticks that come faster still move the plot.
    const auto isWanted = [&control, isSketch] {
        return !control.isCancelled() && (isSketch || !control.isSuperseded());
    };
    std::vector<std::size_t> missing;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        if (answers[i] == nullptr) {
            missing.push_back(i);
        }
    }
    const auto answer = [&](std::size_t begin, std::size_t end, EvalGpu* device) {
        for (std::size_t i = begin; i < end; ++i) {
            answers[missing[i]] =
                lobeAnswer(materials[missing[i]], question, catalog, isWanted, device);
        }
    };
    if (isSketch && missing.size() > 1) {
        inParallel(missing.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
            answer(begin, end, nullptr);
        });
    } else {
        EvalGpu device;
        answer(0, missing.size(), isSketch ? nullptr : &device);
    }
    return {std::move(answers), isWanted()};
}

} // namespace

LobeDock::LobeDock(const DockContext& context)
    : document_(context.document), tried_(context.tried), messages_(context.messages),
      views_(context.views), plots_(new LobePlots(context.document, this)),
      scale_(new QComboBox(this)), term_(new QComboBox(this)), snapshots_(new QAction(this)),
      forget_(textButton(tr("Without Presets"), tr("Take the presets that were dropped here away"),
                         this)),
      note_(new ElidedLabel(this)), times_(new LobeTimes(context, this)),
      worker_({.name = tr("Plotting the reflectance")}) {
    setAcceptDrops(true);
    forget_->setObjectName("forget presets");
    forget_->hide();
    settle_.setSingleShot(true);
    settle_.setInterval(restMs);
    note_->setObjectName("note");
    note_->setMaxLines(maxNoteLines);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 4, 6, 2);
    layout->setSpacing(4);
    layout->addWidget(makeControls());
    layout->addWidget(plots_, 1);
    layout->addWidget(note_);
    connectParts(context);
}

QWidget* LobeDock::makeControls() {
    scale_->setObjectName("scale");
    scale_->setAccessibleName(tr("Scale"));
    scale_->addItem(tr("Linear"), static_cast<int>(LobeScale::Linear));
    scale_->addItem(tr("Cube root"), static_cast<int>(LobeScale::CubeRoot));
    scale_->addItem(tr("Log"), static_cast<int>(LobeScale::Log));
    term_->setObjectName("term");
    term_->setAccessibleName(tr("Term"));
    term_->addItem(tr("Whole"), static_cast<int>(LobeTerm::Whole));
    term_->addItem(tr("Diffuse"), static_cast<int>(LobeTerm::Diffuse));
    term_->addItem(tr("Highlight"), static_cast<int>(LobeTerm::Highlight));
    term_->addItem(tr("Distribution"), static_cast<int>(LobeTerm::Distribution));
    term_->addItem(tr("Masking"), static_cast<int>(LobeTerm::Masking));
    term_->addItem(tr("Fresnel"), static_cast<int>(LobeTerm::Fresnel));
    snapshots_->setText(tr("&Snapshots"));
    snapshots_->setToolTip(tr("Show the snapshots beside what is on screen, five in all"));
    snapshots_->setCheckable(true);
    auto* overlay = new QToolButton(this);
    overlay->setDefaultAction(snapshots_);
    overlay->setObjectName("snapshots overlaid");
    auto* write = textButton(tr("Export"), tr("Write the plot to a file"), this);
    auto* menu = new QMenu(write);
    for (const QString& ending :
         {QStringLiteral("svg"), QStringLiteral("png"), QStringLiteral("csv")}) {
        menu->addAction(tr("As %1…").arg(ending.toUpper()), this, [this, ending] {
            const QString file = askForChartFile(this, ending, QStringLiteral("lobe"));
            if (!file.isEmpty()) {
                exportTo(file);
            }
        });
    }
    write->setMenu(menu);
    write->setPopupMode(QToolButton::InstantPopup);
    auto* row = new QWidget(this);
    auto* widgets = new QHBoxLayout(row);
    widgets->setContentsMargins(0, 0, 0, 0);
    for (QWidget* widget : std::initializer_list<QWidget*>{scale_, term_, makePick(),
                                                           times_->button(), overlay, forget_}) {
        widgets->addWidget(widget);
    }
    widgets->addStretch(1);
    widgets->addWidget(write);
    return row;
}

QToolButton* LobeDock::makePick() {
    auto* pick = textButton(tr("Pick"),
                            tr("Click a place on an object: take its light and its viewer"), this);
    pick->setObjectName("pick incidence");
    connect(pick, &QToolButton::clicked, this, [this] { views_.active().awaitSurfacePick(); });
    for (SideView* view : views_.views()) {
        watchPicks(*view);
    }
    connect(&views_, &CompareArea::viewAdded, this, [this](SideView* view) { watchPicks(*view); });
    return pick;
}

void LobeDock::watchPicks(SideView& view) {
    connect(&view, &SideView::surfacePicked, this,
            [this, &view](const Hit& hit) { takePick(view, hit); });
}

void LobeDock::takePick(SideView& view, const Hit& hit) {
    const Scene& scene = document_.scene(view.side());
    const int chosen = document_.selection().light();
    const auto light = chosen >= 0 ? std::optional(static_cast<std::size_t>(chosen))
                                   : keyLight(scene, document_.catalog());
    picked_ = light ? incidenceAt(hit, scene, document_.catalog(), view.viewport().camera(), *light)
                    : std::nullopt;
    if (!picked_) {
        forgetPick();
        isStale_ = true;
        follow();
        say(&Note::event, tr("No light reaches that place."));
        return;
    }
    plots_->setPicked(picked_);
    isStale_ = true;
    follow();
}

void LobeDock::forgetPick() {
    picked_.reset();
    plots_->setPicked(std::nullopt);
}

void LobeDock::say(QString Note::*part, const QString& text) {
    said_.*part = text;
    QStringList all{said_.event, said_.times, said_.answers};
    all.removeAll(QString());
    note_->setElidedText(all.join(' '));
    note_->setAccessibleDescription(all.join(' '));
}

void LobeDock::connectParts(const DockContext& context) {
    const auto follow = [this] { this->follow(); };
    const auto again = [this] {
        isStale_ = true;
        this->follow();
    };
    const auto anew = [this, again] {
        answers_.clear();
        shown_.clear();
        again();
    };
    onChange(document_, DocumentChange::Drawn | DocumentChange::Current | DocumentChange::Snapshots,
             this, follow);
    onChange(document_, DocumentChange::Catalog, this, anew);
    connect(&context.tried, &TriedMaterial::changed, this, follow);
    connect(snapshots_, &QAction::toggled, this, follow);
    connect(forget_, &QToolButton::clicked, this, [this] {
        dropped_.clear();
        forget_->hide();
        this->follow();
    });
    connect(plots_, &QTabWidget::currentChanged, this, again);
    connect(term_, &QComboBox::currentIndexChanged, this, again);
    connect(scale_, &QComboBox::currentIndexChanged, this,
            [this] { plots_->setScale(static_cast<LobeScale>(scale_->currentData().toInt())); });
    connect(plots_, &LobePlots::lightTurned, this, [this, again] {
        forgetPick();
        again();
    });
    connect(times_, &LobeTimes::changed, this, [this] {
        plots_->setDetails(times_->times());
        say(&Note::times, times_->note());
    });
    connect(&settle_, &QTimer::timeout, this, [this] { ask(false); });
}

void LobeDock::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    follow();
}

void LobeDock::dragEnterEvent(QDragEnterEvent* event) {
    acceptFiles(*event);
}

void LobeDock::dropEvent(QDropEvent* event) {
    acceptCopy(*event);
    QStringList refused;
    for (const auto& file : draggedFiles(*event->mimeData())) {
        if (const auto name = addPreset(file.toStdString()); !name.isEmpty()) {
            refused << name;
        }
    }
    forget_->setVisible(!dropped_.empty());
    follow();
    say(&Note::event, refused.isEmpty() ? QString()
                                        : tr("No room for %1: the plot holds %2 materials.")
                                              .arg(refused.join(QStringLiteral(", ")))
                                              .arg(maxLobeSubjects));
}

QString LobeDock::addPreset(const std::filesystem::path& file) {
    const auto reading = readPreset(file, document_.catalog());
    if (!reading) {
        for (const Error& error : reading.error()) {
            messages_.add(error);
        }
        return {};
    }
    const std::string& own = reading->material.name;
    const std::string name = own.empty() ? file.filename().string() : own;
    if (shownMaterials().size() >= maxLobeSubjects) {
        return asText(name);
    }
    dropped_.push_back({name, reading->material});
    return {};
}

void LobeDock::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    settle_.stop();
    worker_.forget();
    times_->cancel();
    isStale_ = true;
}

std::vector<LobeMaterial> LobeDock::shownMaterials() const {
    std::vector<LobeMaterial> all = lobeMaterials(document_, tried_, snapshots_->isChecked());
    for (const LobeMaterial& each : dropped_) {
        if (all.size() < maxLobeSubjects) {
            all.push_back(each);
        }
    }
    return all;
}

/// Sketches what changed, unless the dock is not seen; showEvent() catches up.
void LobeDock::follow() {
    if (!isVisible()) {
        return;
    }
    std::vector<LobeMaterial> now = shownMaterials();
    if (!isStale_ && now == materials_) {
        return;
    }
    materials_ = std::move(now);
    times_->setMaterials(materials_);
    isStale_ = false;
    say(&Note::event, {});
    ask(true);
    settle_.start();
}

void LobeDock::ask(bool isSketch) {
    const LobePage page = plots_->page();
    LobeQuestion question{page, {}};
    question.lines.plot = linesOf(page);
    question.lines.incoming =
        picked_ ? picked_->incoming() : Incoming{plots_->light() * std::numbers::pi / 180.0, 0.0};
    question.lines.term = static_cast<LobeTerm>(term_->currentData().toInt());
    question.lines.isSketch = isSketch;
    scale_->setEnabled(page == LobePage::Polar || page == LobePage::Solid ||
                       page == LobePage::Slice);
    term_->setEnabled(page != LobePage::Fresnel && page != LobePage::Spectrum &&
                      page != LobePage::Float32 && page != LobePage::Float16);
    std::vector<SharedAnswer> known = answers_.known(materials_, question);
    const auto missing = std::ranges::count(known, nullptr);
    worker_.ask(
        [question, known = std::move(known), materials = materials_,
         catalog = document_.sharedCatalog()](Worker::Control& control) {
            return completed(known, materials, question, *catalog, control);
        },
        [this, question, missing](const Result<Found>& found) {
            if (found && found->isWanted) {
                computed_ += static_cast<int>(missing);
                show(question, found->answers);
            }
        },
        QStringLiteral("lines"));
}

void LobeDock::show(const LobeQuestion& question, const std::vector<SharedAnswer>& answers) {
    answers_.keep(answers);
    const auto hasPlot = [](const SharedAnswer& each) { return each->plot.has_value(); };
    const bool isWhole = !question.lines.isSketch || std::ranges::all_of(answers, hasPlot);
    if (question.page != plots_->page() || answers.empty() ||
        (!isWhole && std::ranges::none_of(answers, hasPlot))) {
        return; // another one is on its way
    }
    if (isWhole) {
        say(&Note::answers, noteOf(answers));
    }
    shown_ = isWhole ? answers : withEarlier(answers);
    plots_->showAnswers(question, shown_);
}

/// Returns the answers, with what is shown of a material in place of a sketch that there is not:
/// what needs the device waits until values rest.
std::vector<SharedAnswer> LobeDock::withEarlier(std::vector<SharedAnswer> answers) const {
    for (SharedAnswer& answer : answers) {
        const auto earlier = std::ranges::find_if(shown_, [&answer](const SharedAnswer& each) {
            return each->plot && each->question.page == answer->question.page &&
                   each->material.name == answer->material.name;
        });
        if (!answer->plot && earlier != shown_.end()) {
            answer = *earlier;
        }
    }
    return answers;
}

QString LobeDock::noteOf(const std::vector<SharedAnswer>& answers) const {
    QStringList notes;
    for (const SharedAnswer& each : answers) {
        if (!each->plot) {
            notes << tr("%1: %2.").arg(asText(each->material.name),
                                       asText(each->plot.error().problem));
        }
    }
    if (picked_ && (plots_->page() == LobePage::Polar || plots_->page() == LobePage::Solid)) {
        notes << tr("Picked: light %1° and viewer %2° from the normal, the viewer %3° out of the "
                    "plane of incidence.")
                     .arg(roundText(plots_->light()), roundText(std::abs(picked_->viewerDegrees())),
                          roundText(picked_->outOfPlane()));
    }
    for (const SharedAnswer& each : answers) {
        const auto* subject = each->plot ? std::get_if<LobeSubject>(&*each->plot) : nullptr;
        if (subject != nullptr && !subject->lines.note.empty()) {
            notes << QStringLiteral("%1: %2.").arg(asText(subject->name),
                                                   asText(subject->lines.note));
        }
    }
    return notes.join(' ');
}

void LobeDock::exportTo(const QString& file) {
    if (const auto written = plots_->exportTo(file); !written) {
        messages_.add(written.error());
    }
}

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/shader_dock.h"

#include <array>
#include <utility>
#include <vector>

#include <QCheckBox>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "docks/family_chooser.h"
#include "docks/panel.h"
#include "docks/settling.h"
#include "docks/shader_text_view.h"
#include "document/document.h"
#include "resources/mesh_library.h"
#include "resources/mesh_snapshot.h"
#include "text/as_text.h"
#include "viewport/compare_area.h"
#include "viewport/viewport.h"

namespace patina {
namespace {

constexpr int shaderSettleMs = 100;
constexpr int shaderProgressSteps = 1000;

/// Returns "  312 instr.   4 VGPRs    512 cycles"; malioc tells no instructions.
QString shaderMarginText(const PredictedFunctions::Saving& saving, const GpuFamily& family) {
    const QString rest =
        ShaderDock::tr("%1 VGPRs %2 cycles").arg(saving.registers, 3).arg(saving.cycles, 6, 'f', 0);
    return family.isMali ? rest
                         : ShaderDock::tr("%1 instr. %2").arg(saving.instructions, 5).arg(rest);
}

/// Is a shader's text without its marks `#line`, which are for compilers' messages.
struct UnmarkedText {
    QString text;
    std::vector<int> lines{0}; ///< are its lines by those of the marked text, both from 1
};

UnmarkedText unmarked(const std::string& marked) {
    UnmarkedText made;
    QStringList kept;
    for (const QString& line : asText(marked).split('\n')) {
        if (!line.startsWith("#line")) {
            kept.push_back(line);
        }
        made.lines.push_back(int(kept.size()));
    }
    made.text = kept.join('\n');
    return made;
}

} // namespace

ShaderDock::ShaderDock(const DockContext& context)
    : document_(context.document), library_(context.meshes), views_(context.views),
      margin_(new QCheckBox(tr("What functions take"), this)), family_(new FamilyChooser(this)),
      cancel_(textButton(tr("Cancel"), tr("Stop and leave the margin empty"), this)),
      progress_(new QProgressBar(this)), state_(new QLabel(this)), text_(new ShaderTextView(this)),
      worker_({.name = tr("Predicting functions"), .canCancel = true}) {
    settle_.setSingleShot(true);
    settle_.setInterval(shaderSettleMs);
    layOut();
    connectParts();
    showState();
}

void ShaderDock::layOut() {
    margin_->setToolTip(tr("Predict what each function takes of the shader on a graphics card that "
                           "need not be here, with what is computed for it alone"));
    progress_->setRange(0, shaderProgressSteps);
    progress_->setMaximumWidth(200);
    progress_->setAccessibleName(tr("Progress of the prediction"));
    state_->setObjectName("state");
    state_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    state_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // never widens the dock
    text_->setAccessibleName(tr("Text of the shader"));
    auto* row = new QHBoxLayout;
    row->addWidget(margin_);
    row->addWidget(family_);
    row->addWidget(cancel_);
    row->addWidget(progress_);
    row->addWidget(state_, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 4, 6, 0);
    layout->setSpacing(4);
    layout->addLayout(row);
    layout->addWidget(text_, 1);
}

void ShaderDock::connectParts() {
    startWhenChanged(settle_, document_, library_);
    connect(&settle_, &QTimer::timeout, this, &ShaderDock::update);
    connect(margin_, &QCheckBox::toggled, this, &ShaderDock::update);
    connect(family_, &QComboBox::currentIndexChanged, this, &ShaderDock::update);
    connect(cancel_, &QToolButton::clicked, this, [this] {
        isStopped_ = true;
        worker_.cancel();
    });
    connect(&worker_, &Worker::progressed, this,
            [this](double share) { progress_->setValue(int(share * shaderProgressSteps)); });
}

void ShaderDock::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    update();
}

QSize ShaderDock::sizeHint() const {
    return {720, 320};
}

/// Leaves the text alone while nobody sees it.
void ShaderDock::update() {
    if (!isVisible()) {
        return;
    }
    isStopped_ = false;
    if (document_.selection().object() < 0) {
        worker_.forget();
        shown_ = {};
        problem_ = tr("No object is selected.");
        text_->clear();
        showMargins();
        return;
    }
    const GpuFamily* family = margin_->isChecked() ? &family_->family() : nullptr;
    worker_.ask([this, subject = subject(), family, known = knownFor(family)](
                    Worker::Control& control) { work(subject, family, known, control); },
                [this](const Result<void>& done) {
                    if (!done) {
                        problem_ = asText(done.error().text());
                    }
                    showMargins();
                },
                "shader");
    showState();
}

/// Returns the current object as the active view's camera sees it.
PredictedSubject ShaderDock::subject() const {
    Scene scene = document_.scene(document_.selection().side());
    scene.camera = views_.active().viewport().camera();
    MeshSource meshes = meshSnapshot(scene, library_);
    return {std::move(scene), static_cast<std::size_t>(document_.selection().object()),
            std::move(meshes), document_.sharedCatalog()};
}

/// Returns the program that is shown where its margin for the family is known: a slider changes no
/// text, and is to cost no prediction.
ProgramText ShaderDock::knownFor(const GpuFamily* family) const {
    const bool isKnown = shown_.functions && *shown_.functions && shown_.family == family;
    return isKnown ? shown_.program : ProgramText();
}

/// Runs in the worker's thread.
void ShaderDock::work(const PredictedSubject& subject, const GpuFamily* family,
                      const ProgramText& known, Worker::Control& control) {
    auto program = surfaceText(subject);
    if (!program) {
        control.show([this, problem = asText(program.error().front().text())] {
            take({});
            problem_ = problem;
        });
        return;
    }
    control.show([this, shown = Shown{*program, family}] { take(shown); });
    if (family == nullptr || *program == known) {
        return;
    }
    FamilyCompilerOptions options;
    options.isStopped = [&control] { return control.isCancelled() || control.isSuperseded(); };
    options.onProgress = [&control](double share) { control.report(share); };
    Shown shown{std::move(*program), family};
    shown.functions = predictedFunctions(shown.program, std::array{family}, options);
    if (!options.isStopped()) {
        control.show([this, shown = std::move(shown)] { take(shown); });
    }
}

/// Shows a text, and keeps its place and its margin where it is the one that is shown.
void ShaderDock::take(Shown shown) {
    problem_.clear();
    const bool isSame =
        shown.program == shown_.program && shown.family == shown_.family && !shown.functions;
    if (shown.program != shown_.program) {
        text_->setPlainText(unmarked(shown.program.fragment).text);
    }
    if (!isSame) {
        shown_ = std::move(shown);
    }
    showMargins();
}

void ShaderDock::showMargins() {
    ShaderTextView::Margins margins;
    int widestLine = 0;
    if (shown_.functions && *shown_.functions) {
        const PredictedFunctions& predicted = **shown_.functions;
        const std::vector<int> lines = unmarked(shown_.program.fragment).lines;
        const auto lineOf = [&lines](const PredictedFunction& function) {
            return lines.at(static_cast<std::size_t>(function.line));
        };
        for (const PredictedFunction& function : predicted.functions) {
            if (const auto saving = predicted.savingOf(function, shown_.family->id)) {
                margins[lineOf(function)] = shaderMarginText(*saving, *shown_.family);
            }
        }
        const PredictedFunction* widest = predicted.widest(shown_.family->id);
        widestLine = widest != nullptr ? lineOf(*widest) : 0;
    }
    text_->setMargins(std::move(margins), widestLine);
    showState();
}

void ShaderDock::showState() {
    const bool isPredicting = isWorking() && margin_->isChecked();
    family_->setEnabled(margin_->isChecked());
    cancel_->setVisible(isPredicting);
    progress_->setVisible(isPredicting);
    progress_->setValue(isPredicting ? progress_->value() : 0);
    state_->setText(stateText());
    state_->setToolTip(state_->text());
}

QString ShaderDock::stateText() const {
    if (!problem_.isEmpty()) {
        return problem_;
    }
    if (!shown_.functions) {
        return !margin_->isChecked() ? QString()
               : isWorking()         ? tr("Predicting …")
               : isStopped_          ? tr("Stopped.")
                                     : QString();
    }
    return *shown_.functions ? predictedText(**shown_.functions)
                             : asText(shown_.functions->error().text());
}

QString ShaderDock::predictedText(const PredictedFunctions& predicted) const {
    const std::string& family = shown_.family->id;
    if (!predicted.whole || !predicted.whole->contains(family)) {
        return predicted.whole ? QString() : asText(predicted.whole.error().text());
    }
    const StageStatistics& whole = predicted.whole->at(family).fragment;
    const QString all = tr("%1 VGPRs, %2 cycles for 64 pixels")
                            .arg(whole.vectorRegisters)
                            .arg(whole.cycles, 0, 'f', 0);
    const PredictedFunction* widest = predicted.widest(family);
    return widest == nullptr ? all : tr("%1; most registers: %2()").arg(all, asText(widest->name));
}

} // namespace patina

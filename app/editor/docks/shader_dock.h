// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QTimer>
#include <QWidget>

#include "background/worker.h"
#include "docks/dock_context.h"
#include "measure/prediction/predicted_functions.h"
#include "measure/prediction/predicted_subject.h"

class QCheckBox;
class QLabel;
class QProgressBar;
class QToolButton;

namespace patina {

class FamilyChooser;
class ShaderTextView;

/// Shows the text of the shader that draws the current object, without what is not in its scene. A
/// switch has what each function takes on a graphics card that is not here in a margin, which is
/// predicted in the background.
class ShaderDock : public QWidget {
    Q_OBJECT

  public:
    explicit ShaderDock(const DockContext& context);

    bool isWorking() const { return !worker_.isIdle(); }

    QSize sizeHint() const override;

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    /// Is a text with what its functions take; nothing where that was not asked for or is not known
    /// yet.
    struct Shown {
        ProgramText program;
        const GpuFamily* family = nullptr;
        std::optional<Result<PredictedFunctions>> functions{};
    };

    void layOut();
    void connectParts();
    void update();
    PredictedSubject subject() const;
    void work(const PredictedSubject& subject, const GpuFamily* family, const ProgramText& known,
              Worker::Control& control);
    ProgramText knownFor(const GpuFamily* family) const;
    void take(Shown shown);
    void showMargins();
    void showState();
    QString stateText() const;
    QString predictedText(const PredictedFunctions& predicted) const;

    Document& document_;
    MeshLibrary& library_;
    CompareArea& views_;
    QTimer settle_; ///< gathers changes of the document
    QCheckBox* margin_;
    FamilyChooser* family_;
    QToolButton* cancel_;
    QProgressBar* progress_;
    QLabel* state_;
    ShaderTextView* text_;
    Shown shown_;
    QString problem_; ///< says why there is no text
    bool isStopped_ = false;
    Worker worker_;
};

} // namespace patina

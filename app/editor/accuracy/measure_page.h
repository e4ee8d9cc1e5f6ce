// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <any>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <QTimer>
#include <QWidget>

#include "accuracy/kept_results.h"
#include "background/worker.h"
#include "docks/dock_context.h"
#include "docks/measure_end.h"
#include "measure/cost/cost_sweep.h"

class QVBoxLayout;

namespace patina {

class MeasureBar;
class MeasureTurn;

/// Measures the scene in the background on demand, keeps the numbers for the session and says when
/// they are out of date. A derived class decides what is measured and shown.
class MeasurePage : public QWidget {
    Q_OBJECT

  public:
    bool isMeasuring() const { return !worker_.isIdle(); }
    /// Returns the result that is shown; null if nothing was measured.
    const PageResult* shown() const { return shown_; }
    /// Returns whether what is shown was measured on another scene than the current one; the camera
    /// does not count.
    bool isStale() const { return stale_; }
    /// Returns the sentence that the page shows about its numbers.
    QString state() const;
    /// Writes what is shown, in the format of the file's suffix; adds a message if that fails.
    void exportTo(const QString& file);

  protected:
    /// See MeasureBar for `what` and `endings`; `task` is the name among what is done beside the
    /// window.
    MeasurePage(const DockContext& context, std::shared_ptr<MeasureTurn> turn, const QString& what,
                const QStringList& endings,
                std::unique_ptr<KeptResults> results = std::make_unique<KeptResults>(),
                const QString& task = tr("Measuring accuracy"));

    virtual void startMeasuring() = 0;
    /// Ends a measurement with what it has by then.
    virtual void stopMeasuring() { worker_.cancel(); }
    /// Returns the subject of numbers that would be measured now.
    virtual MeasuredSubject subject() const = 0;

    /// Returns the subject of numbers of all models, which leaves out the object's own material: a
    /// measurement takes the models' defaults, and a fit only begins there.
    MeasuredSubject subjectOfModels() const;
    virtual void showNumbers(bool stale) = 0;
    virtual QByteArray bytesFor(const QString& ending) const = 0;
    /// Says why there is nothing to measure; empty if there is something.
    virtual QString nothingText() const;
    virtual QString notYetText() const;    ///< is shown before a measurement
    virtual QString runningText() const;   ///< is shown until a measurement says what it does
    virtual QString outOfDateText() const; ///< is shown for numbers that are stale
    virtual QString measuredText() const;  ///< says how the numbers were measured

    /// Returns false while this or another page measures, or if there is nothing to measure.
    bool canStart() const;
    /// Starts a measurement if canStart(). `measure` runs in the worker's thread with a current
    /// context. It must not use the page, whose derived part may be destroyed by then; what it
    /// passes to Worker::Control::show() may.
    void start(std::function<MeasureEnd(Worker::Control&)> measure);
    CostSweep::Subject costSubject();

    /// Takes the numbers so far of the running measurement and shows them. Does nothing if none
    /// runs.
    void take(std::any numbers, const QString& method);

    /// Returns the numbers that are shown; a default value if there are none.
    template <class Numbers>
    const Numbers& numbers() const {
        static const Numbers none{};
        const auto* held = shown_ != nullptr ? std::any_cast<Numbers>(&shown_->numbers) : nullptr;
        return held != nullptr ? *held : none;
    }

    /// Finds the result for the current subject and shows it.
    void refresh();

    MeasureBar& bar() { return *bar_; }
    QVBoxLayout& rows() { return *rows_; } ///< has the bar as its first row
    Document& document() const { return document_; }

    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    void connectParts();
    void follow();
    void finish(const MeasureEnd& end);
    void showState();
    bool hasNumbers() const { return shown_ != nullptr && shown_->numbers.has_value(); }
    QString stateText() const;
    std::string file() const;

    Document& document_;
    DocumentFiles& documentFiles_;
    MeshLibrary& meshes_;
    TextureLibrary& textures_;
    EnvironmentLibrary& environments_;
    MessageLog& messages_;
    std::shared_ptr<MeasureTurn> turn_;
    std::unique_ptr<KeptResults> results_;
    std::optional<PageResult> running_; ///< is what is being measured; empty if nothing is
    QString doing_;                     ///< says what the running measurement does
    const PageResult* shown_ = nullptr;
    bool stale_ = false;
    bool isOfOtherBlocks_ = false; ///< says that numbers are stale by what was read alone
    QTimer settle_;                ///< gathers changes of the document
    MeasureBar* bar_;
    QVBoxLayout* rows_;
    Worker worker_;
};

} // namespace patina

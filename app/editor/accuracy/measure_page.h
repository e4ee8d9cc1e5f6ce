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

/// A page that measures the scene when it is asked to, beside what the artist does, keeps that for
/// the session and says when it is out of date. What is measured and shown is a derived class's.
class MeasurePage : public QWidget {
    Q_OBJECT

  public:
    bool isMeasuring() const { return !worker_.isIdle(); }
    /// Returns what is shown; null where nothing was measured.
    const PageResult* shown() const { return shown_; }
    /// What is shown is of another scene than is on the screen; where it is seen from does not
    /// matter.
    bool isStale() const { return stale_; }
    /// Returns what the page says about its numbers.
    QString state() const;
    /// Writes what was measured, in the form of the file's ending.
    void exportTo(const QString& file);

  protected:
    /// `what` and `endings`: see MeasureBar.
    MeasurePage(const DockContext& context, std::shared_ptr<MeasureTurn> turn, const QString& what,
                const QStringList& endings,
                std::unique_ptr<KeptResults> results = std::make_unique<KeptResults>());

    virtual void startMeasuring() = 0;
    /// Returns what numbers of now are of.
    virtual MeasuredSubject subject() const = 0;
    virtual void showNumbers(bool stale) = 0;
    virtual QByteArray bytesFor(const QString& ending) const = 0;
    /// That there is nothing to measure; empty where there is.
    virtual QString nothingText() const;
    virtual QString outOfDateText() const; ///< said of numbers that are stale
    virtual QString measuredText() const;  ///< how the numbers were measured

    /// False while that or another page's measurement is going on, or where there is nothing to
    /// measure.
    bool canStart() const;
    /// Begins with what costSubject() is now, where it can. In the worker's thread a context is
    /// current. `measure` does not use the page there, whose own part may be gone by the end of it:
    /// what it shows (Worker::Control::show) may.
    void start(std::function<MeasureEnd(Worker::Control&)> measure);
    CostSweep::Subject costSubject();

    /// There are more numbers of what is being measured.
    void take(std::any numbers, const QString& method);

    /// Returns what is shown; the empty value where there is nothing.
    template <class Numbers>
    const Numbers& numbers() const {
        static const Numbers none{};
        const auto* held = shown_ != nullptr ? std::any_cast<Numbers>(&shown_->numbers) : nullptr;
        return held != nullptr ? *held : none;
    }

    /// Finds what is to be shown, and shows it.
    void refresh();

    MeasureBar& bar() { return *bar_; }
    QVBoxLayout& rows() { return *rows_; } ///< the bar is the first
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
    std::optional<PageResult> running_; ///< what is being measured
    QString doing_;                     ///< of that
    const PageResult* shown_ = nullptr;
    bool stale_ = false;
    QTimer settle_; ///< changes of the document are gathered
    MeasureBar* bar_;
    QVBoxLayout* rows_;
    Worker worker_;
};

} // namespace patina

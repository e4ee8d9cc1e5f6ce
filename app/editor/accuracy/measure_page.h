// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <any>
#include <memory>
#include <optional>
#include <string>

#include <QTimer>
#include <QWidget>

#include "accuracy/kept_results.h"
#include "background/background_job.h"
#include "docks/dock_context.h"
#include "measure/cost/cost_sweep.h"

namespace patina {

class MeasureBar;
class MeasureTurn;

/// What a page measured, perhaps not to the end.
struct PageResult {
    MeasuredSubject subject;
    std::string file; ///< of the document; empty: it has none yet
    std::any numbers; ///< of the page's own type; empty: none yet
    QString method;   ///< how they were measured
    bool complete = false;
    QString problem; ///< why it ended before its time; else empty
};

/// A page that measures the scene when it is asked to, beside what the artist does, keeps that for
/// the session and says when it is out of date. What is measured and shown is a derived class's.
class MeasurePage : public QWidget {
    Q_OBJECT

  public:
    bool isMeasuring() const { return work_.isRunning(); }
    /// What is shown is of another scene than is on the screen; where it is seen from does not
    /// matter.
    bool isStale() const { return stale_; }
    /// What the page says about its numbers.
    QString state() const;
    /// Writes what was measured, in the form of the file's ending.
    void exportTo(const QString& file);

  protected:
    /// See MeasureBar.
    MeasurePage(const DockContext& context, std::shared_ptr<MeasureTurn> turn, const QString& what,
                const QStringList& endings);

    virtual void startMeasuring() = 0;
    /// The scene without what makes no difference to the numbers.
    virtual Scene measuredPart(Scene scene, int object) const = 0;
    /// The blocks that the numbers are of.
    virtual SubjectBlocks measuredBlocks() const { return SubjectBlocks::OfScene; }
    virtual void showNumbers(bool stale) = 0;
    virtual QByteArray bytesFor(const QString& ending) const = 0;

    /// False while that or another page's measurement is going on, or without an object.
    bool canStart() const;
    /// Begins with what costSubject() is now, where it can.
    void start(BackgroundJob::Work work);
    CostSweep::Subject costSubject();

    /// There are more numbers of what is being measured.
    void take(std::any numbers, const QString& method);

    /// What is shown; the empty value where there is nothing.
    template <class Numbers>
    const Numbers& numbers() const {
        static const Numbers none{};
        const auto* held = shown_ != nullptr ? std::any_cast<Numbers>(&shown_->numbers) : nullptr;
        return held != nullptr ? *held : none;
    }

    /// Finds what is to be shown, and shows it.
    void refresh();

    MeasureBar& bar() { return *bar_; }
    Document& document() { return document_; }

    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    void connectParts();
    void follow();
    void finish(bool complete, const QString& problem);
    void showState();
    bool hasNumbers() const { return shown_ != nullptr && shown_->numbers.has_value(); }
    QString stateText() const;
    MeasuredSubject subject() const;
    std::string file() const;

    Document& document_;
    DocumentFiles& documentFiles_;
    MeshLibrary& meshes_;
    TextureLibrary& textures_;
    EnvironmentLibrary& environments_;
    MessageLog& messages_;
    std::shared_ptr<MeasureTurn> turn_;
    KeptResults<PageResult> results_;
    std::optional<PageResult> running_; ///< what is being measured
    QString doing_;                     ///< of that
    const PageResult* shown_ = nullptr;
    bool stale_ = false;
    QTimer settle_; ///< changes of the document are gathered
    MeasureBar* bar_;
    BackgroundJob work_; ///< the last: it ends before what it tells
};

} // namespace patina

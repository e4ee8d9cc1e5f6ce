// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include <QTimer>
#include <QWidget>

#include "check/stepped_work.h"
#include "docks/dock_context.h"
#include "measure/cost_sweep.h"

namespace patina {

class MeasureBar;

/// A page that measures the scene when it is asked to, beside what the artist does, and says when
/// that is out of date. What is measured and shown is a derived class's.
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
    MeasurePage(const DockContext& context, const QString& what, const QStringList& endings);

    virtual void startMeasuring() = 0;
    /// The scene without what makes no difference to the numbers.
    virtual Scene measuredPart(Scene scene, int object) const = 0;
    virtual bool hasNumbers() const = 0;
    /// How they were measured.
    virtual QString methodText() const = 0;
    virtual void showNumbers(bool stale) = 0;
    virtual QByteArray bytesFor(const QString& ending) const = 0;

    /// Begins with what costSubject() is now. Nothing happens while that is going on, or without an
    /// object.
    void start(SteppedWork::Maker make);
    CostSweep::Subject costSubject();
    /// There is more to show, or none any more.
    void refresh();

    MeasureBar& bar() { return *bar_; }
    Document& document() { return document_; }

    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    /// What numbers are of.
    struct Subject {
        Scene scene;
        int object = -1;
        std::shared_ptr<const Catalog> catalog;

        friend bool operator==(const Subject&, const Subject&) = default;
    };

    void connectParts();
    void follow();
    void finish(bool complete, const QString& problem);
    void showState();
    QString stateText() const;
    Subject subject() const;

    Document& document_;
    MeshLibrary& meshes_;
    EnvironmentLibrary& environments_;
    MessageLog& messages_;
    std::optional<Subject> measured_;
    bool complete_ = false;
    bool stale_ = false;
    QString problem_;
    QTimer settle_; ///< changes of the document are gathered
    MeasureBar* bar_;
    SteppedWork work_; ///< the last: it ends before what it tells
};

} // namespace patina

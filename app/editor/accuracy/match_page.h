// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "accuracy/measure_page.h"
#include "document/document_state.h"
#include "measure/match/model_matches.h"

class QCheckBox;
class QComboBox;
class QTreeWidget;

namespace patina {

class MatchPlot;

/// Fits the current object's model, or every model, to another material or to a measured surface,
/// and shows how near each comes as soon as it is fitted, then the time that it takes per pixel of
/// the object and the front of both as a chart. Enter gives the object a fitted material.
class MatchPage : public MeasurePage {
    Q_OBJECT

  public:
    MatchPage(const DockContext& context, std::shared_ptr<MeasureTurn> turn);

    /// Makes a preset or a measured file what is to be matched.
    void aimAt(const std::filesystem::path& file);

    const ModelMatches& matches() const { return numbers<ModelMatches>(); }

  protected:
    void startMeasuring() override;
    MeasuredSubject subject() const override;
    void showNumbers(bool stale) override;
    QByteArray bytesFor(const QString& ending) const override;
    QString nothingText() const override;

  private:
    /// Says what can be matched: another view, a snapshot by its name, or a file.
    struct Aim {
        QString name;
        std::optional<Side> side{};
        std::filesystem::path file{};
    };

    QWidget* makeControls();
    void listAims();
    const Material* materialOf(const Aim& aim) const; ///< is null for a file
    void askForFile();
    void select(int match);
    void apply(int row);

    QComboBox* aim_;
    QComboBox* error_; ///< lists what a fit makes small
    QCheckBox* all_;
    QTreeWidget* list_;
    MatchPlot* plot_;       ///< is hidden until a time is known
    std::vector<Aim> aims_; ///< are those that `aim_` lists, in its order
    std::filesystem::path file_;
};

} // namespace patina

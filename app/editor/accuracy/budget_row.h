// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QWidget>

#include "measure/cost/cost_chart.h"
#include "predict/gpu_family.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QToolButton;

namespace patina {

class BoundBox;

/// Asks what may be spent, and shows which point of a chart that buys: "at most 2 ms at 1080p",
/// "error below 1/255".
class BudgetRow : public QWidget {
    Q_OBJECT

  public:
    explicit BudgetRow(QWidget* parent = nullptr);

    /// Returns the graphics card that times are wanted for; nothing for this machine.
    std::optional<CardOfFamily> card() const;
    /// Takes the choice of a card away, since nothing is predicted of what is shown.
    void hideCards();

    /// Answers with these points; stale ones are shown but cannot be applied.
    void setChart(const CostChart& chart, bool stale);

    /// Returns the point that fits the budget best; empty without a budget or a chart.
    const std::optional<BudgetAnswer>& answer() const { return answer_; }

  Q_SIGNALS:
    void answered(int point); ///< is emitted when the artist changes the budget
    void wished(int point);   ///< is emitted when the artist applies the answer
    void cardChosen();

  private:
    void layOut();
    void connectParts();
    CostBudget budget() const;
    double pictures() const;
    void refresh();
    QString answerText(const CostPoint& point, bool fits) const;

    CostChart chart_;
    bool stale_ = false;
    std::optional<BudgetAnswer> answer_;
    QCheckBox* timed_;
    BoundBox* milliseconds_;
    QComboBox* size_;
    QLabel* on_;
    QComboBox* card_;
    QCheckBox* bounded_;
    BoundBox* share_;
    QToolButton* use_;
    QLabel* text_;
};

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/chart_target.h"

namespace patina {

class CompareArea;
class Comparison;
class Document;

/// Measures the active material of the current object.
class MaterialTarget : public ChartTarget {
  public:
    /// The difference of compare() is shown in `views`.
    MaterialTarget(Document& document, Comparison& comparison, CompareArea& views)
        : document_(document), comparison_(comparison), views_(views) {}

    Choice::Scope scope() const override { return Choice::Scope::Material; }
    std::vector<Choice> choices() const override;
    ChosenLevels levels(const std::vector<Choice>& choices) const override;
    MeasuredSubject subject() const override;
    void apply(const std::vector<Choice>& choices, const ChosenLevels& levels,
               const QString& label) override;
    void compare(const std::vector<Choice>& choices, const ChosenLevels& levels) override;
    QString measureText() const override;
    QString noChoicesText() const override;

  private:
    Document& document_;
    Comparison& comparison_;
    CompareArea& views_;
};

} // namespace patina

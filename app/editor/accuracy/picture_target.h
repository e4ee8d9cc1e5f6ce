// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/chart_target.h"

namespace patina {

class CompareArea;
class Comparison;
class Document;

/// Measures the picture of the scene, whatever its materials.
class PictureTarget : public ChartTarget {
  public:
    /// The difference of compare() is shown in `views`.
    PictureTarget(Document& document, Comparison& comparison, CompareArea& views)
        : document_(document), comparison_(comparison), views_(views) {}

    Choice::Scope scope() const override { return Choice::Scope::Picture; }
    std::vector<Choice> choices() const override;
    ChosenLevels levels(const std::vector<Choice>& choices) const override;
    MeasuredSubject subject() const override;
    void apply(const std::vector<Choice>& choices, const ChosenLevels& levels,
               const QString& label) override;
    void compare(const std::vector<Choice>& choices, const ChosenLevels& levels) override;
    QString measureText() const override;
    QString noChoicesText() const override;

  private:
    /// Returns the active side's scene with these levels, and the exact one for every other choice.
    Scene withLevels(const std::vector<Choice>& choices, const ChosenLevels& levels) const;

    Document& document_;
    Comparison& comparison_;
    CompareArea& views_;
};

} // namespace patina

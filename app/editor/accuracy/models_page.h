// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "accuracy/measure_page.h"
#include "measure/cost/model_ranking.h"

namespace patina {

class FamilyChooser;
class ModelList;

/// Shows what each model costs with its defaults on the current object, how many instructions it
/// takes, how much light it loses and what it would cost on graphics cards that are not here. Enter
/// gives the object a model.
class ModelsPage : public MeasurePage {
    Q_OBJECT

  public:
    ModelsPage(const DockContext& context, std::shared_ptr<MeasureTurn> turn);

    /// Starts a measurement. Does nothing while this or another page measures, or without an
    /// object.
    void measure(CostSweep::Options options);

    const std::vector<ModelCost>& costs() const { return numbers<std::vector<ModelCost>>(); }

  protected:
    void startMeasuring() override;
    MeasuredSubject subject() const override;
    void showNumbers(bool stale) override;
    QByteArray bytesFor(const QString& ending) const override;

  private:
    FamilyChooser* family_;
    ModelList* list_;
};

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "background/worker.h"
#include "docks/measure_end.h"
#include "document/document.h"
#include "library/read_blocks.h"
#include "measure/cost/effect_cost.h"
#include "measure/prediction/predicted_effects.h"

namespace patina {

/// Measures in the background what the effects of a document's current object cost, and knows
/// whether that is still what the document shows.
class EffectMeasurement : public QObject {
    Q_OBJECT

  public:
    explicit EffectMeasurement(const Document& document, QObject* parent = nullptr);

    /// Measures the subject, which is of the current object and side. Nothing happens while that is
    /// going on.
    void start(const EffectCostMeter::Subject& subject, EffectCostMeter::Options options);
    void cancel() { worker_.cancel(); }

    /// Forgets what was measured, since another document is there.
    void forget();

    bool isRunning() const { return !worker_.isIdle(); }

    /// Tells whether the costs are of another scene or object than those that are shown, or whether
    /// there are none.
    bool isStale() const;

    /// Returns the costs of the current object, however old they are; null where there are none.
    const EffectCosts* costs() const;

    /// Returns what is predicted for graphics cards that are not here; null where there are no
    /// costs.
    const Result<PredictedEffects>* predicted() const;

    /// Returns a sentence on what was measured of these rows, or on why there are no costs.
    QString stateText(const std::vector<EffectRow>& rows) const;

  Q_SIGNALS:
    void progressed(double share); ///< 0 .. 1
    void ended();

  private:
    /// Holds what costs were measured of.
    struct Measured {
        Scene scene;
        int object = -1;
        Side side = Side::A;
        KnownBlocks blocks; ///< of that scene
        EffectCosts costs{};
        /// Is what each effect takes on graphics cards that are not here, or why that is not known.
        Result<PredictedEffects> predicted{PredictedEffects()};
        MeasureEnd end = false;
    };

    MeasureEnd meter(const EffectCostMeter::Subject& subject,
                     const EffectCostMeter::Options& options, std::size_t object,
                     Worker::Control& control);
    QString whyStale() const;
    QString totalText(const std::vector<EffectRow>& rows) const;

    const Document& document_;
    std::optional<Measured> measured_; ///< the last costs, or what they are being measured of
    Worker worker_;
};

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <memory>
#include <string>

#include "catalog/catalog.h"
#include "measure/cost_chart.h"
#include "scene/scene.h"

namespace patina {

/// What a chart was measured of, wherever it was seen from.
struct ChartSubject {
    Scene scene; ///< with every choice of the object's material exact, and no camera of its own
    int object = -1;
    std::string file; ///< of the document; empty: it has none yet
    std::shared_ptr<const Catalog> catalog;

    friend bool operator==(const ChartSubject&, const ChartSubject&) = default;
};

/// A chart, perhaps of a measurement that has not ended.
struct KeptChart {
    ChartSubject subject;
    Camera camera; ///< where it was measured from
    CostChart chart;
    bool complete = false;
    std::string problem; ///< why it ended before its time; else empty
};

/// A chart is of all choices of the object's material, so which of them is taken makes no
/// difference to it, and who looks at a point from elsewhere still wants the others.
ChartSubject chartSubject(Scene scene, int object, std::string file,
                          std::shared_ptr<const Catalog> catalog);

/// The charts of this session, so that who comes back to a preset finds what was measured.
class KeptCharts {
  public:
    /// Keeps a chart; one of the same subject goes, and the oldest where there are many.
    KeptChart& keep(KeptChart chart);

    /// The newest of the same subject, else of the same file and object; null where there is none.
    const KeptChart* find(const ChartSubject& subject) const;

  private:
    std::deque<KeptChart> charts_; ///< the newest last
};

} // namespace patina

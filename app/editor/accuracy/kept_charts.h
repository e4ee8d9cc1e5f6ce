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
    Scene scene; ///< without what makes no difference: see chartSubject()
    int object = -1;
    std::string file; ///< of the document; empty: it has none yet
    std::shared_ptr<const Catalog> catalog;

    /// A file that is saved, or saved under another name, is of the same material as before.
    friend bool operator==(const ChartSubject& a, const ChartSubject& b) {
        return a.object == b.object && a.catalog == b.catalog && a.scene == b.scene;
    }
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
/// difference to it, and who looks at a point from elsewhere still wants the others. Neither does
/// what says whose work it is, nor what is not measured: the picture's accuracy and the ground.
ChartSubject chartSubject(Scene scene, int object, std::string file,
                          std::shared_ptr<const Catalog> catalog);

/// The charts of this session, so that who comes back to a preset finds what was measured.
class KeptCharts {
  public:
    /// Keeps a chart; one of the same subject goes, and the oldest where there are many.
    KeptChart& keep(KeptChart chart);

    /// The newest of the same subject, which is the subject's file's from now on, else of the same
    /// file and object; null where there is none.
    const KeptChart* find(const ChartSubject& subject);

  private:
    std::deque<KeptChart> charts_; ///< the newest last
};

} // namespace patina

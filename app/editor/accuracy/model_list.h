// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include <QTreeWidget>

#include "catalog/catalog.h"
#include "measure/cost/model_ranking.h"
#include "predict/gpu_family.h"

namespace patina {

/// Lists models with what they are and what they cost, sortable by every number. Enter or a double
/// click picks a model.
class ModelList : public QTreeWidget {
    Q_OBJECT

  public:
    explicit ModelList(QWidget* parent = nullptr);

    /// Chooses the family whose predicted cycles the costs that are set from now on show.
    void setFamily(const GpuFamily& family);

    /// Says which blocks the models of costs that are set from now on are.
    void setCatalog(std::shared_ptr<const Catalog> catalog);

    /// Shows the costs; `stale` says that they were measured on another scene.
    void setCosts(const std::vector<ModelCost>& costs, bool stale);

  Q_SIGNALS:
    void picked(QString model);

  private:
    const GpuFamily* family_;
    std::shared_ptr<const Catalog> catalog_;
};

} // namespace patina

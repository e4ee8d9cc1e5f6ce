// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <QObject>
#include <QString>

#include "background/worker.h"
#include "exchange/material_export.h"
#include "session/session.h"

class QWidget;

namespace patina {

/// Asks for a file and writes a material to it as other programs have it, in the background: a
/// model that they lack is fitted, which takes seconds and can be cancelled.
class MaterialExporter : public QObject {
    Q_OBJECT

  public:
    MaterialExporter(Session& session, QWidget* window);

    void ask(const Material& material, std::shared_ptr<const Catalog> catalog);
    void write(const QString& file, const Material& material,
               std::shared_ptr<const Catalog> catalog);

  Q_SIGNALS:
    /// Is emitted when all is written; `lost` says what is not exactly the same in the file, a line
    /// each.
    void written(QString file, patina::Errors lost);
    void failed(patina::Error why);

  private:
    Session& session_;
    QWidget* window_;
    Worker worker_{{.name = tr("Writing a material"), .canCancel = true}};
};

} // namespace patina

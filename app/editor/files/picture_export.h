// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include <QObject>
#include <QString>

#include "assets/asset_client.h"
#include "background/worker.h"
#include "session/session.h"

class QWidget;

namespace patina {

/// Asks where to and writes what a view shows to a picture file, in the background: 8-bit formats
/// as it is on the screen, the others as linear floats. Where drawing takes long it shows that, and
/// can be cancelled.
class PictureExport : public QObject {
    Q_OBJECT

  public:
    /// Who draws the picture: as it is shown, divided by 255, or as linear floats. It is handed
    /// over when it is done, unless it was cancelled.
    struct Source {
        std::function<void(bool display, std::function<void(Image)> taken)> capture;
        std::function<void()> cancel;
    };

    PictureExport(Session& session, QWidget* window);

    /// Asks for a file under a title that says what is written; `name` is the one that is offered,
    /// without its ending.
    void ask(const QString& title, const QString& name, const Source& source);
    void save(const QString& file, const Source& source);

    /// True where the format of a file keeps linear light.
    static bool isLinear(const QString& file);

  Q_SIGNALS:
    void saved(QString file);
    void failed(patina::Error why);

  private:
    void write(const QString& file, Image picture);

    Session& session_;
    QWidget* window_;
    std::unique_ptr<AssetClient> client_;             ///< made when first needed
    Worker worker_{{.atEnd = Worker::AtEnd::Finish}}; ///< what was asked for is written
};

} // namespace patina

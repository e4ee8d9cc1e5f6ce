// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include <QObject>
#include <QString>

#include "assets/asset_client.h"
#include "background/worker.h"
#include "document/document.h"
#include "scene/turntable.h"
#include "session/session.h"

class QWidget;

namespace patina {

/// Writes a whole turn of what the views show as a numbered series of pictures, one after the other
/// while the window stays free. It is listed in LongTasks with its progress, and can be cancelled:
/// the pictures that are written by then stay.
class TurntableExport : public QObject {
    Q_OBJECT

  public:
    struct Series {
        TurntableOf what = TurntableOf::Object;
        int count = 36;
        QString file; ///< is the name to which numbers are added
    };

    /// Draws the views with another scene, as on the screen in 0 .. 1 or as linear floats.
    struct Source {
        std::function<void(bool display, std::function<Scene(const Scene&)> change,
                           std::function<void(Image)> taken)>
            capture;
        std::function<void()> cancel;
    };

    TurntableExport(const Document& document, Session& session, QWidget* window);
    ~TurntableExport() override;

    /// Asks what turns, for how many pictures and where they go, and begins.
    void ask(const QString& name, const Source& source);

    /// Begins a series; one that is being written ends.
    void start(const Series& series, const Source& source);

  Q_SIGNALS:
    void saved(QString firstFile, int count);
    void failed(patina::Error why);

  private:
    struct Run;

    bool mayReplace(const Series& series);
    void drawNext(const std::shared_ptr<Run>& run);
    void write(const std::shared_ptr<Run>& run, Image picture);
    void end();

    const Document& document_;
    Session& session_;
    QWidget* window_;
    std::shared_ptr<Run> run_;            ///< is null while none is being written
    std::unique_ptr<AssetClient> client_; ///< is made when first needed
    Worker worker_;
};

} // namespace patina

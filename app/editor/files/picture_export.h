// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <QObject>
#include <QString>

#include "assets/asset_client.h"
#include "background/worker.h"
#include "session/session.h"

class QWidget;

namespace patina {

/// A picture of a comparison as it is shown, divided by 255, with what marks it.
struct NamedPicture {
    QString letter;
    QString name;
    QString colour;
    Image picture;
};

/// Asks where to and writes what a view shows to a picture file, in the background: 8-bit formats
/// as it is on the screen, the others as linear floats, and a comparison as a page that wipes
/// between its pictures, too. Where drawing takes long it shows that, and
/// can be cancelled.
class PictureExport : public QObject {
    Q_OBJECT

  public:
    /// Who draws the picture: as it is shown, divided by 255, or as linear floats. It is handed
    /// over when it is done, unless it was cancelled.
    struct Source {
        std::function<void(bool display, std::function<void(Image)> taken)> capture;
        std::function<void()> cancel;
        /// The same with a picture for each side of a comparison; absent: nothing is compared.
        std::function<void(std::function<void(std::vector<NamedPicture>)> taken)> captureEach{};
    };

    PictureExport(Session& session, QWidget* window);

    /// Asks for a file under a title that says what is written; `name` is the one that is offered,
    /// without its ending.
    void ask(const QString& title, const QString& name, const Source& source);
    void save(const QString& file, const Source& source);

    /// True where the format of a file keeps linear light.
    static bool isLinear(const QString& file);

    /// True for a page that holds several pictures.
    static bool isPage(const QString& file);

  Q_SIGNALS:
    void saved(QString file);
    void failed(patina::Error why);

  private:
    void write(const QString& file, Image picture);
    void writePage(const QString& file, std::vector<NamedPicture> pictures);
    void fail(const QString& file);
    AssetClient& client();
    void ask(const QString& file, std::function<Result<void>()> work);

    Session& session_;
    QWidget* window_;
    std::unique_ptr<AssetClient> client_;             ///< made when first needed
    Worker worker_{{.name = tr("Writing a picture"),
                    .atEnd = Worker::AtEnd::Finish}}; ///< what was asked for is written
};

} // namespace patina

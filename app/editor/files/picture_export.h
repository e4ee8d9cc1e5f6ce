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

/// Holds one picture of a comparison with its label; values are those on the screen, 0 .. 1.
struct NamedPicture {
    QString letter;
    QString name;
    QString colour;
    Image picture;
};

/// Asks for a file and writes what a view shows to it in the background: 8-bit formats as on the
/// screen, others as linear floats, and a comparison also as a page that wipes between its
/// pictures. Slow drawing is listed in LongTasks and can be cancelled.
class PictureExport : public QObject {
    Q_OBJECT

  public:
    /// Draws the picture, either as on the screen in 0 .. 1 or as linear floats, and passes it to
    /// `taken`, unless it is cancelled.
    struct Source {
        std::function<void(bool display, std::function<void(Image)> taken)> capture;
        std::function<void()> cancel;
        /// Draws one picture for each side of a comparison; empty if nothing is compared.
        std::function<void(std::function<void(std::vector<NamedPicture>)> taken)> captureEach{};
    };

    PictureExport(Session& session, QWidget* window);

    /// Asks for a file, with a title that says what is written and `name`, without a suffix, as its
    /// suggested name.
    void ask(const QString& title, const QString& name, const Source& source);
    void save(const QString& file, const Source& source);

    /// Returns whether the format of a file holds linear light.
    static bool isLinear(const QString& file);

    /// Returns whether a file is a page of several pictures.
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
    std::unique_ptr<AssetClient> client_; ///< is made when first needed
    Worker worker_{{.name = tr("Writing a picture"),
                    .atEnd = Worker::AtEnd::Finish}}; ///< finishes what was asked for
};

} // namespace patina

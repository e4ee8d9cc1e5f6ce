// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include <QImage>
#include <QObject>
#include <QSize>

#include "background/worker.h"
#include "library/thumbnail_keys.h"

namespace patina {

/// Small pictures of materials in one fixed neutral scene, whatever the document shows, of
/// environments, and of the scenes that ship. Drawn in a worker thread with a context of its own
/// that lives while there is something to draw, and kept on disk until something they are made of
/// changes.
class ThumbnailMaker : public QObject {
    Q_OBJECT

  public:
    struct Folders {
        std::filesystem::path cache;        ///< where the pictures are kept
        std::filesystem::path programCache; ///< shared with the views
        std::filesystem::path scene;        ///< the scene file whose first object is shown
    };

    ThumbnailMaker(std::shared_ptr<const Catalog> catalog, Folders folders,
                   QObject* parent = nullptr);
    ~ThumbnailMaker() override;

    /// Nothing is drawn before this: the first frame of the window comes first.
    void start() { worker_.resume(); }
    void setCatalog(std::shared_ptr<const Catalog> catalog);

    /// Takes the place of what was asked for by that name and is not begun. ready() follows with
    /// the name.
    void ask(const QString& name, const Material& material);

    /// The same for all that is seen from within an environment of these blocks' default values,
    /// or of the picture that the values name: twice as wide as high.
    void askEnvironment(const QString& name, const BlockValues& environment);

    /// The same for a scene file as it is, which lays no picture around its objects.
    void askScene(const QString& name, const std::filesystem::path& file);

    static constexpr int pixels = 256;
    static constexpr QSize environmentPixels{128, 64};

  Q_SIGNALS:
    /// The picture is null when the material's shader does not compile, and where nothing can be
    /// drawn.
    void ready(QString name, QImage picture);

  private:
    class Studio;

    using Drawing = std::function<QImage(Studio& studio)>;

    Result<QImage> picture(const QByteArray& key, const std::shared_ptr<const Catalog>& catalog,
                           const Worker::Control& control, const Drawing& draw);
    void handOver(const QString& name, const Result<QImage>& drawn);

    Folders folders_;
    std::shared_ptr<const Catalog> catalog_;
    ThumbnailKeys keys_;                     ///< of the worker's thread
    Result<std::unique_ptr<Studio>> studio_; ///< of the worker's thread; null: it was not needed
    Worker worker_;
};

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>

#include <QImage>
#include <QObject>
#include <QSize>

#include "background/worker.h"
#include "library/thumbnail_keys.h"

namespace patina {

/// Draws small images of materials in one fixed neutral scene, whatever the document shows, of
/// environments, and of the scenes that ship. Draws in a worker thread, whose context lives while
/// there is something to draw, and keeps images on disk until something they depend on changes.
class ThumbnailMaker : public QObject {
    Q_OBJECT

  public:
    struct Folders {
        std::filesystem::path cache;        ///< keeps the images
        std::filesystem::path programCache; ///< is shared with the views
        std::filesystem::path scene; ///< is the scene file whose first object gets the material
    };

    ThumbnailMaker(std::shared_ptr<const Catalog> catalog, Folders folders,
                   QObject* parent = nullptr);
    ~ThumbnailMaker() override;

    /// Begins to draw; nothing is drawn before, so that the window's first frame does not have to
    /// wait.
    void start() { worker_.resume(); }

    /// Tells whether the user has stopped the drawing. Only pictures that are kept on disk come
    /// then, until goOn() or other blocks.
    bool isStopped() const { return isStopped_; }
    void goOn() { isStopped_ = false; }
    void setCatalog(std::shared_ptr<const Catalog> catalog);

    /// Asks for the image of a material; replaces a waiting request of that name. ready() follows
    /// with the name.
    void ask(const QString& name, const Material& material);

    /// Asks for what is seen from within an environment with these values, of environmentPixels.
    void askEnvironment(const QString& name, const BlockValues& environment);

    /// Asks for the image of a scene file as it is, without a picture around its objects.
    void askScene(const QString& name, const std::filesystem::path& file);

    static constexpr int pixels = 256;
    static constexpr QSize environmentPixels{128, 64};

  Q_SIGNALS:
    /// Is emitted with a null picture if a shader does not compile, if nothing can be drawn, or if
    /// the user has stopped it.
    void ready(QString name, QImage picture);

  private:
    class Studio;

    using Drawing = std::function<QImage(Studio& studio)>;

    Result<QImage> picture(const QByteArray& key, const std::shared_ptr<const Catalog>& catalog,
                           const Worker::Control& control, const Drawing& draw);
    void handOver(const QString& name, const Result<QImage>& drawn);

    Folders folders_;
    std::shared_ptr<const Catalog> catalog_;
    ThumbnailKeys keys_; ///< belong to the worker's thread
    /// Belongs to the worker's thread; null while it is not needed.
    Result<std::unique_ptr<Studio>> studio_;
    std::atomic<bool> isStopped_ = false; ///< is set in the worker's thread
    Worker worker_;
};

} // namespace patina

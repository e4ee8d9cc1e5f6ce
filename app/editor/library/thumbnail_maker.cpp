// SPDX-License-Identifier: GPL-3.0-or-later
#include "library/thumbnail_maker.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <QDir>
#include <QFileInfo>
#include <QSaveFile>

#include "render/gpu/texture_loader.h"
#include "render/renderer.h"
#include "scene/primitives.h"
#include "scene/scene_file.h"

namespace patina {
namespace {

QImage toQImage(const Image& image) {
    QImage picture(image.width, image.height, QImage::Format_RGB888);
    const auto byte = [&](int x, int y, int channel) {
        const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width);
        const auto at =
            (row + static_cast<std::size_t>(x)) * static_cast<std::size_t>(image.channels);
        const float value = image.pixels[at + static_cast<std::size_t>(channel)];
        return static_cast<int>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f));
    };
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            picture.setPixel(x, y, qRgb(byte(x, y, 0), byte(x, y, 1), byte(x, y, 2)));
        }
    }
    return picture;
}

/// On a full disk only flush() fails, commit() does not.
void keep(const QImage& picture, const QString& file) {
    QSaveFile target(file);
    if (QDir().mkpath(QFileInfo(file).path()) && target.open(QIODevice::WriteOnly) &&
        picture.save(&target, "PNG") && target.flush()) {
        target.commit();
    }
}

} // namespace

/// The renderer and the scene of the pictures that are drawn without a rest.
class ThumbnailMaker::Studio {
  public:
    /// The context is current.
    static Result<std::unique_ptr<Studio>> open(const Folders& folders, const Catalog& catalog) {
        Checked<SceneReading> reading = readScene(folders.scene, catalog);
        if (!reading || reading->scene.objects.empty()) {
            return failure("the scene of small pictures cannot be read");
        }
        Result<std::unique_ptr<Renderer>> renderer = Renderer::create({folders.programCache});
        if (!renderer) {
            return tl::unexpected(renderer.error());
        }
        auto studio = std::make_unique<Studio>();
        studio->scene_ = std::move(reading->scene);
        studio->renderer_ = std::move(*renderer);
        studio->renderer_->setTextures(studio->textures_.source());
        return studio;
    }

    /// Null where its program does not compile: what is drawn instead is not what it looks like.
    QImage draw(const Material& material, std::shared_ptr<const Catalog> catalog) {
        if (catalog != catalog_) {
            catalog_ = std::move(catalog);
            renderer_->setCatalog(catalog_);
        }
        scene_.objects.front().material = material;
        View view;
        view.size = {ThumbnailMaker::pixels, ThumbnailMaker::pixels};
        view.camera = scene_.camera;
        const auto meshes = [this](const Object& object) { return mesh(object.mesh); };
        const Result<Image> image = renderer_->capture(scene_, view, meshes, true);
        return image && !isBroken() ? toQImage(*image) : QImage();
    }

  private:
    bool isBroken() const {
        const FrameReport& report = renderer_->report();
        return report.messages.size() > report.warnings;
    }

    MeshView mesh(const std::string& name) {
        const auto [place, isNew] = meshes_.try_emplace(name);
        if (isNew) {
            place->second = primitive(name.substr(name.find(':') + 1)).value_or(Mesh());
        }
        return place->second.view();
    }

    AssetClient files_; ///< starts nothing before an image is wanted
    TextureLoader textures_{files_};
    std::unique_ptr<Renderer> renderer_;
    std::shared_ptr<const Catalog> catalog_;
    Scene scene_;
    std::map<std::string, Mesh> meshes_;
};

ThumbnailMaker::ThumbnailMaker(std::shared_ptr<const Catalog> catalog, Folders folders,
                               QObject* parent)
    : QObject(parent), folders_(std::move(folders)), catalog_(std::move(catalog)),
      keys_(folders_.scene), studio_(nullptr), worker_({.priority = QThread::IdlePriority,
                                                        .atRest = [this] { studio_ = nullptr; },
                                                        .isPaused = true}) {}

ThumbnailMaker::~ThumbnailMaker() = default;

void ThumbnailMaker::setCatalog(std::shared_ptr<const Catalog> catalog) {
    catalog_ = std::move(catalog);
}

void ThumbnailMaker::ask(const QString& name, const Material& material) {
    worker_.ask(
        [this, material, catalog = catalog_](const Worker::Control& control) {
            return picture(material, catalog, control);
        },
        [this, name](const Result<QImage>& drawn) { Q_EMIT ready(name, drawn.value_or(QImage())); },
        name);
}

/// In the worker's thread.
Result<QImage> ThumbnailMaker::picture(const Material& material,
                                       const std::shared_ptr<const Catalog>& catalog,
                                       const Worker::Control& control) {
    const QString file = QStringLiteral("%1/%2.png")
                             .arg(QString::fromStdString(folders_.cache.string()),
                                  QString::fromLatin1(keys_.of(material, *catalog)));
    if (QImage kept(file); !kept.isNull()) {
        return kept;
    }
    if (studio_ && !*studio_) {
        studio_ = control.openContext().and_then([&] { return Studio::open(folders_, *catalog); });
    }
    if (!studio_) {
        return tl::unexpected(studio_.error());
    }
    const QImage drawn = (*studio_)->draw(material, catalog);
    if (!drawn.isNull()) {
        keep(drawn, file);
    }
    return drawn;
}

} // namespace patina

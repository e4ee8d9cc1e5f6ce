// SPDX-License-Identifier: GPL-3.0-or-later
#include "library/thumbnail_maker.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <utility>

#include <glm/exponential.hpp>

#include <QDir>
#include <QFileInfo>
#include <QSaveFile>

#include "core/color.h"
#include "library/as_picture.h"
#include "render/frame/frame_job.h"
#include "render/gpu/texture_loader.h"
#include "render/lights/environment_image.h"
#include "render/renderer.h"
#include "scene/environment.h"
#include "scene/kept_openness.h"
#include "scene/primitives.h"
#include "scene/scene_file.h"

namespace patina {
namespace {

/// Is how long a picture is drawn until it is asked whether it is still wanted.
constexpr std::chrono::milliseconds slice{20};

/// Exposes the environment so that its mean, taken in stops, becomes middle grey (18 %).
QImage seenFromWithin(const EnvironmentRadiance& environment) {
    constexpr double grey = 0.18;
    constexpr double darkest = 1e-4;
    if (environment.texels.empty()) {
        return {};
    }
    double stops = 0.0;
    for (const glm::vec4& texel : environment.texels) {
        const double brightness = luminance(glm::dvec3(texel));
        stops += std::log2(std::isfinite(brightness) ? std::max(brightness, darkest) : darkest);
    }
    const double mean = std::exp2(stops / double(environment.texels.size()));
    const double exposure = std::clamp(grey / mean, 0.01, 16.0);
    QImage picture(environment.size.x, environment.size.y, QImage::Format_RGB888);
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const glm::dvec3 light(
                environment.texels[std::size_t(y) * std::size_t(picture.width()) + std::size_t(x)]);
            const glm::dvec3 shown = srgbEncoded(1.0 - glm::exp(-exposure * light));
            picture.setPixel(x, y,
                             qRgb(int(std::lround(255.0 * shown.r)),
                                  int(std::lround(255.0 * shown.g)),
                                  int(std::lround(255.0 * shown.b))));
        }
    }
    return picture.scaled(ThumbnailMaker::environmentPixels, Qt::IgnoreAspectRatio,
                          Qt::SmoothTransformation);
}

/// Writes an image to a file, or nothing: on a full disk flush() fails where commit() does not.
void keep(const QImage& picture, const QString& file) {
    QSaveFile target(file);
    if (QDir().mkpath(QFileInfo(file).path()) && target.open(QIODevice::WriteOnly) &&
        picture.save(&target, "PNG") && target.flush()) {
        target.commit();
    }
}

} // namespace

/// Holds the renderer and the scene while images are drawn one after the other.
class ThumbnailMaker::Studio {
  public:
    /// Opens a studio. Needs a current context.
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

    /// Returns null if the program does not compile, since the fallback would be a wrong picture,
    /// and when cancelled.
    QImage draw(const Material& material, std::shared_ptr<const Catalog> catalog,
                const Worker::Control& control) {
        scene_.objects.front().material = material;
        return draw(scene_, std::move(catalog), control);
    }

    QImage draw(const Scene& scene, std::shared_ptr<const Catalog> catalog,
                const Worker::Control& control) {
        use(std::move(catalog));
        View view;
        view.size = {ThumbnailMaker::pixels, ThumbnailMaker::pixels};
        view.camera = scene.camera;
        const auto meshes = [this](const Object& object) { return mesh(object.mesh); };
        FrameJob& job = renderer_->begin(scene, view, meshes, FramePurpose::Capture);
        while (job.step(slice) == FrameJob::Progress::More) {
            if (control.isCancelled()) {
                return {};
            }
        }
        const Result<Image> image = job.failure() ? tl::unexpected(*job.failure()) : job.read(true);
        return image && !isBroken() ? asPicture(*image) : QImage();
    }

    /// Returns null if its picture cannot be read or its shader does not compile.
    QImage drawEnvironment(const BlockValues& environment, std::shared_ptr<const Catalog> catalog) {
        use(std::move(catalog));
        Scene alone;
        alone.setPart(kinds::environment, environment);
        View view;
        view.size = glm::ivec2(1);
        const Block* block = catalog_->find(kinds::environment, environment.id);
        if (block != nullptr && pictureParameter(*block) != nullptr) {
            const auto read = files_.loadImage(std::string(pictureFile(environment, *block)));
            if (!read) {
                return {};
            }
            view.environmentImage = EnvironmentImage::from(*read);
        }
        const auto noMeshes = [](const Object&) { return MeshView(); };
        if (!renderer_->capture(alone, view, noMeshes, true)) {
            return {};
        }
        return seenFromWithin(renderer_->job().environmentRadiance());
    }

  private:
    void use(std::shared_ptr<const Catalog> catalog) {
        if (catalog != catalog_) {
            catalog_ = std::move(catalog);
            renderer_->setCatalog(catalog_);
        }
    }

    bool isBroken() const {
        const FrameReport& report = renderer_->report();
        return report.messages.size() > report.warnings;
    }

    MeshView mesh(const std::string& name) {
        const auto [place, isNew] = meshes_.try_emplace(name);
        if (isNew) {
            place->second = primitive(name.substr(name.find(':') + 1)).value_or(Mesh());
            openness_[name] = keptOpenness(place->second.view(), opennessFolder());
        }
        MeshView view = place->second.view();
        view.openness = openness_[name];
        return view;
    }

    AssetClient files_; ///< starts no process before an image is needed
    TextureLoader textures_{files_};
    std::unique_ptr<Renderer> renderer_;
    std::shared_ptr<const Catalog> catalog_;
    Scene scene_;
    std::map<std::string, Mesh> meshes_;
    /// Holds the openness of the meshes' vertices, by mesh name.
    std::map<std::string, std::vector<VertexOpenness>> openness_;
};

ThumbnailMaker::ThumbnailMaker(std::shared_ptr<const Catalog> catalog, Folders folders,
                               QObject* parent)
    : QObject(parent), folders_(std::move(folders)), catalog_(std::move(catalog)),
      keys_(folders_.scene), studio_(nullptr), worker_({.name = tr("Drawing small pictures"),
                                                        .canCancel = true,
                                                        .priority = QThread::IdlePriority,
                                                        .atRest = [this] { studio_ = nullptr; },
                                                        .isPaused = true}) {}

ThumbnailMaker::~ThumbnailMaker() = default;

void ThumbnailMaker::setCatalog(std::shared_ptr<const Catalog> catalog) {
    catalog_ = std::move(catalog);
    goOn();
}

void ThumbnailMaker::ask(const QString& name, const Material& material) {
    worker_.ask(
        [this, material, catalog = catalog_](const Worker::Control& control) {
            return picture(keys_.of(material, *catalog), catalog, control,
                           [&](Studio& studio) { return studio.draw(material, catalog, control); });
        },
        [this, name](const Result<QImage>& drawn) { handOver(name, drawn); }, name);
}

void ThumbnailMaker::askEnvironment(const QString& name, const BlockValues& environment) {
    worker_.ask(
        [this, environment, catalog = catalog_](const Worker::Control& control) {
            return picture(keys_.of(environment, *catalog), catalog, control, [&](Studio& studio) {
                return studio.drawEnvironment(environment, catalog);
            });
        },
        [this, name](const Result<QImage>& drawn) { handOver(name, drawn); }, name);
}

void ThumbnailMaker::askScene(const QString& name, const std::filesystem::path& file) {
    worker_.ask(
        [this, file, catalog = catalog_](const Worker::Control& control) -> Result<QImage> {
            const Checked<SceneReading> read = readScene(file, *catalog);
            if (!read) {
                return tl::unexpected(read.error().front());
            }
            return picture(
                keys_.of(read->scene, file, *catalog), catalog, control,
                [&](Studio& studio) { return studio.draw(read->scene, catalog, control); });
        },
        [this, name](const Result<QImage>& drawn) { handOver(name, drawn); }, name);
}

void ThumbnailMaker::handOver(const QString& name, const Result<QImage>& drawn) {
    Q_EMIT ready(name, drawn.value_or(QImage()));
}

/// Runs in the worker's thread.
Result<QImage> ThumbnailMaker::picture(const QByteArray& key,
                                       const std::shared_ptr<const Catalog>& catalog,
                                       const Worker::Control& control, const Drawing& draw) {
    const QString file =
        QStringLiteral("%1/%2.png")
            .arg(QString::fromStdString(folders_.cache.string()), QString::fromLatin1(key));
    if (QImage kept(file); !kept.isNull()) {
        return kept;
    }
    isStopped_ = isStopped_ || control.isCancelled();
    if (isStopped_) {
        return failure("drawing small pictures was stopped");
    }
    if (studio_ && !*studio_) {
        studio_ = control.openContext().and_then([&] { return Studio::open(folders_, *catalog); });
    }
    if (!studio_) {
        return tl::unexpected(studio_.error());
    }
    const QImage drawn = draw(**studio_);
    if (!drawn.isNull()) {
        keep(drawn, file);
    }
    return drawn;
}

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "library/thumbnail_maker.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QSaveFile>
#include <QThread>

#include "background/free_memory.h"
#include "gl/headless_context.h"
#include "material/preset_file.h"
#include "render/gpu/texture_loader.h"
#include "render/renderer.h"
#include "scene/primitives.h"
#include "scene/scene_file.h"

namespace patina {
namespace {

/// Part of every file name, so that pictures made another way are not taken.
constexpr int pictureVersion = 1;

void addFile(QCryptographicHash& hash, const std::filesystem::path& file) {
    const QFileInfo info(QString::fromStdString(file.string()));
    hash.addData(QByteArray::number(info.size()));
    hash.addData(QByteArray::number(info.lastModified().toMSecsSinceEpoch()));
}

void addBlock(QCryptographicHash& hash, const Block* block) {
    if (block) {
        addFile(hash, block->descriptorFile);
        addFile(hash, block->shaderFile);
    }
}

/// Where the picture of a material lies: named by everything it depends on.
QString fileOf(const ThumbnailMaker::Folders& folders, const Material& material,
               const Catalog& catalog) {
    QCryptographicHash hash(QCryptographicHash::Sha1);
    hash.addData(QByteArray::fromStdString(toJson(material).dump()));
    addBlock(hash, catalog.find(kinds::models, material.model.id));
    for (const auto& [kind, values] : material.parts) {
        addBlock(hash, catalog.find(kind, values.id));
    }
    addFile(hash, folders.scene);
    return QString::fromStdString(folders.cache.string()) +
           QStringLiteral("/%1-%2.png").arg(pictureVersion).arg(hash.result().toHex());
}

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

/// The context, the renderer and the scene of one run of the worker.
class Studio {
  public:
    static std::unique_ptr<Studio> open(const ThumbnailMaker::Folders& folders,
                                        const std::shared_ptr<const Catalog>& catalog) {
        auto studio = std::make_unique<Studio>();
        Checked<SceneReading> reading = readScene(folders.scene, *catalog);
        Result<std::unique_ptr<gl::HeadlessContext>> context = gl::HeadlessContext::create();
        if (!reading || reading->scene.objects.empty() || !context) {
            return nullptr;
        }
        studio->scene_ = std::move(reading->scene);
        studio->context_ = std::move(*context);
        Result<std::unique_ptr<Renderer>> renderer = Renderer::create({folders.programCache});
        if (!renderer) {
            return nullptr;
        }
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
    std::unique_ptr<gl::HeadlessContext> context_;
    std::unique_ptr<Renderer> renderer_;
    std::shared_ptr<const Catalog> catalog_;
    Scene scene_;
    std::map<std::string, Mesh> meshes_;
};

/// On a full disk only flush() fails, commit() does not.
void keep(const QImage& picture, const QString& file) {
    QSaveFile target(file);
    if (QDir().mkpath(QFileInfo(file).path()) && target.open(QIODevice::WriteOnly) &&
        picture.save(&target, "PNG") && target.flush()) {
        target.commit();
    }
}

} // namespace

ThumbnailMaker::ThumbnailMaker(std::shared_ptr<const Catalog> catalog, Folders folders,
                               QObject* parent)
    : QObject(parent), folders_(std::move(folders)), catalog_(std::move(catalog)) {
    worker_.setPriority(QThread::IdlePriority);
    connect(&worker_, &BackgroundJob::finished, this, &ThumbnailMaker::wake);
}

ThumbnailMaker::~ThumbnailMaker() {
    const std::lock_guard lock(mutex_);
    jobs_.clear();
}

void ThumbnailMaker::start() {
    started_ = true;
    wake();
}

void ThumbnailMaker::setCatalog(std::shared_ptr<const Catalog> catalog) {
    catalog_ = std::move(catalog);
}

void ThumbnailMaker::ask(const QString& name, const Material& material) {
    {
        const std::lock_guard lock(mutex_);
        jobs_.push_back({name, material, catalog_});
    }
    wake();
}

void ThumbnailMaker::wake() {
    const std::lock_guard lock(mutex_);
    if (started_ && !jobs_.empty()) {
        worker_.start([this](BackgroundJob::Control&) {
            work();
            return endOf(true, {});
        });
    }
}

bool ThumbnailMaker::next(Job& job) {
    const std::lock_guard lock(mutex_);
    if (jobs_.empty()) {
        return false;
    }
    job = std::move(jobs_.front());
    jobs_.pop_front();
    return true;
}

void ThumbnailMaker::work() {
    std::unique_ptr<Studio> studio;
    bool broken = false;
    for (Job job; next(job);) {
        const QString file = fileOf(folders_, job.material, *job.catalog);
        QImage picture(file);
        if (picture.isNull() && !studio && !broken) {
            studio = Studio::open(folders_, job.catalog);
            broken = !studio;
        }
        if (picture.isNull() && studio) {
            picture = studio->draw(job.material, job.catalog);
            if (!picture.isNull()) {
                keep(picture, file);
            }
        }
        if (!picture.isNull() || studio) {
            Q_EMIT ready(job.name, picture);
        }
    }
    if (studio) {
        studio.reset();
        returnFreeMemory();
    }
}

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/picture_export.h"

#include <memory>
#include <utility>

#include <QFileDialog>
#include <QFileInfo>

#include "assets/comparison_page.h"
#include "background/long_tasks.h"
#include "core/atomic_file.h"
#include "core/display_image.h"

namespace patina {
PictureExport::PictureExport(Session& session, QWidget* window)
    : QObject(window), session_(session), window_(window) {}

void PictureExport::ask(const QString& title, const QString& name, const Source& source) {
    const QString png = tr("PNG, as on the screen (*.png)");
    const QString jpeg = tr("JPEG, as on the screen (*.jpg)");
    const QString exr = tr("OpenEXR, linear floats (*.exr)");
    const QString page = tr("Page to wipe between the pictures (*.html)");
    QStringList kinds{png, jpeg, exr};
    if (source.captureEach) {
        kinds << page;
    }
    QFileDialog dialog(window_, title, session_.folder("picture"), kinds.join(";;"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix("png");
    connect(&dialog, &QFileDialog::filterSelected, &dialog, [&](const QString& filter) {
        dialog.setDefaultSuffix(filter == exr    ? "exr"
                                : filter == jpeg ? "jpg"
                                : filter == page ? "html"
                                                 : "png");
    });
    dialog.selectFile(name + ".png");
    if (dialog.exec() == QDialog::Accepted) {
        const QString file = dialog.selectedFiles().value(0);
        session_.setFolderOf("picture", file);
        save(file, source);
    }
}

void PictureExport::save(const QString& file, const Source& source) {
    const auto task = std::make_shared<quint64>(0);
    const auto finish = [task] { LongTasks::all().end(std::exchange(*task, 0)); };
    *task = LongTasks::all().begin({tr("Drawing a picture"),
                                    [file] {
                                        return TaskState{-1.0, QFileInfo(file).fileName()};
                                    },
                                    [cancel = source.cancel, finish] {
                                        cancel();
                                        finish();
                                    }});
    if (isPage(file) && source.captureEach) {
        source.captureEach([this, file, finish](std::vector<NamedPicture> pictures) {
            finish();
            writePage(file, std::move(pictures));
        });
        return;
    }
    source.capture(!isLinear(file), [this, file, finish](Image picture) {
        finish();
        write(file, std::move(picture));
    });
}

void PictureExport::fail(const QString& file) {
    Q_EMIT failed({file.toStdString(), 0, 0, "there is no picture to write", {}});
}

AssetClient& PictureExport::client() {
    if (!client_) {
        client_ = std::make_unique<AssetClient>();
    }
    return *client_;
}

void PictureExport::ask(const QString& file, std::function<Result<void>()> work) {
    worker_.ask([work = std::move(work)](Worker::Control&) { return work(); },
                [this, file](const Result<void>& written) {
                    if (written) {
                        Q_EMIT saved(file);
                    } else {
                        Q_EMIT failed(written.error());
                    }
                });
}

void PictureExport::write(const QString& file, Image picture) {
    if (picture.pixels.empty()) {
        fail(file);
        return;
    }
    ask(file, [&client = client(), file, display = !isLinear(file),
               picture = std::move(picture)]() mutable {
        const Image linear = display ? linearFromDisplay(std::move(picture)) : std::move(picture);
        return client.saveImage(file.toStdString(), linear);
    });
}

void PictureExport::writePage(const QString& file, std::vector<NamedPicture> pictures) {
    if (pictures.empty()) {
        fail(file);
        return;
    }
    ask(file, [&client = client(), file, pictures = std::move(pictures)]() -> Result<void> {
        std::vector<PagePicture> encoded;
        QStringList title;
        for (const NamedPicture& each : pictures) {
            const auto png = client.encodeImage(".png", linearFromDisplay(each.picture));
            if (!png) {
                return tl::unexpected(png.error());
            }
            encoded.push_back({each.letter.toStdString(), each.name.toStdString(),
                               each.colour.toStdString(), *png});
            title << each.name;
        }
        return writeFileAtomically(file.toStdString(),
                                   comparisonPage(title.join(", ").toStdString(), encoded, {}));
    });
}

bool PictureExport::isLinear(const QString& file) {
    const QString ending = QFileInfo(file).suffix().toLower();
    return ending == "exr" || ending == "hdr";
}

bool PictureExport::isPage(const QString& file) {
    return QFileInfo(file).suffix().toLower() == "html";
}

} // namespace patina

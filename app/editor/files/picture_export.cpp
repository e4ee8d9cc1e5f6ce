// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/picture_export.h"

#include <utility>

#include <QFileDialog>
#include <QFileInfo>
#include <QPointer>
#include <QProgressDialog>

#include "core/display_image.h"

namespace patina {
namespace {

/// A picture that is drawn sooner needs no word about it.
constexpr int quickMs = 300;

} // namespace

PictureExport::PictureExport(Session& session, QWidget* window)
    : QObject(window), session_(session), window_(window) {}

void PictureExport::ask(const QString& title, const QString& name, const Source& source) {
    const QString png = tr("PNG, as on the screen (*.png)");
    const QString jpeg = tr("JPEG, as on the screen (*.jpg)");
    const QString exr = tr("OpenEXR, linear floats (*.exr)");
    QFileDialog dialog(window_, title, session_.folder("picture"),
                       QStringList{png, jpeg, exr}.join(";;"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix("png");
    connect(&dialog, &QFileDialog::filterSelected, &dialog, [&](const QString& filter) {
        dialog.setDefaultSuffix(filter == exr ? "exr" : filter == jpeg ? "jpg" : "png");
    });
    dialog.selectFile(name + ".png");
    if (dialog.exec() == QDialog::Accepted) {
        const QString file = dialog.selectedFiles().value(0);
        session_.setFolderOf("picture", file);
        save(file, source);
    }
}

void PictureExport::save(const QString& file, const Source& source) {
    auto* progress = new QProgressDialog(tr("Drawing the picture …"), tr("Cancel"), 0, 0, window_);
    progress->setWindowModality(Qt::WindowModal);
    progress->setMinimumDuration(quickMs);
    connect(progress, &QProgressDialog::canceled, this, [progress, cancel = source.cancel] {
        cancel();
        progress->deleteLater();
    });
    source.capture(!isLinear(file), [this, file, progress = QPointer(progress)](Image picture) {
        if (progress) {
            progress->disconnect();
            progress->hide();
            progress->deleteLater();
        }
        write(file, std::move(picture));
    });
}

void PictureExport::write(const QString& file, Image picture) {
    const bool display = !isLinear(file);
    if (picture.pixels.empty()) {
        Q_EMIT failed({file.toStdString(), 0, 0, "there is no picture to write", {}});
        return;
    }
    if (!client_) {
        client_ = std::make_unique<AssetClient>();
    }
    auto save = [&client = *client_, file, display,
                 picture = std::move(picture)](Worker::Control&) mutable {
        const Image linear = display ? linearFromDisplay(std::move(picture)) : std::move(picture);
        return client.saveImage(file.toStdString(), linear);
    };
    worker_.ask(std::move(save), [this, file](const Result<void>& written) {
        if (written) {
            Q_EMIT saved(file);
        } else {
            Q_EMIT failed(written.error());
        }
    });
}

bool PictureExport::isLinear(const QString& file) {
    const QString ending = QFileInfo(file).suffix().toLower();
    return ending == "exr" || ending == "hdr";
}

} // namespace patina

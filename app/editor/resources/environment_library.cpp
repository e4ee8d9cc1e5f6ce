// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/environment_library.h"

#include <utility>

#include <QFileInfo>

namespace patina {

EnvironmentLibrary::EnvironmentLibrary(QObject* parent)
    : QObject(parent), worker_({.name = tr("Reading an environment"), .canCancel = true}) {}

std::shared_ptr<const EnvironmentImage> EnvironmentLibrary::image(std::string_view file) {
    if (file != file_) {
        worker_.forget();
        file_ = file;
        image_.reset();
        hasFailed_ = false;
    }
    if (!file_.empty() && !image_ && !isLoading()) {
        load();
    }
    return image_;
}

void EnvironmentLibrary::withhold(FileSet files) {
    withheld_ = std::move(files);
    forgetFailure();
}

void EnvironmentLibrary::forgetFailure() {
    if (std::exchange(hasFailed_, false)) {
        image_.reset();
    }
}

void EnvironmentLibrary::load() {
    const auto read = [file = file_, withheld = withheld_](const Worker::Control& control) {
        AssetClient client;
        client.setRights({.withheld = withheld});
        return client.loadImage(file, &control.progress()).map(EnvironmentImage::from);
    };
    worker_.ask(
        read, [this](const Answer& answer) { finish(answer); }, {},
        QFileInfo(QString::fromStdString(file_)).fileName());
}

void EnvironmentLibrary::finish(const Answer& answer) {
    if (answer) {
        image_ = *answer;
        Q_EMIT loaded(QString::fromStdString(file_));
    } else {
        hasFailed_ = true;
        image_ = EnvironmentImage::missing();
        Q_EMIT failed(answer.error());
    }
}

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/environment_library.h"

#include <utility>

namespace patina {

EnvironmentLibrary::EnvironmentLibrary(QObject* parent) : QObject(parent) {}

EnvironmentLibrary::~EnvironmentLibrary() {
    cancel();
    worker_.clear();
    worker_.waitForDone();
}

std::shared_ptr<const EnvironmentImage> EnvironmentLibrary::image(std::string_view file) {
    if (file != file_) {
        cancel();
        progress_.reset();
        file_ = file;
        image_.reset();
        hasFailed_ = false;
    }
    if (!file_.empty() && !image_ && !isLoading()) {
        load();
    }
    return image_;
}

void EnvironmentLibrary::cancel() {
    if (progress_) {
        progress_->cancelled = true;
    }
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
    progress_ = std::make_shared<Progress>();
    // The destructor waits for the worker; the answer is queued to this object and dropped by Qt
    // when this object is gone.
    worker_.start([this, progress = progress_, file = file_, withheld = withheld_] {
        AssetClient client;
        client.setRights({.withheld = withheld});
        const Answer answer = client.loadImage(file, progress.get()).map(EnvironmentImage::from);
        QMetaObject::invokeMethod(
            this, [this, progress, answer] { finish(progress, answer); }, Qt::QueuedConnection);
    });
    Q_EMIT loadingStarted(QString::fromStdString(file_));
}

void EnvironmentLibrary::finish(const std::shared_ptr<Progress>& progress, const Answer& answer) {
    if (progress != progress_) {
        return; // another picture is wanted by now
    }
    progress_.reset();
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

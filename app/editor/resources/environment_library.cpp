// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/environment_library.h"

#include <utility>
#include <vector>

#include <QFileInfo>

namespace patina {

EnvironmentLibrary::EnvironmentLibrary(QObject* parent)
    : QObject(parent), worker_({.name = tr("Reading an environment"), .canCancel = true}) {}

std::shared_ptr<const EnvironmentImage> EnvironmentLibrary::image(std::string_view file) {
    if (file.empty()) {
        return nullptr;
    }
    auto found = pictures_.find(file);
    if (found == pictures_.end()) {
        found = pictures_.emplace(file, Picture()).first;
    }
    if (!found->second.image && !isLoading()) {
        load(found->first);
    }
    return found->second.image;
}

void EnvironmentLibrary::keep(const std::set<std::string, std::less<>>& files) {
    std::erase_if(pictures_, [&files](const auto& entry) { return !files.contains(entry.first); });
    if (isLoading() && !files.contains(loading_)) {
        worker_.forget();
    }
}

bool EnvironmentLibrary::isMissing(std::string_view file) const {
    const auto found = pictures_.find(file);
    return found != pictures_.end() && found->second.hasFailed;
}

void EnvironmentLibrary::withhold(FileSet files) {
    withheld_ = std::move(files);
    forgetFailure();
}

void EnvironmentLibrary::forgetFailure() {
    for (auto& [file, picture] : pictures_) {
        if (picture.hasFailed) {
            picture = Picture();
        }
    }
}

void EnvironmentLibrary::readAgain() {
    forgetFailure();
    std::vector<std::string> files;
    for (const auto& [file, picture] : pictures_) {
        files.push_back(file);
    }
    for (const std::string& file : files) {
        load(file);
    }
}

void EnvironmentLibrary::load(const std::string& file) {
    loading_ = file;
    const auto read = [file, withheld = withheld_](const Worker::Control& control) {
        AssetClient client;
        client.setRights({.withheld = withheld});
        return client.loadImage(file, &control.progress()).map(EnvironmentImage::from);
    };
    worker_.ask(
        read, [this, file](const Answer& answer) { finish(file, answer); }, {},
        QFileInfo(QString::fromStdString(file)).fileName());
}

void EnvironmentLibrary::finish(const std::string& file, const Answer& answer) {
    Picture& picture = pictures_[file];
    picture.image = answer ? *answer : EnvironmentImage::missing();
    picture.hasFailed = !answer;
    if (answer) {
        Q_EMIT loaded(QString::fromStdString(file));
    } else {
        Q_EMIT failed(answer.error());
    }
}

} // namespace patina

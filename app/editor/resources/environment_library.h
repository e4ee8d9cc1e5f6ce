// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include <QObject>

#include "assets/asset_client.h"
#include "background/worker.h"
#include "render/lights/environment_image.h"

namespace patina {

/// The picture of the document's environment, read by a files process of its own from a worker
/// thread; the views draw without it until it is there. The process ends with the reading: image
/// formats take a lot of memory, and the next picture may never come.
class EnvironmentLibrary : public QObject {
    Q_OBJECT

  public:
    explicit EnvironmentLibrary(QObject* parent = nullptr);

    /// The picture of a file; null while it is not there, a placeholder when it cannot be read.
    /// Another file than the last one starts loading, in place of what is loading.
    std::shared_ptr<const EnvironmentImage> image(std::string_view file);

    bool isLoading() const { return !worker_.isIdle(); }
    const std::string& file() const { return file_; }

    /// Tells whether the file was asked for last and could not be read.
    bool isMissing(std::string_view file) const { return hasFailed_ && file == file_; }

    /// Files that are not read from now on; those that were and are no more are tried again.
    void withhold(FileSet files);

    /// The next image() tries again where the last one could not be read.
    void forgetFailure();

  Q_SIGNALS:
    void loaded(QString file);
    void failed(patina::Error why); ///< also when it was cancelled

  private:
    using Answer = Result<std::shared_ptr<const EnvironmentImage>>;

    void load();
    void finish(const Answer& answer);

    FileSet withheld_;
    std::string file_;
    std::shared_ptr<const EnvironmentImage> image_;
    bool hasFailed_ = false;
    Worker worker_;
};

} // namespace patina

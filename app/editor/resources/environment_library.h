// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>

#include <QObject>

#include "assets/asset_client.h"
#include "background/worker.h"
#include "render/lights/environment_image.h"

namespace patina {

/// The pictures of the environments that are shown, read one after the other by a files process of
/// its own from a worker thread; the views draw without one until it is there. The process ends
/// with the reading: image formats take a lot of memory, and the next picture may never come.
class EnvironmentLibrary : public QObject {
    Q_OBJECT

  public:
    explicit EnvironmentLibrary(QObject* parent = nullptr);

    /// The picture of a file; null while it is not there, a placeholder when it cannot be read.
    /// One that is not there starts loading when none else is.
    std::shared_ptr<const EnvironmentImage> image(std::string_view file);

    /// Forgets all pictures but these, and gives up on loading another one.
    void keep(const std::set<std::string, std::less<>>& files);

    bool isLoading() const { return !worker_.isIdle(); }

    /// Tells whether the file was asked for and could not be read.
    bool isMissing(std::string_view file) const;

    /// Files that are not read from now on; those that were and are no more are tried again.
    void withhold(FileSet files);

    /// The next image() tries again where the last one could not be read.
    void forgetFailure();

  Q_SIGNALS:
    void loaded(QString file);
    void failed(patina::Error why); ///< also when it was cancelled

  private:
    using Answer = Result<std::shared_ptr<const EnvironmentImage>>;

    struct Picture {
        std::shared_ptr<const EnvironmentImage> image; ///< null while it is not there
        bool hasFailed = false;
    };

    void load(const std::string& file);
    void finish(const std::string& file, const Answer& answer);

    FileSet withheld_;
    std::map<std::string, Picture, std::less<>> pictures_; ///< by file
    std::string loading_;                                  ///< the file that is read, or was last
    Worker worker_;
};

} // namespace patina

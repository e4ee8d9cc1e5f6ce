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

/// Holds the pictures of the environments that are shown. A worker thread reads them one after the
/// other with a files process of its own; views draw without a picture until it is loaded. The
/// process ends after each reading, since image formats take much memory and the next picture may
/// never come.
class EnvironmentLibrary : public QObject {
    Q_OBJECT

  public:
    explicit EnvironmentLibrary(QObject* parent = nullptr);

    /// Returns the picture of a file: null while it is not loaded, a placeholder if it cannot be
    /// read. Starts loading it unless another one is being loaded.
    std::shared_ptr<const EnvironmentImage> image(std::string_view file);

    /// Forgets all pictures except these, and cancels loading of another one.
    void keep(const std::set<std::string, std::less<>>& files);

    bool isLoading() const { return !worker_.isIdle(); }

    /// Returns whether the file was asked for and could not be read.
    bool isMissing(std::string_view file) const;

    /// Sets the files that must not be read. Pictures that could not be read are tried again.
    void withhold(FileSet files);

    /// Lets the next image() try again what could not be read.
    void forgetFailure();

    /// Reads all pictures again; views show what they have until then.
    void readAgain();

  Q_SIGNALS:
    void loaded(QString file);
    void failed(patina::Error why); ///< is also emitted when it was cancelled

  private:
    using Answer = Result<std::shared_ptr<const EnvironmentImage>>;

    struct Picture {
        std::shared_ptr<const EnvironmentImage> image; ///< is null while it is not loaded
        bool hasFailed = false;
    };

    void load(const std::string& file);
    void finish(const std::string& file, const Answer& answer);

    FileSet withheld_;
    std::map<std::string, Picture, std::less<>> pictures_; ///< are indexed by file
    std::string loading_; ///< is the file that is being read, or was last
    Worker worker_;
};

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "assets/file_rights.h"
#include "document/document.h"
#include "material/reading_rights.h"

namespace patina {

/// Knows which files that a document names are not read: they lie outside the folder of its file,
/// and nobody agreed to it.
class WithheldFiles : public QObject {
    Q_OBJECT

  public:
    explicit WithheldFiles(Document& document, QObject* parent = nullptr);

    /// Returns all of them, including the images of materials.
    OutsideFiles all() const;
    /// Returns the rights to read meshes, the environment's picture and the files that meshes link
    /// to.
    FileRights rights() const;
    /// Withholds these and no others. Images are left out: materials say themselves which are
    /// withheld.
    void set(OutsideFiles files);
    /// Withholds these as well.
    void add(const OutsideFiles& files);
    /// Allows meshes to read these linked files and no others.
    void allowLinks(FileSet links);
    /// Withholds these linked files, without which a mesh was read.
    void addLinks(const std::vector<std::string>& places);
    /// Allows a file that the user named.
    void allow(const std::filesystem::path& file);
    /// Allows all of them from now on, images and presets as one undoable step. Relative paths of
    /// presets start in the folder of `documentFile`.
    void allowAll(const std::filesystem::path& documentFile);

  Q_SIGNALS:
    /// The withheld files other than images, or the rights, have changed.
    void changed();

  private:
    void allowIn(const MaterialPlace& place, const std::filesystem::path& documentFile,
                 const ReadingRights& rights);

    Document& document_;
    OutsideFiles files_; ///< holds no images
    FileSet links_;      ///< names the linked files that meshes may read
};

} // namespace patina

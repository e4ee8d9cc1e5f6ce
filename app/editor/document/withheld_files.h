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

    /// Returns all of them, the images of materials too.
    OutsideFiles all() const;
    /// Returns what may be read of meshes, of the picture and of the links of meshes.
    FileRights rights() const;
    /// Withholds these alone, beside images, which know it themselves.
    void set(OutsideFiles files);
    /// Withholds these as well.
    void add(const OutsideFiles& files);
    /// Allows these links of meshes alone.
    void allowLinks(FileSet links);
    /// A mesh was read without these links.
    void addLinks(const std::vector<std::string>& places);
    /// Allows what the user named file himself.
    void allow(const std::filesystem::path& file);
    /// Reads them all from now on; images and presets as one undoable step. Paths of presets start
    /// in the folder of this file.
    void allowAll(const std::filesystem::path& documentFile);

  Q_SIGNALS:
    /// There are others, or fewer, beside images, or other rights.
    void changed();

  private:
    void allowIn(const MaterialPlace& place, const std::filesystem::path& documentFile,
                 const ReadingRights& rights);

    Document& document_;
    OutsideFiles files_; ///< beside images
    FileSet links_;      ///< that are allowed
};

} // namespace patina

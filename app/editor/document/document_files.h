// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "document/withheld_files.h"

namespace patina {

/// Holds what the document was opened from or saved to last.
struct DocumentFile {
    enum class Kind { None, Preset, Scene };
    Kind kind = Kind::None;
    std::filesystem::path path;
    bool readOnly = false; ///< says that a newer version wrote it, so it is never overwritten

    friend bool operator==(const DocumentFile&, const DocumentFile&) = default;
};

/// Knows which file a document is and what of it is saved there. It reports errors, and what the
/// reader has to tell, through message().
class DocumentFiles : public QObject {
    Q_OBJECT

  public:
    explicit DocumentFiles(Document& document, QObject* parent = nullptr);

    const DocumentFile& file() const { return file_; }
    /// Tells whether the file is a preset and more than the material that it holds was changed.
    bool outgrewPreset() const;
    /// Tells whether what is shown was recovered and has not been saved since.
    bool isRecovered() const { return isRecovered_; }

    /// Starts a new, untitled document from this scene.
    void startFrom(const Scene& scene);
    bool openScene(const std::filesystem::path& path, const ReadingRights& rights = {});
    /// Opens a scene as a new, untitled document (the default scene).
    bool openTemplate(const std::filesystem::path& path);
    /// Opens a copy of unsaved work, as the document of the file it came from: it is modified, and
    /// nothing undoes that.
    bool recover(const std::filesystem::path& copy, const DocumentFile& origin);
    /// Opens a preset as the document: the material of side A of the current object.
    bool openPreset(const std::filesystem::path& path, const ReadingRights& rights = {});
    /// Puts a preset on a side, as one undoable edit.
    bool applyPreset(const std::filesystem::path& path, Side side,
                     const ReadingRights& rights = {});

    /// Returns what a scene file of this document holds: the scene, with the compared sides and the
    /// snapshots in its extras.
    Scene sceneToSave() const;
    /// Returns the same for a recovery copy, which also says which files must not be read.
    Scene sceneToRecover() const;
    bool saveScene(const std::filesystem::path& path);
    bool savePreset(const std::filesystem::path& path, Side side);
    /// Sets whether saved presets keep the values that only other models use. The document and
    /// scene files always keep them.
    void setKeepsParked(bool keeps) { keepsParked_ = keeps; }
    /// Saves under a name, which the material in the document takes too unless the document is a
    /// scene.
    bool savePreset(const std::filesystem::path& path, Side side, const std::string& name);
    /// Saves to file(), by its kind; returns false when there is none or it must not be written.
    /// Files that come with Patina are never written.
    bool save();

    /// Returns what a scene or preset file names outside its folder and would not read with these
    /// rights.
    static OutsideFiles outsideOf(const std::filesystem::path& path, DocumentFile::Kind kind,
                                  const Catalog& catalog, const ReadingRights& rights);
    WithheldFiles& withheld() { return withheld_; }

  Q_SIGNALS:
    void fileChanged();
    void message(const patina::Error& message);

  private:
    void start(DocumentState state, DocumentFile file, int object = 0);
    std::optional<Errors> takeScene(const std::filesystem::path& path, const ReadingRights& rights);
    bool savePreset(const std::filesystem::path& path, const BlockPath& of, const Material& saved);
    void report(const Errors& messages);
    bool isOwnFile(const std::filesystem::path& path) const;
    bool mayOverwrite(const std::filesystem::path& path);
    void setFile(DocumentFile file);
    void markPresetSaved(Side side);

    Document& document_;
    WithheldFiles withheld_;
    DocumentFile file_;
    int presetObject_ = -1; ///< is the object whose material file_ holds, where that is a preset
    bool isRecovered_ = false;
    bool keepsParked_ = false;
    /// Holds the state as opened or saved, to know what saving a preset leaves out.
    DocumentState savedState_;
};

} // namespace patina

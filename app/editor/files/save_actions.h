// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include <QObject>

#include "document/document_files.h"
#include "session/session.h"

class QWidget;

namespace patina {

class OutsideConsent;

/// Saves what the document shows: asks where to, under which name, and before anything is lost.
class SaveActions : public QObject {
    Q_OBJECT

  public:
    /// All outlive it; dialogs belong to the window.
    SaveActions(Document& document, DocumentFiles& files, Session& session, OutsideConsent& consent,
                QWidget* window);

    /// Returns whether the document was saved.
    bool save();
    bool saveAs();

    /// Writes the material of the active side to a file of its own.
    void exportPreset();

    /// Asks about unsaved changes, and saves them if the user wants that. Returns false if the user
    /// cancels.
    bool mayLoseDocument();

    /// Returns a name that any file system accepts: lower case, without spaces and slashes.
    static QString asFileName(const QString& name);

  Q_SIGNALS:
    /// Is emitted when the whole document is on disk.
    void saved();

  private:
    void noteSaved(const QString& file);
    bool writePreset(const QString& file);
    bool mayReplace(const QString& asked, const QString& file);
    bool mayReplaceChanged(const std::filesystem::path& file);
    QString questionText() const;
    QString suggestedFile() const;
    QString suggestedName() const;
    QString nameOfCopy() const;

    Document& document_;
    DocumentFiles& files_;
    Session& session_;
    OutsideConsent& consent_;
    QWidget* window_;
    /// Is when the document's file was last read or written here.
    std::optional<std::filesystem::file_time_type> written_;
};

} // namespace patina

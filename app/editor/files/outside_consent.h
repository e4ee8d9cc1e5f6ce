// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document_files.h"
#include "session/session.h"

class QWidget;

namespace patina {

/// Asks, once for each file that is opened, whether it may read what it names outside its folder,
/// and remembers the answer.
class OutsideConsent {
  public:
    OutsideConsent(Session& session, QWidget* window) : session_(session), window_(window) {}

    /// Returns what the file may read; asks about what nobody was asked before.
    ReadingRights rightsFor(const QString& file, DocumentFile::Kind kind, const Catalog& catalog);

    /// Asks about these files, and remembers the answer unless the document has no file yet.
    bool ask(const QString& file, const OutsideFiles& wanted);

    /// The user saved this file himself: what it names outside is his own choice, but for what he
    /// refused; links of its meshes that he allowed stay so.
    void noteSaved(const QString& file, DocumentFile::Kind kind, const Catalog& catalog,
                   const WithheldFiles& withheld);

  private:
    Session& session_;
    QWidget* window_;
};

} // namespace patina

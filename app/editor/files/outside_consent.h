// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document_files.h"
#include "session/session.h"

class QWidget;

namespace patina {

/// Asks, once for each file that is opened, whether it may read files outside its folder, and
/// remembers the answer.
class OutsideConsent {
  public:
    OutsideConsent(Session& session, QWidget* window) : session_(session), window_(window) {}

    /// Returns what the file may read; asks about files that nobody was asked about before.
    ReadingRights rightsFor(const QString& file, DocumentFile::Kind kind, const Catalog& catalog);

    /// Asks about these files, and remembers the answer if the document has a file. Returns whether
    /// they may be read.
    bool ask(const QString& file, const OutsideFiles& wanted);

    /// Allows what a file that the user saved names outside its folder, except what was refused. A
    /// scene keeps the links of its meshes that were allowed.
    void noteSaved(const QString& file, DocumentFile::Kind kind, const Catalog& catalog,
                   const WithheldFiles& withheld);

  private:
    Session& session_;
    QWidget* window_;
};

} // namespace patina

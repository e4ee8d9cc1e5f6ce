// SPDX-License-Identifier: GPL-3.0-or-later
// Edits of a document's snapshots, each an undo step.
#pragma once

#include "document/document.h"
#include "material/preset_file.h"

namespace patina {

/// Keeps the active side's material under a name that no other snapshot has; `png`: a picture of
/// it. Nothing where there is no material.
void takeSnapshot(Document& document, std::string png);

/// An empty name changes nothing.
void renameSnapshot(Document& document, std::size_t index, const std::string& name);
void removeSnapshot(Document& document, std::size_t index);

/// Gives the active side the material again.
void restoreSnapshot(Document& document, std::size_t index);

/// Puts it on side B.
void compareWithSnapshot(Document& document, std::size_t index);

/// Snapshots as a scene file has them, and back; what cannot be read is left out.
nlohmann::json snapshotsToJson(const std::vector<Snapshot>& snapshots);
std::vector<Snapshot> snapshotsFromJson(const nlohmann::json& json,
                                        const std::filesystem::path& file, const Catalog& catalog,
                                        const ReadingRights& rights);

} // namespace patina

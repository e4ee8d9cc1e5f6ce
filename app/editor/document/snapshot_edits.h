// SPDX-License-Identifier: GPL-3.0-or-later
// Edits the snapshots of a document; each edit is one undo step.
#pragma once

#include "document/document.h"
#include "material/preset_file.h"

namespace patina {

/// Keeps the active side's material under a name that no other snapshot has. `png` holds the bytes
/// of a picture of it. Does nothing where there is no material.
void takeSnapshot(Document& document, std::string png);

/// Renames a snapshot; an empty name changes nothing.
void renameSnapshot(Document& document, std::size_t index, const std::string& name);
void removeSnapshot(Document& document, std::size_t index);

/// Gives the active side the material of a snapshot.
void restoreSnapshot(Document& document, std::size_t index);

/// Puts the material of a snapshot on side B.
void compareWithSnapshot(Document& document, std::size_t index);

/// Convert between snapshots and their form in a scene file; what cannot be read is left out.
nlohmann::json snapshotsToJson(const std::vector<Snapshot>& snapshots);
std::vector<Snapshot> snapshotsFromJson(const nlohmann::json& json,
                                        const std::filesystem::path& file, const Catalog& catalog,
                                        const ReadingRights& rights);

} // namespace patina

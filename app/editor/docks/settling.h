// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QTimer;

namespace patina {

class Document;
class MeshLibrary;

/// Starts a timer, unless it runs, whenever what the views show may have changed, so that a panel
/// that looks through the whole scene does so once for many edits.
void startWhenChanged(QTimer& settle, const Document& document, const MeshLibrary& meshes);

} // namespace patina

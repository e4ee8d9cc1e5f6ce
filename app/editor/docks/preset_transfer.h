// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QObject>

#include "docks/dock_context.h"
#include "files/preset_bundles.h"

class QWidget;

namespace patina {

class NoticeBar;

/// Asks for the files of bundles of presets, exports and imports them, and says in a notice how far
/// that is.
class PresetTransfer : public QObject {
    Q_OBJECT

  public:
    /// All outlive it; `panel` is the parent of its dialogs.
    PresetTransfer(const DockContext& context, NoticeBar& notice, QWidget& panel);

    void exportPresets(const std::vector<PresetPtr>& presets);
    void importPresets();

  Q_SIGNALS:
    /// A bundle is in this folder now, of which `text` tells.
    void imported(const QString& folder, const QString& text);

  private:
    QString told(const QString& done, const std::vector<BundleOutcome>& outcomes);

    DockContext context_;
    NoticeBar& notice_;
    QWidget& panel_;
    PresetBundles bundles_;
};

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/preset_transfer.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

#include "docks/notice_bar.h"
#include "files/file_actions.h"
#include "library/preset_library.h"
#include "session/session.h"

namespace patina {

PresetTransfer::PresetTransfer(const DockContext& context, NoticeBar& notice, QWidget& panel)
    : context_(context), notice_(notice), panel_(panel), bundles_(context.thumbnails) {
    connect(&bundles_, &PresetBundles::drawn, this, [this](int pictures, int of) {
        notice_.say(tr("Exporting: %1 of %2 pictures").arg(pictures).arg(of),
                    {{tr("Cancel"), tr("Export nothing"), [this] {
                          bundles_.cancelExport();
                          notice_.clear();
                      }}});
    });
    connect(&bundles_, &PresetBundles::exported, this,
            [this](const QString& file, const std::vector<BundleOutcome>& outcomes) {
                const QString done = tr("%1 is written").arg(QFileInfo(file).fileName());
                notice_.say(told(done, outcomes),
                            {{tr("OK"), tr("Close this note"), [this] { notice_.clear(); }}});
            });
    connect(&bundles_, &PresetBundles::imported, this,
            [this](const QString& folder, const std::vector<BundleOutcome>& outcomes) {
                const QString done = tr("Imported into %1").arg(QDir(folder).dirName());
                Q_EMIT imported(folder, told(done, outcomes));
            });
    connect(&bundles_, &PresetBundles::failed, &context_.files, &FileActions::report);
}

void PresetTransfer::exportPresets(const std::vector<PresetPtr>& presets) {
    const QString file = QFileDialog::getSaveFileName(
        &panel_, tr("Export %1 presets").arg(presets.size()),
        context_.session.folder("bundle") + QStringLiteral("/presets.zip"),
        tr("Bundles of presets (*.zip)"));
    if (!file.isEmpty() && !presets.empty()) {
        context_.session.setFolderOf("bundle", file);
        bundles_.exportTo(file, presets);
    }
}

void PresetTransfer::importPresets() {
    const QString file = QFileDialog::getOpenFileName(&panel_, tr("Import presets"),
                                                      context_.session.folder("bundle"),
                                                      tr("Bundles of presets (*.zip)"));
    if (!file.isEmpty()) {
        context_.session.setFolderOf("bundle", file);
        bundles_.importFrom(file, PresetLibrary::userFolder());
    }
}

/// Sends a message for each file that was not done, and returns what is said of all.
QString PresetTransfer::told(const QString& done, const std::vector<BundleOutcome>& outcomes) {
    int failed = 0;
    for (const BundleOutcome& outcome : outcomes) {
        if (!outcome.problem.empty()) {
            context_.files.report({outcome.name, 0, 0, outcome.problem, {}});
            ++failed;
        }
    }
    return failed == 0 ? done : tr("%1, but for %2 files").arg(done).arg(failed);
}

} // namespace patina

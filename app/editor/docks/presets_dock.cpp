// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/presets_dock.h"

#include <algorithm>

#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

#include "docks/panel.h"
#include "docks/picture_grid.h"
#include "docks/search_box.h"
#include "document/document.h"
#include "files/file_actions.h"
#include "library/preset_library.h"
#include "library/thumbnail_maker.h"
#include "session/message_log.h"

namespace patina {
namespace {

constexpr int presetPictureSize = 72;
const QString presetPictureGroup = QStringLiteral("preset/");

QString joined(const std::vector<std::string>& tags) {
    QStringList words;
    for (const std::string& tag : tags) {
        words << QString::fromStdString(tag);
    }
    return words.join(QStringLiteral(", "));
}

QString modelLabel(const Catalog& catalog, const Material& material) {
    const Block* model = catalog.find(kinds::models, material.model.id);
    return QString::fromStdString(model ? model->label : material.model.id);
}

QString toolTipOf(const PresetEntry& entry, const QString& model) {
    const QString description = QString::fromStdString(entry.material.description);
    const QString tags = joined(entry.material.tags);
    QString tip = QStringLiteral("<p><b>%1</b><br>%2</p>")
                      .arg(QString::fromStdString(entry.material.name).toHtmlEscaped(),
                           model.toHtmlEscaped());
    tip += description.isEmpty() ? "" : "<p>" + description.toHtmlEscaped() + "</p>";
    tip += tags.isEmpty() ? "" : "<p>" + tags.toHtmlEscaped() + "</p>";
    return tip + QStringLiteral("<p><i>%1</i></p>")
                     .arg((entry.shipped ? QObject::tr("Comes with Patina")
                                         : QString::fromStdString(entry.file.string()))
                              .toHtmlEscaped());
}

QString nameOf(const PresetEntry& entry) {
    return entry.material.name.empty() ? QFileInfo(QString::fromStdString(entry.file.string()))
                                             .fileName()
                                             .section('.', 0, 0)
                                       : QString::fromStdString(entry.material.name);
}

/// "red" is looked for in "Dark red" and "reddish", not in "scattered".
bool beginsAWord(const QString& text, const QString& searched) {
    for (qsizetype at = text.indexOf(searched, 0, Qt::CaseInsensitive); at >= 0;
         at = text.indexOf(searched, at + 1, Qt::CaseInsensitive)) {
        if (at == 0 || !text[at - 1].isLetterOrNumber() || !searched[0].isLetterOrNumber()) {
            return true;
        }
    }
    return false;
}

} // namespace

PresetsDock::PresetsDock(const DockContext& context)
    : document_(context.document), files_(context.files), presets_(context.presets),
      thumbnails_(context.thumbnails), search_(new SearchBox(this)), hint_(hintLabel(this)),
      grid_(new PictureGrid(presetPictureSize, this)) {
    auto* save =
        textButton(tr("Save…"), tr("Save the active material as a preset of your own"), this);
    search_->setPlaceholderText(tr("Search name, tag or model"));
    search_->setClearButtonEnabled(true);
    search_->setAccessibleName(tr("Search presets"));
    grid_->setAccessibleName(tr("Presets"));
    grid_->setContextMenuPolicy(Qt::CustomContextMenu);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 0);
    layout->addWidget(rowOf({search_, save}));
    layout->addWidget(hint_);
    layout->addWidget(grid_, 1);
    connect(save, &QToolButton::clicked, &files_, &FileActions::exportPreset);
    connect(search_, &QLineEdit::textChanged, this, &PresetsDock::applyFilter);
    const auto put = [this](QListWidgetItem* item) { apply(item, document_.activeSide()); };
    connect(grid_, &PictureGrid::chosen, this, put);
    connect(search_, &QLineEdit::returnPressed, grid_, [this, put] {
        if (QListWidgetItem* found = grid_->currentItem()) {
            put(found);
        }
    });
    connect(grid_, &QWidget::customContextMenuRequested, this, &PresetsDock::showMenu);
    connect(&presets_, &PresetLibrary::changed, this, &PresetsDock::fill);
    connect(&presets_, &PresetLibrary::checked, this, &PresetsDock::applyFilter);
    onChange(document_, DocumentChange::Catalog, grid_, &PictureGrid::wishAnew);
    connect(grid_, &PictureGrid::pictureWished, this, &PresetsDock::askForPicture);
    connect(&thumbnails_, &ThumbnailMaker::ready, this,
            [this](const QString& name, const QImage& picture) {
                if (name.startsWith(presetPictureGroup)) {
                    grid_->setPicture(name.mid(presetPictureGroup.size()), picture);
                }
            });
    fill();
}

void PresetsDock::fill() {
    std::vector<PictureGrid::Entry> entries;
    for (const PresetEntry& entry : presets_.entries()) {
        const QString file = QString::fromStdString(entry.file.string());
        const QString model = modelLabel(document_.catalog(), entry.material);
        entries.push_back({file, nameOf(entry), toolTipOf(entry, model), file});
    }
    grid_->setEntries(entries);
    applyFilter();
}

void PresetsDock::askForPicture(const QString& file) {
    for (const PresetEntry& entry : presets_.entries()) {
        if (QString::fromStdString(entry.file.string()) == file) {
            thumbnails_.ask(presetPictureGroup + file, entry.material);
        }
    }
}

void PresetsDock::applyFilter() {
    const std::vector<PresetEntry>& entries = presets_.entries();
    int shown = 0;
    for (int row = 0; row < grid_->count(); ++row) {
        const PresetEntry& entry = entries[static_cast<std::size_t>(row)];
        const bool match =
            matches(entry, modelLabel(document_.catalog(), entry.material), search_->text());
        grid_->item(row)->setHidden(!match);
        shown += match ? 1 : 0;
    }
    hint_->setText(!presets_.isRead() ? tr("The presets are being read…")
                   : entries.empty()  ? tr("There are no presets yet.")
                                      : tr("No preset matches."));
    hint_->setVisible(shown == 0);
    chooseAShownOne();
}

/// What Enter puts on a side is to be seen.
void PresetsDock::chooseAShownOne() {
    const QListWidgetItem* current = grid_->currentItem();
    const bool isSearching = !search_->text().trimmed().isEmpty();
    if (current ? current->isHidden() : isSearching) {
        grid_->setCurrentItem(grid_->firstShown());
    }
}

void PresetsDock::showMenu(const QPoint& place) {
    const QListWidgetItem* item = grid_->itemAt(place);
    if (!item) {
        return;
    }
    const QString file = grid_->fileOf(item);
    const auto& entries = presets_.entries();
    const auto entry = std::find_if(entries.begin(), entries.end(), [&](const PresetEntry& e) {
        return QString::fromStdString(e.file.string()) == file;
    });
    QMenu menu;
    menu.addAction(tr("Put on side A"), this, [this, file] { files_.applyPreset(file, Side::A); });
    menu.addAction(tr("Put on side B"), this, [this, file] { files_.applyPreset(file, Side::B); });
    const bool isShipped = entry == entries.end() || entry->shipped;
    menu.addAction(isShipped ? tr("Open to edit a copy") : tr("Open to edit this file"), this,
                   [this, file] { files_.open({file}, document_.activeSide()); });
    menu.addSeparator();
    QAction* trash = menu.addAction(tr("Move to trash"), this, [this, file] { moveToTrash(file); });
    trash->setEnabled(!isShipped);
    menu.exec(grid_->viewport()->mapToGlobal(place));
}

void PresetsDock::apply(const QListWidgetItem* item, Side side) {
    files_.applyPreset(grid_->fileOf(item), side);
}

void PresetsDock::moveToTrash(const QString& file) {
    if (QFile::moveToTrash(file)) {
        presets_.scan();
    } else {
        files_.tell({file.toStdString(), 0, 0, "the file could not be moved to the trash", {}});
    }
}

bool matches(const PresetEntry& entry, const QString& modelLabel, const QString& search) {
    const QString text = nameOf(entry) + ' ' + QString::fromStdString(entry.material.description) +
                         ' ' + joined(entry.material.tags) + ' ' + modelLabel;
    const QStringList words = search.split(' ', Qt::SkipEmptyParts);
    return std::all_of(words.begin(), words.end(),
                       [&](const QString& word) { return beginsAWord(text, word); });
}

} // namespace patina

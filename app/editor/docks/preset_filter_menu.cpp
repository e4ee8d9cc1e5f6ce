// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/preset_filter_menu.h"

#include <algorithm>
#include <set>

#include <QDir>
#include <QFileDialog>

#include "library/preset_library.h"

namespace patina {
namespace {

QString text(const std::filesystem::path& path) {
    return QString::fromStdString(path.string());
}

QString labelOf(const PresetFolder& folder) {
    return folder.shipped                               ? QObject::tr("Comes with Patina")
           : folder.path == PresetLibrary::userFolder() ? QObject::tr("My presets")
                                                        : text(folder.path.filename());
}

/// Returns the label of a model as its presets have it; the id if there are none.
QString modelLabel(const PresetLibrary& presets, const QString& model) {
    const std::string id = model.toStdString();
    const auto found = std::ranges::find_if(presets.entries(), [&id](const PresetPtr& entry) {
        return entry->material.model.id == id;
    });
    return found == presets.entries().end() ? model : (*found)->modelLabel;
}

/// Doubles ampersands, since a single one marks a letter in a menu.
QString asMenuText(QString text) {
    return text.replace('&', QStringLiteral("&&"));
}

} // namespace

PresetFilterMenu::PresetFilterMenu(PresetLibrary& presets, QWidget* parent)
    : QMenu(parent), presets_(presets) {
    connect(this, &QMenu::aboutToShow, this, &PresetFilterMenu::fill);
}

QString PresetFilterMenu::summary() const {
    QStringList parts;
    if (filter_.favourites) {
        parts << tr("Favourites");
    }
    if (filter_.recent) {
        parts << tr("Recent");
    }
    if (!filter_.model.isEmpty()) {
        parts << modelLabel(presets_, filter_.model);
    }
    if (!filter_.tag.isEmpty()) {
        parts << filter_.tag;
    }
    for (const PresetFolder& folder : presets_.folders()) {
        if (text(folder.path) == filter_.folder) {
            parts << labelOf(folder);
        }
    }
    if (parts.isEmpty() && !filter_.folder.isEmpty()) {
        parts << QDir(filter_.folder).dirName();
    }
    return parts.isEmpty() ? tr("All presets") : parts.join(QStringLiteral(" · "));
}

void PresetFilterMenu::clearFilter() {
    filter_ = {};
    Q_EMIT filterChanged();
}

void PresetFilterMenu::fill() {
    clear();
    QAction* all = addAction(tr("All presets"), this, &PresetFilterMenu::clearFilter);
    all->setCheckable(true);
    all->setChecked(filter_.isEmpty());
    addSwitch(tr("Favourites"), &PresetFilter::favourites);
    addSwitch(tr("Recently used"), &PresetFilter::recent);
    addSeparator();
    fillModels(*addMenu(tr("Model")));
    fillTags(*addMenu(tr("Tag")));
    fillFolders(*addMenu(tr("Folder")));
}

void PresetFilterMenu::addSwitch(const QString& text, bool PresetFilter::*field) {
    QAction* action = addAction(text);
    action->setCheckable(true);
    action->setChecked(filter_.*field);
    connect(action, &QAction::triggered, this, [this, field](bool on) {
        filter_.*field = on;
        Q_EMIT filterChanged();
    });
}

/// Adds a choice that is removed when it is chosen again.
void PresetFilterMenu::addChoice(QMenu& menu, const QString& text, QString PresetFilter::*field,
                                 const QString& value) {
    QAction* action = menu.addAction(asMenuText(text));
    action->setCheckable(true);
    action->setChecked(filter_.*field == value);
    connect(action, &QAction::triggered, this, [this, field, value](bool on) {
        filter_.*field = on ? value : QString();
        Q_EMIT filterChanged();
    });
}

void PresetFilterMenu::fillModels(QMenu& menu) {
    std::map<QString, QString> models; // label -> id
    for (const PresetPtr& entry : presets_.entries()) {
        models[entry->modelLabel] = QString::fromStdString(entry->material.model.id);
    }
    for (const auto& [label, id] : models) {
        addChoice(menu, label, &PresetFilter::model, id);
    }
}

void PresetFilterMenu::fillTags(QMenu& menu) {
    std::map<std::string, int> counts;
    for (const PresetPtr& entry : presets_.entries()) {
        for (const std::string& tag : entry->material.tags) {
            ++counts[tag];
        }
    }
    for (const auto& [tag, count] : counts) {
        const QString name = QString::fromStdString(tag);
        addChoice(menu, tr("%1 (%2)").arg(name).arg(count), &PresetFilter::tag, name);
    }
}

/// Lists the folders, and below the user's own ones their subfolders; shipped folders have one per
/// model and are not split.
void PresetFilterMenu::fillFolders(QMenu& menu) {
    const QString added = tr("Remove from the library");
    QMenu* removed = new QMenu(added, &menu);
    for (const PresetFolder& folder : presets_.folders()) {
        addChoice(menu, labelOf(folder), &PresetFilter::folder, text(folder.path));
        std::set<std::string> below;
        for (const PresetPtr& entry : presets_.entries()) {
            const auto parent = entry->file.parent_path();
            if (!folder.shipped && entry->folder == folder.path && parent != folder.path) {
                below.insert(parent.string());
            }
        }
        for (const std::string& each : below) {
            const auto inside = std::filesystem::path(each).lexically_relative(folder.path);
            addChoice(menu, QStringLiteral("    ") + text(inside), &PresetFilter::folder,
                      QString::fromStdString(each));
        }
        if (!folder.shipped && folder.path != PresetLibrary::userFolder()) {
            const QString path = text(folder.path);
            removed->addAction(asMenuText(path), this, [this, path] {
                presets_.removeFolder(path);
                clearFilter();
            });
        }
    }
    menu.addSeparator();
    menu.addAction(tr("Add a folder…"), this, &PresetFilterMenu::askForFolder);
    removed->setEnabled(!removed->isEmpty());
    menu.addMenu(removed);
}

void PresetFilterMenu::askForFolder() {
    const QString folder =
        QFileDialog::getExistingDirectory(parentWidget(), tr("Add a folder of presets"));
    if (!folder.isEmpty()) {
        presets_.addFolder(folder);
    }
}

} // namespace patina

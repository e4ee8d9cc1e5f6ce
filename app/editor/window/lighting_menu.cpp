// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/lighting_menu.h"

#include <filesystem>

#include "catalog/catalog.h"
#include "document/document.h"
#include "document/scene_edits.h"
#include "library/thumbnail_maker.h"
#include "scene/scene_file.h"
#include "window/look_style.h"

namespace patina {
namespace {

constexpr int pictureSize = 84; ///< pixels

} // namespace

LightingMenu::LightingMenu(Document& document, ThumbnailMaker& thumbnails, QWidget* parent)
    : QMenu(tr("Li&ghting"), parent), document_(document), thumbnails_(thumbnails) {
    setObjectName("lighting");
    setProperty(LookStyle::iconSize, pictureSize);
    connect(this, &QMenu::aboutToShow, this, &LightingMenu::fill);
    connect(&thumbnails, &ThumbnailMaker::ready, this, &LightingMenu::show);
}

void LightingMenu::fill() {
    clear();
    for (const std::filesystem::path& file : shippedScenes()) {
        const auto read = readScene(file, document_.catalog());
        if (!read) {
            continue;
        }
        const QString name = "scene " + QString::fromStdString(file.string());
        QAction* action = addAction(QString::fromStdString(read->scene.name), this,
                                    [this, scene = read->scene] { setLighting(document_, scene); });
        QPixmap empty(pictureSize, pictureSize); // keeps the menu's size until the picture comes
        empty.fill(Qt::transparent);
        const auto known = pictures_.find(name);
        action->setIcon(known != pictures_.end() ? known->second : QIcon(empty));
        action->setIconVisibleInMenu(true);
        action->setData(name);
        thumbnails_.askScene(name, file); // comes from the disk unless something has changed
    }
}

void LightingMenu::show(const QString& name, const QImage& picture) {
    if (picture.isNull()) {
        return;
    }
    for (QAction* action : actions()) {
        if (action->data().toString() == name) {
            const QIcon icon(QPixmap::fromImage(picture));
            pictures_.insert_or_assign(name, icon);
            action->setIcon(icon);
        }
    }
}

} // namespace patina

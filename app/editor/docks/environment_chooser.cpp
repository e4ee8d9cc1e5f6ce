// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/environment_chooser.h"

#include <algorithm>

#include <QDragEnterEvent>
#include <QFileInfo>
#include <QSignalBlocker>

#include "document/scene_edits.h"
#include "document/swapped_block.h"
#include "library/thumbnail_maker.h"
#include "parameters/dropped_files.h"
#include "scene/environment.h"
#include "session/session.h"
#include "text/short_text.h"

namespace patina {
namespace {

const QString pictureGroup = QStringLiteral("environment/");
constexpr QSize shownPixels{64, 32};

/// Returns whether an item is a file: ids of blocks have no slash, absolute paths begin with one.
bool isFile(const QString& data) {
    return data.startsWith('/');
}

/// Returns those of the dragged files that are panoramas.
QStringList panoramasIn(const QMimeData& data) {
    QStringList files = draggedFiles(data);
    files.removeIf([](const QString& file) {
        const QString ending = QFileInfo(file).suffix().toLower();
        return ending != "hdr" && ending != "exr";
    });
    return files;
}

/// Returns an empty icon that keeps room for the image.
QIcon noPicture() {
    QPixmap empty(ThumbnailMaker::environmentPixels);
    empty.fill(Qt::transparent);
    return QIcon(empty);
}

} // namespace

EnvironmentChooser::EnvironmentChooser(Document& document, Session& session,
                                       ThumbnailMaker& thumbnails, QWidget* parent)
    : BlockChooser(document, kinds::environment, Off::Offered, parent), session_(session),
      thumbnails_(thumbnails) {
    setIconSize(shownPixels);
    setAcceptDrops(true);
    connect(this, &BlockChooser::chosen, this, [this](const QString& data) {
        if (isFile(data)) {
            Q_EMIT pictureChosen(data);
        }
    });
    connect(&thumbnails_, &ThumbnailMaker::ready, this, &EnvironmentChooser::take);
    addFiles();
}

/// Adds the files after the blocks. The constructor adds them itself, since that of the base class
/// calls its own fill().
void EnvironmentChooser::fill() {
    wished_.clear();
    BlockChooser::fill();
    addFiles();
}

void EnvironmentChooser::addFiles() {
    const QSignalBlocker quiet(this);
    const QStringList files = session_.environments();
    if (!files.isEmpty()) {
        insertSeparator(count());
    }
    for (const QString& file : files) {
        addItem(shortened(QFileInfo(file).completeBaseName()), file);
        setItemData(count() - 1, file.toHtmlEscaped(), Qt::ToolTipRole);
    }
    for (int i = 0; i < count(); ++i) {
        if (const QString data = itemData(i).toString(); !data.isEmpty()) {
            setItemIcon(i, pictures_.value(data, noPicture()));
        }
    }
    showCurrent();
}

void EnvironmentChooser::showCurrent() {
    const BlockValues* environment =
        blockValuesAt(document().state(), document().selection().currentPath(kinds::environment));
    const auto picture = QString::fromStdString(
        std::string(environmentPicture(document(), document().selection().side())));
    show(environment == nullptr                      ? QString()
         : isFile(picture) && findData(picture) >= 0 ? picture
                                                     : QString::fromStdString(environment->id));
    wishPicture(currentIndex());
}

void EnvironmentChooser::add(const QString& file) {
    if (session_.environments().value(0) != QFileInfo(file).absoluteFilePath()) {
        session_.addEnvironment(file);
        fill();
    }
}

void EnvironmentChooser::showPopup() {
    wishPictures();
    BlockChooser::showPopup();
}

void EnvironmentChooser::wishPictures() {
    for (int i = 0; i < count(); ++i) {
        wishPicture(i);
    }
}

void EnvironmentChooser::wishPicture(int index) {
    const QString data = itemData(index).toString();
    if (data.isEmpty() || wished_.contains(data)) {
        return;
    }
    wished_.insert(data);
    const Catalog& catalog = document().catalog();
    if (!isFile(data)) {
        const Block* block = catalog.find(kinds::environment, data.toStdString());
        if (block != nullptr && pictureParameter(*block) == nullptr) {
            thumbnails_.askEnvironment(pictureGroup + data, defaultsOf(*block));
        }
        return;
    }
    const std::vector<const Block*> all = catalog.ofKind(kinds::environment);
    const auto found = std::ranges::find_if(
        all, [](const Block* block) { return pictureParameter(*block) != nullptr; });
    if (found != all.end()) {
        BlockValues values = defaultsOf(**found);
        values.parameters[pictureParameter(**found)->id] = data.toStdString();
        thumbnails_.askEnvironment(pictureGroup + data, values);
    }
}

void EnvironmentChooser::take(const QString& name, const QImage& picture) {
    if (!name.startsWith(pictureGroup) || picture.isNull()) {
        return;
    }
    const QString data = name.mid(pictureGroup.size());
    pictures_[data] = QIcon(QPixmap::fromImage(picture));
    if (const int index = findData(data); index >= 0) {
        setItemIcon(index, pictures_[data]);
    }
}

void EnvironmentChooser::dragEnterEvent(QDragEnterEvent* event) {
    if (!panoramasIn(*event->mimeData()).isEmpty()) {
        acceptCopy(*event);
    }
}

/// Adds all dropped files to the list, and lights the scene with the first one.
void EnvironmentChooser::dropEvent(QDropEvent* event) {
    const QStringList files = panoramasIn(*event->mimeData());
    if (files.isEmpty()) {
        return;
    }
    acceptCopy(*event);
    std::for_each(files.rbegin(), files.rend(),
                  [this](const QString& file) { session_.addEnvironment(file); });
    fill();
    Q_EMIT pictureChosen(QFileInfo(files.front()).absoluteFilePath());
}

} // namespace patina

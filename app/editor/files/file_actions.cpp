// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/file_actions.h"

#include <algorithm>

#include <QFileDialog>
#include <QFileInfo>

#include "document/scene_edits.h"
#include "files/details_dialog.h"
#include "material/file_suffixes.h"
#include "measured/measured_reflectance.h"
#include "resources/texture_library.h"
#include "scene/scene_file.h"
#include "sheet/sheet_file.h"
#include "text/as_text.h"

namespace patina {

FileActions::FileActions(Document& document, DocumentFiles& files, MeshLibrary& meshes,
                         TextureLibrary& textures, Session& session, QWidget* window)
    : QObject(window), document_(document), files_(files), meshes_(meshes), textures_(textures),
      session_(session), consent_(session, window),
      saving_(document, files, session, consent_, window),
      meshActions_(document, files, meshes, session, window),
      clipboard_(new ClipboardActions(document, files, meshes, this)), window_(window) {
    connect(&meshes, &MeshLibrary::linksRefused, this, &FileActions::noteLinks);
    connect(&document, &Document::fileNamed, this, [this](const std::filesystem::path& file) {
        if (isMeasuredFile(file)) {
            textures_.readTable(file); // as soon as a value names it, so that a failure is told
        }
    });
}

/// Has the measured files among these read in the background before it goes on; with none it goes
/// on at once.
void FileActions::whenRead(const QStringList& files, const std::function<void()>& next) {
    const auto measured = std::ranges::find_if(
        files, [](const QString& file) { return isMeasuredFile(file.toStdString()); });
    if (measured == files.end()) {
        next();
        return;
    }
    const QStringList rest(measured + 1, files.end());
    textures_.readTable(measured->toStdString(), [this, rest, next] { whenRead(rest, next); });
}

void FileActions::newDocument() {
    if (saving_.mayLoseDocument()) {
        files_.openTemplate(defaultSceneFile());
        meshActions_.forget();
        Q_EMIT documentReplaced();
    }
}

void FileActions::askAndOpen() {
    const QStringList files = QFileDialog::getOpenFileNames(
        window_, tr("Open"), session_.folder("open"),
        tr("Presets, scenes and meshes") +
            " (*.json *.obj *.gltf *.glb *.ply *.stl *.fbx *.dae *.3ds *.blend *.off"
            " *.hdr *.exr *.binary *.bsdf);;" +
            tr("All files") + " (*)");
    if (!files.isEmpty()) {
        session_.setFolderOf("open", files.front());
        open(files, document_.selection().side());
    }
}

void FileActions::noteLinks(const QString& mesh, const std::vector<std::string>& places) {
    files_.withheld().addLinks(places);
    tellOutside(mesh);
}

void FileActions::editDetails() {
    const Side side = document_.selection().side();
    const Material* material = document_.material(side);
    if (!material) {
        return;
    }
    DetailsDialog dialog(*material, window_);
    if (dialog.exec() == QDialog::Accepted) {
        document_.replaceMaterial(side, dialog.edited(), tr("Change details"));
    }
}

void FileActions::open(const QStringList& files, Side side) {
    whenRead(files, [this, files, side] { openRead(files, side); });
}

void FileActions::openRead(const QStringList& files, Side side) {
    QStringList documents;
    QStringList meshes; // these and what follows belong to the document that is opened
    QStringList others;
    for (const QString& file : files) {
        if (kindOf(file) == Kind::Mesh) {
            meshes << file;
        } else if (kindOf(file) == Kind::Panorama || kindOf(file) == Kind::Sheet) {
            others << file;
        } else {
            documents << file;
        }
    }
    if (!documents.isEmpty()) {
        openDocument(documents.takeFirst());
    }
    if (!documents.isEmpty() && kindOf(documents.front()) == Kind::Preset) {
        applyRead(documents.takeFirst(), side == Side::A ? Side::B : Side::A);
    }
    for (const QString& mesh : meshes) {
        meshActions_.load(mesh);
    }
    for (const QString& file : documents) {
        report({file.toStdString(), 0, 0, "is not opened: there is room for one scene or preset",
                "beside it a preset for the other side, and meshes"});
    }
    dropRead(others, side);
}

void FileActions::drop(const QStringList& files, Side side) {
    whenRead(files, [this, files, side] { dropRead(files, side); });
}

void FileActions::dropRead(const QStringList& files, Side side) {
    for (const QString& file : files) {
        switch (kindOf(file)) {
        case Kind::Preset:
            applyRead(file, side);
            document_.selection().setSide(side); // what was put there is what is worked on next
            break;
        case Kind::Scene:
            openDocument(file);
            break;
        case Kind::Panorama:
            patina::setEnvironmentPicture(document_,
                                          QFileInfo(file).absoluteFilePath().toStdString());
            break;
        case Kind::Mesh:
            meshActions_.load(file);
            break;
        case Kind::Sheet:
            document_.selection().setSide(side);
            Q_EMIT sheetWished(file);
            break;
        }
    }
}

void FileActions::applyPreset(const QString& file, Side side) {
    whenRead({file}, [this, file, side] { applyRead(file, side); });
}

void FileActions::applyRead(const QString& file, Side side) {
    const ReadingRights rights =
        consent_.rightsFor(file, DocumentFile::Kind::Preset, document_.catalog());
    if (files_.applyPreset(file.toStdString(), side, rights)) {
        Q_EMIT presetApplied(file);
    }
}

void FileActions::allowOutside() {
    const OutsideFiles wanted = files_.withheld().all();
    const QString file = QString::fromStdString(files_.file().path.string());
    if (!wanted.empty() && consent_.ask(file, wanted)) {
        files_.withheld().allowAll(files_.file().path);
    }
}

FileActions::Kind FileActions::kindOf(const QString& file) {
    if (file.endsWith(asText(sceneSuffix), Qt::CaseInsensitive)) {
        return Kind::Scene;
    }
    if (file.endsWith(QString::fromStdString(std::string(sheetEnding)), Qt::CaseInsensitive)) {
        return Kind::Sheet;
    }
    for (const QString& panorama : {QStringLiteral(".hdr"), QStringLiteral(".exr")}) {
        if (file.endsWith(panorama, Qt::CaseInsensitive)) {
            return Kind::Panorama;
        }
    }
    if (isMeasuredFile(file.toStdString())) {
        return Kind::Preset;
    }
    if (!file.endsWith(QStringLiteral(".json"), Qt::CaseInsensitive)) {
        return Kind::Mesh;
    }
    const bool isNamed = file.endsWith(asText(presetSuffix), Qt::CaseInsensitive);
    return !isNamed && saysItIsAScene(file.toStdString()) ? Kind::Scene : Kind::Preset;
}

void FileActions::openDocument(const QString& file) {
    if (!saving_.mayLoseDocument()) {
        return;
    }
    const bool isScene = kindOf(file) == Kind::Scene;
    const ReadingRights rights =
        consent_.rightsFor(file, isScene ? DocumentFile::Kind::Scene : DocumentFile::Kind::Preset,
                           document_.catalog());
    const bool opened = isScene ? files_.openScene(file.toStdString(), rights)
                                : files_.openPreset(file.toStdString(), rights);
    if (opened) {
        meshActions_.forget();
        meshes_.repeatMissingLinks(document_.scene());
        session_.addRecentFile(file);
        tellOutside(file);
        Q_EMIT documentReplaced();
    }
}

void FileActions::tellOutside(const QString& file) {
    if (!files_.withheld().all().empty()) {
        report({file.toStdString(), 0, 0, "names files outside its folder, which are not read",
                "File > Allow Files Outside, where you trust it"});
    }
}

void FileActions::readAgain() {
    meshes_.readAgain(document_.scene());
    textures_.readAgain();
    Q_EMIT readingAgain();
}

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/save_actions.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QRegularExpression>

#include "files/outside_consent.h"
#include "library/preset_library.h"
#include "material/file_suffixes.h"
#include "measured/measured_reflectance.h"
#include "text/as_text.h"

namespace patina {
namespace {

const QString presetEnding = asText(presetSuffix);
const QString sceneEnding = asText(sceneSuffix);

constexpr int maxNameBytes = 160;

QString presetFilter() {
    return QObject::tr("Patina presets (*.patina.json)");
}

QString sceneFilter() {
    return QObject::tr("Patina scenes (*.patina-scene.json)");
}

/// Returns when a file was written; empty if it does not exist.
std::optional<std::filesystem::file_time_type> timeOf(const std::filesystem::path& file) {
    std::error_code missing;
    const auto time = std::filesystem::last_write_time(file, missing);
    return missing ? std::nullopt : std::optional(time);
}

/// Returns the folder of the user's presets after creating it; a dialog starts elsewhere if that
/// fails.
QString madePresetFolder() {
    const std::filesystem::path folder = PresetLibrary::userFolder();
    std::error_code ignored;
    std::filesystem::create_directories(folder, ignored);
    return QString::fromStdString(folder.string());
}

/// Cuts a name to 160 bytes of UTF-8, so that it fits into 255 with an ending.
QString fitting(QString name) {
    while (name.toUtf8().size() > maxNameBytes) {
        name.chop(name.back().isLowSurrogate() ? 2 : 1);
    }
    return name;
}

QString withSuffix(QString file, const QString& suffix) {
    if (file.isEmpty() || file.endsWith(suffix)) {
        return file;
    }
    const QString json = QStringLiteral(".json");
    return (file.endsWith(json) ? file.chopped(json.size()) : file) + suffix;
}

} // namespace

SaveActions::SaveActions(Document& document, DocumentFiles& files, Session& session,
                         OutsideConsent& consent, QWidget* window)
    : document_(document), files_(files), session_(session), consent_(consent), window_(window) {
    connect(&files, &DocumentFiles::fileChanged, this,
            [this] { written_ = timeOf(files_.file().path); });
}

bool SaveActions::save() {
    const DocumentFile& file = files_.file();
    if (file.kind == DocumentFile::Kind::None || file.readOnly || files_.outgrewPreset() ||
        isShippedPreset(file.path)) {
        return saveAs();
    }
    // Saves even if nothing was edited: moving the camera is no edit, and the file may be gone.
    const bool isSaved = mayReplaceChanged(file.path) && files_.save();
    if (isSaved) {
        noteSaved(QString::fromStdString(file.path.string()));
    }
    return isSaved;
}

bool SaveActions::saveAs() {
    const bool isPreset =
        files_.file().kind == DocumentFile::Kind::Preset && !files_.outgrewPreset();
    QString filter = isPreset ? presetFilter() : sceneFilter();
    QString file = QFileDialog::getSaveFileName(window_, tr("Save As"), suggestedFile(),
                                                sceneFilter() + ";;" + presetFilter(), &filter);
    if (file.isEmpty()) {
        return false;
    }
    const bool asPreset =
        file.endsWith(presetEnding) || (!file.endsWith(sceneEnding) && filter == presetFilter());
    const QString asked = file;
    file = withSuffix(file, asPreset ? presetEnding : sceneEnding);
    if (!mayReplace(asked, file)) {
        return false;
    }
    const bool isSaved = asPreset ? writePreset(file) : files_.saveScene(file.toStdString());
    if (isSaved) {
        session_.setFolderOf("scene", file);
        noteSaved(file);
    }
    return isSaved;
}

/// A preset may hold less than what was changed.
void SaveActions::noteSaved(const QString& file) {
    session_.addRecentFile(file);
    consent_.noteSaved(
        file, file.endsWith(presetEnding) ? DocumentFile::Kind::Preset : DocumentFile::Kind::Scene,
        document_.catalog(), files_.withheld());
    if (!document_.isModified()) {
        Q_EMIT saved();
        return;
    }
    Q_EMIT files_.message(
        {file.toStdString(), 0, 0,
         "the preset is saved, but lights, fog, objects and side B are not part of it",
         "Save As with a scene file to keep them too"});
}

void SaveActions::exportPreset() {
    const Material* material = document_.material(document_.selection().side());
    if (!material) {
        return;
    }
    const QString name = asFileName(QString::fromStdString(material->name)) + presetEnding;
    const QString start = madePresetFolder() + '/' + name;
    const QString asked = QFileDialog::getSaveFileName(window_, tr("Save the material as a preset"),
                                                       start, presetFilter());
    const QString file = withSuffix(asked, presetEnding);
    if (!file.isEmpty() && mayReplace(asked, file) && writePreset(file)) {
        session_.addRecentFile(file);
        consent_.noteSaved(file, DocumentFile::Kind::Preset, document_.catalog(),
                           files_.withheld());
    }
}

/// Writes a preset. Under another file name the material gets that name, since it is another
/// preset.
bool SaveActions::writePreset(const QString& file) {
    const Side side = document_.selection().side();
    const Material* material = document_.material(side);
    if (!material) {
        return false;
    }
    const QString held = QString::fromStdString(material->name);
    const QString name = QFileInfo(file).fileName().chopped(presetEnding.size());
    const bool isSameFile = files_.file().path == file.toStdString();
    const bool staysCalled = !held.isEmpty() && (isSameFile || name == asFileName(held) ||
                                                 name.compare(held, Qt::CaseInsensitive) == 0);
    return files_.savePreset(file.toStdString(), side, (staysCalled ? held : name).toStdString());
}

/// Asks if another program has written the file since it was opened or saved here.
bool SaveActions::mayReplaceChanged(const std::filesystem::path& file) {
    const auto written = timeOf(file);
    return !written || written == written_ ||
           QMessageBox::warning(window_, tr("Save"),
                                tr("%1 was changed by another program since it was opened. "
                                   "Replace it?")
                                    .arg(QString::fromStdString(file.filename().string())),
                                QMessageBox::Yes | QMessageBox::No,
                                QMessageBox::No) == QMessageBox::Yes;
}

/// Asks again if a suffix was added, since the file dialog asked about the name without it.
bool SaveActions::mayReplace(const QString& asked, const QString& file) {
    return file == asked || !QFileInfo::exists(file) ||
           QMessageBox::warning(
               window_, tr("Save"),
               tr("%1 already exists. Replace it?").arg(QFileInfo(file).fileName()),
               QMessageBox::Yes | QMessageBox::No, QMessageBox::No) == QMessageBox::Yes;
}

bool SaveActions::mayLoseDocument() {
    if (!document_.isModified()) {
        return true;
    }
    QMessageBox question(QMessageBox::Question, tr("Unsaved changes"), questionText(),
                         QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window_);
    question.setInformativeText(files_.isRecovered()
                                    ? tr("The recovered work is offered again at the next start "
                                         "if you do not save it.")
                                    : tr("They are lost if you do not save them."));
    question.setDefaultButton(QMessageBox::Save);
    const int answer = question.exec();
    if (answer == QMessageBox::Save) {
        return save() && mayLoseDocument(); // asks again when a preset held only a part of it
    }
    return answer == QMessageBox::Discard;
}

QString SaveActions::questionText() const {
    const QString file = QString::fromStdString(files_.file().path.filename().string());
    if (files_.outgrewPreset()) {
        return tr("Save the changes as a scene? %1 is a preset, which holds a material and no "
                  "lights, fog, objects or side B.")
            .arg(file);
    }
    if (isShippedPreset(files_.file().path)) {
        return tr("Save the changes to a copy? %1 comes with Patina and stays as it is.").arg(file);
    }
    return tr("Save the changes to %1?").arg(file.isEmpty() ? tr("the untitled scene") : file);
}

/// Suggests a copy of files that come with Patina; a preset goes among the user's own.
QString SaveActions::suggestedFile() const {
    const std::filesystem::path& path = files_.file().path;
    const std::filesystem::path folder = path.parent_path();
    if (isShippedPreset(path)) {
        const bool isPreset =
            files_.file().kind == DocumentFile::Kind::Preset && !files_.outgrewPreset();
        return isPreset ? madePresetFolder() + '/' + nameOfCopy() + presetEnding
                        : session_.folder("scene") + '/' + nameOfCopy() + sceneEnding;
    }
    return (folder.empty() ? session_.folder("scene") : QString::fromStdString(folder.string())) +
           '/' + suggestedName();
}

/// Returns "Copy of" with the name in its own case, as it becomes the name of the copy.
QString SaveActions::nameOfCopy() const {
    const Material* material = document_.material(Side::A);
    const bool isPreset = files_.file().kind == DocumentFile::Kind::Preset;
    const std::string& name = isPreset && material ? material->name : document_.scene().name;
    const QString stem = QString::fromStdString(files_.file().path.filename().string());
    const QString called = name.empty() ? stem.section('.', 0, 0) : QString::fromStdString(name);
    return fitting(tr("Copy of %1").arg(called).replace('/', '-'));
}

QString SaveActions::suggestedName() const {
    const std::filesystem::path& path = files_.file().path;
    if (!path.empty()) {
        const QString name = QString::fromStdString(path.filename().string());
        if (isMeasuredFile(path)) {
            return QString::fromStdString(path.stem().string()) +
                   (files_.outgrewPreset() ? sceneEnding : presetEnding);
        }
        return files_.outgrewPreset() && name.endsWith(presetEnding)
                   ? name.chopped(presetEnding.size()) + sceneEnding
                   : name;
    }
    return asFileName(QString::fromStdString(document_.scene().name)) + sceneEnding;
}

QString SaveActions::asFileName(const QString& name) {
    QString safe = name.trimmed().toLower();
    safe.replace(QRegularExpression(QStringLiteral("[^\\w.-]+"),
                                    QRegularExpression::UseUnicodePropertiesOption),
                 QStringLiteral("-"));
    return safe.isEmpty() ? QStringLiteral("untitled") : fitting(safe);
}

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/snapshot_edits.h"

#include <algorithm>
#include <utility>

#include <QByteArray>

#include "document/commands/snapshots_command.h"
#include "document/compare_edits.h"

namespace patina {
namespace {

/// A file may hold this many snapshots, each with a picture of this many bytes in base64.
constexpr std::size_t maxSnapshots = 500;
constexpr std::size_t maxPictureBytes = 1u << 20;

bool isThere(const Document& document, std::size_t index) {
    return index < document.state().snapshots.size();
}

void replaceAll(Document& document, const QString& label, std::vector<Snapshot> snapshots) {
    if (snapshots != document.state().snapshots) {
        document.undoStack().push(new SnapshotsCommand(document, label, std::move(snapshots)));
    }
}

std::string freeName(const std::vector<Snapshot>& snapshots, const std::string& wanted) {
    std::string name = wanted;
    for (int number = 2; std::ranges::find(snapshots, name, &Snapshot::name) != snapshots.end();
         ++number) {
        name = wanted + ' ' + std::to_string(number);
    }
    return name;
}

std::string textIn(const nlohmann::json& json, const char* key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// Returns the picture of a snapshot as PNG; empty where it is too large.
std::string pictureIn(const nlohmann::json& json) {
    const std::string text = textIn(json, "picture");
    return text.size() > maxPictureBytes
               ? std::string()
               : QByteArray::fromBase64(QByteArray::fromStdString(text)).toStdString();
}

} // namespace

void takeSnapshot(Document& document, std::string png) {
    const Material* material = document.material(document.selection().side());
    std::vector<Snapshot> snapshots = document.state().snapshots;
    if (material && snapshots.size() < maxSnapshots) {
        const std::string wanted =
            material->name.empty() ? Document::tr("Snapshot").toStdString() : material->name;
        snapshots.push_back({freeName(snapshots, wanted), *material, std::move(png)});
        replaceAll(document, Document::tr("Take snapshot"), std::move(snapshots));
    }
}

void renameSnapshot(Document& document, std::size_t index, const std::string& name) {
    if (isThere(document, index) && !name.empty()) {
        std::vector<Snapshot> snapshots = document.state().snapshots;
        snapshots[index].name = name;
        replaceAll(document, Document::tr("Rename snapshot"), std::move(snapshots));
    }
}

void removeSnapshot(Document& document, std::size_t index) {
    if (isThere(document, index)) {
        std::vector<Snapshot> snapshots = document.state().snapshots;
        snapshots.erase(snapshots.begin() + static_cast<std::ptrdiff_t>(index));
        replaceAll(document, Document::tr("Remove snapshot"), std::move(snapshots));
    }
}

void restoreSnapshot(Document& document, std::size_t index) {
    if (isThere(document, index)) {
        const Snapshot snapshot = document.state().snapshots[index];
        document.replaceMaterial(
            document.selection().side(), snapshot.material,
            Document::tr("Restore %1").arg(QString::fromStdString(snapshot.name)));
    }
}

void compareWithSnapshot(Document& document, std::size_t index) {
    if (isThere(document, index) && document.material(Side::A)) {
        setSecondMaterial(document, document.state().snapshots[index].material);
    }
}

nlohmann::json snapshotsToJson(const std::vector<Snapshot>& snapshots) {
    nlohmann::json list = nlohmann::json::array();
    for (const Snapshot& snapshot : snapshots) {
        const QByteArray picture = QByteArray::fromStdString(snapshot.png).toBase64();
        list.push_back({{"name", snapshot.name},
                        {"material", toJson(snapshot.material)},
                        {"picture", picture.toStdString()}});
    }
    return list;
}

std::vector<Snapshot> snapshotsFromJson(const nlohmann::json& json,
                                        const std::filesystem::path& file, const Catalog& catalog,
                                        const ReadingRights& rights) {
    std::vector<Snapshot> snapshots;
    for (const nlohmann::json& each : json) {
        if (!each.is_object() || !each.contains("material") || snapshots.size() >= maxSnapshots) {
            continue;
        }
        const LocatedJson document{file.string(), each["material"], {}};
        const auto reading = materialFromJson(document, "", catalog, rights);
        if (reading) {
            snapshots.push_back({textIn(each, "name"), reading->material, pictureIn(each)});
        }
    }
    return snapshots;
}

} // namespace patina

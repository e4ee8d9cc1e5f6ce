// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/chart_store.h"

#include <system_error>

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>

#include "catalog/json_text.h"
#include "core/atomic_file.h"
#include "measure/cost/cost_table.h"
#include "scene/scene_file.h"

namespace patina {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* formatName = "patina.measurement";
constexpr int formatVersion = 1;
constexpr const char* ending = ".patina-measurement.json";
constexpr qsizetype maxFiles = 200;

std::string hashed(const std::string& text) {
    return QCryptographicHash::hash(QByteArray::fromStdString(text), QCryptographicHash::Sha256)
        .toHex()
        .toStdString();
}

json cameraJson(const Camera& camera) {
    return {{"pivot", {camera.pivot.x, camera.pivot.y, camera.pivot.z}},
            {"yaw", camera.yaw},
            {"pitch", camera.pitch},
            {"distance", camera.distance},
            {"fieldOfView", camera.fieldOfView},
            {"near", camera.nearPlane},
            {"far", camera.farPlane}};
}

/// Reads numbers as floats, since they are written so, and since a scene that is read has floats.
Camera cameraFrom(const json& from) {
    const auto number = [](const json& value) { return double(value.get<float>()); };
    const json& pivot = from.at("pivot");
    return {{number(pivot.at(0)), number(pivot.at(1)), number(pivot.at(2))},
            number(from.at("yaw")),
            number(from.at("pitch")),
            number(from.at("distance")),
            number(from.at("fieldOfView")),
            number(from.value("near", json(0.0))),
            number(from.value("far", json(0.0)))};
}

/// Writes what was predicted of the chart's points, in their order.
json predictedJson(const Result<PredictedPoints>& predicted) {
    if (!predicted) {
        return {{"problem", predicted.error().problem}, {"expected", predicted.error().expected}};
    }
    json ways = json::array();
    for (const PredictedWay& way : predicted->ways) {
        ways.push_back({{"levels", way.levels}, {"answer", toJson(way.statistics)}});
    }
    return {{"driver", predicted->driver}, {"ways", ways}};
}

Result<PredictedPoints> predictedFrom(const json& from) {
    if (from.contains("problem")) {
        return failure(from.at("problem").get<std::string>(),
                       from.at("expected").get<std::string>());
    }
    PredictedPoints predicted;
    predicted.driver = from.value("driver", std::string());
    for (const json& way : from.value("ways", json::array())) {
        predicted.ways.push_back(
            {way.at("levels").get<ChosenLevels>(), familyStatisticsIn(way.at("answer").dump())});
    }
    return predicted;
}

json jsonOf(const ChartKey& key, const StoredChart& stored) {
    return {{"format", formatName},
            {"version", formatVersion},
            {"page", key.page},
            {"file", key.file},
            {"object", key.object},
            {"hash", stored.hash},
            {"camera", cameraJson(stored.measured.camera)},
            {"complete", stored.complete},
            {"problem", stored.problem},
            {"chart", costJson(stored.measured.chart)},
            {"predicted", predictedJson(stored.measured.predicted)}};
}

Result<StoredChart> chartFrom(const json& from) {
    try {
        auto chart = costFromJson(from.at("chart"));
        if (!chart) {
            return tl::unexpected(chart.error());
        }
        StoredChart stored;
        stored.measured.camera = cameraFrom(from.at("camera"));
        stored.complete = from.at("complete").get<bool>();
        stored.problem = from.at("problem").get<std::string>();
        stored.measured.chart = std::move(*chart);
        stored.measured.predicted = predictedFrom(from.value("predicted", json::object()));
        stored.hash = from.at("hash").get<std::string>();
        return stored;
    } catch (const json::exception& missing) {
        return failure(missing.what(), "a measurement as Patina writes it");
    }
}

/// Returns a name beside the file that no file has yet.
fs::path asidePath(const fs::path& file) {
    fs::path aside = file.string() + ".damaged";
    std::error_code none;
    for (int i = 2; fs::exists(aside, none); ++i) {
        aside = file.string() + ".damaged-" + std::to_string(i);
    }
    return aside;
}

Error putAside(const fs::path& file, const Error& why) {
    const fs::path aside = asidePath(file);
    std::error_code failed;
    fs::rename(file, aside, failed);
    const std::string where = failed ? std::string("it stays where it is")
                                     : "it was put aside as " + aside.filename().string();
    return {file.string(), why.line, why.column,
            "what was measured before cannot be read, and " + where + ": " + why.problem,
            why.expected};
}

} // namespace

/// Names the file with the format's version, so that a newer Patina's files are left alone.
fs::path ChartStore::fileOf(const ChartKey& key) const {
    const json name{formatVersion, key.page, key.file, key.object};
    return folder_ / (hashed(writeJson(name)).substr(0, 32) + ending);
}

Result<void> ChartStore::write(const ChartKey& key, const StoredChart& stored) const {
    std::error_code failed;
    fs::create_directories(folder_, failed);
    const Result<void> written =
        failed ? tl::unexpected(Error{folder_.string(), 0, 0, failed.message(),
                                      "a folder in which measurements can be kept"})
               : writeFileAtomically(fileOf(key), writeJson(jsonOf(key, stored)));
    removeOldest();
    return written;
}

Result<std::optional<StoredChart>> ChartStore::read(const ChartKey& key) const {
    const fs::path file = fileOf(key);
    std::error_code none;
    if (!fs::exists(file, none)) {
        return std::nullopt;
    }
    const auto text = readJson(file);
    if (!text) {
        return tl::unexpected(putAside(file, text.error()));
    }
    auto stored = chartFrom(text->value);
    if (!stored) {
        return tl::unexpected(putAside(file, stored.error()));
    }
    return std::move(*stored);
}

void ChartStore::removeOldest() const {
    const QDir dir(QString::fromStdString(folder_.string()));
    const QFileInfoList files =
        dir.entryInfoList({QStringLiteral("*") + ending}, QDir::Files, QDir::Time);
    for (const QFileInfo& old : files.mid(maxFiles)) {
        QFile::remove(old.absoluteFilePath());
    }
}

std::string hashOf(const MeasuredSubject& subject, const std::string& device) {
    json blocks = json::array();
    for (const Block& block : subject.blocks.blocks) {
        blocks.push_back({block.kind, block.id, block.version});
    }
    const json all{{"scene", toJson(subject.scene, "/")},
                   {"object", subject.object},
                   {"blocks", blocks},
                   {"texts", subject.blocks.texts},
                   {"device", device}};
    return hashed(writeJson(all));
}

} // namespace patina

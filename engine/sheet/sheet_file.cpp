// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet/sheet_file.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "catalog/catalog.h"
#include "catalog/suggestion.h"
#include "core/atomic_file.h"
#include "core/number_text.h"
#include "material/texture_path.h"

namespace patina {
namespace {

using Json = nlohmann::json;

constexpr std::array<std::string_view, 3> numberWords{"time", "error", "albedo"};

/// Returns a file's value as it would be typed for --set. Nothing is returned for null, an object,
/// or an array that is empty or not of numbers.
std::optional<std::string> typedText(const Json& json) {
    if (json.is_string()) {
        return json.get<std::string>();
    }
    if (json.is_boolean()) {
        return json.get<bool>() ? "true" : "false";
    }
    if (json.is_number()) {
        return shortestFloatText(json.get<double>());
    }
    const bool isNumbers =
        json.is_array() && !json.empty() &&
        std::ranges::all_of(json, [](const Json& each) { return each.is_number(); });
    if (!isNumbers) {
        return std::nullopt;
    }
    std::string text;
    for (const Json& each : json) {
        text += (text.empty() ? "" : ",") + shortestFloatText(each.get<double>());
    }
    return text;
}

Json jsonOfTyped(const std::string& text) {
    if (text == "true" || text == "false") {
        return text == "true";
    }
    const std::optional<double> number = parseNumber(text);
    return number && shortestFloatText(*number) == text ? Json(*number) : Json(text);
}

/// Returns a mistake that points at one of an array's values.
ValueError wrongAt(std::size_t index, std::string problem, const char* expected) {
    return {Error{{}, 0, 0, std::move(problem), expected}, fmt::format("/{}", index)};
}

/// Reads one sheet file and collects its mistakes.
class SheetReader {
  public:
    SheetReader(const LocatedJson& document, const ReadingRights& rights)
        : reader_(document, "", errors_), references_(document.file, rights) {}

    Checked<SheetReading> run() {
        reading_.readOnly = readHeader(reader_, sheetFormat, reading_.notes) == FileAge::Newer;
        reader_.read("name", sheet().name);
        readPreset();
        if (reader_.isObject() && !reader_.has("x")) {
            reader_.addError("x", "the key \"x\" is missing", "an axis: an object");
        }
        sheet().x = axis("x");
        if (const Json* y = reader_.find("y"); y != nullptr && !y->is_null()) {
            sheet().y = axis("y");
        }
        reader_.read("controlRow", sheet().hasControlRow);
        reader_.read("cellPixels", sheet().cellPixels);
        readNumbers();
        sheet().unknown = reader_.unknown();
        reading_.outside = references_.outside();
        addLimitMistakes();
        return settled(std::move(reading_), std::move(errors_));
    }

  private:
    Sheet& sheet() { return reading_.sheet; }

    void readPreset() {
        std::string preset;
        reader_.read("preset", preset);
        if (!preset.empty() && references_.mayRead(preset, OutsideFile::Kind::Preset)) {
            sheet().preset = imageFromFile(preset, references_.base());
        } else if (!preset.empty()) {
            reading_.notes.push_back(reader_.document().error(
                "/preset",
                fmt::format("the preset \"{}\" is not in the sheet's folder and is not read",
                            preset),
                "a relative path with forward slashes into that folder"));
        }
    }

    SheetAxis axis(std::string_view key) {
        SheetAxis axis;
        JsonReader reader = reader_.child(key);
        if (!reader.isObject()) {
            return axis;
        }
        const auto* found = std::ranges::find_if(
            axisWords, [&reader](const AxisWord& each) { return reader.has(each.word); });
        if (found == axisWords.end()) {
            reader_.addError(key, "the axis does not say what it is of",
                             "one of the keys value, models, accuracy, lights, environments");
            return axis;
        }
        axis.kind = found->kind;
        if (axis.kind == AxisKind::Value) {
            reader.read("value", axis.value);
            readRange(reader, axis);
            readEntries(reader, "values", axis);
        } else {
            readEntries(reader, found->word, axis);
        }
        refuseUnknown(reader);
        return axis;
    }

    void readRange(JsonReader& reader, SheetAxis& axis) {
        if (!reader.has("from") && !reader.has("to") && !reader.has("steps")) {
            return;
        }
        for (const char* key : {"from", "to", "steps"}) {
            if (!reader.has(key)) {
                reader.addError("", fmt::format("the key \"{}\" is missing", key),
                                "from, to and steps");
            }
        }
        if (reader.has("values")) {
            reader.addError("values", "the axis has a range and values", "one of them");
        }
        SheetRange& range = axis.range.emplace();
        reader.read("from", range.from);
        reader.read("to", range.to);
        reader.read("steps", range.steps);
    }

    void readEntries(JsonReader& reader, const char* key, SheetAxis& axis) {
        const Json* entries = reader.array(key);
        for (std::size_t i = 0; entries != nullptr && i < entries->size(); ++i) {
            const Json& entry = (*entries)[i];
            const auto text = axis.kind == AxisKind::Value || entry.is_string()
                                  ? typedText(entry)
                                  : std::optional<std::string>();
            const auto refuse = [&](std::string problem, const char* expected) {
                reader.addError(key, wrongAt(i, std::move(problem), expected));
            };
            if (!text) {
                refuse(described(entry) + " stands here",
                       axis.kind == AxisKind::Value
                           ? "a number, true or false, text or an array of numbers"
                           : "text");
            } else if (axis.kind == AxisKind::Environments &&
                       text->find_first_of("./\\") != std::string::npos) {
                refuse(fmt::format("a sheet names no files, as \"{}\" is", *text),
                       "the id of an environment, or none");
            } else {
                axis.entries.push_back(*text);
            }
        }
    }

    /// Makes every unknown key an error, since a misspelt one would change the axis in silence.
    void refuseUnknown(JsonReader& reader) {
        std::vector<std::string> known{"from", "to", "steps", "values"};
        for (const auto& [kind, word] : axisWords) {
            known.insert(kind == AxisKind::Value ? known.begin() : known.end(), word);
        }
        const Json misspelt = reader.unknown(); // outlives the loop
        for (const auto& item : misspelt.items()) {
            reader.addError(item.key(), fmt::format("an axis has no key \"{}\"", item.key()),
                            oneOf(item.key(), known));
        }
    }

    void readNumbers() {
        const Json* words = reader_.array("numbers");
        for (std::size_t i = 0; words != nullptr && i < words->size(); ++i) {
            const Json& word = (*words)[i];
            const auto number =
                word.is_string() ? cellNumberOf(word.get<std::string>()) : std::nullopt;
            if (number) {
                sheet().numbers.push_back(*number);
            } else {
                reader_.addError("numbers", wrongAt(i, described(word) + " stands here",
                                                    "time, error or albedo"));
            }
        }
    }

    void addLimitMistakes() {
        if (!errors_.empty()) {
            return;
        }
        for (const Error& mistake : limitMistakes(sheet())) {
            errors_.push_back(
                reader_.document().error(mistake.file, mistake.problem, mistake.expected));
        }
    }

    Errors errors_;
    SheetReading reading_;
    JsonReader reader_;
    References references_;
};

Json toJson(const SheetAxis& axis) {
    Json json = Json::object();
    Json entries = Json::array();
    for (const std::string& entry : axis.entries) {
        entries.push_back(axis.kind == AxisKind::Value ? jsonOfTyped(entry) : Json(entry));
    }
    const auto* key = std::ranges::find(axisWords, axis.kind, &AxisWord::kind)->word;
    if (axis.kind != AxisKind::Value) {
        json[key] = std::move(entries);
        return json;
    }
    json[key] = axis.value;
    if (axis.range) {
        json["from"] = axis.range->from;
        json["to"] = axis.range->to;
        json["steps"] = axis.range->steps;
    } else {
        json["values"] = std::move(entries);
    }
    return json;
}

std::size_t stepsOf(const SheetAxis& axis) {
    return axis.range ? static_cast<std::size_t>(std::max(axis.range->steps, 1))
                      : std::max<std::size_t>(axis.entries.size(), 1);
}

/// Adds what breaks the limits of one axis; `key` is the axis' key in the file.
void addAxisMistakes(Errors& mistakes, const SheetAxis& axis, const std::string& key) {
    const bool isFinite =
        !axis.range || (std::isfinite(axis.range->from) && std::isfinite(axis.range->to));
    if (!isFinite) {
        mistakes.push_back({'/' + key, 0, 0, "the range has no end", "finite numbers"});
    }
    if (axis.range && (axis.range->steps < 1 || axis.range->steps > maxSheetSteps)) {
        mistakes.push_back({fmt::format("/{}/steps", key), 0, 0,
                            fmt::format("{} steps", axis.range->steps),
                            fmt::format("1 .. {}", maxSheetSteps)});
    }
    if (axis.entries.size() > std::size_t(maxSheetSteps)) {
        mistakes.push_back({'/' + key, 0, 0, fmt::format("{} steps", axis.entries.size()),
                            fmt::format("1 .. {}", maxSheetSteps)});
    }
}

} // namespace

Errors limitMistakes(const Sheet& sheet) {
    Errors mistakes;
    addAxisMistakes(mistakes, sheet.x, "x");
    if (sheet.y) {
        addAxisMistakes(mistakes, *sheet.y, "y");
    }
    if (sheet.cellPixels < minCellPixels || sheet.cellPixels > maxCellPixels) {
        mistakes.push_back({"/cellPixels", 0, 0,
                            fmt::format("cells of {} pixels", sheet.cellPixels),
                            fmt::format("{} .. {}", minCellPixels, maxCellPixels)});
    }
    const double cells = double(stepsOf(sheet.x)) * (sheet.y ? double(stepsOf(*sheet.y)) : 1.0);
    const double pixels = cells * sheet.cellPixels * sheet.cellPixels;
    if (mistakes.empty() && pixels > maxSheetPixels) {
        mistakes.push_back(
            {"/cellPixels", 0, 0,
             fmt::format("{} cells of {} pixels are too large a picture", cells, sheet.cellPixels),
             fmt::format("{} million pixels at most", int(maxSheetPixels / 1e6))});
    }
    return mistakes;
}

std::string_view wordOf(CellNumber number) {
    return numberWords[static_cast<std::size_t>(number)];
}

std::optional<CellNumber> cellNumberOf(std::string_view word) {
    const auto* found = std::ranges::find(numberWords, word);
    return found == numberWords.end()
               ? std::nullopt
               : std::optional(static_cast<CellNumber>(found - numberWords.begin()));
}

Checked<SheetReading> readSheet(const std::filesystem::path& path, const ReadingRights& rights) {
    const Result<LocatedJson> document = readJson(path);
    return document ? SheetReader(*document, rights).run()
                    : tl::unexpected(Errors{document.error()});
}

nlohmann::json toJson(const Sheet& sheet, const std::filesystem::path& folder) {
    Json json = sheet.unknown;
    json["format"] = sheetFormat.name;
    json["version"] = sheetFormat.version;
    json["name"] = sheet.name;
    if (!sheet.preset.empty()) {
        json["preset"] = imageForFile(sheet.preset, folder);
    }
    json["x"] = toJson(sheet.x);
    json["y"] = sheet.y ? toJson(*sheet.y) : Json();
    json["controlRow"] = sheet.hasControlRow;
    json["cellPixels"] = sheet.cellPixels;
    json["numbers"] = Json::array();
    for (const CellNumber number : sheet.numbers) {
        json["numbers"].push_back(wordOf(number));
    }
    return json;
}

Result<void> writeSheet(const std::filesystem::path& path, const Sheet& sheet) {
    return writeFileAtomically(path, writeJson(toJson(sheet, referenceFolder(path))));
}

std::vector<std::filesystem::path> shippedSheets() {
    std::vector<std::filesystem::path> sheets;
    std::error_code ignored; // a folder that cannot be read has no sheets
    const auto folder = dataFolder() / "presets" / "sheets";
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
        if (entry.path().string().ends_with(sheetEnding)) {
            sheets.push_back(entry.path());
        }
    }
    std::ranges::sort(sheets);
    return sheets;
}

} // namespace patina

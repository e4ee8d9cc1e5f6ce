// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/edit_journal.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <QCryptographicHash>
#include <QFile>

#include "catalog/json_text.h"
#include "core/atomic_file.h"
#include "core/ordinary_file.h"
#include "scene/scene_file.h"

namespace patina {
namespace {

using Json = nlohmann::json;

/// Is the length in bytes above which the copy is written again.
constexpr std::uintmax_t longestJournal = 1u << 20;
constexpr std::uintmax_t maxFileBytes = 256u << 20; ///< bytes; no copy and no journal is longer

/// Returns the first line of a journal, a hash of its copy, so that it is never read with another
/// one.
std::string firstLine(std::string_view copyText) {
    const QByteArray hash = QCryptographicHash::hash(
        QByteArray::fromRawData(copyText.data(), qsizetype(copyText.size())),
        QCryptographicHash::Sha256);
    return hash.toHex().toStdString();
}

Error notWritten(const std::filesystem::path& path, const QFile& file) {
    return {path.string(), 0, 0,
            "unsaved work cannot be kept safe: " + file.errorString().toStdString(),
            "a folder with room that can be written to"};
}

/// Takes the journal's next line; empty at its end, or if the last line is incomplete.
std::optional<std::string_view> takeLine(std::string_view& rest) {
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos) {
        return std::nullopt;
    }
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end + 1);
    return line;
}

/// Applies a line; returns whether that was possible.
bool apply(std::string_view line, Json& scene) {
    const Json patch = Json::parse(line, nullptr, false);
    try {
        scene.patch_inplace(patch);
        return true;
    } catch (const Json::exception&) {
        return false;
    }
}

} // namespace

std::filesystem::path EditJournal::beside(const std::filesystem::path& copy) {
    return copy.string() + ".journal";
}

Result<void> EditJournal::write(const Scene& scene) {
    Json now = toJson(scene, std::filesystem::absolute(copy_).lexically_normal().parent_path());
    if (written_.is_null() || bytes_ > longestJournal) {
        return writeCopy(std::move(now));
    }
    const Json patch = Json::diff(written_, now);
    if (patch.empty()) {
        return {};
    }
    Result<void> appended = append(patch);
    written_ = appended ? std::move(now) : Json(); // half a line may be there: write a new copy
    return appended;
}

Result<void> EditJournal::writeCopy(Json scene) {
    const std::string text = writeJson(scene);
    if (Result<void> copied = writeFileAtomically(copy_, text); !copied) {
        return copied;
    }
    const std::string first = firstLine(text) + '\n';
    Result<void> begun = writeFileAtomically(beside(copy_), first);
    bytes_ = first.size();
    written_ = begun ? std::move(scene) : Json();
    return begun;
}

Result<void> EditJournal::append(const Json& patch) {
    const std::string line = patch.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
    const std::filesystem::path path = beside(copy_);
    QFile file(QString::fromStdString(path.string()));
    const bool isOpen = file.open(QIODevice::WriteOnly | QIODevice::Append);
    if (!isOpen || file.write(line.data(), qint64(line.size())) != qint64(line.size()) ||
        !file.flush()) {
        return tl::unexpected(notWritten(path, file));
    }
    bytes_ += line.size();
    return {};
}

Result<void> EditJournal::join(const std::filesystem::path& copy) {
    const Result<std::string> journal = readFile(beside(copy), maxFileBytes);
    const Result<std::string> text = readFile(copy, maxFileBytes);
    if (!journal || !text) {
        return {}; // without a journal the copy is complete
    }
    Json scene = Json::parse(*text, nullptr, false);
    std::string_view rest = *journal;
    std::optional<std::string_view> line = takeLine(rest);
    if (scene.is_discarded() || line != firstLine(*text)) {
        return {};
    }
    line = takeLine(rest);
    while (line && apply(*line, scene)) {
        line = takeLine(rest);
    }
    Result<void> joined = writeFileAtomically(copy, writeJson(scene));
    if (joined) {
        std::error_code ignored; // a journal that stays is ignored
        std::filesystem::remove(beside(copy), ignored);
    }
    return joined;
}

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/texture_library.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string_view>

#include <QFileInfo>

#include "background/tell_afterwards.h"
#include "core/color.h"
#include "core/table_number.h"

namespace patina {
namespace {

constexpr int previewPixels = 64;

/// Returns the largest level that is no larger than a preview.
const TexturePicture::Level& smallLevel(const TexturePicture& picture) {
    const auto found = std::ranges::find_if(picture.levels, [](const auto& level) {
        return level.size.x <= previewPixels && level.size.y <= previewPixels;
    });
    return found == picture.levels.end() ? picture.levels.back() : *found;
}

int displayed(float linear) {
    return static_cast<int>(std::lround(255.0 * srgbEncoded(double(linear))));
}

/// Returns a texel as a screen shows it.
QRgb shown(const std::byte* at, TexelFormat format) {
    if (format == TexelFormat::Grey32 || format == TexelFormat::Color32) {
        float light[4] = {};
        std::memcpy(light, at, texelBytes(format));
        const bool isGrey = format == TexelFormat::Grey32;
        return qRgb(displayed(light[0]), displayed(light[isGrey ? 0 : 1]),
                    displayed(light[isGrey ? 0 : 2]));
    }
    const auto part = [at, format](int i) {
        return std::to_integer<int>(at[format == TexelFormat::Grey8 ? 0 : i]);
    };
    return qRgb(part(0), part(1), part(2));
}

QImage previewOf(const TexturePicture& picture) {
    const TexturePicture::Level& level = smallLevel(picture);
    QImage image(level.size.x, level.size.y, QImage::Format_RGB32);
    const std::byte* at = picture.bytes.data() + level.offset;
    for (int y = level.size.y - 1; y >= 0; --y) { // a texture's rows go up
        for (int x = 0; x < level.size.x; ++x) {
            image.setPixel(x, y, shown(at, picture.format));
            at += texelBytes(picture.format);
        }
    }
    return image;
}

} // namespace

TextureLibrary::TextureLibrary(Client client, QObject* parent)
    : QObject(parent), client_(std::move(client)),
      worker_({.name = tr("Reading a file"), .canCancel = true}) {}

std::optional<TextureLookup> TextureLibrary::among(const Pictures& pictures,
                                                   const Failures& failures, const TextureUse& use,
                                                   TextureDecoding decoding) {
    const std::pair<std::string_view, TextureDecoding> key(use.file, decoding);
    if (use.outside || failures.contains(key)) {
        return TextureLookup{nullptr, true};
    }
    const auto found = pictures.find(key);
    return found == pictures.end() ? std::nullopt
                                   : std::optional(TextureLookup{found->second, false});
}

TextureLookup TextureLibrary::find(const TextureUse& use, TextureDecoding decoding) {
    if (const auto known = among(pictures_, failures_, use, decoding)) {
        return *known;
    }
    if (!loading_.contains(std::pair<std::string_view, TextureDecoding>(use.file, decoding))) {
        load({use.file, decoding});
    }
    return {};
}

SharedTable TextureLibrary::table(int number) {
    if (SharedTable there = tableAtHand(number)) {
        return there;
    }
    if (!loadingTables_.contains(number)) {
        read(fileOfTable(number), {number},
             [number] { return patina::readTable(number).map([](const auto&) {}); });
    }
    return tableAtHand(0);
}

void TextureLibrary::readTable(const std::filesystem::path& file, std::function<void()> done) {
    const std::string path = std::filesystem::absolute(file).lexically_normal().string();
    read(
        file, {tableNumber(path, TableForm::WithoutGrain), tableNumber(path, TableForm::WithGrain)},
        [file] { return patina::readTable(file).map([](const auto&) {}); }, std::move(done));
}

void TextureLibrary::read(const std::filesystem::path& file, const std::vector<int>& tables,
                          const std::function<Result<void>()>& reading,
                          std::function<void()> done) {
    loadingTables_.insert(tables.begin(), tables.end());
    const auto finish = [this, tables, file, done = std::move(done)](const Result<void>& read) {
        for (const int table : tables) {
            loadingTables_.erase(table);
        }
        if (!read && !done) {
            Q_EMIT failed(QString::fromStdString(file.string()), read.error());
        }
        if (done) {
            done();
        }
        Q_EMIT arrived();
    };
    worker_.ask([reading](const Worker::Control&) { return reading(); }, finish, {},
                QString::fromStdString(file.filename().string()));
}

TextureSource TextureLibrary::snapshot() const {
    return [pictures = pictures_, failures = failures_](const TextureUse& use,
                                                        TextureDecoding decoding) {
        return among(pictures, failures, use, decoding).value_or(TextureLookup());
    };
}

QImage TextureLibrary::preview(const std::string& file) const {
    const auto found = known_.find(file);
    return found == known_.end() ? QImage() : found->second.preview;
}

bool TextureLibrary::hasAlpha(const std::string& file) const {
    const auto found = known_.find(file);
    return found != known_.end() && found->second.hasAlpha;
}

QString TextureLibrary::problem(const TextureUse& use) const {
    if (use.outside) {
        return tr("The file lies outside the preset's folder and is not read until you allow it.");
    }
    for (const auto& [key, why] : failures_) {
        if (key.first == use.file) {
            return QString::fromStdString(why.problem);
        }
    }
    return {};
}

void TextureLibrary::forgetFailures() {
    failures_.clear();
}

void TextureLibrary::readAgain() {
    forgetFailures();
    dropUnused();
    std::vector<Key> keys;
    for (const auto& [key, picture] : pictures_) {
        keys.push_back(key);
    }
    for (const Key& key : keys) {
        if (!loading_.contains(key)) {
            load(key);
        }
    }
    Q_EMIT arrived(); // of those that failed before
}

void TextureLibrary::load(const Key& key) {
    dropUnused();
    loading_.insert(key);
    const auto read = [key, &client = client_()](const Worker::Control& control) {
        return client.loadTexture(key.first, key.second, &control.progress());
    };
    worker_.ask(
        read, [this, key](const Answer& answer) { finish(key, answer); }, {},
        QFileInfo(QString::fromStdString(key.first)).fileName());
    tellAfterwards(
        *this, [this, file = QString::fromStdString(key.first)] { Q_EMIT loadingStarted(file); });
}

void TextureLibrary::finish(const Key& key, const Answer& answer) {
    loading_.erase(key);
    if (answer) {
        pictures_[key] = *answer;
        known_[key.first] = {previewOf(**answer), (*answer)->hasAlpha};
    } else {
        const bool isNews = problem(textureUse({}, key.first)).isEmpty();
        failures_.insert_or_assign(key, answer.error());
        if (isNews) {
            Q_EMIT failed(QString::fromStdString(key.first), answer.error());
        }
    }
    Q_EMIT arrived();
}

/// Drops images that no view holds any more.
void TextureLibrary::dropUnused() {
    std::erase_if(pictures_, [](const auto& entry) { return entry.second.use_count() == 1; });
}

} // namespace patina

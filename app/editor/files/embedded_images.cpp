// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/embedded_images.h"

#include <map>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include <QByteArray>
#include <QCryptographicHash>

#include "core/atomic_file.h"

namespace patina {
namespace {

constexpr std::string_view png = "data:image/png;base64,";
constexpr std::string_view jpeg = "data:image/jpeg;base64,";

/// Returns the bytes behind the head of a data URI; nothing where they are no base64.
std::optional<QByteArray> decoded(std::string_view text) {
    auto result =
        QByteArray::fromBase64Encoding(QByteArray(text.data(), static_cast<qsizetype>(text.size())),
                                       QByteArray::AbortOnBase64DecodingErrors);
    return result ? std::optional(*std::move(result)) : std::nullopt;
}

/// Writes an image and returns its path.
Result<std::string> keptImage(const std::string& uri, const std::filesystem::path& folder) {
    const std::string_view head = uri.starts_with(png) ? png : jpeg;
    const auto bytes =
        uri.starts_with(head) ? decoded(std::string_view(uri).substr(head.size())) : std::nullopt;
    if (!bytes) {
        return failure("an image inside the file is damaged");
    }
    const QByteArray hash = QCryptographicHash::hash(*bytes, QCryptographicHash::Sha256).toHex();
    const std::filesystem::path file =
        folder / (hash.left(32).toStdString() + (head == png ? ".png" : ".jpg"));
    std::error_code failed;
    if (!std::filesystem::exists(file, failed)) {
        std::filesystem::create_directories(folder, failed);
        if (const auto written = writeFileAtomically(
                file, std::string_view(bytes->data(), static_cast<std::size_t>(bytes->size())));
            !written) {
            return tl::unexpected(written.error());
        }
    }
    return file.generic_string();
}

void keepAll(std::map<std::string, std::string>& images, const std::filesystem::path& folder,
             Errors& errors) {
    for (auto image = images.begin(); image != images.end();) {
        const auto kept = image->second.starts_with("data:") ? keptImage(image->second, folder)
                                                             : Result<std::string>(image->second);
        if (!kept) {
            errors.push_back(kept.error());
            image = images.erase(image);
            continue;
        }
        image->second = *kept;
        ++image;
    }
}

} // namespace

Errors keepEmbeddedImages(MeshMaterial& material, const std::filesystem::path& folder) {
    Errors errors;
    keepAll(material.images, folder, errors);
    keepAll(material.presetImages, folder, errors);
    return errors;
}

} // namespace patina

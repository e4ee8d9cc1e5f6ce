// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/json_clipboard.h"

#include <memory>

#include <QClipboard>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QMimeData>

#include "scene/scene_limits.h"

namespace patina {
namespace {

const QString trustedType = QStringLiteral("application/x-patina+json");

} // namespace

std::string CopiedJson::format() const {
    const auto found = json.value.is_object() ? json.value.find("format") : json.value.end();
    return found != json.value.end() && found->is_string() ? found->get<std::string>()
                                                           : std::string();
}

void copyJson(const nlohmann::json& json, bool isTrusted) {
    const std::string text = writeJson(json);
    auto data = std::make_unique<QMimeData>();
    data->setText(QString::fromStdString(text));
    if (isTrusted) {
        data->setData(trustedType, QByteArray::fromStdString(text));
    }
    QGuiApplication::clipboard()->setMimeData(data.release());
}

Result<CopiedJson> copiedJson() {
    const QMimeData* data = QGuiApplication::clipboard()->mimeData();
    const bool isTrusted = data && data->hasFormat(trustedType);
    const std::string text = isTrusted ? data->data(trustedType).toStdString()
                             : data    ? data->text().toStdString()
                                       : std::string();
    Result<LocatedJson> json = parseJson(text, {}, sceneLimits);
    if (!json) {
        return tl::unexpected(inClipboard(json.error()));
    }
    return CopiedJson{std::move(*json), isTrusted};
}

bool hasCopiedJson() {
    const QMimeData* data = QGuiApplication::clipboard()->mimeData();
    return data && data->hasText() && data->text().trimmed().startsWith('{');
}

Error inClipboard(Error error) {
    if (error.file.empty()) {
        error.file = QCoreApplication::translate("patina::Clipboard", "Clipboard").toStdString();
    }
    return error;
}

Errors inClipboard(Errors errors) {
    for (Error& error : errors) {
        error = inClipboard(std::move(error));
    }
    return errors;
}

} // namespace patina

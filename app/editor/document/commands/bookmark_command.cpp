// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/commands/bookmark_command.h"

namespace patina {
namespace {

std::optional<Camera> keptAt(const Document& document, int digit) {
    const auto& bookmarks = document.scene().bookmarks;
    const auto found = bookmarks.find(digit);
    return found == bookmarks.end() ? std::nullopt : std::optional(found->second);
}

} // namespace

BookmarkCommand::BookmarkCommand(Document& document, int digit, const Camera& camera)
    : ChangeCommand(document, Document::tr("Keep view %1").arg(digit), digit,
                    keptAt(document, digit), camera) {}

void BookmarkCommand::apply(const std::optional<Camera>& camera) {
    auto& bookmarks = state().scene.bookmarks;
    if (camera) {
        bookmarks.insert_or_assign(target(), *camera);
    } else {
        bookmarks.erase(target());
    }
    document().announce({DocumentChange::Bookmarks});
}

} // namespace patina

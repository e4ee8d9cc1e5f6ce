// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/document_form.h"

#include "parameters/document_source.h"
#include "resources/texture_library.h"

namespace patina {

DocumentForm::DocumentForm(Document& document, TextureLibrary& textures, std::string_view kind,
                           QWidget* parent)
    : DocumentForm(document, textures, kind, std::nullopt, parent) {}

DocumentForm::DocumentForm(Document& document, TextureLibrary& textures, const BlockPath& path)
    : DocumentForm(document, textures, path.kind, path, nullptr) {}

DocumentForm::DocumentForm(Document& document, TextureLibrary& textures, std::string_view kind,
                           std::optional<BlockPath> fixed, QWidget* parent)
    : ParameterForm(parent), document_(document), textures_(textures), kind_(kind),
      fixed_(std::move(fixed)) {
    follow();
    onChange(document_, DocumentChange::Value | DocumentChange::Texture, this,
             [this](const DocumentChange& change) {
                 if (change.path == path_) {
                     refresh(change.parameterId);
                 }
             });
    onChange(document_, DocumentChange::Locks, this, [this](const DocumentChange& change) {
        if (change.path == path_) {
            refresh();
        }
    });
    if (kind_ == settings::camera) {
        onChange(document_, DocumentChange::Camera, this, [this] { refresh(); });
    }
    connect(&textures_, &TextureLibrary::arrived, this, [this] { refresh(); });
    onChange(document_,
             DocumentChange::Material | DocumentChange::Block | DocumentChange::Lights |
                 DocumentChange::Objects | DocumentChange::Current | DocumentChange::Scene |
                 DocumentChange::Catalog | DocumentChange::OwnView,
             this, &DocumentForm::follow);
}

void DocumentForm::follow() {
    path_ = fixed_ ? *fixed_ : document_.selection().currentPath(kind_);
    setBlock(document_.block(path_), std::make_unique<DocumentSource>(document_, textures_, path_),
             emptyText());
    setEnabled(path_.index >= 0);
}

QString DocumentForm::emptyText() const {
    const BlockValues* values = blockValuesAt(document_.state(), path_);
    if (values && !document_.block(path_)) {
        return tr("\u201c%1\u201d is not installed. Its values are kept.")
            .arg(QString::fromStdString(values->id));
    }
    return values ? tr("Nothing to adjust.") : QString();
}

} // namespace patina

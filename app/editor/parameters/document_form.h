// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "document/document.h"
#include "parameters/parameter_form.h"

namespace patina {

class TextureLibrary;

/// Shows the form of one kind of block, or of settings, of what is current in a document. It
/// follows the document: values, swapped models, the selected object, light and side.
class DocumentForm : public ParameterForm {
    Q_OBJECT

  public:
    DocumentForm(Document& document, TextureLibrary& textures, std::string_view kind,
                 QWidget* parent = nullptr);

    /// Shows a block of a kind of which the scene has several in a row, by its index.
    DocumentForm(Document& document, TextureLibrary& textures, const BlockPath& path);

    const BlockPath& path() const { return path_; }

  private:
    DocumentForm(Document& document, TextureLibrary& textures, std::string_view kind,
                 std::optional<BlockPath> fixed, QWidget* parent);
    void follow();
    QString emptyText() const;

    Document& document_;
    TextureLibrary& textures_;
    std::string kind_;
    std::optional<BlockPath> fixed_; ///< is the path that is shown whatever is current
    BlockPath path_;
};

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

    const BlockPath& path() const { return path_; }

  private:
    void follow();
    QString emptyText() const;

    Document& document_;
    TextureLibrary& textures_;
    std::string kind_;
    BlockPath path_;
};

} // namespace patina

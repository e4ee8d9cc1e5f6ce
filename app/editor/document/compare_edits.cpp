// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/compare_edits.h"

#include <utility>

#include "document/commands/compare_command.h"
#include "document/commands/further_command.h"
#include "document/commands/own_view_command.h"
#include "document/commands/picture_command.h"

namespace patina {

void setSecondMaterial(Document& document, std::optional<Material> material) {
    if (material != document.state().second) {
        document.undoStack().push(new CompareCommand(document, std::move(material)));
    }
}

void setFurtherMaterials(Document& document, std::vector<Material> materials) {
    if (materials != document.state().further) {
        document.undoStack().push(new FurtherCommand(document, std::move(materials)));
    }
}

void setComparedPicture(Document& document, std::optional<ComparedPicture> picture) {
    if (picture != document.state().picture) {
        document.undoStack().push(new PictureCommand(document, std::move(picture)));
    }
}

void setOwnView(Document& document, Side side, const OwnView& own, const QString& label) {
    if (own != document.state().ownViews[indexOf(side)]) {
        document.undoStack().push(new OwnViewCommand(document, side, own, label));
    }
}

void showOwnPicture(Document& document) {
    if (document.state().picture && document.state().picture->first) {
        ComparedPicture picture = *document.state().picture;
        picture.first.reset();
        setComparedPicture(document, std::move(picture));
    }
}

} // namespace patina

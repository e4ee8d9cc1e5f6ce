// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/comparison.h"

#include <algorithm>
#include <utility>

#include "document/commands/material_command.h"
#include "document/commands/preview_command.h"
#include "document/compare_edits.h"

namespace patina {

Comparison::Comparison(Document& document, QObject* parent) : QObject(parent), document_(document) {
    onChange(document, DocumentChange::Scene, this, [this] { lastSecond_.reset(); });
}

void Comparison::setComparing(bool on) {
    const Material* first = document_.material(Side::A);
    if (!on && document_.state().second) {
        if (hasSecondMaterial(document_.state())) {
            lastSecond_ = document_.state().second;
            lastSecondObject_ = document_.selection().object();
        }
        end();
    } else if (on && first && !document_.state().second) {
        const bool returns = lastSecond_ && lastSecondObject_ == document_.selection().object();
        setSecondMaterial(document_, returns ? *lastSecond_ : *first);
    }
}

void Comparison::setSideCount(std::size_t count) {
    const Material* active = document_.material(document_.selection().side());
    if (!active || count == document_.shownSides()) {
        return;
    }
    if (count < 2) {
        setComparing(false);
        return;
    }
    const Material copied = *active;
    const OwnView own = ownView(document_.state(), document_.selection().side());
    const std::size_t before = document_.shownSides();
    const QString label = tr("Compare %1 views").arg(count);
    document_.editAsOneStep(label, [&] {
        setComparing(true);
        for (const Side side : sides) {
            if (indexOf(side) >= std::max(before, indexOf(Side::C)) && indexOf(side) < count) {
                setOwnView(document_, side, own, label);
            }
        }
        std::vector<Material> further = document_.state().further;
        further.resize(std::min(count, sides.size()) - indexOf(Side::C), copied);
        setFurtherMaterials(document_, std::move(further));
    });
}

/// Stops comparing, as one step. Side A gets its own material back where it only previewed another
/// one.
void Comparison::end() {
    if (!document_.state().preview && !document_.state().picture) {
        setSecondMaterial(document_, std::nullopt);
        return;
    }
    document_.editAsOneStep(tr("Stop comparing"), [&] {
        putBack();
        setComparedPicture(document_, std::nullopt);
        setSecondMaterial(document_, std::nullopt);
        setPreview(std::nullopt);
    });
}

/// Gives the object whose side A shows another material its own one.
void Comparison::putBack() {
    const int object = document_.state().preview ? document_.state().preview->object : -1;
    if (const std::optional<Material> own = materialAside(document_.state(), object)) {
        document_.undoStack().push(
            new MaterialCommand(document_, {object, Side::A}, *own, tr("Stop comparing")));
    }
}

void Comparison::setPreview(std::optional<MaterialPreview> preview) {
    if (preview != document_.state().preview) {
        document_.undoStack().push(new PreviewCommand(document_, std::move(preview)));
    }
}

void Comparison::previewMaterials(const Material& first, const Material& second,
                                  const QString& label) {
    const Material* held = document_.material(Side::A);
    if (!held) {
        return;
    }
    document_.editAsOneStep(label, [&] {
        setComparedPicture(document_, std::nullopt);
        putBack();
        const Material own = *document_.material(Side::A);
        document_.replaceMaterial(Side::A, first, label);
        setSecondMaterial(document_, second);
        setPreview(own == first ? std::nullopt
                                : std::optional(
                                      MaterialPreview{document_.selection().object(), own, first}));
    });
}

void Comparison::previewPictures(const Scene& first, const Scene& second, const QString& label) {
    const Material* held = document_.material(document_.selection().side());
    if (!held) {
        return;
    }
    const std::optional<Material> aside =
        document_.selection().side() == Side::A
            ? materialAside(document_.state(), document_.selection().object())
            : std::nullopt;
    const Scene own = document_.ownScene(document_.selection().side());
    const ComparedPicture wanted{aside.value_or(*held), pictureOf(first, own),
                                 pictureOf(second, own)};
    if (document_.isComparing() && document_.state().picture == wanted) {
        return;
    }
    document_.editAsOneStep(label, [&] {
        if (!document_.isComparing() || !(*document_.material(Side::A) == wanted.material) ||
            !(*document_.material(Side::B) == wanted.material)) {
            previewMaterials(wanted.material, wanted.material, label);
        }
        setComparedPicture(document_, wanted);
    });
}

void Comparison::setLevels(Side side, const AccuracyLevels& levels, const QString& label) {
    const Material* held = document_.material(side);
    if (!held) {
        return;
    }
    Material wanted = *held;
    wanted.accuracy = levels;
    if (side == Side::B || !materialAside(document_.state(), document_.selection().object())) {
        document_.replaceMaterial(side, wanted, label);
        return;
    }
    document_.editAsOneStep(label, [&] {
        setPreview(std::nullopt);
        document_.replaceMaterial(side, wanted, label);
    });
}

void Comparison::swapSides() {
    const Material* first = document_.material(Side::A);
    const bool isAlike = first && document_.state().second && *first == *document_.state().second;
    const OwnView ownA = ownView(document_.state(), Side::A);
    const OwnView ownB = ownView(document_.state(), Side::B);
    const bool isSame = isAlike && !document_.state().picture && ownA == ownB;
    if (!first || !document_.state().second || isSame) {
        return;
    }
    const Material formerFirst = *first;
    document_.undoStack().beginMacro(tr("Swap A and B"));
    if (document_.state().picture) {
        ComparedPicture swapped = *document_.state().picture;
        std::swap(swapped.first, swapped.second);
        setComparedPicture(document_, std::move(swapped));
    }
    document_.replaceMaterial(Side::A, *document_.state().second, tr("Swap A and B"),
                              MaterialEdit::Applied);
    setSecondMaterial(document_, formerFirst);
    setOwnView(document_, Side::A, ownB, tr("Swap A and B"));
    setOwnView(document_, Side::B, ownA, tr("Swap A and B"));
    document_.undoStack().endMacro();
}

} // namespace patina

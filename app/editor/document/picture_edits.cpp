// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/picture_edits.h"

#include "document/picture_parameters.h"

namespace patina {
namespace {

/// Sets all values of a block at a path; those that stay the same make no edit.
void setValues(Document& document, const BlockPath& path, const BlockValues& wanted) {
    for (const auto& [id, value] : wanted.parameters) {
        document.setValue(path, id, value);
    }
}

} // namespace

void setPicture(Document& document, const Scene& from) {
    const BlockPath scenePath = document.selection().currentPath(settings::scene);
    for (const Parameter& parameter : pictureAccuracyParameters()) {
        if (const auto level = pictureLevel(from, parameter.id)) {
            document.setValue(scenePath, parameter.id, *level);
        }
    }
    if (const BlockValues* transparency = from.part(kinds::transparency)) {
        document.setBlock(pathOf(kinds::transparency), transparency->id);
        setValues(document, pathOf(kinds::transparency), *transparency);
    }
    if (const BlockValues* environment = from.part(kinds::environment)) {
        setValues(document, document.selection().currentPath(kinds::environment), *environment);
    }
    for (std::size_t i = 0; i < from.lights.size(); ++i) {
        if (const BlockValues* shadow = from.lights[i].part(kinds::shadows)) {
            setValues(document, pathOf(kinds::shadows, static_cast<int>(i)), *shadow);
        }
    }
    for (std::size_t i = 0; i < from.passes.size(); ++i) {
        setValues(document, pathOf(kinds::pass, static_cast<int>(i)), from.passes[i]);
    }
}

} // namespace patina

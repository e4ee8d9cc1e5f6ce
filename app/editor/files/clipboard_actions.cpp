// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/clipboard_actions.h"

#include <algorithm>

#include "document/scene_edits.h"
#include "files/place_beside.h"
#include "material/preset_file.h"
#include "scene/scene_file.h"
#include "scene/scene_format.h"
#include "text/counted.h"

namespace patina {
namespace {

ReadingRights rightsOf(const CopiedJson& copied) {
    ReadingRights rights;
    rights.everything = copied.isTrusted;
    return rights;
}

} // namespace

ClipboardActions::ClipboardActions(Document& document, DocumentFiles& files, MeshLibrary& meshes,
                                   QObject* parent)
    : QObject(parent), document_(document), files_(files), meshes_(meshes) {}

void ClipboardActions::copyMaterial() const {
    if (const Material* material = document_.material(document_.selection().side())) {
        copyJson(toJson(*material), mayReadAll(*material));
    }
}

void ClipboardActions::copyObjects() const {
    if (const std::vector<Object> objects = editedObjects(); !objects.empty()) {
        copyJson(sceneJsonOf(std::span<const Object>(objects)), mayReadAll(objects));
    }
}

void ClipboardActions::cutObjects() {
    copyObjects();
    removeObjects(document_, document_.selection().editedObjects());
}

void ClipboardActions::copyLight() const {
    if (const Light* light = currentLight()) {
        copyJson(sceneJsonOf(std::span<const Light>(light, 1)), true);
    }
}

void ClipboardActions::cutLight() {
    copyLight();
    removeLight(document_, document_.selection().light());
}

void ClipboardActions::duplicateLight() {
    if (const Light* light = currentLight()) {
        addLights(document_, {*light}, tr("Duplicate light"));
    }
}

void ClipboardActions::paste() {
    const Result<CopiedJson> copied = copiedJson();
    if (!copied) {
        report({copied.error()});
    } else if (copied->format() == sceneFormat.name) {
        pasteScene(*copied);
    } else {
        pasteMaterial(*copied); // reports other text as no preset
    }
}

void ClipboardActions::pasteMaterial(const CopiedJson& copied) {
    const auto reading =
        materialFromJson(placed(copied), "", document_.catalog(), rightsOf(copied));
    if (!reading) {
        report(reading.error());
        return;
    }
    if (!document_.material(document_.selection().side())) {
        report({{{}, 0, 0, "there is no object to paste the material onto", "an object"}});
        return;
    }
    const QString name = QString::fromStdString(reading->material.name);
    document_.replaceMaterials(document_.selection().side(), reading->material,
                               tr("Paste %1").arg(name.isEmpty() ? tr("material") : name));
    report(reading->notes);
}

void ClipboardActions::pasteScene(const CopiedJson& copied) {
    const auto reading = sceneFromJson(placed(copied), document_.catalog(), rightsOf(copied));
    if (!reading) {
        report(reading.error());
        return;
    }
    const std::vector<Object>& objects = reading->scene.objects;
    const std::vector<Light>& lights = reading->scene.lights;
    if (objects.empty() && lights.empty()) {
        report({{{}, 1, 1, "the scene has neither objects nor lights", "one of them"}});
        return;
    }
    files_.withheld().add(reading->outside);
    const auto addThem = [&] {
        if (!objects.empty()) {
            addObjects(document_, placedBeside(document_.scene(), objects, meshes_),
                       counted(objects.size(), tr("Paste object"), tr("Paste %1 objects")));
        }
        if (!lights.empty()) {
            addLights(document_, lights,
                      counted(lights.size(), tr("Paste light"), tr("Paste %1 lights")));
        }
    };
    if (objects.empty() || lights.empty()) {
        addThem();
    } else {
        document_.editAsOneStep(tr("Paste objects and lights"), addThem);
    }
    report(reading->notes);
}

bool ClipboardActions::mayReadAll(const Material& material) const {
    return std::ranges::none_of(material.textures,
                                [](const auto& each) { return each.second.outside; });
}

bool ClipboardActions::mayReadAll(const std::vector<Object>& objects) const {
    const FileRights rights = files_.withheld().rights();
    return std::ranges::all_of(objects, [&](const Object& object) {
        return mayReadAll(object.material) && !rights.withheld.contains(object.mesh);
    });
}

std::vector<Object> ClipboardActions::editedObjects() const {
    std::vector<Object> objects;
    for (const int index : document_.selection().editedObjects()) {
        objects.push_back(document_.scene().objects[static_cast<std::size_t>(index)]);
    }
    return objects;
}

const Light* ClipboardActions::currentLight() const {
    const int index = document_.selection().light();
    return index < 0 ? nullptr : &document_.scene().lights[static_cast<std::size_t>(index)];
}

/// Resolves relative paths of copied text against the folder of the document's file.
LocatedJson ClipboardActions::placed(const CopiedJson& copied) const {
    LocatedJson json = copied.json;
    json.file = files_.file().path.string();
    return json;
}

/// Tells errors as errors of the clipboard, not of the document's file.
void ClipboardActions::report(Errors messages) {
    for (Error& message : messages) {
        message.file = message.file == files_.file().path.string() ? std::string() : message.file;
        Q_EMIT document_.reported(inClipboard(std::move(message)));
    }
}

} // namespace patina

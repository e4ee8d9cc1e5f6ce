// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/scene_dock.h"

#include <algorithm>

#include <QFileInfo>
#include <QGroupBox>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

#include "docks/auto_exposure_button.h"
#include "docks/block_chooser.h"
#include "docks/check_list.h"
#include "docks/object_actions.h"
#include "docks/panel.h"
#include "docks/part_panel.h"
#include "docks/passes_panel.h"
#include "document/own_view.h"
#include "document/scene_edits.h"
#include "files/file_actions.h"
#include "parameters/document_form.h"
#include "parameters/parameter_row.h"
#include "scene/primitives.h"

namespace patina {
namespace {

QString capitalised(const std::string& name) {
    QString text = QString::fromStdString(name);
    text[0] = text[0].toUpper();
    return text;
}

QString nameOf(const Object& object) {
    return object.name.empty() ? QFileInfo(QString::fromStdString(object.mesh)).fileName()
                               : QString::fromStdString(object.name);
}

QGroupBox* titled(const QString& title, QWidget* content) {
    auto* box = new QGroupBox(title);
    auto* layout = new QVBoxLayout(box);
    layout->addWidget(content);
    return box;
}

} // namespace

std::vector<DockPage> SceneDock::pages() {
    return {
        {tr("Object"), tr("Place, rotation and scale")},
        {tr("Scene"), tr("Ground, background, ambient light, occlusion, exposure, wavelengths")},
        {tr("Display"), tr("Tone curve")},
        {tr("Picture Passes"), tr("Painterly, watercolour, dither, halftone screens")},
        {tr("Camera"), tr("Field of view, near and far, distance and pivot")},
    };
}

SceneDock::SceneDock(const DockContext& context)
    : document_(context.document), files_(context.files), list_(new CheckList(this)),
      add_(textButton(tr("Add"), tr("Add an object"), this)),
      remove_(textButton(tr("Remove"), tr("Remove the selected objects (Del)"), this)),
      meshes_(new QMenu(this)), tone_(new BlockChooser(document_, kinds::tone, tr("None"), this)) {
    add_->setMenu(meshes_);
    add_->setPopupMode(QToolButton::InstantPopup);
    list_->setAccessibleName(tr("Objects"));
    auto* forms = new QWidget;
    auto* layout = new QVBoxLayout(forms);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(
        titled(tr("Object"), new DocumentForm(document_, context.textures, settings::object)));
    auto* scene = new DocumentForm(document_, context.textures, settings::scene);
    layout->addWidget(titled(tr("Scene"), scene));
    if (ParameterRow* exposure = scene->row(exposureSetting)) {
        exposure->addButton(autoExposureButton(document_, context.views, exposure));
    }
    layout->addWidget(titled(tr("Display"), display(context)));
    layout->addWidget(titled(tr("Picture Passes"), new PassesPanel(document_, context.textures)));
    addPartPanels(*layout, BlockOwner::Scene, document_, context.textures);
    layout->addWidget(
        titled(tr("Camera"), new DocumentForm(document_, context.textures, settings::camera)));
    auto* heading = new QLabel(tr("Objects"), this);
    fillPanel(this, {rowOf({heading, add_, remove_}), list_}, forms);
    connectList();
    connect(meshes_, &QMenu::aboutToShow, this, &SceneDock::fillMenu);
    connect(remove_, &QToolButton::clicked, this,
            [this] { removeObjects(document_, document_.selection().editedObjects()); });
    onChange(document_, DocumentChange::Objects | DocumentChange::Current | DocumentChange::Scene,
             this, &SceneDock::update);
    onChange(document_, DocumentChange::Value, this, [this](const DocumentChange& change) {
        if (change.path.isAt(settings::object)) {
            update();
        }
    });
    update();
}

/// Returns the widgets of the tone curve, which maps brightness into the range of a screen.
QWidget* SceneDock::display(const DockContext& context) {
    auto* box = new QWidget;
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    tone_->setAccessibleName(tr("Tone curve"));
    layout->addWidget(labelled(tr("Tone &curve"), tone_));
    layout->addWidget(new DocumentForm(document_, context.textures, kinds::tone));
    connect(tone_, &BlockChooser::chosen, this, [this](const QString& id) {
        document_.setBlock(pathOf(kinds::tone), id.toStdString());
    });
    const auto show = [this] {
        const BlockValues* tone = document_.scene().part(kinds::tone);
        tone_->show(tone ? QString::fromStdString(tone->id) : QString());
    };
    onChange(document_, DocumentChange::Block | DocumentChange::Scene, this, show);
    show();
    return box;
}

void SceneDock::connectList() {
    for (QAction* action : (new ObjectActions(document_, files_, this))->all()) {
        list_->addAction(action);
    }
    list_->setContextMenuPolicy(Qt::ActionsContextMenu);
    list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    connect(list_, &CheckList::selected, this,
            [this](const std::vector<int>& rows) { document_.selection().setObjects(rows); });
    connect(list_, &CheckList::switched, this, &SceneDock::switchObject, Qt::QueuedConnection);
    connect(list_, &CheckList::renamed, this, &SceneDock::renameObject, Qt::QueuedConnection);
    connect(list_, &CheckList::duplicateWished, &files_.meshes(), &MeshActions::duplicateObjects);
    connect(list_, &CheckList::removeWished, this,
            [this] { removeObjects(document_, document_.selection().editedObjects()); });
}

void SceneDock::fillMenu() {
    meshes_->clear();
    for (const std::string& name : primitiveNames()) {
        meshes_->addAction(capitalised(name), this, [this, name] { addBuiltin(name); });
    }
    meshes_->addSeparator();
    meshes_->addAction(tr("Import mesh…"), &files_.meshes(), &MeshActions::askAndImport);
}

void SceneDock::update() {
    std::vector<CheckList::Row> rows;
    for (const Object& object : document_.scene().objects) {
        const QString mesh = QString::fromStdString(
            object.part.empty() ? object.mesh : object.mesh + " (" + object.part + ')');
        const QString group = QString::fromStdString(object.group);
        rows.push_back({nameOf(object), group.isEmpty() ? mesh : tr("%1, in %2").arg(mesh, group),
                        object.visible});
    }
    list_->setRows(rows, document_.selection().object(), document_.selection().objects());
    remove_->setEnabled(document_.selection().object() >= 0);
}

void SceneDock::addBuiltin(const std::string& name) {
    Object object;
    object.name = capitalised(name).toStdString();
    object.mesh = "builtin:" + name;
    files_.meshes().addBeside(object);
}

void SceneDock::switchObject(int index, bool on) {
    const std::vector<int> edited = document_.selection().editedObjects();
    const bool isOfSelection = std::ranges::find(edited, index) != edited.end();
    changeObjects(document_, isOfSelection ? edited : std::vector<int>{index},
                  on ? tr("Show") : tr("Hide"), [on](Object& object) { object.visible = on; });
}

void SceneDock::renameObject(int index, const QString& name) {
    Object object = document_.scene().objects.at(static_cast<std::size_t>(index));
    object.name = name.toStdString();
    setObject(document_, index, object);
}

} // namespace patina

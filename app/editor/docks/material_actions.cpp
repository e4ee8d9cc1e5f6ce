// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/material_actions.h"

#include <random>
#include <utility>

#include "document/random_material.h"
#include "document/tried_material.h"
#include "files/file_actions.h"
#include "material/block_values.h"
#include "session/start_value_files.h"

namespace patina {
namespace {

const QString originalName = QStringLiteral("original");

} // namespace

MaterialActions::MaterialActions(Document& document, FileActions& files, TriedMaterial& tried,
                                 QObject* parent)
    : QObject(parent), document_(document), tried_(tried) {
    add(tr("&Copy Material"), tr("As JSON, the text of a preset"), [&files] {
        files.clipboard().copyMaterial();
    })->setShortcut(QKeySequence(QStringLiteral("Ctrl+Shift+C")));
    add(tr("&Paste Material"), tr("Onto the active side and the selected objects"), [&files] {
        files.clipboard().paste();
    })->setShortcut(QKeySequence(QStringLiteral("Ctrl+Shift+V")));
    add(tr("&Randomise"),
        tr("Values that the sliders reach. Locked ones, choices, images and what "
           "glows stay."),
        [this] { randomise(); });
    original_ = add(tr("Show &Original"),
                    tr("The material as it was opened or applied, until it is edited"), {});
    original_->setCheckable(true);
    original_->setShortcut(QKeySequence(QStringLiteral("O")));
    original_->setShortcutContext(Qt::WidgetWithChildrenShortcut); // works in the views
    connect(original_, &QAction::triggered, this, &MaterialActions::showOriginal);
    add(tr("Set as &Default of the Model"),
        tr("The model begins with these values wherever it is chosen anew"),
        [this] { setStartValues(false); });
    forget_ =
        add(tr("&Forget the Default of the Model"),
            tr("The model begins with its own values again"), [this] { setStartValues(true); });
    connect(&tried_, &TriedMaterial::changed, this, &MaterialActions::follow);
    onChange(document_,
             DocumentChange::Material | DocumentChange::Current | DocumentChange::Scene |
                 DocumentChange::Objects,
             this, &MaterialActions::follow);
    follow();
}

QAction* MaterialActions::add(const QString& text, const QString& toolTip,
                              std::function<void()> what) {
    auto* action = new QAction(text, this);
    action->setToolTip(toolTip);
    if (what) {
        connect(action, &QAction::triggered, this, std::move(what));
    }
    actions_.push_back(action);
    return action;
}

void MaterialActions::showOriginal(bool shows) {
    const Side side = document_.selection().side();
    tried_.end(); // whoever tries another one hears of it
    const Material* original = document_.originalMaterial({document_.selection().object(), side});
    if (shows && original) {
        tried_.show(side, *original, originalName);
    }
    follow();
}

void MaterialActions::randomise() {
    std::mt19937 random{std::random_device{}()};
    std::uniform_real_distribution<double> share(0.0, 1.0);
    randomiseMaterial(document_, [&] { return share(random); });
}

void MaterialActions::setStartValues(bool isRemoval) {
    const Material* material = document_.material(document_.selection().side());
    if (!material) {
        return;
    }
    const std::string& model = material->model.id;
    const nlohmann::json wanted = isRemoval ? nlohmann::json() : parametersJson(material->model);
    if (const auto written = writeStartValues(startValueFolder(), model, wanted); !written) {
        Q_EMIT document_.reported(written.error());
        return;
    }
    StartValues all = document_.startValues();
    all.erase(model);
    if (!isRemoval) {
        all.emplace(model, wanted);
    }
    document_.setStartValues(std::move(all));
    follow();
}

void MaterialActions::follow() {
    const Material* material = document_.material(document_.selection().side());
    for (QAction* action : actions_) {
        action->setEnabled(material != nullptr);
    }
    forget_->setEnabled(material && document_.startValues().contains(material->model.id));
    original_->setChecked(tried_.isShown(originalName));
}

} // namespace patina

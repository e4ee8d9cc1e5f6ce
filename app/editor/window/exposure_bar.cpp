// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/exposure_bar.h"

#include <QHBoxLayout>
#include <QToolButton>

#include "docks/auto_exposure_button.h"
#include "document/document.h"
#include "document/own_view.h"
#include "parameters/document_editor.h"
#include "parameters/parameter_editor.h"
#include "parameters/scrub_label.h"

namespace patina {
namespace {

constexpr int exposureWidth = 190; ///< pixels

} // namespace

ExposureBar::ExposureBar(Document& document, CompareArea& views, QWidget* parent)
    : QWidget(parent),
      stops_(makeDocumentEditor(document, {pathOf(settings::scene), exposureSetting}, this)) {
    setObjectName("exposureBar");
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
    const Parameter& exposure = stops_->parameter();
    auto* label = new ScrubLabel(stops_->name(), this);
    label->setToolTip(QString::fromStdString(exposure.doc));
    stops_->setToolTip(label->toolTip());
    stops_->setFixedWidth(exposureWidth);
    stops_->scrubWith(*label);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(4, 0, 4, 0);
    row->addWidget(label);
    row->addWidget(stops_);
    row->addWidget(autoExposureButton(document, views, this));
    onChange(document, DocumentChange::Value | DocumentChange::Scene, this,
             [this, &document] { show(document); });
    show(document);
}

void ExposureBar::show(const Document& document) {
    stops_->present(document.value(pathOf(settings::scene), stops_->parameter()));
}

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/auto_exposure_button.h"

#include <QObject>
#include <QToolButton>

#include "core/auto_exposure.h"
#include "docks/panel.h"
#include "document/document.h"
#include "document/own_view.h"
#include "viewport/compare_area.h"

namespace patina {

QToolButton* autoExposureButton(Document& document, CompareArea& views, QWidget* parent) {
    auto* button = textButton(QObject::tr("Auto"),
                              QObject::tr("Set the exposure so that the mean brightness of the "
                                          "picture (the mean of its pixels' logarithms, without "
                                          "black ones) becomes middle grey, 18 %"),
                              parent);
    button->setAccessibleName(QObject::tr("Automatic exposure"));
    QObject::connect(button, &QToolButton::clicked, button, [&document, &views] {
        if (const auto stops = autoExposure(views.active().viewport().linearPicture())) {
            document.setValue(pathOf(settings::scene), exposureSetting, *stops);
        }
    });
    return button;
}

} // namespace patina

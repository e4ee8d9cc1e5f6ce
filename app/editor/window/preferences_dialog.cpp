// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/preferences_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>

#include "session/session.h"
#include "viewport/compare_area.h"
#include "window/theme.h"

namespace patina {

PreferencesDialog::PreferencesDialog(Session& session, Theme& theme, CompareArea& views,
                                     QWidget* parent)
    : QDialog(parent) {
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName("preferences");
    setWindowTitle(tr("Preferences"));
    auto* look = new QComboBox(this);
    look->addItem(tr("As the system"), int(Look::System));
    look->addItem(tr("Dark"), int(Look::Dark));
    look->addItem(tr("Light"), int(Look::Light));
    look->setCurrentIndex(look->findData(int(session.look())));
    auto* mouse = new QComboBox(this);
    mouse->setObjectName("mouseScheme");
    mouse->addItem(tr("Default: left orbits, middle pans, right moves nearer"));
    mouse->addItem(tr("Maya: the same, but only with Alt"));
    mouse->addItem(tr("Blender: middle orbits, with Shift pans, with Ctrl moves nearer"));
    mouse->addItem(tr("Trackpad: two fingers orbit, with Shift pan, with Ctrl move nearer"));
    mouse->setCurrentIndex(int(session.mouseHabits().scheme));
    auto* wheel = new QCheckBox(tr("The wheel moves nearer and farther without Ctrl"), this);
    wheel->setObjectName("wheelZooms");
    wheel->setChecked(session.mouseHabits().wheelZooms);
    auto* form = new QFormLayout(this);
    form->addRow(tr("&Look"), look);
    form->addRow(tr("&Mouse in a view"), mouse);
    form->addRow(QString(), wheel);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(look, &QComboBox::currentIndexChanged, this, [look, &session, &theme] {
        const auto chosen = static_cast<Look>(look->currentData().toInt());
        session.setLook(chosen);
        theme.setLook(chosen);
    });
    const auto apply = [mouse, wheel, &session, &views] {
        const MouseHabits habits{static_cast<MouseScheme>(mouse->currentIndex()),
                                 wheel->isChecked()};
        session.setMouseHabits(habits);
        views.setMouseHabits(habits);
    };
    connect(mouse, &QComboBox::currentIndexChanged, this, apply);
    connect(wheel, &QCheckBox::toggled, this, apply);
}

} // namespace patina

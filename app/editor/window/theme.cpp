// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/theme.h"

#include <QApplication>
#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusPendingCallWatcher>
#include <QDBusPendingReply>
#include <QDBusVariant>
#include <QPalette>
#include <QSettings>
#include <QStandardPaths>

#include "core/ordinary_file.h"
#include "window/look_style.h"

namespace patina {
namespace {

constexpr std::uintmax_t maxDesktopBytes = 1u << 20;

// The desktop portal's settings (org.freedesktop.portal.Settings, version 1).
const QString portalService = QStringLiteral("org.freedesktop.portal.Desktop");
const QString portalPath = QStringLiteral("/org/freedesktop/portal/desktop");
const QString portalInterface = QStringLiteral("org.freedesktop.portal.Settings");
const QString appearanceGroup = QStringLiteral("org.freedesktop.appearance");
const QString schemeKey = QStringLiteral("color-scheme");
constexpr unsigned schemeUnset = 0;
constexpr unsigned schemeDark = 1;
constexpr unsigned schemeLight = 2;

/// Holds the few colours a look is made of.
struct Colours {
    QColor window, base, alternate, text, button, faint, hint, accent, accentText, edge;
};

const Colours dark{"#2b2c2f", "#222326", "#28292c", "#dedfe2", "#37393d",
                   "#85888e", "#a3a6ac", "#3d7fc4", "#ffffff", "#1b1c1e"};
const Colours light{"#eeeff1", "#ffffff", "#f5f6f7", "#1d1f22", "#f7f8f9",
                    "#7d8087", "#5f6269", "#2f74c0", "#ffffff", "#b9bcc2"};

QPalette paletteOf(const Colours& c) {
    QPalette palette(c.text, c.button, c.button.lighter(125), c.edge, c.button.darker(115), c.text,
                     c.accentText, c.base, c.window);
    palette.setColor(QPalette::AlternateBase, c.alternate);
    palette.setColor(QPalette::ButtonText, c.text);
    palette.setColor(QPalette::ToolTipBase, c.base);
    palette.setColor(QPalette::ToolTipText, c.text);
    palette.setColor(QPalette::PlaceholderText, c.hint);
    palette.setColor(QPalette::Highlight, c.accent);
    palette.setColor(QPalette::HighlightedText, c.accentText);
    palette.setColor(QPalette::Link, c.accent.lighter(115));
    for (const QPalette::ColorRole role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        palette.setColor(QPalette::Disabled, role, c.faint);
    }
    palette.setColor(QPalette::Disabled, QPalette::Highlight, c.faint);
    return palette;
}

bool isDarkPalette(const QPalette& palette) {
    return palette.color(QPalette::Window).lightness() <
           palette.color(QPalette::WindowText).lightness();
}

/// Tells whether the settings of GTK ask for a dark look, which desktops without a portal write.
bool gtkPrefersDark() {
    if (qEnvironmentVariable("GTK_THEME").endsWith(QLatin1String(":dark"))) {
        return true;
    }
    const QString file =
        QStandardPaths::locate(QStandardPaths::GenericConfigLocation, "gtk-3.0/settings.ini");
    if (!OrdinaryFile::open(file.toStdString(), maxDesktopBytes)) {
        return false;
    }
    const QSettings gtk(file, QSettings::IniFormat);
    return gtk.value("Settings/gtk-application-prefer-dark-theme").toBool() ||
           gtk.value("Settings/gtk-theme-name").toString().endsWith("-dark", Qt::CaseInsensitive);
}

} // namespace

Theme::Theme(QObject* parent)
    : QObject(parent), systemIsDark_(isDarkPalette(QApplication::palette()) || gtkPrefersDark()) {
    QApplication::setStyle(new LookStyle);
    apply();
}

void Theme::setLook(Look look) {
    look_ = look;
    apply();
}

bool Theme::isDark() const {
    return look_ == Look::Dark || (look_ == Look::System && systemIsDark_);
}

void Theme::followDesktop() {
    QDBusConnection bus = QDBusConnection::sessionBus();
    if (!bus.isConnected()) {
        return;
    }
    bus.connect(portalService, portalPath, portalInterface, "SettingChanged", this,
                SLOT(settingChanged(QString, QString, QDBusVariant)));
    QDBusMessage question =
        QDBusMessage::createMethodCall(portalService, portalPath, portalInterface, "Read");
    question << appearanceGroup << schemeKey;
    auto* watcher = new QDBusPendingCallWatcher(bus.asyncCall(question), this);
    connect(watcher, &QDBusPendingCallWatcher::finished, this, [this, watcher] {
        const QDBusPendingReply<QDBusVariant> reply = *watcher;
        watcher->deleteLater();
        if (reply.isValid()) {
            // Read() wraps its answer in two variants.
            const QVariant inner = reply.value().variant();
            setDesktopScheme(inner.canConvert<QDBusVariant>()
                                 ? inner.value<QDBusVariant>().variant().toUInt()
                                 : inner.toUInt());
        }
    });
}

void Theme::settingChanged(const QString& group, const QString& key, const QDBusVariant& value) {
    if (group != appearanceGroup || key != schemeKey) {
        return;
    }
    // Some desktops change from dark to "no preference" when they mean their usual light look.
    const unsigned scheme = value.variant().toUInt();
    const unsigned usual = gtkPrefersDark() ? schemeDark : schemeLight;
    setDesktopScheme(scheme == schemeUnset ? usual : scheme);
}

void Theme::setDesktopScheme(unsigned scheme) {
    if (scheme == schemeUnset) {
        return;
    }
    const bool wantsDark = scheme == schemeDark;
    if (wantsDark != systemIsDark_) {
        systemIsDark_ = wantsDark;
        apply();
    }
}

void Theme::apply() const {
    QApplication::setPalette(paletteOf(isDark() ? dark : light));
}

} // namespace patina

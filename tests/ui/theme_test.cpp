// SPDX-License-Identifier: GPL-3.0-or-later
// The look that follows the desktop, as its portal tells of changes.
#include "window/theme.h"

#include <QApplication>
#include <QPalette>
#include <QtDBus/QDBusVariant>

#include <gtest/gtest.h>

#include "support/program.h"

namespace patina::tests::theme_test {
namespace {

constexpr unsigned noPreference = 0;
constexpr unsigned preferDark = 1;
constexpr unsigned preferLight = 2;

class DesktopLook : public testing::Test {
  protected:
    DesktopLook() { qputenv("XDG_CONFIG_HOME", QByteArray::fromStdString(empty_.path().string())); }

    void report(unsigned scheme, const QString& key = "color-scheme") {
        const QString group = "org.freedesktop.appearance";
        ASSERT_TRUE(QMetaObject::invokeMethod(
            &theme_, "settingChanged", Qt::DirectConnection, Q_ARG(QString, group),
            Q_ARG(QString, key), Q_ARG(QDBusVariant, QDBusVariant(QVariant::fromValue(scheme)))));
    }

    static int windowLightness() {
        return QApplication::palette().color(QPalette::Window).lightness();
    }

    TemporaryFolder empty_; ///< no settings of a desktop
    Theme theme_;
};

TEST_F(DesktopLook, Dark_DarkensThePalette) {
    report(preferLight);
    const int light = windowLightness();
    report(preferDark);
    EXPECT_TRUE(theme_.isDark());
    EXPECT_LT(windowLightness(), light / 2);
}

TEST_F(DesktopLook, NoPreferenceAfterDark_IsLightAgain) {
    report(preferDark);
    report(noPreference);
    EXPECT_FALSE(theme_.isDark());
}

TEST_F(DesktopLook, AnotherSetting_ChangesNothing) {
    report(preferDark);
    report(preferLight, "contrast");
    EXPECT_TRUE(theme_.isDark());
}

TEST_F(DesktopLook, LookOfTheUser_Wins) {
    theme_.setLook(Look::Light);
    report(preferDark);
    EXPECT_FALSE(theme_.isDark());
}

} // namespace
} // namespace patina::tests::theme_test

// SPDX-License-Identifier: GPL-3.0-or-later
// The least that a Qt program with an OpenGL view can be: what the editor's start is compared with.
#include <cstdio>

#include <QApplication>
#include <QOpenGLWidget>
#include <QSurfaceFormat>

int main(int count, char** arguments) {
    QSurfaceFormat format;
    format.setVersion(4, 1);
    format.setProfile(QSurfaceFormat::CoreProfile);
    QSurfaceFormat::setDefaultFormat(format);
    QApplication application(count, arguments);
    QOpenGLWidget window;
    window.resize(1280, 800);
    QObject::connect(&window, &QOpenGLWidget::frameSwapped,
                     [] { std::fputs("first frame\n", stderr); });
    window.show();
    return QApplication::exec();
}

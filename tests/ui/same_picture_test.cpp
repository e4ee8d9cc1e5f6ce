// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen in the editor is what the command line renders.
#include <algorithm>
#include <cstdlib>

#include <QProcess>

#include "ui/window_fixture.h"

namespace patina::tests::same_picture_test {
namespace {

class SamePicture : public WindowFixture {
  protected:
    /// The command line's picture of the preset at the size of the view.
    QImage rendered(const std::filesystem::path& preset, QSize size) {
        const QString file = QString::fromStdString(home("rendered.png").string());
        const QString pixels = QStringLiteral("%1x%2").arg(size.width()).arg(size.height());
        QProcess::execute(PATINA_BINARY_DIR "/bin/patina",
                          {"render", QString::fromStdString(preset.string()), "--scene",
                           QString::fromStdString(threeLightsFile().string()), "--size", pixels,
                           "-o", file});
        return QImage(file).convertToFormat(QImage::Format_RGB888);
    }
};

/// The largest difference of two bytes; 255 when the sizes differ.
int largestStep(const QImage& a, const QImage& b) {
    if (a.size() != b.size() || a.isNull()) {
        return 255;
    }
    int largest = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int i = 0; i < 3 * a.width(); ++i) {
            largest = std::max(largest, std::abs(a.constScanLine(y)[i] - b.constScanLine(y)[i]));
        }
    }
    return largest;
}

TEST_F(SamePicture, OfAPreset_InTheEditorAndFromTheCommandLine) {
    const std::filesystem::path preset = otherPreset(document());
    ASSERT_TRUE(window().documentFiles().openPreset(preset));
    window().resize(1200, 490); // views that are narrower than high step back
    newFrames();
    const QImage shown = view().grabPicture().convertToFormat(QImage::Format_RGB888);
    EXPECT_LE(largestStep(shown, rendered(preset, shown.size())), 1);
}

} // namespace
} // namespace patina::tests::same_picture_test

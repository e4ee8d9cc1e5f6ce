// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QImage>
#include <QObject>

#include "viewport/compare_area.h"

namespace patina {

/// Takes the picture of what is seen in the middle of the window: of one view, or of A, B and,
/// where it is shown, C beside each other, each below its title. Linear floats have no titles, and
/// no C, for they are no light.
class ViewsCapture : public QObject {
    Q_OBJECT

  public:
    explicit ViewsCapture(CompareArea& views);

    /// As PictureCapture::start(), for all views.
    void start(bool display, PictureCapture::Taken taken);

    /// Ends that without a picture.
    void cancel();

  private:
    Image besideEachOther(Image first, Image second, bool display) const;

    CompareArea& views_;
};

/// A picture that is shown, as an Image divided by 255.
Image asImage(const QImage& picture);

/// Pictures in a row, from the left, as high as the highest; black where one has nothing.
Image inARow(const std::vector<Image>& pictures);

} // namespace patina

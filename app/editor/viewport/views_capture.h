// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include <QImage>
#include <QObject>

#include "viewport/compare_area.h"

namespace patina {

/// The picture of one view, with what marks it.
struct SidePictureTaken {
    Side side;
    QString caption;
    Image picture;
};

/// Takes the picture of what is seen in the middle of the window: of one view, or of several as
/// they stand, each below its title, and their difference where it is shown; or of A and B as one
/// where they are wiped or lie over each other. Linear floats have no titles, and no difference,
/// for they are no light.
class ViewsCapture : public QObject {
    Q_OBJECT

  public:
    explicit ViewsCapture(CompareArea& views);

    /// As PictureCapture::start(), for all views.
    void start(bool display, PictureCapture::Taken taken);

    /// The same with a picture for each view, without titles; none where there is none.
    using EachTaken = std::function<void(std::vector<SidePictureTaken>)>;
    void startEach(bool display, EachTaken taken);

    /// Ends that without a picture.
    void cancel();

  private:
    void goOn(std::vector<SideView*> rest, std::vector<SidePictureTaken> done, bool display,
              const EachTaken& taken);
    Image asTheyStand(std::vector<SidePictureTaken> pictures, bool display) const;

    CompareArea& views_;
};

/// A picture that is shown, as an Image divided by 255.
Image asImage(const QImage& picture);

/// Pictures in a row, from the left, as high as the highest; black where one has nothing.
Image inARow(const std::vector<Image>& pictures);

/// The same below each other.
Image inAColumn(const std::vector<Image>& pictures);

} // namespace patina

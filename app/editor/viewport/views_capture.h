// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include <QImage>
#include <QObject>

#include "viewport/compare_area.h"

namespace patina {

/// Holds the picture of one view with its side and its caption.
struct SidePictureTaken {
    Side side;
    QString caption;
    Image picture;
};

/// Takes the picture of the views in the middle of the window: of a single view, or of several as
/// they are arranged, each below its title, and their difference where it is shown; or of A and B
/// as one where they are wiped or lie over each other, unless a change draws others than are on the
/// screen: those stand side by side. Pictures of linear floats have no titles and
/// no difference, as these are not light.
class ViewsCapture : public QObject {
    Q_OBJECT

  public:
    explicit ViewsCapture(CompareArea& views);

    /// Does what PictureCapture::start() does, for all views.
    void start(bool display, PictureCapture::Taken taken,
               const PictureCapture::SceneChange& change = {});

    /// Takes one picture per view, without titles; `taken` gets an empty list where one of them
    /// cannot be drawn.
    using EachTaken = std::function<void(std::vector<SidePictureTaken>)>;
    void startEach(bool display, const EachTaken& taken,
                   const PictureCapture::SceneChange& change = {});

    /// Ends what was started without a picture.
    void cancel();

  private:
    void goOn(std::vector<SideView*> rest, std::vector<SidePictureTaken> done, bool display,
              const EachTaken& taken, const PictureCapture::SceneChange& change);
    Image asTheyStand(std::vector<SidePictureTaken> pictures, bool display,
                      bool hasDifference) const;

    CompareArea& views_;
};

/// Returns a picture of a screen as an Image, values 0 .. 1, three channels.
Image asImage(const QImage& picture);

/// Returns pictures side by side from the left; the row is as high as the highest and black where a
/// picture ends.
Image inARow(const std::vector<Image>& pictures);

/// Returns pictures below each other; the column is as wide as the widest and black where a picture
/// ends.
Image inAColumn(const std::vector<Image>& pictures);

} // namespace patina

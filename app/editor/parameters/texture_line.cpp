// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/texture_line.h"

#include <QCheckBox>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QToolButton>

namespace patina {
namespace {

constexpr int thumbnailSide = 24;
constexpr double fadedShare = 0.35; ///< is the opacity of an image that is switched off

QPixmap faded(const QPixmap& picture, double share) {
    QPixmap result(picture.size());
    result.fill(Qt::transparent);
    QPainter painter(&result);
    painter.setOpacity(share);
    painter.drawPixmap(0, 0, picture);
    return result;
}

/// Makes a picture of colours that blend from corner to corner.
QImage madeCornerColors() {
    QImage picture(thumbnailSide, thumbnailSide, QImage::Format_RGB32);
    for (int y = 0; y < thumbnailSide; ++y) {
        for (int x = 0; x < thumbnailSide; ++x) {
            const auto right = float(x) / float(thumbnailSide - 1);
            const auto down = float(y) / float(thumbnailSide - 1);
            picture.setPixelColor(x, y,
                                  QColor::fromRgbF((1.0f - right) * (1.0f - down), right, down));
        }
    }
    return picture;
}

/// Returns that picture, which is one and the same for all lines.
const QImage& cornerColors() {
    static const QImage picture = madeCornerColors();
    return picture;
}

/// Returns an icon of four checker fields, which says "an image" without words; in alarming colours
/// it says that one is missing.
QIcon checker(const QColor& light, const QColor& dark) {
    QPixmap picture(thumbnailSide, thumbnailSide);
    picture.fill(dark);
    QPainter painter(&picture);
    const int half = thumbnailSide / 2;
    painter.fillRect(0, 0, half, half, light);
    painter.fillRect(half, half, half, half, light);
    return picture;
}

} // namespace

TextureLine::TextureLine(const QString& valueName, QWidget* parent)
    : QWidget(parent), valueName_(valueName),
      choose_(button({}, tr("Put an image on it, or drop one here"))),
      enabled_(new QCheckBox(this)), name_(new QLabel(this)),
      allow_(button(tr("Allow"), tr("Read this file although it is not in the preset's folder"))),
      settings_(button(QStringLiteral("…"), tr("How the image is read and laid on"))),
      remove_(button(QStringLiteral("×"), tr("Take the image away"))) {
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(4);
    line->addWidget(choose_);
    line->addWidget(enabled_);
    line->addWidget(name_, 1);
    line->addWidget(allow_);
    line->addWidget(settings_);
    line->addWidget(remove_);
    name_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    name_->setTextFormat(Qt::PlainText);
    enabled_->setObjectName("enabled");
    name_->setObjectName("name");
    allow_->setObjectName("allow");
    remove_->setObjectName("remove");
    choose_->setAccessibleName(tr("Image of %1").arg(valueName));
    enabled_->setToolTip(tr("Whether the image counts; while it does not it stays here"));
    enabled_->setAccessibleName(tr("Image of %1 counts").arg(valueName));
    allow_->setAccessibleName(tr("Allow the image of %1").arg(valueName));
    settings_->setAccessibleName(tr("Settings of the image of %1").arg(valueName));
    remove_->setAccessibleName(tr("Remove the image of %1").arg(valueName));
    connect(choose_, &QToolButton::clicked, this, &TextureLine::chooseWished);
    connect(enabled_, &QCheckBox::clicked, this, &TextureLine::enabledWished);
    connect(allow_, &QToolButton::clicked, this, &TextureLine::allowWished);
    connect(settings_, &QToolButton::clicked, this, &TextureLine::settingsWished);
    connect(remove_, &QToolButton::clicked, this, &TextureLine::removeWished);
    present(std::nullopt, {});
}

/// The button itself asks for a file; its arrow has what else can drive the value.
void TextureLine::offerVertexColors() {
    auto* choices = new QMenu(choose_);
    choices->setToolTipsVisible(true);
    choices->addAction(tr("Image File..."), this, &TextureLine::chooseWished);
    choices->addAction(tr("Vertex Colours"), this, &TextureLine::vertexColorsWished)
        ->setToolTip(tr("The colours that the object's mesh has at its corners; white where it "
                        "has none"));
    choose_->setMenu(choices);
    choose_->setPopupMode(QToolButton::MenuButtonPopup);
}

QToolButton* TextureLine::button(const QString& text, const QString& toolTip) {
    auto* made = new QToolButton(this);
    made->setText(text);
    made->setToolTip(toolTip);
    made->setAutoRaise(true);
    made->setFocusPolicy(Qt::StrongFocus);
    return made;
}

/// Leaves everything alone where it is as it was: a slider's tick presents it again, and an icon
/// that is set is painted and laid out anew.
void TextureLine::present(const std::optional<TextureUse>& use, const TexturePreview& preview) {
    const QImage& image = use && isVertexColors(use->file) ? cornerColors() : preview.image;
    const bool isNew = !isPresented_ || use != use_ || preview.problem != problem_ ||
                       image.cacheKey() != image_.cacheKey();
    if (!isNew) {
        return;
    }
    isPresented_ = true;
    use_ = use;
    problem_ = preview.problem;
    isBound_ = use.has_value();
    for (QWidget* part : {static_cast<QWidget*>(enabled_), static_cast<QWidget*>(name_),
                          static_cast<QWidget*>(settings_), static_cast<QWidget*>(remove_)}) {
        part->setVisible(isBound_);
    }
    allow_->setVisible(isBound_ && use->outside);
    if (isBound_) {
        enabled_->setChecked(use->enabled);
        name_->setEnabled(use->enabled);
        showName(*use, preview.problem);
    }
    image_ = image;
    isMissing_ = isBound_ && !preview.problem.isEmpty();
    counts_ = !use || use->enabled;
    showPreview();
}

void TextureLine::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        showPreview();
    }
}

void TextureLine::showName(const TextureUse& use, const QString& problem) {
    if (isVertexColors(use.file)) {
        name_->setText(tr("Vertex colours"));
        name_->setToolTip(tr("The colours that the object's mesh has at its corners"));
        name_->setAccessibleDescription({});
        return;
    }
    const QString file = QString::fromStdString(use.file);
    const QString name = QFileInfo(file).fileName();
    name_->setText(problem.isEmpty() ? name : tr("⚠ %1").arg(name));
    name_->setToolTip(problem.isEmpty() ? file : file + '\n' + problem);
    name_->setAccessibleDescription(problem);
}

void TextureLine::showPreview() {
    const bool shows = isBound_ && !image_.isNull() && !isMissing_;
    QColor quiet = palette().color(QPalette::WindowText);
    quiet.setAlphaF(0.35f);
    if (shows) {
        const QPixmap small = QPixmap::fromImage(image_.scaled(thumbnailSide, thumbnailSide,
                                                               Qt::KeepAspectRatioByExpanding,
                                                               Qt::SmoothTransformation));
        choose_->setIcon(counts_ ? small : faded(small, fadedShare));
    } else {
        choose_->setIcon(isMissing_ && counts_ ? checker(QColor(255, 0, 255), QColor(40, 0, 40))
                                               : checker(quiet, Qt::transparent));
    }
    const int side = isBound_ ? thumbnailSide : thumbnailSide / 2;
    choose_->setIconSize({side, side});
    choose_->setToolTip(isBound_ ? tr("Choose another image")
                                 : tr("Put an image on %1, or drop "
                                      "one here")
                                       .arg(valueName_));
}

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/picture_file_editor.h"

#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QToolButton>

#include "catalog/picture_roles.h"
#include "parameters/dropped_files.h"
#include "parameters/editor_factory.h"
#include "session/session.h"

namespace patina {
namespace {

/// Says what is chosen: a picture, or measurements.
struct FileWords {
    QString purpose; ///< names the folder that is kept for the next time
    QString title;
    QString tip;
    QString filter;
};

/// Returns the kinds of files to choose from: panoramas, or any picture for thresholds.
QString pictureFilter(const Parameter& parameter) {
    return parameter.role == roles::threshold
               ? PictureFileEditor::tr("Pictures") +
                     QStringLiteral(" (*.png *.jpg *.jpeg *.tif *.tiff *.bmp *.exr *.hdr)")
               : PictureFileEditor::tr("HDR pictures") + QStringLiteral(" (*.hdr *.exr)");
}

FileWords wordsOf(const Parameter& parameter) {
    return infoOf(parameter.type).isTable
               ? FileWords{QStringLiteral("measured"),
                           PictureFileEditor::tr("Choose a Measured Surface"),
                           PictureFileEditor::tr("Choose a file of the MERL or RGL collection, or "
                                                 "drop one here"),
                           PictureFileEditor::tr("Measured surfaces") + " (*.binary *.bsdf)"}
               : FileWords{QStringLiteral("picture"), PictureFileEditor::tr("Choose a picture"),
                           PictureFileEditor::tr("Choose a picture, or drop one here"),
                           pictureFilter(parameter)};
}

/// Returns the first local file that is dragged; empty for anything else.
QString fileIn(const QMimeData& data) {
    return draggedFiles(data).value(0);
}

} // namespace

PictureFileEditor::PictureFileEditor(const Parameter& parameter, QWidget* parent)
    : ParameterEditor(parameter, parent), button_(new QToolButton(this)) {
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(button_, 1);
    button_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    button_->setToolButtonStyle(Qt::ToolButtonTextOnly);
    button_->setFocusPolicy(Qt::StrongFocus);
    setAcceptDrops(true);
    connect(button_, &QToolButton::clicked, this, &PictureFileEditor::choose);
    present(Value(std::string()));
}

void PictureFileEditor::present(const Value& value) {
    const auto* file = std::get_if<std::string>(&value);
    file_ = file ? QString::fromStdString(*file) : QString();
    button_->setText(file_.isEmpty() ? tr("Choose…") : QFileInfo(file_).fileName());
    button_->setToolTip(file_.isEmpty() ? wordsOf(parameter()).tip : file_);
    button_->setAccessibleName(tr("%1: %2").arg(name(), button_->text()));
}

QWidget* PictureFileEditor::focusTarget() {
    return button_;
}

void PictureFileEditor::choose() {
    const FileWords words = wordsOf(parameter());
    Session session;
    const QString start = file_.isEmpty() ? session.folder(words.purpose) : file_;
    const QString file = QFileDialog::getOpenFileName(
        this, words.title, start, words.filter + ";;" + tr("All files") + " (*)");
    if (!file.isEmpty()) {
        session.setFolderOf(words.purpose, file);
        take(file);
    }
}

void PictureFileEditor::take(const QString& file) {
    Q_EMIT edited(Value(QFileInfo(file).absoluteFilePath().toStdString()));
}

void PictureFileEditor::dragEnterEvent(QDragEnterEvent* event) {
    if (!fileIn(*event->mimeData()).isEmpty()) {
        acceptCopy(*event);
    }
}

void PictureFileEditor::dropEvent(QDropEvent* event) {
    if (const QString file = fileIn(*event->mimeData()); !file.isEmpty()) {
        acceptCopy(*event);
        take(file);
    }
}

/// Makes the chooser of a file with the measurements of a surface.
ParameterEditor* makeMeasuredEditor(const Parameter& parameter, QWidget* parent) {
    return new PictureFileEditor(parameter, parent);
}

} // namespace patina

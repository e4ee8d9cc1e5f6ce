// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/turntable_export.h"

#include <utility>

#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QMessageBox>
#include <QSpinBox>

#include "background/long_tasks.h"
#include "core/display_image.h"
#include "files/picture_export.h"

namespace patina {
namespace {

constexpr int maxPictures = 3600;
constexpr double wholeTurn = 360.0; // degrees

QString fileAt(const TurntableExport::Series& series, int number) {
    return QString::fromStdString(seriesFile(series.file.toStdString(), number).string());
}

} // namespace

/// Is a series that is being written.
struct TurntableExport::Run {
    Series series;
    Source source;
    int done = 0;
    quint64 task = 0;
    bool isCancelled = false;
};

TurntableExport::TurntableExport(const Document& document, Session& session, QWidget* window)
    : QObject(window), document_(document), session_(session), window_(window) {}

TurntableExport::~TurntableExport() {
    end();
}

void TurntableExport::ask(const QString& name, const Source& source) {
    QDialog dialog(window_);
    dialog.setWindowTitle(tr("Export turntable"));
    auto* form = new QFormLayout(&dialog);
    auto* what = new QComboBox(&dialog);
    what->addItems({tr("The objects"), tr("The lights"), tr("The environment")});
    auto* count = new QSpinBox(&dialog);
    count->setRange(1, maxPictures);
    count->setValue(Series().count);
    form->addRow(tr("What &turns"), what);
    form->addRow(tr("&Pictures of a whole turn"), count);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, &dialog);
    connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    form->addRow(buttons);
    if (dialog.exec() != QDialog::Accepted) {
        return;
    }
    const QString file = QFileDialog::getSaveFileName(
        window_, tr("Export turntable: a number is added to the name"),
        session_.folder("picture") + '/' + name + ".png",
        tr("PNG, as on the screen (*.png);;JPEG, as on the screen (*.jpg);;"
           "OpenEXR, linear floats (*.exr)"),
        nullptr, QFileDialog::DontConfirmOverwrite);
    if (file.isEmpty()) {
        return;
    }
    session_.setFolderOf("picture", file);
    const Series series{static_cast<TurntableOf>(what->currentIndex()), count->value(),
                        QFileInfo(file).suffix().isEmpty() ? file + ".png" : file};
    if (mayReplace(series)) {
        start(series, source);
    }
}

bool TurntableExport::mayReplace(const Series& series) {
    const QString first = fileAt(series, 1);
    return !QFileInfo::exists(first) ||
           QMessageBox::question(window_, tr("Export turntable"),
                                 tr("%1 is there already. Replace the pictures of this name?")
                                     .arg(QFileInfo(first).fileName())) == QMessageBox::Yes;
}

void TurntableExport::start(const Series& series, const Source& source) {
    end();
    const auto possible = onTurntable(document_.scene(), document_.catalog(), series.what, 0.0);
    if (!possible) {
        Q_EMIT failed(possible.error());
        return;
    }
    if (!client_) {
        client_ = std::make_unique<AssetClient>();
    }
    run_ = std::make_shared<Run>(Run{series, source});
    const std::weak_ptr<Run> running = run_;
    run_->task =
        LongTasks::all().begin({tr("Writing a turntable"),
                                [running] {
                                    const auto run = running.lock();
                                    return run ? TaskState{double(run->done) / run->series.count,
                                                           tr("picture %1 of %2")
                                                               .arg(run->done + 1)
                                                               .arg(run->series.count)}
                                               : TaskState();
                                },
                                [this] { end(); }});
    drawNext(run_);
}

/// Draws the next picture of a series, unless that was ended.
void TurntableExport::drawNext(const std::shared_ptr<Run>& run) {
    if (run->isCancelled) {
        return;
    }
    const double degrees = wholeTurn * run->done / run->series.count;
    const auto turned = [catalog = document_.sharedCatalog(), what = run->series.what,
                         degrees](const Scene& scene) {
        return onTurntable(scene, *catalog, what, degrees).value_or(scene);
    };
    run->source.capture(!PictureExport::isLinear(run->series.file), turned,
                        [this, run](Image picture) {
                            if (!run->isCancelled) {
                                write(run, std::move(picture));
                            }
                        });
}

void TurntableExport::write(const std::shared_ptr<Run>& run, Image picture) {
    const QString file = fileAt(run->series, run->done + 1);
    if (picture.pixels.empty()) {
        end();
        Q_EMIT failed({file.toStdString(), 0, 0, "there is no picture to write", {}});
        return;
    }
    const bool isLinear = PictureExport::isLinear(file);
    worker_.ask(
        [&client = *client_, file, isLinear,
         picture = std::move(picture)](Worker::Control&) mutable -> Result<void> {
            return client.saveImage(file.toStdString(),
                                    isLinear ? std::move(picture)
                                             : linearFromDisplay(std::move(picture)));
        },
        [this, run](const Result<void>& written) {
            if (run->isCancelled) {
                return;
            }
            if (!written) {
                end();
                Q_EMIT failed(written.error());
            } else if (++run->done == run->series.count) {
                end();
                Q_EMIT saved(fileAt(run->series, 1), run->series.count);
            } else {
                drawNext(run);
            }
        });
}

void TurntableExport::end() {
    if (const auto run = std::exchange(run_, nullptr)) {
        run->isCancelled = true;
        LongTasks::all().end(run->task);
        run->source.cancel();
    }
}

} // namespace patina

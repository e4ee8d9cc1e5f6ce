// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/details_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QPlainTextEdit>

namespace patina {
namespace {

constexpr int dialogWidth = 420;
constexpr int descriptionLines = 4;
const QString betweenTags = QStringLiteral(", ");

QString joined(const std::vector<std::string>& tags) {
    QStringList texts;
    for (const std::string& tag : tags) {
        texts << QString::fromStdString(tag);
    }
    return texts.join(betweenTags);
}

std::string trimmed(const QString& text) {
    return text.trimmed().toStdString();
}

std::vector<std::string> tagsIn(const QString& text) {
    std::vector<std::string> tags;
    for (const QString& tag : text.split(',')) {
        if (!tag.trimmed().isEmpty()) {
            tags.push_back(trimmed(tag));
        }
    }
    return tags;
}

} // namespace

DetailsDialog::DetailsDialog(const Material& material, QWidget* parent)
    : QDialog(parent), material_(material), name_(line("name", material.name)),
      description_(new QPlainTextEdit(QString::fromStdString(material.description), this)),
      author_(line("author", material.author)), license_(line("license", material.license)),
      tags_(line("tags", {})) {
    setObjectName("details");
    setWindowTitle(tr("Material Details"));
    description_->setObjectName("description");
    description_->setTabChangesFocus(true);
    description_->setFixedHeight(descriptionLines * fontMetrics().lineSpacing() +
                                 2 * description_->frameWidth() + fontMetrics().leading());
    tags_->setText(joined(material.tags));
    tags_->setPlaceholderText(tr("metal, rough, worn"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QFormLayout(this);
    layout->addRow(tr("&Name"), name_);
    layout->addRow(tr("&Description"), description_);
    layout->addRow(tr("&Author"), author_);
    layout->addRow(tr("&Licence"), license_);
    layout->addRow(tr("&Tags"), tags_);
    layout->addRow(buttons);
    setMinimumWidth(dialogWidth);
}

QLineEdit* DetailsDialog::line(const QString& name, const std::string& text) {
    auto* edit = new QLineEdit(QString::fromStdString(text), this);
    edit->setObjectName(name);
    return edit;
}

Material DetailsDialog::edited() const {
    Material edited = material_;
    edited.name = trimmed(name_->text());
    edited.description = trimmed(description_->toPlainText());
    edited.author = trimmed(author_->text());
    edited.license = trimmed(license_->text());
    edited.tags = tagsIn(tags_->text());
    return edited;
}

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/safe_start.h"

#include <cerrno>
#include <charconv>
#include <csignal>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#include <unistd.h>

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>

namespace patina {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view prefix = "running-";

QString safeStartText(const char* words) {
    return QCoreApplication::translate("SafeStart", words);
}

/// Returns the process number in the name of a mark; 0 for another file.
int processOf(const fs::path& mark) {
    const std::string name = mark.filename().string();
    int process = 0;
    if (name.starts_with(prefix)) {
        std::from_chars(name.data() + prefix.size(), name.data() + name.size(), process);
    }
    return process;
}

bool runs(int process) {
    return kill(process, 0) == 0 || errno == EPERM;
}

} // namespace

StartMark::StartMark(const fs::path& folder) {
    std::error_code ignored; // without a mark no safe start is offered
    fs::create_directories(folder, ignored);
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
        const int process = processOf(entry.path());
        if (process > 0 && !runs(process)) {
            foundCrash_ = true;
            fs::remove(entry.path(), ignored);
        }
    }
    const fs::path mark = folder / (std::string(prefix) + std::to_string(getpid()));
    if (std::ofstream(mark)) {
        mark_ = mark;
    }
}

StartMark::~StartMark() {
    std::error_code ignored;
    if (!mark_.empty()) {
        fs::remove(mark_, ignored);
    }
}

bool offerSafeStart(SafeStartReason reason) {
    if (reason == SafeStartReason::None) {
        return false;
    }
    QMessageBox question(QMessageBox::Question, safeStartText("Start of Patina"),
                         reason == SafeStartReason::Crash
                             ? safeStartText("Patina did not close properly the last time.")
                             : safeStartText("Shift is held."));
    question.setObjectName("safeStart");
    question.setInformativeText(safeStartText(
        "It can begin without the files that were named, without unsaved work and without "
        "your own models and other blocks. Nothing of them is lost: they are there again "
        "at the next start."));
    QPushButton* usual =
        question.addButton(safeStartText("Start as Usual"), QMessageBox::AcceptRole);
    QPushButton* without =
        question.addButton(safeStartText("Start Without Them"), QMessageBox::ActionRole);
    question.setDefaultButton(reason == SafeStartReason::Crash ? usual : without);
    question.setEscapeButton(usual);
    question.exec();
    return question.clickedButton() == without;
}

} // namespace patina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/safe_start.h"

#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
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

/// Returns whether the program that left a mark still runs: the system gives its lock up however
/// it ended. Where files cannot be locked, it is taken for running; what is no file is no mark.
bool runs(const fs::path& mark) {
    const int descriptor = ::open(mark.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW);
    if (descriptor < 0) {
        return true;
    }
    struct stat status {};
    const bool isFile = ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
    const bool isLocked = !isFile || ::flock(descriptor, LOCK_EX | LOCK_NB) != 0;
    ::close(descriptor);
    return isLocked;
}

} // namespace

StartMark::StartMark(const fs::path& folder) {
    std::error_code ignored; // without a mark no safe start is offered
    fs::create_directories(folder, ignored);
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
        const bool isMark = entry.path().filename().string().starts_with(prefix);
        if (isMark && !runs(entry.path())) {
            foundCrash_ = true;
            fs::remove(entry.path(), ignored);
        }
    }
    std::string draft = folder / "starting-XXXXXX";
    descriptor_ = ::mkostemp(draft.data(), O_CLOEXEC);
    if (descriptor_ >= 0) {
        ::flock(descriptor_, LOCK_EX | LOCK_NB); // before it has the name that others look for
        mark_ = folder / (std::string(prefix) + draft.substr(draft.rfind('-') + 1));
        fs::rename(draft, mark_, ignored);
    }
}

StartMark::~StartMark() {
    std::error_code ignored;
    if (descriptor_ >= 0) {
        fs::remove(mark_, ignored);
        ::close(descriptor_);
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

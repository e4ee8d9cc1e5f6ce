// SPDX-License-Identifier: GPL-3.0-or-later
#include "library/folder_watcher.h"

#include <array>

#include <sys/inotify.h>
#include <unistd.h>

namespace patina {
namespace {

constexpr std::uint32_t events = IN_CLOSE_WRITE | IN_CREATE | IN_DELETE | IN_MOVE | IN_DELETE_SELF |
                                 IN_MOVE_SELF | IN_ATTRIB | IN_ONLYDIR;

} // namespace

FolderWatcher::FolderWatcher(QObject* parent) : QObject(parent) {}

FolderWatcher::~FolderWatcher() {
    close();
}

void FolderWatcher::close() {
    arrived_.reset();
    if (queue_ >= 0) {
        ::close(queue_);
        queue_ = -1;
    }
}

/// Makes a new queue each time, since a folder that was replaced has another inode.
void FolderWatcher::watch(const std::vector<std::filesystem::path>& folders) {
    close();
    queue_ = inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
    if (queue_ < 0) {
        return;
    }
    for (const std::filesystem::path& folder : folders) {
        inotify_add_watch(queue_, folder.c_str(), events); // a missing folder is not watched
    }
    arrived_ = std::make_unique<QSocketNotifier>(queue_, QSocketNotifier::Read);
    connect(arrived_.get(), &QSocketNotifier::activated, this, &FolderWatcher::read);
}

void FolderWatcher::read() {
    std::array<char, 16384> names{};
    while (::read(queue_, names.data(), names.size()) > 0) {
        // which file it was does not matter
    }
    Q_EMIT changed();
}

} // namespace patina

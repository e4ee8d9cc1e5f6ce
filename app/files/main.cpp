// SPDX-License-Identifier: GPL-3.0-or-later
// `patina-files`: reads and writes foreign file formats for `patina`, in a process of its own.
#include <csignal>
#include <cstdio>

#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include "files/file_server.h"

int main() {
    struct stat facts {};
    if (::fstat(STDIN_FILENO, &facts) != 0 || !S_ISSOCK(facts.st_mode)) {
        std::fputs("patina-files is started by patina and is of no use alone\n", stderr);
        return 2;
    }
    // Without the signal a file over the allowed size is an error of the call that writes it.
    std::signal(SIGXFSZ, SIG_IGN);
    // _exit() skips the libraries' clean-up, which has nothing to save.
    ::_exit(patina::FileServer(patina::Channel(patina::FileHandle(STDIN_FILENO))).run());
}

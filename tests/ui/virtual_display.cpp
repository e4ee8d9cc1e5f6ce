// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/virtual_display.h"

#include <csignal>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace patina::tests {

namespace {

/// Becomes the server; it writes the number it chose to `out`.
[[noreturn]] void becomeServer(int out) {
    prctl(PR_SET_PDEATHSIG, SIGTERM); // ends with the test, however that ends
    const std::string number = std::to_string(out);
    const int nowhere = open("/dev/null", O_RDWR);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "1600x1000x24",
           "-nolisten", "tcp", static_cast<char*>(nullptr));
    _exit(127);
}

/// What the server says before it is ready to be used: its number and a newline. Empty when it
/// ended without a word.
std::string readNumber(int in) {
    std::string number;
    for (char c = 0; read(in, &c, 1) == 1 && c != '\n';) {
        number += c;
    }
    return number;
}

} // namespace

VirtualDisplay::VirtualDisplay() {
    int ends[2] = {-1, -1};
    if (pipe(ends) != 0) {
        return;
    }
    server_ = fork();
    if (server_ == 0) {
        close(ends[0]);
        becomeServer(ends[1]);
    }
    close(ends[1]);
    const std::string number = readNumber(ends[0]);
    close(ends[0]);
    if (!number.empty()) {
        name_ = ":" + number;
    }
}

VirtualDisplay::~VirtualDisplay() {
    if (server_ > 0) {
        kill(server_, SIGTERM);
        waitpid(server_, nullptr, 0);
    }
}

} // namespace patina::tests

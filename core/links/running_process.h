// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include <vector>

namespace codewheel {

// A process as /proc tells of it. Names are bytes, since no file has to be named in UTF-8.
struct RunningProcess
{
    int id = 0;
    QByteArray name{};                 // at most 15 characters, as the kernel keeps it
    int terminal = 0;                  // number of the device that controls it; 0: none
    bool isSeen = false;               // whether we may see what it has open
    std::vector<QByteArray> devices{}; // that it has open, once for each time
};

// All of them, by id. `root`: the folder that has "proc" in it.
std::vector<RunningProcess> runningProcesses(const QByteArray &root);

} // namespace codewheel

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "links/running_process.h"

#include <QStringList>

#include <optional>

namespace codewheel {

// A program that runs.
struct Process
{
    int id = 0;
    QString name{};         // at most 15 characters, as the kernel keeps it
    bool isOurs = false;    // this program
    bool isOfOther = false; // of another user: what it has open cannot be seen

    friend bool operator==(const Process &, const Process &) = default;
};

// What the system tells about itself in /proc, /sys and /etc. Only looks; opens no device. What cannot be
// read is empty. It looks at processes once, when they are first asked for.
class Computer
{
public:
    // `root`: a folder that has these folders in it, instead of "/".
    explicit Computer(QString root = {});

    bool has(const QString &path) const;
    QByteArray contents(const QString &path) const; // without space around it
    QStringList folders(const QString &path) const; // names in it, links to folders too, sorted
    QString target(const QString &path) const;      // of a link, as written there
    // Without links; below the root. As it is, if it is not there.
    QString canonical(const QString &path) const;
    // A file in a folder that is for everybody.
    bool mayRemove(const QString &path) const;
    // That have it open, as far as we may see, or are controlled by it. Not who made it, if it is a pseudo
    // terminal: that is its other end.
    std::vector<Process> holdersOf(const QString &path) const;
    std::optional<Process> process(int id) const;
    bool exists(int id) const; // also a process that is hidden from us
    bool runs(const QString &program) const;

private:
    const std::vector<RunningProcess> &running() const;
    Process told(const RunningProcess &process) const;

    const QString m_root;
    mutable std::optional<std::vector<RunningProcess>> m_running;
};

} // namespace codewheel

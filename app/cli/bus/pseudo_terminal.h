// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/complaint.h"

#include <QByteArray>
#include <QString>

#include <chrono>
#include <optional>

namespace codewheel {

// A pseudo terminal that another program opens like a serial port. Only programs on this computer can. Used
// by the command serve.
class PseudoTerminal
{
public:
    // Empty if the system has none.
    static std::optional<PseudoTerminal> make();
    ~PseudoTerminal();
    PseudoTerminal(PseudoTerminal &&other) noexcept;
    PseudoTerminal &operator=(PseudoTerminal &&) = delete;

    QString path() const { return m_path; }
    // What the other program has set it to, in bit/s; 0 for an unusual rate.
    int baudRate() const;

    // Waits for bytes, for a program that comes or goes, or for `wake` to be readable, at most this long.
    void wait(int wake, std::chrono::microseconds atMost) const;
    // Since the last call the last program that had it open has closed it. Ask before read(): then what the
    // next one writes has not been read yet.
    bool clientLeft();
    QByteArray read(); // what is there now, in pieces
    // What nobody reads is dropped once the system's buffer is full. How many bytes it took.
    qsizetype write(const QByteArray &bytes);
    void dropUnfetched(); // what was written and not read

private:
    PseudoTerminal(int ours, int theirs, int watch, QString path);

    int m_ours;
    int m_theirs; // kept open, so that other programs may come and go
    int m_watch;  // tells who opens and closes it; below 0 where the system has none
    int m_clients = 0;
    QString m_path;
};

// The system has none left.
Complaint noPseudoTerminal();

} // namespace codewheel

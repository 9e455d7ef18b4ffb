// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

#include <chrono>
#include <optional>

namespace codewheel {

// A pseudo terminal that another program opens as if it were a serial port. Only programs on this computer
// can. Used by the command serve.
class PseudoTerminal
{
public:
    // Nothing where the system has none.
    static std::optional<PseudoTerminal> make();
    ~PseudoTerminal();
    PseudoTerminal(PseudoTerminal &&other) noexcept;
    PseudoTerminal &operator=(PseudoTerminal &&) = delete;

    QString path() const { return m_path; }
    // What the other program has set it to, in bit/s; 0 for one that is no usual rate.
    int baudRate() const;

    // Waits for bytes or for `wake` to be readable, at most this long.
    void wait(int wake, std::chrono::microseconds atMost) const;
    QByteArray read();                   // what is there now
    void write(const QByteArray &bytes); // what nobody fetches is dropped once the system's buffer is full

private:
    PseudoTerminal(int ours, int theirs, QString path);

    int m_ours;
    int m_theirs; // kept open, so that other programs may come and go
    QString m_path;
};

} // namespace codewheel

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/stop_signals.h"
#include "cli/call/terminal.h"

#include <QByteArray>

#include <functional>
#include <optional>

namespace codewheel {

// Lines as they are typed or come from a pipe, while something else goes on. Used by commands that answer
// each line.
class TypedLines
{
public:
    explicit TypedLines(const Terminal &terminal)
        : m_terminal(terminal)
    {}

    // The next line; empty at the end of the input, and after Ctrl+C. `meanwhile` is called repeatedly until
    // there is one, and ends the wait by returning false; without it nothing is done while waiting.
    std::optional<QString> next(const std::function<bool()> &meanwhile = {});
    bool isStopped() { return m_isStopped = m_isStopped || m_stop.came(); } // by Ctrl+C

private:
    enum class Input { none, some, ended };

    Input wait(bool isQuiet);
    Input take();
    std::optional<QString> fromStream();

    const Terminal &m_terminal;
    StopSignals m_stop;
    QByteArray m_read;
    bool m_isEnded = false;
    bool m_isStopped = false;
};

} // namespace codewheel

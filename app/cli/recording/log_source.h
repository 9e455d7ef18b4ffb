// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/stop_signals.h"

#include <QString>

#include <cstdint>
#include <string_view>
#include <vector>

namespace codewheel {

// The file or pipe that a log comes from. While it waits for more, also for somebody who opens the other end
// of a pipe, Ctrl+C ends it.
class LogSource
{
public:
    enum class State : std::uint8_t {
        hasMore,
        isEmpty, // for now: a pipe
        isAtEnd,
        wasStopped,
        failed,
    };

    explicit LogSource(const QString &path);
    ~LogSource();
    Q_DISABLE_COPY_MOVE(LogSource)

    bool isOpen() const { return m_descriptor >= 0; }
    const QString &path() const { return m_path; }
    QString error() const; // why it could not be opened or read

    // What comes next, up to `most` bytes; with isEmpty there was nothing yet.
    State read();
    std::string_view bytes() const { return {m_bytes.data(), m_size}; }
    State wait(); // until there is more, or the end

private:
    State look(int timeOut); // ms; negative: for ever

    static constexpr std::size_t most = 65'536;

    QString m_path;
    int m_descriptor = -1;
    int m_error = 0;
    StopSignals m_stop;
    std::vector<char> m_bytes;
    std::size_t m_size = 0;
};

} // namespace codewheel

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/check_outcome.h"
#include "kinds/esc/line/line_settings.h"
#include "serial/byte_link.h"

#include <QCoreApplication>

#include <atomic>
#include <optional>
#include <vector>

namespace codewheel {

enum class LineStep : std::uint8_t {
    found,   // the port is there
    opened,  // with these settings
    quiet,   // nobody else talks on the line
    encoder, // answers, with a position
};

// What a step of LineCheck found.
struct LineFinding
{
    LineStep step = LineStep::found;
    LineAddress address{}; // of an encoder; 0: whichever there is
    CheckOutcome outcome = CheckOutcome::skipped;
    QString sentence{};
    std::optional<Refusal> why{}; // of a port that cannot be opened

    friend bool operator==(const LineFinding &, const LineFinding &) = default;
};

// Tests a serial line step by step: whether its port can be opened, whether nobody else talks on it, and
// which encoders answer. It listens before it asks; where somebody talks, it asks nothing. Only reads are
// sent. Each next() does one step, so its caller can show what was found so far; interrupt() ends a step that
// waits. Used by the connection page.
class LineCheck
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::LineCheck)

public:
    static constexpr Instant listens{300'000}; // three time-outs as delivered: a master polls in that time

    // `link` must outlive this and is used by nobody else meanwhile. Without addresses any encoder is asked,
    // at the master address, which only works for one that is alone (manual, "Masteraddress: 00").
    LineCheck(ByteLink &link, LineSettings settings, std::vector<LineAddress> addresses);
    ~LineCheck(); // closes the link
    Q_DISABLE_COPY_MOVE(LineCheck)

    bool isDone() const { return m_next == m_steps.size(); }
    LineFinding next();
    void interrupt(); // skips what is left. Any thread

    static QString stepText(LineStep step, LineAddress address); // "Serial port", "Encoder 05"
    // What came instead of an answer, and what to check.
    static QString silenceText(int strayBytes, bool isEchoed);

private:
    LineFinding find();
    LineFinding open();
    LineFinding listen();
    LineFinding ask(LineAddress address);
    LineFinding told(CheckOutcome outcome, const QString &sentence) const;
    LineFinding refused(const Refusal &why);

    ByteLink &m_link;
    const LineSettings m_settings;
    std::vector<LineFinding> m_steps; // not made yet
    std::size_t m_next = 0;
    Result<void> m_opened;
    bool m_isOver = false; // nothing further can be found out
    std::atomic<bool> m_isStopped = false;
};

} // namespace codewheel

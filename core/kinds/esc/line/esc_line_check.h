// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/check_outcome.h"
#include "kinds/esc/line/esc_line_settings.h"
#include "serial/byte_link.h"

#include <QCoreApplication>

#include <atomic>
#include <optional>
#include <vector>

namespace codewheel {

enum class EscLineStep : std::uint8_t {
    found,   // the port is there
    opened,  // with these settings
    quiet,   // nobody else talks on the line
    encoder, // answers, with a position
};

// What a step of EscLineCheck found.
struct EscLineFinding
{
    EscLineStep step = EscLineStep::found;
    EscLineAddress address{}; // of an encoder; 0: whichever there is
    CheckOutcome outcome = CheckOutcome::skipped;
    QString sentence{};
    std::optional<Refusal> why{}; // of a port that cannot be opened

    friend bool operator==(const EscLineFinding &, const EscLineFinding &) = default;
};

// Tests a serial line step by step: whether its port can be opened, whether nobody else talks on it, and
// which encoders answer. It listens before it asks; where somebody talks, it asks nothing. Only reads are
// sent. Each next() does one step, so its caller can show what was found so far; interrupt() ends a step that
// waits. Used by the connection page.
class EscLineCheck
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::EscLineCheck)

public:
    static constexpr Instant listens{300'000}; // three time-outs as delivered: a master polls in that time

    // `link` must outlive this and is used by nobody else meanwhile. Without addresses any encoder is asked,
    // at the master address, which only works for one that is alone (manual, "Masteraddress: 00").
    EscLineCheck(ByteLink &link, EscLineSettings settings, std::vector<EscLineAddress> addresses);
    ~EscLineCheck(); // closes the link
    Q_DISABLE_COPY_MOVE(EscLineCheck)

    bool isDone() const { return m_next == m_steps.size(); }
    EscLineFinding next();
    void interrupt(); // skips what is left. Any thread

    static QString stepText(EscLineStep step, EscLineAddress address); // "Serial port", "Encoder 05"
    // What came instead of an answer, and what to check.
    static QString silenceText(int strayBytes, bool isEchoed);

private:
    EscLineFinding find();
    EscLineFinding open();
    EscLineFinding listen();
    EscLineFinding ask(EscLineAddress address);
    EscLineFinding told(CheckOutcome outcome, const QString &sentence) const;
    EscLineFinding refused(const Refusal &why);

    ByteLink &m_link;
    const EscLineSettings m_settings;
    std::vector<EscLineFinding> m_steps; // not made yet
    std::size_t m_next = 0;
    Result<void> m_opened;
    bool m_isOver = false; // nothing further can be found out
    std::atomic<bool> m_isStopped = false;
};

} // namespace codewheel

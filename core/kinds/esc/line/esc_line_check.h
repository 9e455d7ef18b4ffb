// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/link_check.h"
#include "kinds/esc/line/esc_line_settings.h"
#include "serial/byte_link.h"

#include <QCoreApplication>

#include <vector>

namespace codewheel {

enum class EscLineStep : std::uint8_t {
    found,   // the port is there
    opened,  // with these settings
    quiet,   // nobody else talks on the line
    encoder, // answers, with a position
};

using EscLineFinding = LinkFinding<EscLineStep, EscLineAddress>;

// Tests a serial line step by step: whether its port can be opened, whether nobody else talks on it, and
// which encoders answer. It listens before it asks; where somebody talks, it asks nothing. Only reads are
// sent. Used by the connection page.
class EscLineCheck final : public LinkCheck<ByteLink, EscLineStep, EscLineAddress>
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::EscLineCheck)

public:
    static constexpr Instant listens{300'000}; // three time-outs as delivered: a master polls in that time

    // Without addresses any encoder is asked, at the master address, which only works for one that is alone
    // (manual, "Masteraddress: 00").
    EscLineCheck(ByteLink &link, EscLineSettings settings, std::vector<EscLineAddress> addresses);

    static QString stepText(EscLineStep step, EscLineAddress address); // "Serial port", "Encoder 05"
    // What came instead of an answer, and what to check.
    static QString silenceText(int strayBytes, bool isEchoed);

private:
    EscLineFinding found(EscLineStep step, EscLineAddress address) override;
    EscLineFinding find();
    EscLineFinding open();
    EscLineFinding listen();
    EscLineFinding ask(EscLineAddress address);

    const EscLineSettings m_settings;
    Result<void> m_opened;
};

} // namespace codewheel

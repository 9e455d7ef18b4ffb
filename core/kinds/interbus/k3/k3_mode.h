// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/words/k3_explain.h"

#include <optional>

namespace codewheel {

// "Set encoder to default", 0E000000h (FRABA manual 10.1, Baumer manual 5).
inline constexpr unsigned resetNumber = 7;
constexpr bool isReset(Word out) noexcept
{
    return k3::isParameterWord(out) && k3::number(out) == resetNumber;
}

// The mode of an encoder that has several (FRABA): known once told, or once a word that passed has switched
// it (FRABA manual 5.4.2, 5.4.4). Otherwise it stays unknown, and nothing is guessed.
class K3Mode
{
public:
    // An encoder takes a word that was there for 2 cycles (assumed); the third one shows the new mode.
    static constexpr int cyclesUntilTaken = 3;

    void tell(std::optional<Mode> mode, std::optional<unsigned> camProgram = {});
    // The same, by somebody's word: no word that passed has shown it.
    void believe(std::optional<Mode> mode, std::optional<unsigned> camProgram);
    enum class Switched : std::uint8_t { no, perhaps, certainly };
    // Once a word has switched the mode, even if to the one it was in; or perhaps has, since it left OUT too
    // early to know.
    Switched observe(Word out);
    // Nobody sees what becomes of `out`. True: it, or the word before it, may switch the mode, or the cam
    // program, which is not known from now on.
    bool loseSight(Word out);
    std::optional<Mode> now() const { return m_mode; }
    bool isOnlyBelieved() const { return m_mode && m_isBelieved; }
    // The cam program, 1..8, in cam mode.
    std::optional<unsigned> camProgram() const { return m_camProgram; }

private:
    bool isOpen() const;
    bool switches(Word out) const;
    bool leadsElsewhere(Word out) const;
    static Mode modeOf(Word out);
    void switchedBy(Word out);
    void mayBeSwitchedBy(Word out);

    std::optional<Mode> m_mode;
    std::optional<unsigned> m_camProgram;
    bool m_isBelieved = false;
    Word m_out = 0;
    int m_stoodFor = 0;
};

// The mode that an encoder has after power-up with this start-up mode (read-out 9, FRABA manual 10.2).
std::optional<Mode> modeAfterStartUp(std::int64_t startUpMode);
std::optional<unsigned> camProgramAfterStartUp(std::int64_t startUpMode);
// The start-up mode that leads to this mode. Empty: cam mode with an unknown program.
std::optional<std::int64_t> startUpModeFor(Mode mode, std::optional<unsigned> camProgram);

} // namespace codewheel

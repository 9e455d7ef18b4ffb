// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/k3_mode.h"

namespace codewheel {
namespace {

constexpr Word camModeWord = 0x2080'0000; // + program; 0: back to position mode
constexpr Word camProgramMask = 0x0000'000F;

} // namespace

void K3Mode::observe(Word out)
{
    if (out != m_out) {
        m_out = out;
        m_stoodFor = 0;
    }
    if (m_stoodFor < cyclesUntilTaken && ++m_stoodFor == cyclesUntilTaken)
        switchedBy(out);
}

void K3Mode::switchedBy(Word out)
{
    if ((out & ~camProgramMask) == camModeWord) {
        const Word program = out & camProgramMask;
        if (program == 0)
            m_mode = Mode::position;
        else if (program <= 8)
            m_mode = Mode::cam;
    } else if (m_mode == Mode::position || m_mode == Mode::velocity) {
        // In cam mode these two words set the cam configuration instead.
        if (out == k3::velocityOn)
            m_mode = Mode::velocity;
        else if (out == k3::velocityOff)
            m_mode = Mode::position;
    }
}

std::optional<Mode> modeAfterStartUp(std::int64_t startUpMode)
{
    if (startUpMode == 0 || startUpMode == 1) // K2, K3
        return Mode::position;
    if (startUpMode == 2)
        return Mode::velocity;
    if (startUpMode >= 3 && startUpMode <= 10)
        return Mode::cam;
    return std::nullopt;
}

} // namespace codewheel

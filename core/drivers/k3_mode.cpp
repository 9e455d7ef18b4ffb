// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/k3_mode.h"

#include "words/k3_cam_word.h"

namespace codewheel {

bool K3Mode::observe(Word out)
{
    if (out != m_out) {
        m_out = out;
        m_stoodFor = 0;
    }
    return m_stoodFor < cyclesUntilTaken && ++m_stoodFor == cyclesUntilTaken && switchedBy(out);
}

bool K3Mode::switchedBy(Word out)
{
    if (k3::isProgramWord(out)) {
        const Word program = out & ~k3::programWord;
        if (program > k3::camProgramCount)
            return false;
        m_mode = program == 0 ? Mode::position : Mode::cam;
        return true;
    }
    // In cam mode these two words set the cam configuration instead.
    if (m_mode != Mode::position && m_mode != Mode::velocity)
        return false;
    if (out != k3::velocityOn && out != k3::velocityOff)
        return false;
    m_mode = out == k3::velocityOn ? Mode::velocity : Mode::position;
    return true;
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

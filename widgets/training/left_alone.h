// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace codewheel {

// Decides when to report a move by hand: once, after half a second without another one.
class LeftAlone
{
public:
    void moved() { m_framesToRest = framesOfRest; }
    void forget() { m_framesToRest = 0; }
    bool isMoving() const { return m_framesToRest > 0; }
    // Called with each frame. True once, after the last move.
    bool frame() { return m_framesToRest > 0 && --m_framesToRest == 0; }

private:
    static constexpr int framesOfRest = 15;

    int m_framesToRest = 0;
};

} // namespace codewheel

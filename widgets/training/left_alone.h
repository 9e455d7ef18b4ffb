// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace codewheel {

// A move by hand is told of once: when the part was left alone for half a second.
class LeftAlone
{
public:
    void moved() { m_framesToRest = framesOfRest; }
    void forget() { m_framesToRest = 0; }
    bool isMoving() const { return m_framesToRest > 0; }
    // With each frame. True once after the last move.
    bool frame() { return m_framesToRest > 0 && --m_framesToRest == 0; }

private:
    static constexpr int framesOfRest = 15;

    int m_framesToRest = 0;
};

} // namespace codewheel

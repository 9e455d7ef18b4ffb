// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace codewheel {

// A move by hand is told of once: when the part was left alone for half a second.
class LeftAlone
{
public:
    void moved() { m_picturesToRest = picturesOfRest; }
    void forget() { m_picturesToRest = 0; }
    bool isMoving() const { return m_picturesToRest > 0; }
    // With each picture. True once after the last move.
    bool picture() { return m_picturesToRest > 0 && --m_picturesToRest == 0; }

private:
    static constexpr int picturesOfRest = 15;

    int m_picturesToRest = 0;
};

} // namespace codewheel

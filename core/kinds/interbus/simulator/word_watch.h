// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/words/k3_word.h"

namespace codewheel {

// What a simulated encoder has seen of OUT: how long the word has been there, the edges of D31 and D30, and
// whether the word has been dealt with.
class WordWatch
{
public:
    // After power-up: the first word seen is not an edge.
    void reset() { *this = WordWatch(); }

    void see(Word out)
    {
        const Word rising = m_first ? 0 : out & ~m_word;
        const bool started = (out & k3::startBit) != 0;
        m_startEdge = (rising & k3::startBit) != 0;
        if ((out & k3::presetBit) == 0)
            m_presetEdge = false;
        else if ((rising & k3::presetBit) != 0 && !started) // D30 is ignored while D31 is 1
            m_presetEdge = true;
        if (m_first || out != m_word) {
            m_cycles = 0;
            m_done = false;
        }
        ++m_cycles;
        m_word = out;
        m_first = false;
    }

    bool isOld(Word out) const { return m_done && out == m_word; }
    bool isDone() const { return m_done; }
    bool hasStood(int cycles) const { return m_cycles >= cycles; }
    void setDone() { m_done = true; }

    bool startEdge() const { return m_startEdge; } // in the cycle just seen
    // D30 rose, and nobody has asked since.
    bool takePresetEdge()
    {
        const bool edge = m_presetEdge;
        m_presetEdge = false;
        return edge;
    }

private:
    Word m_word = 0;
    long long m_cycles = 0;
    bool m_first = true;
    bool m_done = false;
    bool m_startEdge = false;
    bool m_presetEdge = false;
};

} // namespace codewheel

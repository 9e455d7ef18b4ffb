// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/simulator/fraba_cams.h"

#include "kinds/interbus/words/k3_word.h"

namespace codewheel {

namespace {

// D31..D29 of OUT; the cam number is in D28..D25.
constexpr Word startOfCam = 0x4000'0000;
constexpr Word stopOfCam = 0x6000'0000;
constexpr Word camConfiguration = 0x2040'0000; // + 16 bit
constexpr Word shift = 0x2010'0000;            // + 8 bit

// 2020xxxx: what is read out; start and stop + cam number
constexpr Word readConfiguration = 0x00;
constexpr Word readStart = 0x10;
constexpr Word readStop = 0x20;
constexpr Word readShift = 0x40;

constexpr Word wrongData = 0x8200'0000;
constexpr Word wrongCommand = 0x8400'0000;

constexpr Word camsMask = 0xFF;
constexpr int positionBit = 8;
constexpr Word positionMask = 0x1'FFFF; // 17 bit

} // namespace

void FrabaCams::enter(unsigned program)
{
    m_entered = program;
    m_current = m_stored[program - 1];
    m_changed = false;
}

bool FrabaCams::leave()
{
    const bool saved = m_changed;
    if (saved)
        m_stored[m_entered - 1] = m_current;
    m_entered = 0;
    m_changed = false;
    return saved;
}

void FrabaCams::powerUp()
{
    if (isEntered())
        enter(m_entered);
}

void FrabaCams::clear()
{
    *this = FrabaCams();
}

std::optional<Word> FrabaCams::take(Word out, std::int64_t totalRange)
{
    Program changed = m_current;
    if ((out & 0xFFFF'0000) == camConfiguration) {
        changed.active = out & 0xFFFF;
    } else if ((out & 0xFFFF'FF00) == shift) {
        changed.shift = out & 0xFF;
        if (changed.shift > largestShift)
            return wrongData;
    } else if ((out & startOfCam) != 0) {
        const unsigned number = k3::number(out);
        const Word position = k3::data(out);
        if (number >= cams)
            return wrongCommand;
        if (position >= totalRange)
            return camAboveLargestPosition;
        Cam &cam = changed.cam[number];
        ((out & k3::statusMask) == stopOfCam ? cam.stop : cam.start) = position;
    } else {
        return wrongCommand;
    }
    m_current = changed;
    m_changed = true;
    return std::nullopt;
}

std::optional<Word> FrabaCams::readOut(Word what) const
{
    if (what == readConfiguration)
        return m_current.active;
    if (what == readShift)
        return m_current.shift;
    if (what >= readStart && what < readStart + cams)
        return m_current.cam[what - readStart].start;
    if (what >= readStop && what < readStop + cams)
        return m_current.cam[what - readStop].stop;
    return std::nullopt;
}

// From start to stop, both included; through zero if start is after stop (assumed).
bool FrabaCams::isOn(const Cam &cam, Word position)
{
    const bool afterStart = position >= cam.start;
    const bool beforeStop = position <= cam.stop;
    return cam.start <= cam.stop ? afterStart && beforeStop : afterStart || beforeStop;
}

Word FrabaCams::word(std::int64_t position) const
{
    const auto value = static_cast<Word>(position);
    Word on = 0;
    for (unsigned n = 0; n < cams; ++n) {
        if (isOn(m_current.cam[n], value))
            on |= Word{1} << n;
    }
    const Word shown = (value >> m_current.shift) & positionMask;
    return shown << positionBit | (on & m_current.active & camsMask);
}

} // namespace codewheel

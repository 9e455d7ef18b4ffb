// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/k3/k3_mode.h"

#include "kinds/interbus/words/k3_cam_word.h"

namespace codewheel {
namespace {

// Start-up modes: 0 K2, 1 K3, 2 velocity, 3 cam program 1.
constexpr std::int64_t startUpInPosition = 1;
constexpr std::int64_t startUpInVelocity = 2;

} // namespace

void K3Mode::tell(std::optional<Mode> mode, std::optional<unsigned> camProgram)
{
    m_mode = mode;
    m_camProgram = mode == Mode::cam ? camProgram : std::nullopt;
    m_isBelieved = false;
}

void K3Mode::believe(std::optional<Mode> mode, std::optional<unsigned> camProgram)
{
    tell(mode, camProgram);
    m_isBelieved = true;
}

K3Mode::Switched K3Mode::observe(Word out)
{
    bool wasOpen = false;
    if (out != m_out) {
        wasOpen = isOpen() && leadsElsewhere(m_out);
        if (wasOpen)
            tell(std::nullopt);
        m_out = out;
        m_stoodFor = 0;
    }
    if (m_stoodFor == cyclesUntilTaken || ++m_stoodFor != cyclesUntilTaken || !switches(out))
        return wasOpen ? Switched::perhaps : Switched::no;
    switchedBy(out);
    return Switched::certainly;
}

bool K3Mode::loseSight(Word out)
{
    const bool before = isOpen() && leadsElsewhere(m_out);
    const bool now = out != m_out && leadsElsewhere(out);
    if (before)
        mayBeSwitchedBy(m_out);
    if (now)
        mayBeSwitchedBy(out);
    return before || now;
}

// From one cam program to another it stays in cam mode either way.
void K3Mode::mayBeSwitchedBy(Word out)
{
    if (modeOf(out) != m_mode)
        tell(std::nullopt);
    else if ((out & ~k3::programWord) != m_camProgram)
        tell(Mode::cam);
}

// Its word has not been there long enough to be certain that it was taken.
bool K3Mode::isOpen() const
{
    return m_stoodFor > 0 && m_stoodFor < cyclesUntilTaken && switches(m_out);
}

bool K3Mode::switches(Word out) const
{
    if (k3::isProgramWord(out))
        return (out & ~k3::programWord) <= k3::camProgramCount;
    // In cam mode these two words set the cam configuration instead.
    const bool mayBeVelocity = m_mode == Mode::position || m_mode == Mode::velocity;
    return mayBeVelocity && (out == k3::velocityOn || out == k3::velocityOff);
}

// To another mode than this one. In cam mode the word of the same program may save it.
bool K3Mode::leadsElsewhere(Word out) const
{
    return switches(out) && (m_mode == Mode::cam || modeOf(out) != m_mode);
}

Mode K3Mode::modeOf(Word out)
{
    if (out == k3::velocityOn)
        return Mode::velocity;
    const bool isOfCams = k3::isProgramWord(out) && out != k3::programWord;
    return isOfCams ? Mode::cam : Mode::position;
}

void K3Mode::switchedBy(Word out)
{
    tell(modeOf(out), out & ~k3::programWord);
}

std::optional<Mode> modeAfterStartUp(std::int64_t startUpMode)
{
    if (startUpMode == 0 || startUpMode == startUpInPosition)
        return Mode::position;
    if (startUpMode == startUpInVelocity)
        return Mode::velocity;
    if (camProgramAfterStartUp(startUpMode))
        return Mode::cam;
    return std::nullopt;
}

std::optional<unsigned> camProgramAfterStartUp(std::int64_t startUpMode)
{
    if (startUpMode <= startUpInVelocity || startUpMode > startUpInVelocity + k3::camProgramCount)
        return std::nullopt;
    return static_cast<unsigned>(startUpMode - startUpInVelocity);
}

std::optional<std::int64_t> startUpModeFor(Mode mode, std::optional<unsigned> camProgram)
{
    if (mode == Mode::position)
        return startUpInPosition;
    if (mode == Mode::velocity)
        return startUpInVelocity;
    return camProgram ? std::optional(startUpInVelocity + std::int64_t{*camProgram}) : std::nullopt;
}

} // namespace codewheel

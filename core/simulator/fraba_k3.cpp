// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/fraba_k3.h"

#include <cmath>

namespace codewheel {

namespace {

constexpr std::int64_t clockwise = 3;
constexpr std::int64_t counterclockwise = 4;

ParameterSet factorySet(PhysicalResolution resolution)
{
    ParameterSet set;
    set.steps = resolution.stepsPerTurn;
    set.revolutions = 1;
    set.coding = clockwise;
    set.measuringRange = resolution.turns;
    return set;
}

} // namespace

FrabaK3::FrabaK3(PhysicalResolution resolution, std::int64_t raw, FrabaPlate plate, K3Timing timing)
    : SimulatedK3(TurningShaft(resolution, raw), factorySet(resolution), timing)
    , m_plate(plate)
{
    begin();
}

// Read-out ends with the first word whose D16 is 0. The FRABA preset acts in every cycle in which it is seen.
void FrabaK3::seen(Word out)
{
    if ((out & k3::readOutRequestBit) == 0)
        showReadOut(0);
    if (out == k3::frabaPreset && phase() == Phase::operation)
        initialisePreset(ParameterMemory::Storing::inEeprom);
}

bool FrabaK3::take(Word out)
{
    if (k3::isReadOutRequest(out))
        showReadOut(readOutAnswer(out & 0xFFFF));
    else if (readOut() != 0)
        return true; // D16 goes on asking for the value: nothing else is understood
    else if (out == k3::frabaPreset)
        return false;
    else if ((out & k3::presetBit) != 0)
        takePreset(out);
    else if ((out & k3::manufacturerBit) != 0)
        takeManufacturerWord(out);
    else if (k3::isParameterWord(out))
        takeParameter(out);
    return true;
}

// "Parameter received (not checked yet)": Cp and the data stand in IN from the first cycle on.
void FrabaK3::takeParameter(Word out)
{
    using namespace parameter_number;
    const unsigned number = k3::number(out);
    if (number <= zeroOffset || number == setToDefault)
        process(out, k3::confirmation | out);
    else
        fail(error_number::unknownNumber);
}

// A programmed preset can be activated once.
void FrabaK3::takePreset(Word out)
{
    if (out != k3::initialisePreset)
        fail(error_number::unknownNumber);
    else if (takePresetEdge() && phase() == Phase::operation && memory().active().presetArmed)
        initialisePreset(ParameterMemory::Storing::inEeprom);
}

void FrabaK3::takeManufacturerWord(Word out)
{
    if (out == k3::velocityOn)
        m_mode = Mode::velocity;
    else if (out == k3::velocityOff)
        m_mode = Mode::position;
    else
        fail(error_number::unknownNumber);
}

bool FrabaK3::confirm(unsigned number, Word data)
{
    using namespace parameter_number;
    std::int64_t value = data;
    switch (number) {
    case steps:
        value += m_plate.stepsMinusOne ? 1 : 0;
        if (value < 1 || value > k3::dataMask)
            return false;
        break;
    case revolutions:
        if (value < 1 || value > mostTurns)
            return false;
        break;
    case coding:
        if (value != clockwise && value != counterclockwise)
            return false;
        break;
    case setToDefault:
        if (value != 0)
            return false;
        memory().confirmDefault();
        return true;
    default:
        break;
    }
    memory().confirm(number, value);
    return true;
}

Word FrabaK3::operationWord() const
{
    if (shaft().isFasterThan(fastestCode))
        return k3::notValidBit;
    return m_mode == Mode::velocity ? velocity() : arithmetic().codedValue(shaft().raw());
}

// Whole revolutions per minute, positive when the position rises, 25-bit two's complement (assumed)
Word FrabaK3::velocity() const
{
    const long rpm = std::lround(arithmetic().isClockwise() ? shaft().speed() : -shaft().speed());
    return static_cast<Word>(rpm) & k3::dataMask;
}

void FrabaK3::wentToDefault()
{
    m_mode = Mode::position;
}

} // namespace codewheel

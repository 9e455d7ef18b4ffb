// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/simulator/fraba_k3.h"

#include "kinds/interbus/words/k3_word.h"

#include <cmath>

namespace codewheel {

namespace {

constexpr std::int64_t clockwise = 3;
constexpr std::int64_t counterclockwise = 4;

constexpr Word modeWord = 0x2080'0000; // + cam program, 0: position mode
constexpr Word programMask = 0xF;
constexpr Word camReadOutMask = 0xFFFF'0000;

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

FrabaK3::FrabaK3(PhysicalResolution resolution, std::int64_t raw, FrabaPlate plate, EncoderTiming timing)
    : SimulatedK3(TurningShaft(resolution, raw), factorySet(resolution), timing)
    , m_plate(plate)
{
    begin();
}

bool FrabaK3::isCamReadOut(Word out) const
{
    return (out & camReadOutMask) == k3::camReadOut && m_mode == Mode::cam;
}

// Once requested by D16, a read-out lasts as long as D16 is set, whatever the rest of the word; with the cams
// it is the word itself that requests it.
bool FrabaK3::holdsReadOut(Word out) const
{
    return isCamReadOut(out) || (m_readsByD16 && (out & k3::readOutRequestBit) != 0);
}

// In every mode (assumed: the manual only says how a cam word is refused).
std::optional<Word> FrabaK3::fault() const
{
    return m_camOutOfRange ? std::optional(camAboveLargestPosition) : std::nullopt;
}

void FrabaK3::setCamOutOfRange(bool outOfRange)
{
    m_camOutOfRange = outOfRange;
    faultChanged();
}

// The FRABA preset acts in every cycle in which it is seen.
void FrabaK3::seen(Word out)
{
    if (!holdsReadOut(out))
        showReadOut(0);
    if (isFrabaPreset(out) && phase() == Phase::operation)
        initialisePreset(ParameterMemory::Storing::inEeprom);
}

bool FrabaK3::take(Word out)
{
    if (k3::isReadOutRequest(out) || isCamReadOut(out)) {
        showReadOut(readOutAnswer(out));
        m_readsByD16 = k3::isReadOutRequest(out);
        return true;
    }
    if (readOut() != 0)
        return true; // nothing else is understood
    if (isFrabaPreset(out))
        return false;
    takeCommand(out);
    return true;
}

void FrabaK3::takeCommand(Word out)
{
    if ((out & ~programMask) == modeWord)
        switchTo(out & programMask);
    else if (m_mode == Mode::cam)
        takeCamWord(out);
    else if ((out & k3::presetBit) != 0)
        takePreset(out);
    else if ((out & k3::manufacturerBit) != 0)
        takeManufacturerWord(out);
    else if (k3::isParameterWord(out))
        takeParameter(out);
}

// "Parameter received (not checked yet)": Cp and the data are in IN from the first cycle on.
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

// At once, without acknowledgement or run; 0 is position mode. The program left is saved, which also ends the
// cam parameterization.
void FrabaK3::switchTo(unsigned program)
{
    if (program > FrabaCams::programs) {
        fail(error_number::wrongData);
        return;
    }
    if (m_mode == Mode::cam) {
        if (m_cams.leave())
            memory().countWrite();
        if (!memory().hasPending() && !memory().isLost())
            operate();
    }
    m_mode = program == 0 ? Mode::position : Mode::cam;
    if (program != 0)
        m_cams.enter(program);
}

// In cam mode each word is acknowledged until run, immediately unless the encoder is slow.
void FrabaK3::takeCamWord(Word out)
{
    if ((out & k3::controlMask) == 0)
        return; // normal running
    if (isSlow()) {
        process(out, phase() == Phase::operation ? 0 : shown());
        return;
    }
    const Word answer = camAnswer(out);
    if (k3::isConfirmation(answer))
        acknowledge(answer);
    else
        failWith(answer);
}

// IN is OUT with D31 D30 = 11 (assumed), or the error instead.
Word FrabaK3::camAnswer(Word out)
{
    return m_cams.take(out, arithmetic().total()).value_or(k3::confirmation | out);
}

Word FrabaK3::answerTo(Word processed)
{
    return m_mode == Mode::cam ? camAnswer(processed) : SimulatedK3::answerTo(processed);
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
    switch (m_mode) {
    case Mode::velocity:
        return velocity();
    case Mode::cam:
        return m_cams.word(arithmetic().processValue(shaft().raw()));
    case Mode::position:
        break;
    }
    return arithmetic().codedValue(shaft().raw());
}

// Whole revolutions per minute, positive when the position rises, 25-bit two's complement (assumed)
Word FrabaK3::velocity() const
{
    const long rpm = std::lround(arithmetic().isClockwise() ? shaft().speed() : -shaft().speed());
    return static_cast<Word>(rpm) & k3::dataMask;
}

void FrabaK3::wentToDefault()
{
    m_cams.clear();
    m_mode = Mode::position;
}

} // namespace codewheel

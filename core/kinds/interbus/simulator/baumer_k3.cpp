// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/simulator/baumer_k3.h"

#include "kinds/interbus/words/k3_word.h"

namespace codewheel {

BaumerK3::BaumerK3(PhysicalResolution resolution, std::int64_t raw, EncoderTiming timing)
    : SimulatedK3(TurningShaft(resolution, raw), ParameterSet(), timing)
{
    begin();
}

bool BaumerK3::take(Word out)
{
    if ((out & k3::presetBit) != 0) {
        // NPV is not stored before some parameter is written
        if (takePresetEdge() && phase() == Phase::operation)
            initialisePreset(ParameterMemory::Storing::volatileOnly);
    } else if (k3::number(out) != 0) {
        takeParameter(out & ~k3::manufacturerBit);
    }
    return true;
}

// While processing, the previous number (0 at first) is shown beside the new data. The number confirmed last
// must not be sent again: it is ignored.
void BaumerK3::takeParameter(Word out)
{
    const unsigned previous = phase() == Phase::parameterization ? k3::number(shown()) : 0;
    if (k3::number(out) != previous)
        process(out, k3::confirmation | k3::parameterWord(previous, k3::data(out)));
}

bool BaumerK3::confirm(unsigned number, Word data)
{
    using namespace parameter_number;
    if (number == setToDefault)
        memory().confirmDefault();
    else if (number <= offset || number == measuringRange)
        memory().confirm(number, data);
    else
        memory().confirmUnknown();
    return true;
}

std::optional<unsigned> BaumerK3::startUpError() const
{
    return m_batteryLow ? std::optional(error_number::batteryLow) : std::nullopt;
}

std::optional<Word> BaumerK3::fault() const
{
    constexpr Word shown = k3::error | k3::withNumber(error_number::codeDiscFaulty);
    return m_codeDiscFaulty ? std::optional(shown) : std::nullopt;
}

void BaumerK3::setCodeDiscFaulty(bool faulty)
{
    m_codeDiscFaulty = faulty;
    faultChanged();
}

} // namespace codewheel

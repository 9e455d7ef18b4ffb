// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/cycle_time.h"

#include "kinds/interbus/ring/numbering.h"

#include <algorithm>

namespace codewheel {
namespace {

constexpr MicrosecondsOnTheWire perKilometre{16};

// t = (stuffing x 13 (6 + n) + a m) tBit + software + 0.016 ms/km
struct Form
{
    double stuffing;
    double bitsPerRemoteDevice;
    MicrosecondsOnTheWire software;
};
constexpr Form g3{1.0, 1.5, MicrosecondsOnTheWire{200}};
constexpr Form g4{1.15, 4.0, MicrosecondsOnTheWire{700}}; // (assumed; gives the published 16.2 ms)

} // namespace

RingLoad ringLoad(const RingStructure &structure, double cableKilometres)
{
    RingLoad load{0, 0, cableKilometres};
    for (const RingDevice &participant : structure) {
        load.dataBytes += 2 * std::max(participant.inWords, participant.outWords);
        if (!isOnLocalBus(participant))
            ++load.remoteBusDevices;
    }
    return load;
}

MicrosecondsOnTheWire cycleTime(const RingLoad &load, MicrosecondsOnTheWire bit, CycleTimeForm form)
{
    const Form &f = form == CycleTimeForm::g3 ? g3 : g4;
    const double bits =
        f.stuffing * 13 * (6 + load.dataBytes) + f.bitsPerRemoteDevice * load.remoteBusDevices;
    return bits * bit + f.software + load.cableKilometres * perKilometre;
}

} // namespace codewheel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/known_keeper.h"

#include "bus/encoder_bus.h"
#include "catalog/device_description.h"

#include <algorithm>

namespace codewheel {
namespace {

// What an encoder keeps without supply, as far as is known, and what is printed on it. Not the mode it is in.
bool lasts(const ParameterDescription &parameter, const Known &known)
{
    const bool isStored = parameter.canBeWritten && parameter.stored && known.kept != Kept::untilPowerOff;
    return isStored || parameter.onLabel;
}

bool has(const KnownBefore &known, Parameter parameter)
{
    return std::ranges::count(known.values, parameter, &KnownBefore::Entry::parameter) > 0;
}

// Now, and from before as long as it is open whether it is the same encoder.
KnownBefore knownOf(const EncoderSession &encoder, bool isSimulated)
{
    KnownBefore all{.values = {}, .serialNumber = reportedSerialNumber(encoder)};
    for (const ParameterDescription &parameter : encoder.device().parameters)
        if (const auto known = encoder.known(parameter.parameter);
            known && (isSimulated || lasts(parameter, *known)))
            all.values.push_back({parameter.parameter, known->value, known->evidence,
                                  encoder.dateTime(known->at), known->kept});
    if (const auto &before = encoder.knownBefore()) {
        for (const KnownBefore::Entry &value : before->values)
            if (!has(all, value.parameter))
                all.values.push_back(value);
        if (!all.serialNumber)
            all.serialNumber = before->serialNumber;
    }
    return all;
}

} // namespace

void KnownKeeper::watch(EncoderBus &bus)
{
    if (m_bus != nullptr)
        m_bus->disconnect(this);
    m_bus = &bus;
    connect(&bus, &EncoderBus::nodesChanged, this, &KnownKeeper::meetAll);
    connect(&bus, &EncoderBus::meetsAgain, this, &KnownKeeper::meetAgain);
    connect(&bus, &EncoderBus::replaced, this, &KnownKeeper::forgetAt);
    meetAll();
}

void KnownKeeper::forget()
{
    std::erase_if(m_memory, [](const auto &one) { return !one.first.second; });
    if (m_bus != nullptr && m_bus->isOpen())
        for (const auto &[place, encoder] : m_met)
            if (encoder != nullptr)
                remember(*encoder);
}

void KnownKeeper::forgetSimulated()
{
    std::erase_if(m_memory, [](const auto &one) { return one.first.second; });
}

void KnownKeeper::forgetAt(Place place)
{
    if (const auto met = m_met.find(place); met != m_met.end() && met->second != nullptr)
        met->second->disconnect(this);
    m_memory.erase({place, false});
    m_memory.erase({place, true});
}

void KnownKeeper::meetAll()
{
    for (const Place place : m_bus->places())
        if (EncoderSession *encoder = m_bus->encoder(place);
            encoder != nullptr && std::exchange(m_met[place], encoder) != encoder)
            meet(*encoder);
}

void KnownKeeper::meetAgain()
{
    for (const auto &[place, encoder] : m_met)
        if (encoder != nullptr)
            encoder->setKnownBefore(knownOf(*encoder, m_bus->isSimulated()));
}

void KnownKeeper::meet(EncoderSession &encoder)
{
    const auto memory = m_memory.find({encoder.place(), m_bus->isSimulated()});
    if (memory != m_memory.end() && memory->second.deviceKey == encoder.device().key) {
        encoder.setKnownBefore(memory->second.known);
        if (m_bus->isSimulated()) // it waited meanwhile, and nobody else was there
            encoder.takeKnownBefore();
    }
    remember(encoder); // it may have been told something already
    for (const auto changed : {&EncoderSession::knownChanged, &EncoderSession::knownBeforeChanged})
        connect(&encoder, changed, this, [this, &encoder] { remember(encoder); });
}

void KnownKeeper::remember(const EncoderSession &encoder)
{
    const bool isSimulated = m_bus->isSimulated();
    m_memory[{encoder.place(), isSimulated}] = {encoder.device().key, knownOf(encoder, isSimulated)};
}

} // namespace codewheel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/la66/la66_encoder.h"

#include "kinds/interbus/words/la66_word.h"

#include <utility>

namespace codewheel {
namespace {

EncoderState stateOf(Word in) noexcept
{
    if (la66::isServiceMode(in))
        return EncoderState::service;
    if ((in & ~(la66::errorBit | la66::dataMask)) != 0)
        return EncoderState::unknown;
    return la66::hasError(in) ? EncoderState::error : EncoderState::operation;
}

} // namespace

Reading decodeLa66(Word in, Instant at) noexcept
{
    static_assert(la66::magnetOutside == 1 << magnetErrorNumber);
    Reading reading;
    reading.at = at;
    reading.in = in;
    reading.state = stateOf(in);
    reading.coding = PositionCoding::binary;
    if (reading.state == EncoderState::operation || reading.state == EncoderState::error)
        reading.position = la66::data(in);
    if (reading.state == EncoderState::error)
        reading.errorNumber = magnetErrorNumber;
    return reading;
}

void La66Knowledge::observe(Word in, Instant now)
{
    const bool serviceMode = la66::isServiceMode(in);
    if (serviceMode && !m_serviceMode && la66::isService(in)) // one with the error bit changed nothing
        observeAnswer(in, now);
    m_serviceMode = serviceMode;
}

void La66Knowledge::observeAnswer(Word in, Instant now)
{
    const unsigned service = la66::service(in);
    const bool written = la66::isWrite(in);
    if (written && !m_othersWrite)
        m_values.countEepromWrite();
    const ParameterDescription *parameter =
        written ? findNumber(m_device, service) : findReadOut(m_device, service);
    if (parameter != nullptr)
        m_values.learn(
            {parameter->parameter, la66::data(in), written ? Evidence::echoed : Evidence::read, now});
}

void La66Encoder::forget(Parameter parameter)
{
    knowledge.values().forget(parameter);
    reportChanges();
}

void La66Encoder::loseSightByHand(Word out)
{
    if (!la66::isServiceMode(out) || !la66::isService(out) || !la66::isWrite(out) ||
        la66::answers(reading.in, out))
        return;
    InDoubt doubt{.position = la66::service(out) == la66::presetAdjustment};
    if (const auto *parameter = knowledge.find(la66::service(out))) {
        doubt.values = {{parameter->parameter, la66::data(out)}};
        forget(parameter->parameter);
    }
    if (doubt.hasSomething())
        events.emplace_back(std::move(doubt));
}

void La66Encoder::reportChanges()
{
    if (auto changes = knowledge.values().takeChanges())
        events.emplace_back(std::move(*changes));
}

void La66Encoder::observe(Word in, Word /*out*/, Instant now)
{
    knowledge.observe(in, now);
    reportChanges();
    reading = decodeLa66(in, now);
    const bool isOfNow = reading.state == EncoderState::operation;
    reading.stepsPerSecond = speed.after(isOfNow ? reading.position : std::nullopt, now);
}

} // namespace codewheel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/interbus/ring/driven_encoder.h"

#include "catalog/catalog.h"
#include "kinds/interbus/k3/k3_reading.h"
#include "kinds/interbus/simulator/baumer_k3.h"
#include "kinds/interbus/simulator/fraba_k3.h"

#include <gtest/gtest.h>
#include <stdexcept>

namespace codewheel {
namespace {

constexpr PhysicalResolution thirteenPlusTwelveBit{.stepsPerTurn = 8192, .turns = 4096};
constexpr std::int64_t raw = 12'345;
constexpr int longestJob = 10'000; // cycles

const DeviceDescription &describe(QStringView key)
{
    static const Catalog catalog = Catalog::builtIn();
    return *catalog.find(key);
}

constexpr Parameter settable[] = {Parameter::steps,  Parameter::revolutions,   Parameter::direction,
                                  Parameter::coding, Parameter::preset,        Parameter::zeroOffset,
                                  Parameter::offset, Parameter::measuringRange};

} // namespace

std::unique_ptr<SimulatedK3> frabaK3()
{
    return std::make_unique<FrabaK3>(thirteenPlusTwelveBit, raw, FrabaPlate{.serialNumber = 1});
}

std::unique_ptr<SimulatedK3> baumerK3()
{
    return std::make_unique<BaumerK3>(thirteenPlusTwelveBit, raw);
}

DrivenEncoder::DrivenEncoder(QStringView device, std::unique_ptr<SimulatedK3> encoder)
    : m_encoder(std::move(encoder))
    , m_device(describe(device))
    , m_driver(m_device)
{
    if (m_device.quirks.hasModes)
        tell(Parameter::startUpMode, 1);
    cycles(10);
}

void DrivenEncoder::tell(Parameter parameter, std::int64_t value)
{
    m_known[parameter] = {parameter, value, Evidence::told, m_now};
    std::vector<Known> all;
    for (const auto &[_, known] : m_known)
        all.push_back(known);
    m_driver.setKnown(all);
}

void DrivenEncoder::tellAll()
{
    for (const Parameter parameter : settable)
        if (m_device.find(parameter) != nullptr)
            tell(parameter, actual(parameter));
    if (m_device.quirks.mayCountStepsMinusOne)
        tell(Parameter::multiTurnAndStepsMinusOne, 2);
}

void DrivenEncoder::begin(const Job &job, Pace pace)
{
    m_outcome.reset();
    const auto taken = m_driver.begin(1, job, pace, m_in, m_out, m_now);
    ASSERT_TRUE(taken) << taken.error().id.row().key;
}

void DrivenEncoder::cycle()
{
    m_now += std::chrono::milliseconds(1);
    m_in = m_encoder->cycle(m_out);
    m_out = m_driver.cycle(m_in, m_out, m_now);
    collect();
}

void DrivenEncoder::cycles(int count)
{
    for (int i = 0; i < count; ++i)
        cycle();
}

std::optional<int> DrivenEncoder::finish()
{
    for (int i = 0; i < longestJob; ++i) {
        if (m_outcome)
            return i;
        cycle();
    }
    return std::nullopt;
}

std::int64_t DrivenEncoder::actual(Parameter parameter) const
{
    const ParameterSet &set = m_encoder->parameters();
    const std::pair<Parameter, std::int64_t> all[] = {
        {Parameter::steps, set.steps},
        {Parameter::revolutions, set.revolutions},
        {Parameter::direction, set.coding},
        {Parameter::coding, set.coding},
        {Parameter::preset, set.preset},
        {Parameter::zeroOffset, set.zeroOffset},
        {Parameter::offset, set.offset},
        {Parameter::measuringRange, set.measuringRange},
        {Parameter::presetFlag, set.presetArmed ? 1 : 0},
    };
    for (const auto &[its, value] : all)
        if (its == parameter)
            return value;
    throw std::logic_error("not a parameter of the set");
}

EncoderState DrivenEncoder::state() const
{
    return stateOf(m_in, m_device.dialect.as<k3::Dialect>());
}

std::optional<CamProgram> DrivenEncoder::knownCams(unsigned program) const
{
    const auto found = m_cams.find(program);
    return found == m_cams.end() ? std::nullopt : std::optional(found->second.program);
}

void DrivenEncoder::expectTruth() const
{
    EXPECT_EQ(m_out, 0u);
    ASSERT_TRUE(m_outcome);
    for (const ParameterValue &value : m_outcome->written)
        EXPECT_EQ(actual(value.parameter), value.value)
            << "told as written: " << parameterKey(value.parameter).toStdString();
    for (const Parameter parameter : settable) {
        const auto known = m_known.find(parameter);
        if (known != m_known.end()) {
            EXPECT_EQ(actual(parameter), known->second.value)
                << "told as known: " << parameterKey(parameter).toStdString();
        }
    }
}

void DrivenEncoder::collect()
{
    for (const Event &event : m_driver.takeEvents()) {
        if (const auto *outcome = std::get_if<Outcome>(&event))
            m_outcome = *outcome;
        const auto *change = std::get_if<KnowledgeChanged>(&event);
        if (change == nullptr)
            continue;
        m_eepromWrites += change->eepromWrites;
        for (const unsigned program : change->camsNoLongerKnown)
            m_cams.erase(program);
        for (const KnownCams &known : change->cams)
            m_cams[known.program.number] = known;
        for (const Known &known : change->known)
            m_known[known.parameter] = known;
        for (const Parameter parameter : change->noLongerKnown)
            m_known.erase(parameter);
    }
}

} // namespace codewheel

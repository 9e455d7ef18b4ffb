// SPDX-License-Identifier: GPL-3.0-or-later
#include "transfer/transfer_plan.h"

#include "bus/buses.h"
#include "bus/participant.h"
#include "catalog/catalog.h"
#include "catalog/hex_code.h"
#include "drivers/job_check.h"
#include "drivers/values_to_write.h"
#include "journal/eeprom_cost.h"

#include <algorithm>
#include <numeric>

namespace codewheel {
namespace {

// "FRABA OCD-IB K3", "device code 0237h"
QString wantedName(const Catalog &catalog, const TransferWish &wish)
{
    const DeviceDescription *device =
        wish.deviceKey.isEmpty() ? catalog.generic(wish.deviceCode) : catalog.find(wish.deviceKey);
    return device ? device->fullName() : hexCode(wish.deviceCode, 4);
}

// What stands at the place: nothing, another device, or one that cannot be driven.
std::optional<Refusal> hindranceOfPlace(const Buses &buses, const TransferWish &wish)
{
    const EncoderBus *bus = buses.busOf(wish.place);
    const auto found = bus ? bus->found(wish.place) : std::nullopt;
    if (!found)
        return buses.whyNotThere(wish.place);
    if (auto other = bus->isOther(wish.place, wish.deviceKey, wish.serialNumber))
        return other;
    const EncoderSession *encoder = bus->encoder(wish.place);
    const DeviceDescription *device = encoder ? &encoder->device() : bus->catalog().find(found->deviceKey);
    const QString name = participantName(*found, device);
    const bool isOther = (wish.deviceCode != 0 && wish.deviceCode != found->deviceCode) ||
                         (!wish.deviceKey.isEmpty() && device != nullptr && wish.deviceKey != device->key);
    if (isOther)
        return Refusal{RefusalKind::link,
                       RefusalId::ringDiffers,
                       {wish.place.toString(), wantedName(bus->catalog(), wish), name}};
    if (!encoder || !encoder->can().writes)
        return Refusal{RefusalKind::notSupported, RefusalId::writingNotSupported, {name}};
    return std::nullopt;
}

// What the encoder, or the program, is doing.
std::optional<Refusal> hindranceOfState(const EncoderBus &bus, const EncoderSession &encoder)
{
    const QString place = encoder.place().toString();
    const Reading &reading = encoder.latest();
    if (!bus.isOperating())
        return Refusal{RefusalKind::busy, RefusalId::watchOnly, {place}};
    if (!bus.isRunning())
        return Refusal{RefusalKind::busy, RefusalId::notRunning, {place}};
    if (encoder.runningJob())
        return Refusal{RefusalKind::busy, RefusalId::jobRunning, {place}};
    if (reading.state == EncoderState::silent)
        return Refusal{RefusalKind::device, RefusalId::encoderSilent, {place}};
    if (reading.state == EncoderState::parameterization)
        return Refusal{RefusalKind::busy, RefusalId::inParameterization, {reading.in}};
    return std::nullopt;
}

bool isFor(const Step &step, const TransferRow &row)
{
    return step.parameter == row.wanted.parameter;
}

std::optional<Refusal> errorOf(const Result<void> &checked)
{
    return checked ? std::nullopt : std::optional(checked.error());
}

// The difference between a wish and an encoder, and the jobs that make an end of it.
class EncoderComparison
{
public:
    EncoderComparison(const EncoderSession &encoder, const TransferWish &wish, EncoderPlan &plan)
        : m_encoder(encoder)
        , m_device(encoder.device())
        , m_wish(wish)
        , m_plan(plan)
    {}

    void compare();
    void plan();

private:
    void compareValue(const ParameterValue &value);
    void compareCams(const CamProgram &program);
    void addPositionMode();
    void addValues(ParameterValues values);
    void addCams();
    void addPosition();
    void takeSteps(const Job &job);
    void takeStep(const Step &step);
    Word wordFor(const ParameterValue &value) const;
    void setHindrance(const std::optional<Refusal> &hindrance);
    ParameterValues valuesBefore() const;
    SwitchMode modeAfterwards() const;

    const EncoderSession &m_encoder;
    const DeviceDescription &m_device;
    const TransferWish &m_wish;
    EncoderPlan &m_plan;
};

void EncoderComparison::setHindrance(const std::optional<Refusal> &hindrance)
{
    if (!m_plan.hindrance)
        m_plan.hindrance = hindrance;
}

void EncoderComparison::compare()
{
    for (const ParameterDescription &parameter : m_device.parameters) // in the order they are written
        if (const auto value = valueOf(m_wish.values, parameter.parameter))
            compareValue({parameter.parameter, *value});
    for (const ParameterValue &value : m_wish.values)
        if (m_device.find(value.parameter) == nullptr)
            compareValue(value);
    if (!m_wish.cams.empty() && !m_encoder.can().cams)
        setHindrance(Refusal{RefusalKind::notSupported, RefusalId::camsNotSupported, {m_device.fullName()}});
    for (const CamProgram &program : m_wish.cams)
        compareCams(program);
    if (m_wish.position && !m_encoder.can().presets)
        setHindrance(
            Refusal{RefusalKind::notSupported, RefusalId::presetNotSupported, {m_device.fullName()}});
}

void EncoderComparison::compareValue(const ParameterValue &value)
{
    TransferRow row{.wanted = value, .known = m_encoder.known(value.parameter)};
    row.hindrance = errorOf(checkValue(m_device, value));
    row.isThere = !row.hindrance && isThereAlready(m_encoder, value);
    setHindrance(row.hindrance);
    m_plan.rows.push_back(std::move(row));
}

void EncoderComparison::compareCams(const CamProgram &program)
{
    const auto known = m_encoder.cams(program.number);
    m_plan.cams.push_back({program, known, known && known->program == program});
}

void EncoderComparison::plan()
{
    addPositionMode();
    ParameterValues values;
    std::optional<ParameterValue> presetAtTheEnd;
    for (const TransferRow &row : m_plan.rows) {
        const bool isPreset = row.wanted.parameter == Parameter::preset;
        if (m_wish.position && isPreset && row.wanted.value != *m_wish.position)
            presetAtTheEnd = row.wanted; // setting the position takes the preset for itself
        else if (!m_wish.position || !isPreset)
            values.push_back(row.wanted);
    }
    addValues(values);
    addCams();
    addPosition();
    if (presetAtTheEnd)
        takeSteps(WriteParameters{.values = {*presetAtTheEnd}, .onlyWhatDiffers = true, .previous = {}});
    m_plan.presetIsRearmed = m_wish.position && m_device.quirks.presetNeedsRearming;
}

void EncoderComparison::addPositionMode()
{
    const bool isElsewhere = m_device.quirks.hasModes && m_encoder.latest().mode != Mode::position;
    if (m_wish.toPositionMode && isElsewhere) {
        takeSteps(SwitchMode{});
        m_plan.eepromWrites += mostEepromWrites(m_encoder, SwitchMode{}); // leaves a cam program, perhaps
    } else if (m_encoder.latest().mode == Mode::cam && !m_plan.rows.empty())
        setHindrance(
            Refusal{RefusalKind::notSupported, RefusalId::inCamMode, {wordFor(m_plan.rows.front().wanted)}});
    else if (m_wish.position && isElsewhere)
        setHindrance(Refusal{RefusalKind::notSupported, RefusalId::modeNotKnown, {k3::initialisePreset}});
}

Word EncoderComparison::wordFor(const ParameterValue &value) const
{
    const ParameterDescription *parameter = m_device.find(value.parameter);
    return k3::parameterWord(parameter ? parameter->number.value_or(0) : 0, static_cast<Word>(value.value));
}

void EncoderComparison::addValues(ParameterValues values)
{
    WriteParameters job = jobForWish(m_encoder, {.wanted = std::move(values)});
    if (job.values.empty())
        return;
    job.previous = valuesBefore();
    for (TransferRow &row : m_plan.rows) // some are sent with the others though they are there
        row.isThere = row.isThere && !valueOf(job.values, row.wanted.parameter);
    m_plan.readsFirst = job.onlyWhatDiffers;
    m_plan.stepsMayBeLess = m_device.quirks.mayCountStepsMinusOne && valueOf(job.values, Parameter::steps) &&
                            !m_encoder.known(Parameter::multiTurnAndStepsMinusOne);
    takeSteps(job);
}

// A program that is changed is stored when it is left (FRABA manual 5.4.4).
void EncoderComparison::addCams()
{
    WriteCams job{.programs = {}, .afterwards = modeAfterwards()};
    for (const TransferCamRow &row : m_plan.cams)
        if (!row.isThere)
            job.programs.push_back(row.wanted);
    if (job.programs.empty())
        return;
    const int programs = static_cast<int>(job.programs.size());
    takeSteps(job);
    m_plan.eepromWrites += programs;
}

void EncoderComparison::addPosition()
{
    if (m_wish.position)
        takeSteps(SetPreset{.value = *m_wish.position});
}

// What is sent is shown beside its value, and each value costs a write.
void EncoderComparison::takeSteps(const Job &job)
{
    if (m_plan.hindrance)
        return;
    const auto steps = m_encoder.planned({job});
    if (!steps) {
        setHindrance(steps.error());
        return;
    }
    for (const Step &step : *steps)
        if (writesValue(step))
            takeStep(step);
    m_plan.eepromWrites += eepromWritesOf(*steps, m_device);
    m_plan.jobs.push_back(job);
}

void EncoderComparison::takeStep(const Step &step)
{
    const auto row =
        std::ranges::find_if(m_plan.rows, [&](const TransferRow &one) { return isFor(step, one); });
    if (row != m_plan.rows.end())
        row->step = row->isThere ? std::nullopt : std::optional(step);
    else if (step.data) // computed on the way
        m_plan.rows.push_back({.wanted = {*step.parameter, *step.data},
                               .known = m_encoder.known(*step.parameter),
                               .step = step,
                               .goesAlong = true});
}

ParameterValues EncoderComparison::valuesBefore() const
{
    ParameterValues values;
    for (const Known &known : allKnown(m_encoder))
        if (const ParameterDescription *parameter = m_device.find(known.parameter);
            parameter != nullptr && parameter->canBeWritten())
            values.push_back({known.parameter, known.value});
    return values;
}

// Back to where it was; position mode where nobody knows.
SwitchMode EncoderComparison::modeAfterwards() const
{
    const Reading &reading = m_encoder.latest();
    if (m_wish.toPositionMode || !reading.mode)
        return {};
    return {*reading.mode, reading.camProgram.value_or(0)};
}

EncoderPlan planFor(const Buses &buses, const TransferWish &wish)
{
    EncoderPlan plan{.place = wish.place, .station = wish.station, .position = wish.position};
    plan.hindrance = wish.hindrance ? wish.hindrance : hindranceOfPlace(buses, wish);
    const EncoderSession *encoder = buses.encoder(wish.place);
    if (encoder != nullptr)
        plan.device = encoder->device().fullName();
    if (encoder == nullptr || wish.hindrance) { // what stands there now says nothing
        for (const ParameterValue &value : wish.values)
            plan.rows.push_back({.wanted = value});
        return plan;
    }
    EncoderComparison comparison(*encoder, wish, plan);
    comparison.compare();
    if (!plan.hindrance)
        comparison.plan();
    if (!plan.hindrance)
        plan.hindrance = hindranceOfState(*buses.busOf(wish.place), *encoder);
    if (plan.hindrance) {
        plan.jobs.clear();
        plan.eepromWrites = 0;
    }
    return plan;
}

} // namespace

TransferPlan planTransfer(const Buses &buses, const std::vector<TransferWish> &wishes)
{
    TransferPlan plan;
    for (const TransferWish &wish : wishes)
        plan.push_back(planFor(buses, wish));
    return plan;
}

int eepromWritesOf(const TransferPlan &plan)
{
    return std::accumulate(plan.begin(), plan.end(), 0,
                           [](int sum, const EncoderPlan &one) { return sum + one.eepromWrites; });
}

} // namespace codewheel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "transfer/transfer_plan.h"

#include "bus/buses.h"
#include "bus/participant.h"
#include "catalog/catalog.h"
#include "catalog/hex_code.h"
#include "jobs/protocol.h"
#include "jobs/values_to_write.h"
#include "journal/eeprom_cost.h"
#include "transfer/new_encoder.h"

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

// The reason is what is at the place: nothing, a different device, or one that cannot be driven.
std::optional<Refusal> hindranceOfPlace(const Buses &buses, const TransferWish &wish)
{
    const EncoderBus *bus = buses.busOf(wish.place);
    const auto found = bus ? bus->found(wish.place) : std::nullopt;
    if (!found)
        return buses.whyNotThere(wish.place);
    // A new one is of the make that was named for it.
    const QString deviceKey = wish.newEncoder ? QString() : wish.deviceKey;
    if (auto other = bus->isOther(wish.place, deviceKey, wish.serialNumber))
        return other;
    const EncoderSession *encoder = bus->encoder(wish.place);
    const DeviceDescription *device = encoder ? &encoder->device() : bus->catalog().find(found->deviceKey);
    const QString name = bus->nameOf(*found, device);
    const bool isOther = (wish.deviceCode != 0 && wish.deviceCode != found->deviceCode) ||
                         (!deviceKey.isEmpty() && device != nullptr && deviceKey != device->key);
    if (isOther)
        return Refusal{RefusalKind::link,
                       RefusalId::ringDiffers,
                       {wish.place.shown(), wantedName(bus->catalog(), wish), name}};
    const bool canBeWritten =
        wish.newEncoder ? wish.newEncoder->capabilities.writes : encoder && encoder->can().writes;
    if (!encoder || !canBeWritten)
        return Refusal{RefusalKind::notSupported, RefusalId::writingNotSupported, {name}};
    return std::nullopt;
}

// The reason is what the encoder, or the program, is doing.
std::optional<Refusal> hindranceOfState(const EncoderBus &bus, const EncoderSession &encoder, InWatch watch)
{
    const QString place = encoder.place().shown();
    const Reading &reading = encoder.latest();
    if (watch == InWatch::isHindrance && !bus.isOperating())
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

// The difference between a wish and an encoder, and the jobs that remove it.
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
    void addPositionMode();
    void addCams();
    void add(const Job &job);
    void setHindrance(const std::optional<Refusal> &hindrance);
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
    m_plan.write = planWrite(m_encoder, {.wanted = m_wish.values, .setPositionTo = m_wish.position});
    for (const WriteRow &row : m_plan.write.rows)
        setHindrance(row.hindrance);
    const bool wantsAny =
        !m_wish.values.empty() || !m_wish.cams.empty() || m_wish.position || m_wish.toPositionMode;
    if (wantsAny && !m_plan.write.lostAndNotWritten.empty())
        setHindrance(Refusal{RefusalKind::device,
                             RefusalId::valuesMissingAfterLoss,
                             {parameterNames(m_plan.write.lostAndNotWritten)}});
    if (!m_wish.cams.empty() && !m_encoder.can().cams)
        setHindrance(Refusal{RefusalKind::notSupported, RefusalId::camsNotSupported, {m_device.fullName()}});
    for (const CamProgram &program : m_wish.cams) {
        const auto known = m_encoder.cams(program.number);
        m_plan.cams.push_back({program, known, known && known->program == program});
    }
}

// The cams go before the position.
void EncoderComparison::plan()
{
    const bool onlyWritingHelps = hasLostParameters(m_encoder); // until then the encoder takes no other word
    if (!onlyWritingHelps)
        addPositionMode();
    setHindrance(m_plan.write.refusal);
    const std::vector<Job> &jobs = m_plan.write.jobs;
    const auto setsPosition =
        std::ranges::find_if(jobs, [](const Job &job) { return std::holds_alternative<SetPreset>(job); });
    m_plan.jobs.insert(m_plan.jobs.end(), jobs.begin(), setsPosition);
    if (onlyWritingHelps)
        addPositionMode();
    addCams();
    m_plan.jobs.insert(m_plan.jobs.end(), setsPosition, jobs.end());
    m_plan.eepromWrites += eepromWritesOf(m_plan.write.steps, m_device);
    m_plan.presetIsRearmed = m_wish.position && m_device.quirks.presetNeedsRearming;
}

void EncoderComparison::addPositionMode()
{
    const bool isElsewhere = m_device.quirks.hasModes && m_encoder.latest().mode != Mode::position;
    if (m_wish.toPositionMode && isElsewhere) {
        add(SwitchMode{});
        m_plan.eepromWrites += mostEepromWrites(m_encoder, SwitchMode{}); // may leave a cam program
    } else if (m_encoder.latest().mode == Mode::cam && !m_wish.values.empty())
        setHindrance(Refusal{RefusalKind::notSupported,
                             RefusalId::inCamMode,
                             {protocolOf(m_device).firstWord(m_device, m_plan.write.job)}});
    else if (m_wish.position && isElsewhere)
        setHindrance(Refusal{RefusalKind::notSupported,
                             RefusalId::modeNotKnown,
                             {protocolOf(m_device).firstWord(m_device, SetPreset{})}});
}

// A changed program is stored when it is left (FRABA manual 5.4.4).
void EncoderComparison::addCams()
{
    WriteCams job{.programs = {}, .afterwards = modeAfterwards()};
    for (const TransferCamRow &row : m_plan.cams)
        if (!row.isThere)
            job.programs.push_back(row.wanted);
    if (job.programs.empty())
        return;
    add(job);
    m_plan.eepromWrites += static_cast<int>(job.programs.size());
}

void EncoderComparison::add(const Job &job)
{
    if (const auto steps = m_encoder.planned({job}); !steps)
        setHindrance(steps.error());
    m_plan.jobs.push_back(job);
}

// Back to where it was; position mode if nobody knows.
SwitchMode EncoderComparison::modeAfterwards() const
{
    const Reading &reading = m_encoder.latest();
    if (m_wish.toPositionMode || !reading.mode)
        return {};
    return {*reading.mode, reading.camProgram.value_or(0)};
}

// Without an encoder to compare them with.
ParameterValues valuesToShow(const TransferWish &wish)
{
    return wish.newEncoder ? inTurn(*wish.newEncoder, {.wanted = wish.values, .setPositionTo = wish.position})
                           : wish.values;
}

EncoderPlan planFor(const Buses &buses, const TransferWish &wish, InWatch watch)
{
    EncoderPlan plan{.place = wish.place, .station = wish.station, .position = wish.position};
    plan.hindrance = wish.hindrance ? wish.hindrance : hindranceOfPlace(buses, wish);
    const EncoderSession *encoder = buses.encoder(wish.place);
    std::optional<NewEncoder> replacing;
    if (encoder != nullptr && wish.newEncoder) {
        plan.newEncoder = wish.newEncoder;
        encoder = &replacing.emplace(*buses.busOf(wish.place), wish.place, *wish.newEncoder);
    }
    if (encoder != nullptr)
        plan.device = encoder->device().fullName();
    if (encoder == nullptr || wish.hindrance) { // what is there now says nothing
        for (const ParameterValue &value : valuesToShow(wish))
            plan.write.rows.push_back({.wanted = value});
        return plan;
    }
    EncoderComparison comparison(*encoder, wish, plan);
    comparison.compare();
    if (!plan.hindrance)
        comparison.plan();
    if (plan.hindrance) {
        std::erase_if(plan.write.rows, &WriteRow::goesAlong);
        for (WriteRow &row : plan.write.rows)
            row.step.reset();
    } else
        plan.hindrance = hindranceOfState(*buses.busOf(wish.place), *buses.encoder(wish.place), watch);
    if (plan.hindrance) {
        plan.jobs.clear();
        plan.eepromWrites = 0;
    }
    return plan;
}

} // namespace

TransferPlan planTransfer(const Buses &buses, const std::vector<TransferWish> &wishes, InWatch watch)
{
    TransferPlan plan;
    for (const TransferWish &wish : wishes)
        plan.push_back(planFor(buses, wish, watch));
    return plan;
}

int eepromWritesOf(const TransferPlan &plan)
{
    return std::accumulate(plan.begin(), plan.end(), 0,
                           [](int sum, const EncoderPlan &one) { return sum + one.eepromWrites; });
}

} // namespace codewheel

// SPDX-License-Identifier: GPL-3.0-or-later
// Jobs, places, positions and the report for encoders on several buses.
#include "jobs/step_text.h"
#include "jobs/write_plan.h"
#include "kinds/esc/line/esc_line_session.h"
#include "kinds/esc/plan/esc_line_plan.h"
#include "kinds/esc/simulator/simulated_esc_line_link.h"
#include "kinds/interbus/make_driver.h"
#include "kinds/interbus/plan/project_take_over.h"
#include "report/live_encoders.h"
#include "report/make_report.h"
#include "tests/transfer/transfer_bus.h"
#include "transfer/last_positions.h"
#include "transfer/project_places.h"
#include "transfer/replacement.h"
#include "transfer/value_store.h"
#include "vocabulary/refusal_text.h"

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using test::baumer;
using test::fraba;

constexpr Place turning = placeOnLine({0x03});
constexpr Place standing = placeOnLine({0x05});

const QString rs485 = QStringLiteral("kuebler-esc-rs485");

class RingAndLine : public test::TransferBus
{
protected:
    RingAndLine()
    {
        EXPECT_TRUE(line.open({}, {}, EscLineSession::Start::operating, EscLineSession::Drive::byHand));
        for (const EscLineAddress address : simulated->addresses())
            EXPECT_TRUE(line.add(address, rs485));
        buses.add(line);
        pass(1s);
    }
    void pass(std::chrono::milliseconds duration)
    {
        for (auto passed = 0ms; passed < duration; passed += 10ms) {
            bus.advance(10ms);
            line.advance(10ms);
        }
    }
    TransferAccount carryOutAll(const TransferPlan &plan)
    {
        round.start(jobsOf(plan), JobRound::AfterRefusal::goOn);
        for (int i = 0; i < 2000 && round.isRunning(); ++i)
            pass(10ms);
        EXPECT_FALSE(round.isRunning());
        return accountOf(buses, TransferKind::write, plan, round.results());
    }
    EncoderSession &onLine(Place place) { return *line.encoder(place); }
    EscRegisters registers(Place place)
    {
        EscRegisters its;
        EXPECT_TRUE(
            simulated->withEncoder(EscLineAddress::of(place.node),
                                   [&](const SimulatedEscEncoder &encoder) { its = encoder.registers(); }));
        return its;
    }
    // With the connected ring, and these encoders of the line.
    Project projectWith(std::initializer_list<Place> places) const
    {
        Project project = projectOf(bus.structure());
        setLinePlan(project, firstLine, {});
        for (const Place place : places) {
            ProjectDevice &encoder = project.devices.emplace_back();
            encoder.standAt(place);
            encoder.participant.deviceKey = rs485;
        }
        return project;
    }
    std::string hindrance(const Project &project, Place place) const
    {
        const auto why = ProjectPlaces(project, buses).hindrance(place);
        return why ? refusalText(*why).toStdString() : std::string();
    }

    std::shared_ptr<SimulatedEscLine> simulated = std::make_shared<SimulatedEscLine>();
    EscLineSession line{std::make_unique<SimulatedEscLineLink>(simulated), catalog,
                        QDateTime(QDate(2026, 3, 1), QTime(14, 2)), makeRequestDriver};
};

TEST_F(RingAndLine, OneRoundWritesToEncodersOfBoth)
{
    const TransferPlan plan = planTransfer(buses, {{.place = baumer, .values = {{Parameter::steps, 4096}}},
                                                   {.place = standing, .values = {{Parameter::steps, 864}}}});
    ASSERT_TRUE(plan[1].isWritten());
    ASSERT_EQ(plan[1].write.rows.size(), 2u);
    EXPECT_EQ(sentText(plan[1].write.rows[0].step.value()), QStringLiteral("05GR00000360"));
    EXPECT_TRUE(plan[1].write.rows[1].goesAlong);
    EXPECT_EQ(plan[1].eepromWrites, 2);
    const TransferAccount account = carryOutAll(plan);
    EXPECT_TRUE(account.isDone());
    EXPECT_EQ(account.encoders[1].rows.size(), 1u); // what was wanted
    EXPECT_TRUE(account.encoders[1].positionBefore);
    EXPECT_EQ(registers(standing).stepsPerTurn, 864u);
}

// It would have to be searched for in the middle of the round.
TEST_F(RingAndLine, WhereAnEncoderStandsIsNotTransferred)
{
    Project project = projectWith({standing});
    ProjectDevice &device = *findDevice(project, standing);
    device.wanted = {{Parameter::direction, 1}, {Parameter::lineAddress, 9}, {Parameter::baudRate, 9600}};
    device.stored = {{Parameter::lineAddress, 9, Evidence::read, {}}};
    const ProjectPlaces places(project, buses);
    EXPECT_EQ(wishOf(device, TransferSource::wanted, places, catalog).values,
              (ParameterValues{{Parameter::direction, 1}}));
    EXPECT_TRUE(wishOf(device, TransferSource::stored, places, catalog).values.empty());
}

TEST_F(RingAndLine, WhatAnEncoderOfALineCannotDoIsSaid)
{
    const TransferPlan plan = planTransfer(buses, {{.place = standing, .cams = {CamProgram{}}}});
    EXPECT_EQ(plan[0].hindrance->id, RefusalId::camsNotSupported);
    EXPECT_EQ(jobsToStore(onLine(standing), true).jobs.size(), 1u); // no cams
    EXPECT_EQ(planTransfer(buses, {{.place = placeOnLine({9})}})[0].hindrance->id, RefusalId::notConnected);
}

TEST_F(RingAndLine, ALineThatIsLostKeepsNoRingFromItsValues)
{
    const auto values = [](Parameter parameter, std::int64_t value) {
        return ParameterValues{{parameter, value}};
    };
    const TransferPlan plan =
        planTransfer(buses, {{.place = turning, .values = values(Parameter::direction, 1)},
                             {.place = standing, .values = values(Parameter::direction, 1)},
                             {.place = baumer, .values = values(Parameter::steps, 4096)}});
    simulated->setUnplugged(true);
    const TransferAccount account = carryOutAll(plan);
    EXPECT_EQ(account.encoders[0].why->id, RefusalId::portLost);
    EXPECT_FALSE(account.encoders[1].why); // nobody asked it
    EXPECT_TRUE(account.encoders[2].isDone());
}

TEST_F(RingAndLine, AWriteThatWasCutOffByItsLineIsToldSoAndKeepsNoRingFromItsValues)
{
    const TransferPlan plan = planTransfer(buses, {{.place = standing, .values = {{Parameter::direction, 1}}},
                                                   {.place = baumer, .values = {{Parameter::steps, 4096}}}});
    round.start(jobsOf(plan), JobRound::AfterRefusal::goOn);
    for (int i = 0; i < 1000 && !round.jobProgress().hasTaken; ++i)
        line.advance(1ms);
    simulated->setUnplugged(true);
    pass(20s);
    ASSERT_FALSE(round.isRunning());
    const TransferAccount account = accountOf(buses, TransferKind::write, plan, round.results());
    EXPECT_EQ(account.encoders[0].why->id, RefusalId::stoppedInWrite);
    EXPECT_EQ(account.encoders[0].rows[0].became, Became::unknown);
    EXPECT_EQ(account.encoders[0].leftIn, EncoderState::unknown);
    EXPECT_TRUE(account.encoders[1].isDone());
}

TEST_F(RingAndLine, AlarmStopAmidAWriteOnALineBeginsNoOther)
{
    const TransferPlan plan = planTransfer(buses, {{.place = standing, .values = {{Parameter::direction, 1}}},
                                                   {.place = baumer, .values = {{Parameter::steps, 4096}}}});
    round.start(jobsOf(plan), JobRound::AfterRefusal::goOn);
    for (int i = 0; i < 1000 && !round.jobProgress().hasTaken; ++i)
        line.advance(1ms);
    line.alarmStop();
    pass(2s);
    ASSERT_FALSE(round.isRunning());
    EXPECT_EQ(round.results()[0].why->id, RefusalId::stoppedInWrite);
    EXPECT_FALSE(round.results()[1].isBegun());
}

TEST_F(RingAndLine, CancelBeginsNoOtherOnAnyBus)
{
    const TransferPlan plan = planTransfer(buses, {{.place = standing, .values = {{Parameter::direction, 1}}},
                                                   {.place = baumer, .values = {{Parameter::steps, 4096}}}});
    round.start(jobsOf(plan), JobRound::AfterRefusal::goOn);
    for (int i = 0; i < 1000 && !round.jobProgress().hasTaken; ++i)
        line.advance(1ms);
    round.cancel(OnCancel::leaveAsIs);
    pass(2s);
    ASSERT_FALSE(round.isRunning());
    const TransferAccount account = accountOf(buses, TransferKind::write, plan, round.results());
    EXPECT_TRUE(account.encoders[0].isBegun);
    EXPECT_FALSE(account.encoders[1].isBegun);
    EXPECT_TRUE(registers(standing).countsCcw);
    EXPECT_EQ(words(baumer), QString());
}

TEST_F(RingAndLine, ABusThatIsNotConnectedIsToldOfEachOfItsDevices)
{
    const Project project = projectWith({standing});
    EXPECT_EQ(hindrance(project, standing), "");
    EXPECT_TRUE(ProjectPlaces(project, buses).isAtItsPlace(standing));
    buses.remove(&line);
    EXPECT_EQ(hindrance(project, standing),
              "esc:05 is not connected. Connect its bus, and look which devices are there.");
    EXPECT_EQ(hindrance(project, fraba), "");
}

TEST_F(RingAndLine, OnALineAddressDeviceAndSerialNumberTellTheEncoder)
{
    Project project = projectWith({turning, standing, placeOnLine({9})});
    EXPECT_NE(hindrance(project, placeOnLine({9})), "");
    ProjectDevice &device = *findDevice(project, standing);
    for (const char *same : {"0012D5A4", "12d5a4", "1234340", "SN 12/4", ""}) {
        device.label.serialNumber = QString::fromLatin1(same);
        EXPECT_EQ(hindrance(project, standing), "") << same;
    }
    device.label.serialNumber = QStringLiteral("4711");
    EXPECT_EQ(
        hindrance(project, standing),
        "esc:05: the label in the project has the serial number 4711, the encoder reports 1234340 (12D5A4h). "
        "Replace the encoder in the project, or correct the label.");
    EXPECT_FALSE(ProjectPlaces(project, buses).hindranceToReplace(standing));
    device.participant.deviceKey = QStringLiteral("kuebler-esc-rs422");
    EXPECT_EQ(ProjectPlaces(project, buses).hindrance(standing)->id, RefusalId::deviceDiffers);
    EXPECT_EQ(connectedEncoders(project, buses).size(), 7u); // six of the ring, and 03
}

TEST_F(RingAndLine, APlaceIsGivenAnotherDeviceWithoutWhatWasKnown)
{
    ASSERT_TRUE(onLine(standing).known(Parameter::serialNumber));
    const QString rs422 = QStringLiteral("kuebler-esc-rs422");
    ASSERT_TRUE(line.name(standing, rs422, 16));
    EXPECT_EQ(onLine(standing).device().key, rs422);
    EXPECT_EQ(onLine(standing).device().physicalTurns, 16);
    EXPECT_FALSE(onLine(standing).known(Parameter::serialNumber));
    pass(1s);
    EXPECT_EQ(onLine(standing).latest().state, EncoderState::operation);
    EXPECT_TRUE(onLine(standing).known(Parameter::serialNumber));
    EXPECT_EQ(line.name(standing, QStringLiteral("fraba-ocd-ib")).error().id, RefusalId::deviceOfOtherBus);
}

TEST_F(RingAndLine, AReplacedOneGetsThePositionAndWhatItCanBeTold)
{
    Project project = projectWith({standing});
    ProjectDevice &device = *findDevice(project, standing);
    device.wanted = {{Parameter::direction, 1}, {Parameter::lineAddress, 9}};
    device.stored = {{Parameter::preset, 5, Evidence::read, {}},
                     {Parameter::lineAddress, 7, Evidence::read, {}},
                     {Parameter::lowerLimit, 0, Evidence::read, {}}};
    const Replacement now{catalog.find(rs485), 0, 0, QStringLiteral("0012D5A4")};
    const TransferPlan plan =
        planTransfer(buses, {wishToReplace(device, now, 2000, ProjectPlaces(project, buses))});
    ASSERT_FALSE(plan[0].hindrance);
    EXPECT_EQ(plan[0].write.rows.size(), 1u);
    EXPECT_TRUE(carryOutAll(plan).isDone());
    EXPECT_EQ(registers(standing).preset, 2000u);
    EXPECT_EQ(replaced(device, now, 2000).wanted,
              (ParameterValues{{Parameter::direction, 1}, {Parameter::lineAddress, 9}}));
    const Replacement other{catalog.find(rs485), 0, 0, QStringLiteral("4711")};
    EXPECT_EQ(planTransfer(buses, {wishToReplace(device, other, 2000, ProjectPlaces(project, buses))})[0]
                  .hindrance->id,
              RefusalId::serialDiffers);
}

TEST_F(RingAndLine, ThePositionBeforeAnEncoderFellSilentIsKept)
{
    const LastPositions positions(buses);
    pass(100ms);
    const Project project = projectWith({standing});
    const auto kept = [&](const Project &all) { return findDevice(all, standing)->lastPosition; };
    EXPECT_EQ(kept(withLastPositions(project, positions, buses))->position, 0x1235);
    ASSERT_TRUE(positions.at(fraba));
    simulated->withEncoder({0x05}, [](SimulatedEscEncoder &encoder) { encoder.condition().mute = true; });
    pass(5s);
    ASSERT_EQ(onLine(standing).latest().state, EncoderState::silent);
    EXPECT_EQ(
        planTransfer(buses, {{.place = standing, .values = {{Parameter::steps, 864}}}})[0].hindrance->id,
        RefusalId::encoderSilent);
    EXPECT_EQ(positions.at(standing)->since, SeenPosition::Since::gone);
    EXPECT_EQ(kept(withLastPositions(project, positions, buses))->position, 0x1235);
}

TEST_F(RingAndLine, OfASimulatedLineInThePlaceOfAPortNothingIsKeptOrReported)
{
    const LastPositions positions(buses);
    pass(100ms);
    round.start({jobsToStore(onLine(standing), false)}, JobRound::AfterRefusal::goOn);
    pass(5s);
    Project project = projectWith({standing});
    EscLinePlan plan;
    plan.settings.port = QStringLiteral("/dev/ttyUSB0");
    setLinePlan(project, firstLine, plan);
    const Project kept = withLastPositions(project, positions, buses);
    EXPECT_FALSE(findDevice(kept, standing)->lastPosition);
    ReportInput input{.project = project, .version = {}, .now = {}};
    addConnected(input, buses);
    EXPECT_FALSE(input.connected.contains(firstLine));
    EXPECT_FALSE(input.live.contains(standing));
    EXPECT_FALSE(input.writes.contains(standing));
    EXPECT_TRUE(input.writes.contains(fraba)) << "its ring is planned for training";
}

TEST_F(RingAndLine, TheReportTellsOfEncodersOfBoth)
{
    round.start({jobsToStore(onLine(standing), false)}, JobRound::AfterRefusal::goOn);
    pass(5s);
    ReportInput input{.project = projectWith({standing, placeOnLine({9})}), .version = {}, .now = {}};
    addConnected(input, buses);
    EXPECT_EQ(input.connected.size(), 2U);
    EXPECT_TRUE(input.live.contains(standing));
    EXPECT_TRUE(input.writes.contains(fraba));
    EXPECT_TRUE(input.writes.contains(standing));
    const Report report = makeReport(input, catalog);
    const auto isBus = [](const ReportFact &fact) { return fact.name == QStringLiteral("Bus"); };
    EXPECT_EQ(std::ranges::find_if(report.facts, isBus)->text.toStdString(),
              "not connected as configured; lines that differ: 3")
        << "one is missing, two are additional";
}

} // namespace
} // namespace codewheel

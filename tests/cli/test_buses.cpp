// SPDX-License-Identifier: GPL-3.0-or-later
// Calls on several buses of a kind: which one PLACE means, and how it is reported.
#include "catalog/catalog.h"
#include "cli/call/command_line.h"
#include "cli/call/stop_signals.h"
#include "cli/commands.h"
#include "cli/kinds/esc/esc_line_access.h"
#include "cli/kinds/interbus/ring_access.h"
#include "cli/kinds/link_kind.h"
#include "kinds/esc/plan/esc_line_plan.h"
#include "kinds/esc/simulator/simulated_esc_line_link.h"
#include "kinds/interbus/plan/ring_plan.h"
#include "project/bus_kind.h"
#include "project/project_file.h"
#include "tests/cli/cli_run.h"
#include "tests/cli/kinds/esc/shared_line.h"

#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>

#include <array>
#include <csignal>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/inotify.h>
#include <unistd.h>

namespace codewheel {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr BusId secondRing{3};
constexpr BusId secondLine{4};

// Two training rings and two lines with the encoders 03, 05 and 12, as a project plans them.
class CliBuses : public testing::Test
{
protected:
    CliBuses()
    {
        project.buses = {planned(firstBus, "interbus", "Crane 1"), planned(firstLine, "esc", "Gate 1"),
                         planned(secondRing, "interbus", "Crane 2"), planned(secondLine, "esc", "Gate 2")};
        plan({firstLine, EscLineAddress{5}.node()}, "Left");
        plan({secondLine, EscLineAddress{5}.node()}, "Right");
        plan({secondLine, EscLineAddress{0x12}.node()}, "Top");
    }

    static PlannedBus planned(BusId id, const char *kind, const char *name)
    {
        const QString key = QString::fromLatin1(kind);
        return {id, key, QString::fromLatin1(name), busKind(key)->usual()};
    }
    void plan(Place place, const char *station)
    {
        ProjectDevice device;
        device.standAt(place);
        device.participant.deviceKey = QStringLiteral("kuebler-esc-rs485");
        device.station = QString::fromLatin1(station);
        project.devices.push_back(device);
    }

    CliRun run(QStringList words)
    {
        EXPECT_TRUE(saveProject(project, file));
        words << QStringLiteral("--project") << file;
        const Subcommand &command = *commandNamed(words.takeFirst());
        const auto arguments = parseArguments(words, optionsOf(command), {});
        EXPECT_TRUE(arguments);
        return runWith({}, [&](const Terminal &terminal) {
            RingAccess one(*rings[0].bus);
            RingAccess two(*rings[1].bus);
            const auto left = line(firstLine);
            const auto right = line(secondLine);
            if (const auto ledger = arguments->value("--ledger")) {
                left->keepLedger(*ledger);
                right->keepLedger(*ledger);
            }
            return runOn(command, *arguments, catalog, {&one, left.get(), &two, right.get()}, terminal);
        });
    }
    CliRun run(const char *words) { return run(QString::fromLatin1(words).split(u' ')); }
    // The JSON output of a command for one place with spaces in its name.
    QJsonObject told(const char *command, const char *place)
    {
        return run({QString::fromLatin1(command), QString::fromLatin1(place), QStringLiteral("--for"),
                    QStringLiteral("1"), QStringLiteral("--json")})
            .json();
    }

    std::unique_ptr<EscLineAccess> line(BusId id)
    {
        const SharedLine::Cut its = id == firstLine ? cut : SharedLine::Cut();
        return std::make_unique<EscLineAccess>(cutLink(std::make_shared<SimulatedEscLine>(), its),
                                               EscLineLink(), catalog, id);
    }
    void unplugAfter(const char *request)
    {
        cut = {request, [](SimulatedEscLine &line) { line.setUnplugged(true); }};
    }

    const Catalog catalog = Catalog::builtIn();
    TrainingSession rings[2] = {
        openTrainingSession(catalog, QDateTime(QDate(2026, 3, 1), QTime(14, 2))),
        openTrainingSession(catalog, QDateTime(QDate(2026, 3, 1), QTime(14, 2)), secondRing)};
    SharedLine::Cut cut; // of the first line
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("cranes.codewheel"));
    Project project;
};

TEST_F(CliBuses, APlaceThatSeveralBusesHaveIsRefusedWithTheChoices)
{
    const CliRun ring = run("monitor 2.0");
    EXPECT_EQ(ring.exit, 2);
    EXPECT_THAT(ring.err,
                HasSubstr("Several buses may have 2.0. Give one of these: Crane 1/2.0, Crane 2/2.0."));
    EXPECT_THAT(run("monitor 05").err, HasSubstr("Gate 1/esc:05, Gate 2/esc:05."));
    EXPECT_THAT(run("monitor 07").err, HasSubstr("Gate 1/esc:07, Gate 2/esc:07."))
        << "planned on none, and may be on both";
    EXPECT_EQ(errorKey(run("monitor 2.0 --json")), "placeNotUnique");
}

TEST_F(CliBuses, APlaceThatOneBusHasNeedsNoName)
{
    const QJsonObject json = told("monitor", "12");
    EXPECT_EQ(json[u"exit"], 0);
    EXPECT_EQ(json[u"busName"], QStringLiteral("Gate 2"));
    EXPECT_EQ(json[u"place"], QStringLiteral("esc:12"));
}

TEST_F(CliBuses, TheNameOfTheBusTellsWhichOne)
{
    for (const auto &[typed, bus, place] :
         {std::tuple{"Crane 2/2.0", "Crane 2", "2.0"}, std::tuple{"Gate 1/05", "Gate 1", "esc:05"},
          std::tuple{"4/05", "Gate 2", "esc:05"}, std::tuple{"Gate 2/esc:05", "Gate 2", "esc:05"},
          std::tuple{"Gate 2/Right", "Gate 2", "esc:05"}, std::tuple{"Left", "Gate 1", "esc:05"}}) {
        const QJsonObject json = told("monitor", typed);
        EXPECT_EQ(json[u"exit"], 0) << typed;
        EXPECT_EQ(json[u"busName"].toString().toStdString(), bus) << typed;
        EXPECT_EQ(json[u"place"].toString().toStdString(), place) << typed;
    }
}

TEST_F(CliBuses, WhatIsNoBusOrNotOnItIsRefused)
{
    EXPECT_EQ(told("monitor", "Crane 3/2.0")[u"error"][u"key"], QStringLiteral("unknownBus"));
    EXPECT_THAT(run({QStringLiteral("monitor"), QStringLiteral("Crane 2/9.0")}).err,
                HasSubstr("There is no device at Crane 2/9.0. There are devices at: 1.0, 2.0,"));
    EXPECT_THAT(run("monitor 9.0").err,
                HasSubstr("There is no device at 9.0. There are devices at: Crane 1/1.0, Crane 1/2.0,"));
    EXPECT_EQ(told("monitor", "Gate 1/Right")[u"error"][u"key"], QStringLiteral("unknownStation"));
    EXPECT_EQ(told("monitor", "Crane 2/05")[u"error"][u"key"], QStringLiteral("unknownDevice"));
    EXPECT_EQ(told("monitor", "/2.0")[u"error"][u"key"], QStringLiteral("unknownBus"));
}

// Nobody could tell which one a script means.
TEST_F(CliBuses, AStationThatReadsLikeAPlaceOnABusIsRefused)
{
    findDevice(project, {secondLine, EscLineAddress{0x12}.node()})->station = QStringLiteral("Crane 1/2.0");
    const QJsonObject json = told("monitor", "Crane 1/2.0");
    EXPECT_EQ(json[u"error"][u"key"], QStringLiteral("placeNotUnique"));
    EXPECT_EQ(told("monitor", "1/2.0")[u"busName"], QStringLiteral("Crane 1"));
    EXPECT_EQ(told("monitor", "4/esc:12")[u"busName"], QStringLiteral("Gate 2"));
    findDevice(project, {secondLine, EscLineAddress{0x12}.node()})->station = QStringLiteral("Crane 1/top");
    EXPECT_EQ(told("monitor", "Crane 1/top")[u"busName"], QStringLiteral("Gate 2")) << "there is no other";
}

TEST_F(CliBuses, NoPlaceIsNoDeviceWithoutAStation)
{
    for (ProjectDevice &device : project.devices)
        device.station.clear();
    for (const char *nothing : {"", "Gate 1/"}) {
        const CliRun run =
            this->run({QStringLiteral("preset"), QString::fromLatin1(nothing), QStringLiteral("5")});
        EXPECT_EQ(run.exit, 2) << nothing;
    }
}

TEST_F(CliBuses, ANameThatIsTheNumberOfAnotherBusIsRefused)
{
    project.buses[0].name = QStringLiteral("3");
    EXPECT_EQ(told("monitor", "3/2.0")[u"error"][u"key"], QStringLiteral("busNotUnique"));
    EXPECT_EQ(told("monitor", "1/2.0")[u"bus"], 1);
    EXPECT_EQ(told("monitor", "01/2.0")[u"error"][u"key"], QStringLiteral("unknownBus"));
}

TEST_F(CliBuses, AnEncoderThatTellsAnotherSerialNumberIsNotTheProjectsOne)
{
    findDevice(project, {firstLine, EscLineAddress{5}.node()})->label.serialNumber =
        QStringLiteral("DEADBEEF");
    EXPECT_EQ(told("monitor", "Left")[u"error"][u"key"], QStringLiteral("serialDiffers"));
    EXPECT_EQ(told("monitor", "Gate 1/05")[u"error"][u"key"], QStringLiteral("serialDiffers"));
    EXPECT_EQ(told("monitor", "Right")[u"exit"], 0);
}

// In sentences, and in the form in which it is typed.
TEST_F(CliBuses, PlacesAreToldWithTheirBus)
{
    const CliRun asked =
        run({QStringLiteral("write"), QStringLiteral("Crane 2/1.0"), QStringLiteral("steps=255")});
    EXPECT_EQ(asked.exit, 2);
    EXPECT_THAT(asked.out, HasSubstr("To be written to Crane 2/1.0, FRABA OCD-IB K3:"));
    EXPECT_EQ(Place({firstBus, NodeId("1.0")}).shown(), QStringLiteral("1.0")) << "when the call is over";
}

TEST_F(CliBuses, WhatIsRefusedIsToldWithItsBus)
{
    rings[1].bus->setRunning(false);
    const CliRun stopped = run({QStringLiteral("write"), QStringLiteral("Crane 2/1.0"),
                                QStringLiteral("steps=255"), QStringLiteral("--yes")});
    EXPECT_EQ(stopped.exit, 1);
    EXPECT_THAT(stopped.err, HasSubstr("Nothing was sent to Crane 2/1.0: the bus is stopped."));
    EXPECT_THAT(run({QStringLiteral("read"), QStringLiteral("Crane 2/6.0")}).err,
                HasSubstr("The device at Crane 2/6.0 is not an encoder"));
    findDevice(project, {secondLine, EscLineAddress{5}.node()})->label.serialNumber =
        QStringLiteral("DEADBEEF");
    EXPECT_THAT(run({QStringLiteral("read"), QStringLiteral("Right")}).err, HasSubstr("Gate 2/esc:05"));
}

TEST_F(CliBuses, WritingGoesToTheBusThatIsNamed)
{
    const auto writes = [&](int i) { return rings[i].controls->shafts()[0].eepromWrites; };
    EXPECT_EQ(run({QStringLiteral("write"), QStringLiteral("Crane 2/1.0"), QStringLiteral("steps=255"),
                   QStringLiteral("--yes")})
                  .exit,
              0);
    EXPECT_EQ(writes(0), 0);
    EXPECT_EQ(writes(1), 1);
}

TEST_F(CliBuses, WhatIsTypedForAllOfALineCountsForEachThatTheProjectHas)
{
    const QString ledger = folder.filePath(QStringLiteral("eeprom.sqlite"));
    run({QStringLiteral("terminal"), QStringLiteral("00GD1"), QStringLiteral("--bus"),
         QStringLiteral("Gate 2"), QStringLiteral("--yes"), QStringLiteral("--ledger"), ledger});
    const QJsonArray accounts =
        runLine(QStringLiteral("ledger --json --ledger ") + ledger).json()[u"accounts"].toArray();
    ASSERT_EQ(accounts.size(), 2);
    for (const auto &account : accounts) {
        EXPECT_EQ(account[u"countedBy"], QStringLiteral("serialNumber"));
        EXPECT_EQ(account[u"writes"].toInt() + account[u"perhaps"].toInt(), 1);
    }
}

TEST_F(CliBuses, ACommandOfOneKindAsksWhichBus)
{
    EXPECT_EQ(errorKey(run("master --json")), "busNotUnique");
    EXPECT_EQ(errorKey(run("master --bus Gate --json")), "unknownBus");
    EXPECT_EQ(run({QStringLiteral("master"), QStringLiteral("stop"), QStringLiteral("--bus"),
                   QStringLiteral("Crane 2")})
                  .exit,
              0);
    EXPECT_TRUE(rings[0].bus->isRunning());
    EXPECT_FALSE(rings[1].bus->isRunning());
    const QJsonObject told = run({QStringLiteral("terminal"), QStringLiteral("05P"), QStringLiteral("--bus"),
                                  QStringLiteral("Gate 2"), QStringLiteral("--json")})
                                 .lastJson();
    EXPECT_EQ(told[u"bus"], 4);
    EXPECT_EQ(told[u"busName"], QStringLiteral("Gate 2"));
    const CliRun wrong = run({QStringLiteral("master"), QStringLiteral("--bus"), QStringLiteral("Gate 1")});
    EXPECT_EQ(wrong.exit, 2) << "a line has no master";
}

TEST_F(CliBuses, AnAlarmStopIsForAllRingsWhereNoneIsNamed)
{
    const CliRun stop = run("master alarm-stop --json");
    EXPECT_EQ(stop.exit, 0);
    ASSERT_EQ(stop.json()[u"buses"].toArray().size(), 2);
    EXPECT_EQ(stop.json()[u"buses"][1][u"busName"], QStringLiteral("Crane 2"));
    for (const TrainingSession &ring : rings)
        EXPECT_FALSE(ring.bus->isRunning());
    EXPECT_THAT(run("master alarm-stop").out, HasSubstr("Crane 2:\n"));
}

TEST_F(CliBuses, ABusWhoseLinkIsNotKnownIsLeftOut)
{
    RingPlan plan;
    plan.link.kind = QStringLiteral("profi");
    setRingPlan(project, secondRing, plan);
    project.buses.erase(project.buses.begin() + 1);
    ASSERT_TRUE(saveProject(project, file));
    const QString at = QStringLiteral(" --link project --project ") + file;
    const CliRun other = runLine(QStringLiteral("read 1.0 steps") + at);
    EXPECT_EQ(other.exit, 0) << other.err;
    EXPECT_THAT(other.err, HasSubstr("The project links \"Crane 2\" by \"profi\""));
    const CliRun itself = runWith({}, [&](const Terminal &terminal) {
        return runCommandLine({QStringLiteral("read"), QStringLiteral("Crane 2/2.0"),
                               QStringLiteral("--link"), QStringLiteral("project"),
                               QStringLiteral("--project"), file},
                              terminal);
    });
    EXPECT_EQ(itself.exit, 2);
    EXPECT_THAT(itself.err,
                HasSubstr("The project has the bus \"Crane 2\", but the link does not lead to it."));
    project.buses = {project.buses[1]};
    project.devices.clear();
    ASSERT_TRUE(saveProject(project, file));
    EXPECT_EQ(errorKey(runLine(QStringLiteral("scan --json") + at)), "noSuchLink");
}

TEST_F(CliBuses, ScanSaysWhichBusesAreNew)
{
    project.buses = {planned(firstBus, "interbus", "Crane 1"), planned(secondRing, "esc", "Gate 1"),
                     planned(secondLine, "esc", "Gate 2")};
    project.devices.clear();
    ASSERT_TRUE(saveProject(project, file));
    EXPECT_THAT(runLine(QStringLiteral("scan --yes --project %1 --save %1").arg(file)).out,
                HasSubstr("Saved as a new bus, beside those of the project: "));
}

TEST_F(CliBuses, ScanTellsAndKeepsEveryBus)
{
    const QString saved = folder.filePath(QStringLiteral("found.codewheel"));
    const CliRun scan =
        run({QStringLiteral("scan"), QStringLiteral("--json"), QStringLiteral("--save"), saved});
    EXPECT_EQ(scan.exit, 0);
    QStringList names;
    for (const QJsonValue bus : scan.json()[u"buses"].toArray())
        names << bus[u"busName"].toString();
    EXPECT_EQ(names, (QStringList{QStringLiteral("Crane 1"), QStringLiteral("Gate 1"),
                                  QStringLiteral("Crane 2"), QStringLiteral("Gate 2")}));
    const Project found = *loadProject(saved);
    ASSERT_EQ(found.buses.size(), 4U);
    for (const BusId ring : {firstBus, secondRing})
        EXPECT_EQ(devicesOn(found, ring).size(), 7U);
    for (const BusId line : {firstLine, secondLine})
        EXPECT_EQ(devicesOn(found, line).size(), 3U);
    EXPECT_EQ(findDevice(found, {secondLine, EscLineAddress{0x12}.node()})->station, QStringLiteral("Top"));
}

TEST_F(CliBuses, ALineThatIsUnpluggedKeepsNoOtherFromItsValues)
{
    for (ProjectDevice &device : project.devices)
        device.wanted = {{Parameter::direction, 1}};
    const QStringList call{QStringLiteral("transfer"), file, QStringLiteral("--yes"),
                           QStringLiteral("--json")};
    for (const auto &[request, became] : {std::pair{"05U", "notDone"}, {"05GD", "unknown"}}) {
        unplugAfter(request);
        const CliRun run = this->run(call);
        EXPECT_EQ(run.exit, 1) << request;
        const QJsonArray encoders = run.json()[u"encoders"].toArray();
        ASSERT_EQ(encoders.size(), 3) << run.err;
        EXPECT_EQ(encoders[0][u"values"][0][u"became"], QString::fromLatin1(became));
        EXPECT_EQ(encoders[1][u"values"][0][u"became"], QStringLiteral("written"));
        EXPECT_EQ(encoders[2][u"values"][0][u"became"], QStringLiteral("written"));
    }
}

TEST_F(CliBuses, WhatCouldNotBeAskedIsNotMissing)
{
    unplugAfter("05N");
    const CliRun run = this->run({QStringLiteral("compare"), file});
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.out, Not(HasSubstr("missing")));
    EXPECT_THAT(run.err, HasSubstr("Gate 1: The serial port"));
    EXPECT_THAT(run.err, HasSubstr("Lines that differ: 14. Not compared, since the link does not lead "
                                   "there, or it cannot be reached: Gate 1."));
}

TEST_F(CliBuses, ACancelledSearchTellsWhatWasNotSearched)
{
    StopSignals held; // so that only the command gets Ctrl+C
    cut = {"01N", [](SimulatedEscLine &) { std::raise(SIGINT); }};
    const CliRun run = this->run("scan --json");
    EXPECT_EQ(errorKey(run), "scanCancelled");
    const QJsonArray buses = run.json()[u"buses"].toArray();
    ASSERT_EQ(buses.size(), 4);
    EXPECT_EQ(buses[3][u"busName"], QStringLiteral("Gate 2"));
    EXPECT_EQ(buses[3][u"error"][u"key"], QStringLiteral("notSearched"));
}

// Its encoders may be switched off.
TEST_F(CliBuses, OfASilentLineWhatIsPlannedStays)
{
    cut = {"01N", [](SimulatedEscLine &line) { line.setSilent(true); }};
    const QString saved = folder.filePath(QStringLiteral("found.codewheel"));
    const CliRun scan = run({QStringLiteral("scan"), QStringLiteral("--save"), saved});
    EXPECT_EQ(scan.exit, 0);
    EXPECT_THAT(scan.out, HasSubstr("Gate 1: nothing answers there. The encoders that are planned on it stay "
                                    "in the project.\nSaved in"));
    const Project found = *loadProject(saved);
    ASSERT_EQ(devicesOn(found, firstLine).size(), 1U);
    EXPECT_EQ(devicesOn(found, firstLine)[0].station, QStringLiteral("Left"));
    EXPECT_EQ(devicesOn(found, secondLine).size(), 3U);
}

TEST_F(CliBuses, BadOptionsOfASearchAreSaidBeforeIt)
{
    const CliRun run = this->run("scan --first 40");
    EXPECT_EQ(run.exit, 2);
    EXPECT_EQ(run.out, "");
}

// The encoders 05 of both lines report the same serial number.
TEST_F(CliBuses, WhatIsListedOfSeveralBusesIsToldWithItsBus)
{
    const QString ledger = folder.filePath(QStringLiteral("ledger.sqlite"));
    const auto on = [&](const char *command, const char *place, const char *more) {
        return run({QString::fromLatin1(command), QString::fromLatin1(place), QString::fromLatin1(more),
                    QStringLiteral("--yes"), QStringLiteral("--ledger"), ledger});
    };
    ASSERT_EQ(on("write", "Gate 1/05", "steps=864").exit, 0);
    EXPECT_THAT(runLine(QStringLiteral("ledger --ledger ") + ledger).out, HasSubstr("  esc:05  "));
    EXPECT_THAT(run({QStringLiteral("restore"), QStringLiteral("Gate 1/05"), QStringLiteral("--list"),
                     QStringLiteral("--ledger"), ledger})
                    .out,
                Not(HasSubstr("Gate 1")));
    ASSERT_EQ(on("write", "Gate 2/05", "steps=999").exit, 0);
    ASSERT_EQ(on("write", "Gate 2/12", "steps=999").exit, 0);
    const CliRun list = run({QStringLiteral("restore"), QStringLiteral("Gate 1/05"), QStringLiteral("--list"),
                             QStringLiteral("--ledger"), ledger});
    EXPECT_THAT(list.out, HasSubstr("  Gate 1/esc:05  steps="));
    EXPECT_THAT(list.out, HasSubstr("  Gate 2/esc:05  steps="));
    ASSERT_EQ(on("write", "Gate 1/05", "steps=864").exit, 0);
    const std::string unnamed = runLine(QStringLiteral("ledger --ledger ") + ledger).out;
    EXPECT_THAT(unnamed, HasSubstr("  2/esc:05  "));
    EXPECT_THAT(unnamed, HasSubstr("  4/esc:12  "));
    EXPECT_THAT(run({QStringLiteral("ledger"), QStringLiteral("--ledger"), ledger}).out,
                HasSubstr("  Gate 2/esc:12  "));
    // In another project the numbers may stand for other buses.
    std::swap(project.buses[2].id, project.buses[3].id);
    project.devices.clear();
    const std::string other = run({QStringLiteral("ledger"), QStringLiteral("--ledger"), ledger}).out;
    EXPECT_THAT(other, HasSubstr("  4/esc:12  "));
    EXPECT_THAT(other, Not(HasSubstr("Crane 2")));
}

TEST_F(CliBuses, AFaultPlanIsForOneRing)
{
    project.buses = {planned(firstBus, "interbus", "Crane"), planned(secondRing, "interbus", "Gate")};
    project.devices.clear();
    ASSERT_TRUE(saveProject(project, file));
    const QString call =
        QStringLiteral("master --after 31000 --json --bus %1 --link project --project %2 --fault-plan ")
            .arg(QStringLiteral("Gate"), file) +
        QStringLiteral(CODEWHEEL_ROOT "/resources/examples/faults.json");
    EXPECT_EQ(errorKey(runLine(call)), "busNotUnique");
    EXPECT_EQ(errorKey(runLine(call + QStringLiteral(" --fault-bus Door"))), "unknownBus");
    const auto told = [&](const char *ring) {
        return runLine(call + QStringLiteral(" --fault-bus ") + QString::fromLatin1(ring)).json();
    };
    EXPECT_GT(told("Gate")[u"messages"].toArray().size(), told("Crane")[u"messages"].toArray().size());
    EXPECT_EQ(told("Gate")[u"busName"], QStringLiteral("Gate"));
    EXPECT_EQ(told("Gate")[u"bus"], 3);
}

// Another program may save in between, so reading twice could give two answers.
TEST_F(CliBuses, TheProjectIsReadOnce)
{
    project.buses = {planned(firstBus, "interbus", "Crane")};
    project.devices.clear();
    for (const char *call : {"compare %1", "scan --project %1", "store %1", "compare %1 --link project"}) {
        ASSERT_TRUE(saveProject(project, file));
        const int watch = ::inotify_init1(IN_CLOEXEC | IN_NONBLOCK);
        ::inotify_add_watch(watch, QFile::encodeName(file).constData(), IN_OPEN | IN_CLOSE);
        runLine(QString::fromLatin1(call).arg(file));
        std::array<char, 4'096> events{}; // the events of a single file have no names
        EXPECT_EQ(::read(watch, events.data(), events.size()), ssize_t{2 * sizeof(inotify_event)}) << call;
        ::close(watch);
    }
}

// Already when the arguments are parsed.
TEST_F(CliBuses, TheLinkProjectLeadsToAllBusesOfTheProject)
{
    project.buses.erase(project.buses.begin() + 1);
    project.buses.pop_back();
    project.devices.clear();
    ASSERT_TRUE(saveProject(project, file));
    const QString call = QStringLiteral(" --link project --json --project ") + file;
    const QJsonArray buses = runLine(QStringLiteral("scan") + call).json()[u"buses"].toArray();
    ASSERT_EQ(buses.size(), 2);
    EXPECT_EQ(buses[1][u"busName"], QStringLiteral("Crane 2"));
    EXPECT_EQ(errorKey(runLine(QStringLiteral("monitor 1.0") + call)), "placeNotUnique");
    EXPECT_EQ(errorKey(runLine(QStringLiteral("scan --link project --json"))), "noProject");
    EXPECT_EQ(errorKey(runLine(QStringLiteral("compare %1 --link project --json").arg(file))), "busDiffers")
        << "the project is its first argument";

    project.buses.push_back(planned(secondLine, "esc", "Gate"));
    ASSERT_TRUE(saveProject(project, file));
    const CliRun portless = runLine(QStringLiteral("scan") + call);
    EXPECT_EQ(errorKey(portless), "noPortInProject");
    EXPECT_THAT(portless.err, HasSubstr("The project has no port for \"Gate\" yet."));
    EXPECT_EQ(portless.json()[u"buses"].toArray().size(), 3) << "the others are told";
    EXPECT_EQ(errorKey(runLine(QStringLiteral("monitor 05") + call)), "noPortInProject");
}

TEST_F(CliBuses, OneCallHasOneProjectWithBuses)
{
    const QString other = folder.filePath(QStringLiteral("other.codewheel"));
    ASSERT_TRUE(saveProject(project, file) && saveProject(project, other));
    EXPECT_EQ(errorKey(runLine(QStringLiteral("compare %1 --project %2 --json").arg(file, other))),
              "twoProjects");
    project.buses.clear();
    project.devices.clear();
    ASSERT_TRUE(saveProject(project, file));
    EXPECT_EQ(errorKey(runLine(QStringLiteral("scan --link project --json --project ") + file)), "noBuses");
}

// What was not looked at does not count as the same.
TEST_F(CliBuses, ComparingSomeBusesIsNoComparison)
{
    project.buses = {planned(secondLine, "esc", "Gate 2")};
    project.devices.erase(project.devices.begin());
    ASSERT_TRUE(saveProject(project, file));
    EscLinePlan plan;
    plan.settings.port = QStringLiteral("/dev/none");
    EXPECT_EQ(errorKey(runLine(QStringLiteral("compare %1 --link interbus:training --json").arg(file))),
              "notAllCompared");
}

TEST_F(CliBuses, ABusThatCannotBeReachedKeepsNoOtherFromBeingReported)
{
    project.buses = {planned(firstBus, "interbus", "Crane"), planned(secondLine, "esc", "Gate")};
    project.devices.erase(project.devices.begin());
    EscLinePlan plan;
    plan.settings.port = QStringLiteral("/dev/none");
    setLinePlan(project, secondLine, plan);
    ASSERT_TRUE(saveProject(project, file));
    const QString report = folder.filePath(QStringLiteral("report.html"));
    const CliRun run =
        runLine(QStringLiteral("report %1 --read --link project --json -o %2").arg(file, report));
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(run), "portNotFound");
    EXPECT_TRUE(QFile::exists(report));
    ProjectDevice hoist;
    hoist.standAt({firstBus, NodeId("1.0")});
    project.devices.insert(project.devices.begin(), hoist);
    ASSERT_TRUE(saveProject(project, file));
    const std::string compared = runLine(QStringLiteral("compare %1 --link project").arg(file)).err;
    EXPECT_THAT(compared, HasSubstr("Gate: There is no serial port /dev/none"));
}

// A bus of the call is the project's bus of its kind, identified by its port.
TEST_F(CliBuses, ALinkHasTheNumberOfTheBusThatIsMeant)
{
    const auto numberAt = [this](const char *link) {
        const auto links = linksMeant(QString::fromLatin1(link), &project);
        return (*links->front()(catalog))->bus().id().number;
    };
    EscLinePlan right;
    right.settings.port = QStringLiteral("/dev/ttyRight");
    setLinePlan(project, secondLine, right);
    EXPECT_EQ(numberAt("esc:/dev/ttyRight"), 4);
    EXPECT_GT(numberAt("esc:/dev/ttyOther"), 4) << "none of the lines is there";
    EXPECT_EQ(numberAt("esc:training"), 2);
    EXPECT_EQ(numberAt("interbus:training"), 1);
    project.buses = {planned(firstLine, "interbus", "Crane"), planned(secondRing, "interbus", "Crane 2")};
    EXPECT_GT(numberAt("esc:/dev/ttyOther"), 3) << "number 2 is a ring";
    EXPECT_EQ(numberAt("interbus:training"), 1) << "it is none of the two";
    project.buses.pop_back();
    EXPECT_EQ(numberAt("training"), 2) << "the only ring";
}

class CliProjectLinks : public CliBuses
{
protected:
    CliProjectLinks()
    {
        for (const auto &[line, bits] : {std::pair(firstLine, 28), std::pair(secondLine, 30)}) {
            EscLinePlan plan;
            plan.settings.port = QStringLiteral("/dev/none");
            plan.settings.fractionBits = bits;
            setLinePlan(project, line, plan);
        }
    }
    CliRun call(QStringList words)
    {
        EXPECT_TRUE(saveProject(project, file));
        words << QStringLiteral("--project") << file << QStringLiteral("--json");
        return runWith({}, [&](const Terminal &terminal) { return runCommandLine(words, terminal); });
    }
    CliRun explain(const char *request, const char *link = "esc:project")
    {
        return call({QStringLiteral("explain"), QStringLiteral("40000000"), QStringLiteral("--other"),
                     QString::fromLatin1(request), QStringLiteral("--device"),
                     QStringLiteral("kuebler-esc-rs485"), QStringLiteral("--link"),
                     QString::fromLatin1(link)});
    }
};

// The same digits are a factor of 1 with 30 fraction bits, and of 4 with 28.
TEST_F(CliProjectLinks, ARequestIsExplainedByTheLineThatHasItsAddress)
{
    for (const char *link : {"esc:project", "project"}) {
        const QJsonObject top = explain("12F", link).json();
        EXPECT_EQ(top[u"busName"], QStringLiteral("Gate 2")) << link;
        EXPECT_EQ(top[u"outOfRange"], false);
        EXPECT_EQ(explain("Gate 1/12F", link).json()[u"outOfRange"], true);
        EXPECT_EQ(explain("4/05F", link).json()[u"outOfRange"], false);
    }
    const CliRun several = explain("05F");
    EXPECT_EQ(errorKey(several), "placeNotUnique");
    EXPECT_THAT(several.err, HasSubstr("Gate 1/esc:05, Gate 2/esc:05. Name the line before the request, as "
                                       "Gate 1/05F."));
    EXPECT_EQ(errorKey(explain("Gate 3/05F")), "unknownBus");
    EXPECT_EQ(errorKey(explain("Crane 1/05F", "project")), "unknownDevice");
    EXPECT_EQ(explain("Crane 1/05F", "project").err.find("differs"), std::string::npos)
        << "nothing is asked of the ring";
}

TEST_F(CliProjectLinks, TheLimitsOfADeviceAreThoseOfTheLineThatIsNamed)
{
    const auto most = [&](const CliRun &run) {
        for (const QJsonValue parameter : run.json()[u"parameters"].toArray())
            if (parameter[u"parameter"] == QStringLiteral("scaling-factor"))
                return parameter[u"maximum"].toInteger();
        return qint64{};
    };
    const QStringList words{QStringLiteral("devices"), QStringLiteral("kuebler-esc-rs485"),
                            QStringLiteral("--link"), QStringLiteral("project")};
    EXPECT_EQ(errorKey(call(words)), "busNotUnique");
    EXPECT_EQ(most(call(words + QStringList{QStringLiteral("--bus"), QStringLiteral("Gate 1")})), 1 << 28);
    EXPECT_EQ(most(call(words + QStringList{QStringLiteral("--bus"), QStringLiteral("4")})), 1 << 30);
    QStringList ofTheRing = words;
    ofTheRing[1] = QStringLiteral("fraba-ocd-ib");
    EXPECT_EQ(call(ofTheRing).exit, 0) << "it is on no line";
}

TEST_F(CliProjectLinks, EachSchemeLeadsToTheBusesOfItsKindInTheProject)
{
    const auto names = [&](const char *link) {
        const CliRun scan =
            call({QStringLiteral("scan"), QStringLiteral("--link"), QString::fromLatin1(link)});
        QStringList all;
        for (const QJsonValue bus : scan.json()[u"buses"].toArray())
            all << bus[u"busName"].toString();
        return all.join(u'|');
    };
    EXPECT_EQ(names("interbus:project"), QStringLiteral("Crane 1|Crane 2"));
    EXPECT_EQ(names("esc:project"), QStringLiteral("Gate 1|Gate 2"));
    const auto refused = [&](const char *link) {
        return linksMeant(QString::fromLatin1(link), &project).error();
    };
    EXPECT_EQ(refused("interbus:project,foo=1").key, QStringLiteral("linkWithoutSettings"));
    EXPECT_EQ(refused("esc:project,foo=1").key, QStringLiteral("unknownLineSetting"));
    EXPECT_THAT(refused("interbus:com1").text.toStdString(),
                HasSubstr("interbus:project, esc:project, can:project, slcan:project, canopen:project, those "
                          "of one kind alone"));
    project.buses = {planned(firstBus, "interbus", "Crane")};
    EXPECT_EQ(refused("esc:project").text,
              QStringLiteral("The project has no buses for the link \"esc:project\"."));
    EXPECT_EQ(linksMeant(QStringLiteral("interbus:project"), nullptr).error().key,
              QStringLiteral("noProject"));
}

constexpr std::array otherOptions{Option{"--depth", "M", nullptr}, Option{"--dry", nullptr, nullptr}};
const Service otherService{"other", otherOptions, [](const Call &) -> Checked<Answer> {
                               return badInput("served", QStringLiteral("served"));
                           }};

// A kind of bus that can also be reached by another kind's scheme.
class OtherKind final : public LinkKind
{
public:
    QString bus() const override { return QStringLiteral("other"); }
    QStringList schemes() const override { return {QStringLiteral("esc")}; }
    QString help() const override { return {}; }
    bool isPlace(const QString &) const override { return false; }
    Checked<std::vector<MakeLink>> links(const LinkText &text, const Project *) const override
    {
        return badInput("reached", text.where + text.settings.join(u','));
    }
    Checked<MakeLink> planned(const Project &, BusId, const QStringList &) const override { return {}; }
    MakeLink training(const Project *) const override { return {}; }
    std::span<const Service> services() const override { return {&otherService, 1}; }
};

TEST(CliLinks, WhatAKindServesStandsInTheHelp)
{
    const auto other = addLinkKind(std::make_unique<OtherKind>());
    EXPECT_THAT(runLine(QStringLiteral("serve")).err,
                HasSubstr("| modbus-rtu [--port PORT] [--seats N] [--read-only] | esc "));
    EXPECT_THAT(runLine(QStringLiteral("serve")).err, HasSubstr(" | other [--depth M] [--dry]"));
    EXPECT_EQ(errorKey(runLine(QStringLiteral("serve other --depth 5 --json"))), "served");
}

TEST(CliLinks, OfSeveralKindsWithASchemeTheProtocolChooses)
{
    const auto other = addLinkKind(std::make_unique<OtherKind>());
    const auto keyOf = [](const char *link) {
        const auto links = linksMeant(QString::fromLatin1(link), nullptr);
        return links ? "esc" : links.error().key.toStdString();
    };
    EXPECT_EQ(keyOf("esc:ttyUSB0,protocol=esc,baud=9600"), "esc");
    EXPECT_EQ(keyOf("esc:ttyUSB0,protocol=other,rate=1"), "reached");
    EXPECT_EQ(keyOf("esc:ttyUSB0"), "protocolMissing");
    EXPECT_EQ(keyOf("esc:ttyUSB0,protocol=modbus"), "unknownProtocol");
}

TEST(CliLinks, WhereOneKindHasTheSchemeNoProtocolIsNeeded)
{
    EXPECT_TRUE(linksMeant(QStringLiteral("esc:ttyUSB0,protocol=esc"), nullptr));
    EXPECT_EQ(
        linksMeant(QStringLiteral("esc:training,protocol=interbus"), nullptr).error().text,
        QStringLiteral("\"interbus\" is not spoken at esc:training. What protocol= can name there: esc."));
    EXPECT_EQ(linksMeant(QStringLiteral("interbus:training"), nullptr)->size(), 1U);
    EXPECT_EQ(linksMeant(QStringLiteral("interbus:com1"), nullptr).error().key,
              QStringLiteral("unknownLink"));
    EXPECT_EQ(linksMeant(QStringLiteral("interbus:training,foo=1"), nullptr).error().text,
              QStringLiteral("The link interbus:training has no settings. Leave \"foo=1\" out."));
}

} // namespace
} // namespace codewheel

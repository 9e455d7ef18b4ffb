// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "journal/ledger.h"
#include "kinds/interbus/plan/project_take_over.h"
#include "kinds/interbus/plan/ring_plan.h"
#include "project/bus_kind.h"
#include "project/bus_plans.h"
#include "report/deviations.h"
#include "report/kept_counts.h"
#include "tests/report/report_example.h"
#include "tests/support/places.h"
#include "tests/support/plans.h"

#include <QLocale>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

const char *const frabaHeading = "1.0: FRABA OCD-IB K3, Crane 1, hoist";
const char *const baumerHeading = "2.0: Baumer GXP6W K3, Crane 1, trolley";

// The input keeps its numbers in the C locale; this changes the locale for a test and restores it.
class InLocale
{
public:
    explicit InLocale(const QLocale &locale) { QLocale::setDefault(locale); }
    ~InLocale() { QLocale::setDefault(QLocale::c()); }
    Q_DISABLE_COPY_MOVE(InLocale)
};

TEST(CommissioningReport, TellsProjectProgramDateAndLinkFirst)
{
    const Report report = reportOf(exampleInput());
    EXPECT_EQ(report.title, QStringLiteral("Commissioning report"));
    EXPECT_EQ(report.subject, QStringLiteral("Harbour crane"));
    EXPECT_EQ(report.origin, QStringLiteral("Codewheel 0.1.0, 1 Mar 2026 14:00:00"));
    EXPECT_THAT(factsOf({report.facts}),
                ElementsAre("Project: Harbour crane", "File: crane.codewheel",
                            "Date: 1 Mar 2026 14:00:00 (UTC+00:00)", "Program: Codewheel 0.1.0",
                            "Link: training bus (simulated)", "Devices: 3, encoders among them: 2",
                            "Deviations of encoders: 1", "Bus: not compared with a connected one"));
}

TEST(CommissioningReport, StandsInItsOrder)
{
    const Report report = reportOf(exampleInput());
    std::vector<std::string> headings;
    for (const ReportSection &section : report.sections)
        headings.push_back(section.heading.toStdString());
    EXPECT_THAT(headings,
                ElementsAre("Deviations", "Bus structure", "Approximate cycle time", "Encoders", frabaHeading,
                            baumerHeading, "EEPROM writes by this program", "Signatures"));
}

TEST(CommissioningReport, StructureHasNumberStationDeviceCodeWordsAndAddresses)
{
    ReportInput input = exampleInput();
    input.project.devices[1].set(GivenAddresses{.out = 16});
    EXPECT_THAT(rowsOf(sectionOf(reportOf(input), "Bus structure")),
                ElementsAre("1.0 | Crane 1, hoist | FRABA OCD-IB K3 | 37h | 2 / 2 | 0 | 0",
                            "2.0 | Crane 1, trolley | Baumer GXP6W K3 | 37h | 2 / 2 | 4 | 16 by hand",
                            "3.0 |  | bus terminal | 0Ch | 0 / 0 |  | "));
}

TEST(CommissioningReport, AddressesAreCountedAsTheProjectCountsThem)
{
    ReportInput input = exampleInput();
    changeRing(input.project, [](RingPlan &ring) { ring.addresses.unit = AddressRules::Unit::word; });
    const Report report = reportOf(input);
    EXPECT_THAT(rowsOf(sectionOf(report, "Bus structure")),
                Contains("2.0 | Crane 1, trolley | Baumer GXP6W K3 | 37h | 2 / 2 | 2 | 2"));
    const auto &table = std::get<ReportTable>(sectionOf(report, "Bus structure").blocks.front());
    EXPECT_TRUE(table.header.contains(QStringLiteral("IN from word")));
}

TEST(CommissioningReport, EveryValueHasItsEvidenceAndTime)
{
    EXPECT_THAT(rowsOf(sectionOf(reportOf(exampleInput()), frabaHeading)),
                ElementsAre("Steps | 4096 | 8192 | steps | read | 1 Mar 2026 12:00:00 | differs",
                            "Revolutions |  | unknown | revolutions |  |  | ",
                            "Direction | 3 (CW) | 3 (CW) |  | confirmed | 1 Mar 2026 12:01:00 | as wanted",
                            "Preset | 0 | unknown | steps |  |  | not compared",
                            "Zero offset |  | unknown | steps |  |  | "));
}

TEST(CommissioningReport, ValuesThatMayNotActAreToldAlthoughTheyAreAsWanted)
{
    ReportInput input = exampleInput();
    ProjectDevice &device = fraba(input);
    device.participant.deviceKey = QStringLiteral("kuebler-esc-rs485");
    device.wanted = {{Parameter::steps, 2000}};
    device.stored = {{Parameter::steps, 2000, Evidence::read, input.now}};
    const auto facts = [&] {
        const Report report = reportOf(input);
        const auto its = std::ranges::find_if(report.sections, [](const ReportSection &section) {
            return section.heading.startsWith(QStringLiteral("1.0: "));
        });
        return its == report.sections.end() ? std::vector<std::string>() : factsOf(its->blocks);
    };
    EXPECT_THAT(facts(),
                Contains(testing::StartsWith("Perhaps not in force: It is not known whether scaling")));
    device.stored.push_back({Parameter::scaling, 0, Evidence::read, input.now});
    EXPECT_THAT(facts(), Contains(testing::StartsWith("Not in force: Scaling is off")));
    device.stored.back().value = 1;
    EXPECT_THAT(facts(), Each(testing::Not(HasSubstr("in force"))));
}

TEST(CommissioningReport, AFactoryValueIsNeverTakenForAKnownOne)
{
    ReportInput input = exampleInput();
    fraba(input).stored.clear();
    const std::vector<std::string> rows = rowsOf(sectionOf(reportOf(input), frabaHeading));
    EXPECT_EQ(rows.size(), 5U);
    EXPECT_THAT(rows, Each(HasSubstr("unknown")));
}

TEST(CommissioningReport, WhatTheConnectedEncoderTellsGoesBeforeTheProject)
{
    ReportInput input = exampleInput();
    input.live["1.0"_ring].values = {{Parameter::steps, 4096, Evidence::read, input.now}};
    const ReportSection section = sectionOf(reportOf(input), frabaHeading);
    EXPECT_THAT(rowsOf(section),
                Contains("Steps | 4096 | 4096 | steps | read | 1 Mar 2026 14:00:00 | as wanted"));
    EXPECT_THAT(rowsOf(section), Contains("Direction | 3 (CW) | unknown |  |  |  | not compared"));
    EXPECT_THAT(factsOf(section.blocks), Contains("Known values: of the connected encoder"));
    input.live["1.0"_ring].isSimulated = true;
    EXPECT_THAT(factsOf(sectionOf(reportOf(input), frabaHeading).blocks),
                Contains("Known values: of a simulated encoder"));
    EXPECT_THAT(factsOf(sectionOf(reportOf(input), baumerHeading).blocks),
                Contains("Known values: as stored in the project; the encoder was not asked"));
}

TEST(CommissioningReport, WhatIsNotUpToDateIsSaidWithReasonAndTime)
{
    const auto stopped = Freshness::Reason::stopped;
    ReportInput input = exampleInput();
    input.project.buses.front().name = QStringLiteral("Crane");
    input.live["1.0"_ring].values = {{Parameter::steps, 4096, Evidence::read, input.now}};
    input.live["1.0"_ring].notLive = NotLive{stopped, input.now.addSecs(-60)};
    const QString seen = QStringLiteral("The bus does not run. Last seen: 1 Mar 2026 13:59:00.");
    EXPECT_THAT(factsOf(sectionOf(reportOf(input), frabaHeading).blocks),
                Contains("Known values: of the connected encoder, not up to date. " + seen.toStdString()));

    ConnectedBus &connected = input.connected[input.project.buses.front().id];
    for (const ProjectDevice &device : input.project.devices)
        connected.devices.push_back(device.participant);
    EXPECT_THAT(paragraphsOf(sectionOf(reportOf(input), "Deviations")),
                Contains("The connected bus is as configured."));
    for (const Participant &device : connected.devices)
        connected.notLive[device.number] = NotLive{stopped, input.now.addSecs(-60)};
    const Report old = reportOf(input);
    EXPECT_THAT(
        paragraphsOf(sectionOf(old, "Deviations")),
        testing::AllOf(Contains("The connected bus was as configured."),
                       Contains("Compared as last seen, not up to date: Crane: " + seen.toStdString())));
    EXPECT_THAT(factsOf({old.facts}), Contains("Bus: connected as configured (not up to date)"));
    connected.notLive.erase(connected.devices.front().number);
    EXPECT_THAT(paragraphsOf(sectionOf(reportOf(input), "Deviations")),
                Contains("Compared as last seen, not up to date: Crane: 2.0, 3.0: " + seen.toStdString()));
}

TEST(CommissioningReport, DeviationsAndWhatCouldNotBeComparedAreTold)
{
    const ReportSection section = sectionOf(reportOf(exampleInput()), "Deviations");
    EXPECT_THAT(rowsOf(section),
                ElementsAre("1.0 | Crane 1, hoist | Steps | 4096 steps | 8192 steps | read"));
    EXPECT_THAT(paragraphsOf(section),
                ElementsAre(HasSubstr("1 wanted value(s) or cam program(s) could not be compared"),
                            "The configured bus was not compared with a connected one."));
}

TEST(CommissioningReport, ComparisonOfTheBusIsToldLineByLine)
{
    ReportInput input = exampleInput();
    input.connected[firstBus].devices = participantsOn(input.project, firstBus);
    EXPECT_THAT(paragraphsOf(sectionOf(reportOf(input), "Deviations")),
                Contains("The connected bus is as configured."));
    EXPECT_THAT(factsOf({reportOf(input).facts}), Contains("Bus: connected as configured"));
    input.connected[firstBus].devices.front() = RingDevice{NodeId("1.0"), 0x0236, 2, 2, {}, 0};
    EXPECT_THAT(factsOf({reportOf(input).facts}),
                Contains("Bus: not connected as configured; lines that differ: 2"));
    EXPECT_THAT(rowsOf(sectionOf(reportOf(input), "Deviations")),
                Contains("1.0: configured K3 37h, found K2 36h"));
}

// Two rings with the same places, each with differences, wanted values and notes.
ReportInput twoRings()
{
    ReportInput input = exampleInput();
    input.project.buses.front().name = QStringLiteral("Crane 1");
    planBus(input.project, BusId{3}, *busKind(QString::fromLatin1(interbusKind))).name =
        QStringLiteral("Crane 2");
    std::vector<ProjectDevice> same = input.project.devices;
    for (ProjectDevice &device : same)
        device.bus = BusId{3};
    same[1].set(GivenAddresses{.out = 1});
    same[2].note = QStringLiteral("In the cabinet");
    setDevicesOn(input.project, BusId{3}, std::move(same));
    return input;
}

TEST(CommissioningReport, SamePlacesOfTwoRingsAreToldApart)
{
    const ReportInput input = twoRings();
    const Report report = reportOf(input);
    EXPECT_THAT(rowsOf(sectionOf(report, "Deviations")),
                ElementsAre("Crane 1/1.0 | Crane 1, hoist | Steps | 4096 steps | 8192 steps | read",
                            "Crane 2/1.0 | Crane 1, hoist | Steps | 4096 steps | 8192 steps | read",
                            StartsWith("Crane 2/2.0 | ")));
    EXPECT_THAT(rowsOf(sectionOf(report, "EEPROM writes by this program")),
                Contains(StartsWith("Crane 2/2.0 | ")));
    EXPECT_THAT(factsOf(sectionOf(report, "Notes").blocks), ElementsAre("Crane 2/3.0: In the cabinet"));
    sectionOf(report, "Crane 1/1.0: FRABA OCD-IB K3, Crane 1, hoist");
    sectionOf(report, "Crane 2/1.0: FRABA OCD-IB K3, Crane 1, hoist");
}

TEST(CommissioningReport, BusesThatWereNotComparedAreNamed)
{
    ReportInput input = twoRings();
    input.connected[firstBus].devices = participantsOn(input.project, firstBus);
    EXPECT_THAT(factsOf({reportOf(input).facts}),
                Contains("Bus: connected as configured; not compared: Crane 2"));
    EXPECT_THAT(paragraphsOf(sectionOf(reportOf(input), "Deviations")),
                Contains("Not compared with connected ones: Crane 2."));
    input.connected[BusId{3}].devices = {};
    EXPECT_THAT(factsOf({reportOf(input).facts}),
                Contains("Bus: not connected as configured; lines that differ: 3"));
    EXPECT_THAT(rowsOf(sectionOf(reportOf(input), "Deviations")), Contains(StartsWith("Crane 2 | 1.0: ")));
}

TEST(CommissioningReport, AMakeOfAnotherDeviceCodeIsNotBelieved)
{
    ReportInput input = exampleInput();
    fraba(input).participant.deviceCode = 0x0236;
    const std::vector<ReportedDevice> devices = reportedDevices(input, catalog());
    ASSERT_NE(devices.front().description, nullptr);
    EXPECT_EQ(devices.front().description->deviceCode, 0x0236u);
}

TEST(CommissioningReport, BrokenRulesOfTheBusAreTold)
{
    ReportInput input = exampleInput();
    fraba(input).set(GivenAddresses{.in = 0});
    input.project.devices[1].set(GivenAddresses{.in = 2});
    EXPECT_THAT(rowsOf(sectionOf(reportOf(input), "Deviations")), Contains(StartsWith("2.0 | ")));
}

TEST(CommissioningReport, CountsDeviationsForPrograms)
{
    const ReportInput input = exampleInput();
    const DeviationCounts counts = countDeviations(reportedDevices(input, catalog()));
    EXPECT_EQ(counts.deviations, 1);
    EXPECT_EQ(counts.notKnown, 1);
}

// One K3 encoder and the formulas of INTERBUS: 0.463 and 1.007 ms at 500 kBd.
TEST(CommissioningReport, CycleTimeIsToldByBothFormulas)
{
    ReportInput input = exampleInput();
    input.project.devices.resize(1);
    EXPECT_THAT(
        rowsOf(sectionOf(reportOf(input), "Approximate cycle time")),
        ElementsAre("500 kBd | about 0.463 ms | about 1.007 ms", "2 MBd | about 0.266 ms | about 0.777 ms"));
}

TEST(CommissioningReport, CycleTimesOfSeveralRingsHaveTheirNames)
{
    const Report report = reportOf(twoRings());
    for (const char *heading : {"Approximate cycle time of Crane 1", "Approximate cycle time of Crane 2"})
        EXPECT_EQ(rowsOf(sectionOf(report, heading)).size(), 2U);
}

TEST(CommissioningReport, EepromWritesSayHowTheEncoderIsTold)
{
    ReportInput input = exampleInput();
    input.writes["1.0"_ring] = {12, 0, input.now.addDays(-30), CountedBy::serialNumber,
                                QStringLiteral("20417")};
    input.writes["2.0"_ring] = {3, 2, {}, CountedBy::session, {}};
    EXPECT_THAT(
        rowsOf(sectionOf(reportOf(input), "EEPROM writes by this program")),
        ElementsAre(
            "1.0 | Crane 1, hoist | 12 | 30 Jan 2026 14:00:00 | serial number 20417 (4FC1h), read "
            "from it | about 200; nothing is guaranteed beyond 500",
            "2.0 | Crane 1, trolley | 3, perhaps 2 more |  | this connection only; nothing is kept of "
            "others | not stated"));
    input.writes.clear();
    EXPECT_THAT(rowsOf(sectionOf(reportOf(input), "EEPROM writes by this program")),
                Contains("2.0 | Crane 1, trolley | unknown |  |  | not stated"));
}

// For encoders that are not connected, the ledger knows what was written to them.
TEST(CommissioningReport, EepromWritesOfTheLedgerAreAddedByTheBestThatIsKnown)
{
    const Catalog catalog = Catalog::builtIn();
    auto ledger = Ledger::open(DatabasePlace::memory());
    ASSERT_TRUE(ledger);
    const QString file = QStringLiteral("/crane.codewheel");
    const auto note = [&](const EncoderIdentity &identity, int writes) {
        EXPECT_TRUE(ledger->begin({.at = QDateTime(QDate(2026, 1, 30), QTime(14, 0), Qt::UTC),
                                   .identity = identity.key(),
                                   .by = identity.by,
                                   .place = identity.place,
                                   .planned = writes,
                                   .writes = writes,
                                   .settled = true}));
    };
    const QString fraba = QStringLiteral("FRABA");
    note({CountedBy::serialNumber, fraba, QStringLiteral("4711"), {}, "1.0"_ring}, 12);
    note({CountedBy::labelSerialNumber, fraba, QStringLiteral("20417"), {}, "1.0"_ring}, 7);
    note({CountedBy::place, fraba, {}, file, "1.0"_ring}, 5);

    const Place encoder = "1.0"_ring;
    ReportInput input = exampleInput();
    input.writes.clear();
    ProjectDevice &planned = input.project.devices[0];
    planned.participant.deviceKey = QStringLiteral("fraba-ocd-ib");
    planned.label.serialNumber.clear();
    planned.stored.clear();
    const auto counted = [&] {
        input.writes.clear();
        addKept(input, *ledger, catalog, file);
        return input.writes["1.0"_ring];
    };
    EXPECT_EQ(counted().writes, 5);
    EXPECT_EQ(counted().by, CountedBy::place);
    planned.label.serialNumber = QStringLiteral("20417");
    EXPECT_EQ(counted().writes, 7);
    planned.stored = {{Parameter::serialNumber, 4711, Evidence::read, {}}};
    EXPECT_EQ(counted().writes, 12);
    EXPECT_EQ(counted().serialNumber, QStringLiteral("4711"));
    EXPECT_EQ(input.writes.size(), 1u);        // nothing is known of the others
    input.writes["1.0"_ring] = {.writes = 99}; // the connected encoder reports its own
    addKept(input, *ledger, catalog, file);
    EXPECT_EQ(input.writes.at(encoder).writes, 99);
}

TEST(CommissioningReport, SerialNumberIsOfTheEncoderOrOfItsLabelOrUnknown)
{
    ReportInput input = exampleInput();
    EXPECT_THAT(factsOf(sectionOf(reportOf(input), frabaHeading).blocks), Contains("Serial number: unknown"));
    EXPECT_THAT(factsOf(sectionOf(reportOf(input), baumerHeading).blocks),
                Contains("Serial number: B 4711 (from the label)"));
    fraba(input).stored.push_back({Parameter::serialNumber, 20417, Evidence::read, input.now});
    EXPECT_THAT(factsOf(sectionOf(reportOf(input), frabaHeading).blocks),
                Contains("Serial number: 20417 (4FC1h) (read)"));
    for (const auto &[typed, shown] :
         {std::pair("20417", "20417 (4FC1h)"), {"4fc1", "20417 (4FC1h)"}, {"1234", "1234"}}) {
        findDevice(input.project, "1.0"_ring)->label.serialNumber = QString::fromLatin1(typed);
        EXPECT_THAT(
            factsOf(sectionOf(reportOf(input), frabaHeading).blocks),
            Contains(std::string("Serial number: 20417 (4FC1h) (read), ") + shown + " (from the label)"));
    }
}

TEST(CommissioningReport, NumbersAndDatesFollowTheLocale)
{
    const InLocale german(QLocale(QLocale::German, QLocale::Germany));
    const std::vector<std::string> rows = rowsOf(sectionOf(reportOf(exampleInput()), frabaHeading));
    EXPECT_THAT(rows, Contains("Steps | 4.096 | 8.192 | steps | read | 01.03.2026 12:00 | differs"));
    EXPECT_THAT(rowsOf(sectionOf(reportOf(exampleInput()), "Approximate cycle time")).front(),
                HasSubstr("about 0,"));
}

TEST(CommissioningReport, TimesAreInTheZoneOfTheReport)
{
    ReportInput input = exampleInput();
    input.now = input.now.toOffsetFromUtc(2 * 3600);
    const Report report = reportOf(input);
    EXPECT_THAT(factsOf({report.facts}), Contains("Date: 1 Mar 2026 16:00:00 (UTC+02:00)"));
    EXPECT_THAT(rowsOf(sectionOf(report, frabaHeading)), Contains(HasSubstr("1 Mar 2026 14:01:00")));
}

TEST(CommissioningReport, ADeviceWithoutDescriptionStandsInTheStructureOnly)
{
    ReportInput input = exampleInput();
    input.project.devices[2].participant =
        RingDevice{NodeId("3.0"), 0x0103, 1, 1, QStringLiteral("my-device"), 0};
    input.project.devices[2].note = QStringLiteral("Valve island");
    const Report report = reportOf(input);
    EXPECT_THAT(rowsOf(sectionOf(report, "Bus structure")),
                Contains(HasSubstr("my-device (no description of it is known)")));
    EXPECT_THAT(factsOf(sectionOf(report, "Notes").blocks), ElementsAre("3.0: Valve island"));
}

TEST(CommissioningReport, APositionEncoderHasNoParameters)
{
    ReportInput input = exampleInput();
    fraba(input).participant = RingDevice{NodeId("1.0"), 0x0136, 1, 1, QStringLiteral("fraba-ocd-ib-k1"), 0};
    fraba(input).wanted.clear();
    fraba(input).stored.clear();
    EXPECT_THAT(paragraphsOf(sectionOf(reportOf(input), "1.0: FRABA OCD-IB K1, Crane 1, hoist")),
                Contains("It has no parameters: it only sends its position."));
}

TEST(CommissioningReport, AnEmptyProjectIsAReportToo)
{
    ReportInput input;
    input.now = exampleInput().now;
    const Report report = reportOf(input);
    EXPECT_THAT(factsOf({report.facts}), Contains("Project: without a title"));
    EXPECT_THAT(paragraphsOf(sectionOf(report, "Bus structure")), ElementsAre("The project has no devices."));
    EXPECT_THAT(paragraphsOf(sectionOf(report, "Encoders")), ElementsAre("The project has no encoders."));
}

TEST(CommissioningReport, NobodysNameIsInTheSignatures)
{
    const Report report = reportOf(exampleInput());
    const auto &places = std::get<SignaturePlaces>(sectionOf(report, "Signatures").blocks.front());
    EXPECT_EQ(places.roles, (QStringList{QStringLiteral("Commissioned by"), QStringLiteral("Accepted by")}));
    EXPECT_EQ(places.name, QStringLiteral("Name"));
}

} // namespace
} // namespace codewheel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/html_report.h"
#include "report/transfer_report.h"
#include "tests/transfer/transfer_bus.h"
#include "transfer/transfer_words.h"

namespace codewheel {
namespace {

using test::baumer;
using test::singleTurn;

using TransferReports = test::TransferBus;

TEST_F(TransferReports, TellWhatBecameOfEachValueAndWhyNot)
{
    encoder(baumer).tell(Parameter::coding, 6);
    const TransferPlan plan =
        planTransfer(buses, {{.place = baumer,
                              .station = QStringLiteral("Hoist"),
                              .values = {{Parameter::steps, 4096}, {Parameter::coding, 6}}},
                             {.place = singleTurn, .values = {{Parameter::steps, 100}}}});
    TransferAccount account = carryOut(plan);
    account.source = QStringLiteral("crane.codewheel");
    const QString text = reportAsText(reportOf(account, catalog, QStringLiteral("1.2")));
    EXPECT_EQ(
        text.toStdString(),
        "Values written to encoders\n==========================\n\ncrane.codewheel\n\nDate:          1 Mar "
        "2026 14:02:00\nEncoders:      1 of 2 have all of it\nWritten:       1\nAlready there: 1\nEEPROM "
        "writes: 1\nSoftware:      Codewheel 1.2\n\n2.0 Hoist\n---------\n\nDevice:           Baumer GXP6W "
        "K3\nResult:           Done.\nBegun:            1 Mar 2026 14:02:00\nEnded:            1 Mar 2026 "
        "14:02:00\nEEPROM writes:    1\nPosition before:  not known\nPosition after:   343674\nState "
        "afterwards: in operation\n\nParameter                   Before         Wanted  What became of "
        "it\nSteps                      unknown           4096  Written, confirmed by the "
        "handshake\nCoding     6 (Gray, CCW) (by hand)  6 (Gray, CCW)  Already there\n\n3.0\n---\n\nDevice: "
        "FRABA OCD-IB K1\nResult: The FRABA OCD-IB K1 cannot be parameterized over the bus.\n\nParameter   "
        "Before  Wanted  What became of it\nSteps      unknown     100  Not done\n");
    const QByteArray html = reportAsHtml(reportOf(account, catalog, QStringLiteral("1.2")));
    EXPECT_TRUE(html.contains("crane.codewheel"));
    EXPECT_TRUE(html.contains("Written, confirmed by the handshake"));
}

TEST_F(TransferReports, NameTheBusWhereSeveralHaveThePlace)
{
    setBusNames({{baumer.bus, QStringLiteral("Crane 2")}});
    const TransferAccount account{.encoders = {{.place = baumer}}};
    const QString heading = reportOf(account, catalog, {}).sections.front().heading;
    setBusNames({});
    EXPECT_EQ(heading, QStringLiteral("Crane 2/2.0"));
}

TEST_F(TransferReports, PlansSayWhatIsWorthKnowing)
{
    const TransferPlan plan = planTransfer(
        buses,
        {{.place = test::fraba, .values = {{Parameter::steps, 255}}, .cams = {CamProgram{}}, .position = 100},
         {.place = baumer}});
    EXPECT_EQ(transfer_words::summary(plan[0]).toStdString(),
              "Values and cam programs to write: 2. EEPROM writes: at most 4.");
    EXPECT_EQ(transfer_words::notes(plan[0]).join(u'\n').toStdString(),
              "The encoder is read first; what it already has is not written again.\n"
              "If the encoder counts steps minus 1, the word for the steps is one less.\n"
              "Cam programs are read, written where they differ, and stored when they are left.\n"
              "At the end, the position is set to 100.\n"
              "A preset acts once: it is programmed again where it is used up.");
    EXPECT_EQ(transfer_words::summary(plan[1]).toStdString(), "Nothing is wanted for it.");
}

TEST_F(TransferReports, ClaimNoMoreOfTheScalingThanIsKnown)
{
    using Id = ValueNote::Id;
    const auto text = [this](Id id) {
        const TransferAccount account{.encoders = {{.place = baumer, .notInForce = ValueNote{id, {}}}}};
        return reportAsText(reportOf(account, catalog, {}));
    };
    EXPECT_TRUE(text(Id::scalingOff).contains(QStringLiteral("\nNot in force: Scaling is off")));
    EXPECT_TRUE(text(Id::scalingUnknown).contains(QStringLiteral("\nPerhaps not in force: It is not known")));
}

} // namespace
} // namespace codewheel

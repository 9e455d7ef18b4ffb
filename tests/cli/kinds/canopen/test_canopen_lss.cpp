// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/nmt.h"
#include "tests/cli/kinds/canopen/shared_can_bus.h"

#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;

// Stops node 16 as soon as it is asked for, as another master would.
class StopsSixteen final : public CanParticipant
{
public:
    int rate() const override { return 125'000; }
    const CanFrame *toSend() const override { return m_isToStop ? &m_stop : nullptr; }
    void sent(const CanFrame & /*frame*/, Instant /*now*/) override { m_isToStop = false; }
    void take(const CanFrame &frame, Instant /*now*/) override { m_isToStop = frame.id == 0x610; }

private:
    CanFrame m_stop = canopen::NmtRequest{canopen::NmtCommand::stop, 16}.frame();
    bool m_isToStop = false;
};

constexpr auto identityOfNew = "vendor 10Dh, product 25h, revision 10001h, serial number 1245205 (130015h)";

TEST(CliLss, FindsTheDeviceWithoutANumber)
{
    SharedCanBus bus;
    const CliRun run = bus.runLine(QStringLiteral("lss scan"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.out, HasSubstr(std::string("A device without a number: ") + identityOfNew));
    const QJsonObject device = bus.runLine(QStringLiteral("lss scan --json")).json()[u"device"].toObject();
    EXPECT_EQ(device[u"serialNumber"], 1'245'205);
    EXPECT_TRUE(device[u"node"].isNull());
}

TEST(CliLss, GivesItANumberAfterItsIdentityWasShown)
{
    SharedCanBus bus;
    const CliRun declined = bus.runLine(QStringLiteral("lss node 9"), {true, "n\n"});
    EXPECT_EQ(declined.exit, 2);
    EXPECT_THAT(declined.out, HasSubstr(identityOfNew));
    EXPECT_EQ(bus.runLine(QStringLiteral("od can:9 read 1018:4")).exit, 1);
    const CliRun done = bus.runLine(QStringLiteral("lss node 9"), {true, "y\n"});
    EXPECT_EQ(done.exit, 0);
    EXPECT_THAT(done.out, HasSubstr("Node 9 (09h) has reported."));
    EXPECT_THAT(bus.runLine(QStringLiteral("od can:9 read 1018:4")).out, HasSubstr("1245205"));
    EXPECT_EQ(errorKey(bus.runLine(QStringLiteral("lss scan --json"))), "lssNobodyWithoutNumber");
}

TEST(CliLss, ANumberThatIsTakenIsRefused)
{
    SharedCanBus bus;
    EXPECT_EQ(errorKey(bus.runLine(QStringLiteral("lss node 5 --yes --json"))), "nodeNumberTaken");
    EXPECT_EQ(errorKey(bus.runLine(QStringLiteral("lss node 128 --yes --json"))), "canopenNodeNumberWrong");
}

TEST(CliLss, ANumberWhoseNodeWasStoppedIsRefused)
{
    SharedCanBus bus;
    bus.plant().bus()->add(std::make_shared<StopsSixteen>());
    EXPECT_EQ(errorKey(bus.runLine(QStringLiteral("lss node 16 --yes --json"))), "nodeNumberStopped");
}

TEST(CliLss, OfANodeItIsSelectedByItsIdentity)
{
    SharedCanBus bus;
    EXPECT_THAT(bus.runLine(QStringLiteral("lss show --of can:6")).out,
                HasSubstr("Node 6 (06h): vendor 10Dh, product 25h, revision 10001h, serial number 1234340"));
    const CliRun number = bus.runLine(QStringLiteral("lss node 16 --of can:6 --yes"));
    EXPECT_EQ(number.exit, 0);
    EXPECT_THAT(number.out, HasSubstr("in force after a reset"));
    const CliRun rate = bus.runLine(QStringLiteral("lss rate 250000 --of can:6 --yes"));
    EXPECT_EQ(rate.exit, 0);
    EXPECT_THAT(rate.out, HasSubstr("has taken the rate"));
    EXPECT_EQ(bus.eepromWritesOf6(), 0U);
    QTemporaryDir folder;
    const QString ledger = QStringLiteral(" --ledger ") + folder.filePath(QStringLiteral("ledger"));
    EXPECT_EQ(bus.runLine(QStringLiteral("lss store --of can:6 --yes") + ledger).exit, 0);
    EXPECT_EQ(bus.eepromWritesOf6(), 1U);
    EXPECT_THAT(runLine(QStringLiteral("ledger") + ledger).out, HasSubstr("1234340")) << "it is counted";
}

TEST(CliLss, ForOneAloneNobodyKnowsWhoElseTookPart)
{
    SharedCanBus bus({canopen::trainingEncoders()[1]});
    const CliRun run = bus.runLine(QStringLiteral("lss show --alone"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.out, HasSubstr("Whether other devices took part as well is not known."));
    SharedCanBus several;
    EXPECT_EQ(errorKey(several.runLine(QStringLiteral("lss show --alone --json"))), "lssNoAnswer");
}

TEST(CliLss, WrongCallsAreRefused)
{
    SharedCanBus bus;
    const auto key = [&](const char *line) {
        const CliRun run = bus.runLine(QString::fromLatin1(line) + QStringLiteral(" --json"));
        EXPECT_EQ(run.exit, 2) << line;
        return errorKey(run);
    };
    EXPECT_EQ(key("lss go"), "lssActionWrong");
    EXPECT_EQ(key("lss node"), "lssArgumentsWrong");
    EXPECT_EQ(key("lss store 5"), "lssArgumentsWrong");
    EXPECT_EQ(key("lss rate 100000 --yes"), "lssRateWrong");
    EXPECT_EQ(key("lss scan --alone"), "lssScanOfAll");
    EXPECT_EQ(key("lss show --alone --of can:5"), "lssOfAndAlone");
    EXPECT_EQ(key("lss node 9"), "noConsent");
}

} // namespace
} // namespace codewheel

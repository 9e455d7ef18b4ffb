// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/nmt.h"
#include "tests/cli/kinds/canopen/shared_can_bus.h"

#include <QFile>
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

// It was stored before it got its number.
TEST(CliLss, IdentifiersThatItKeepsAreTold)
{
    auto encoders = canopen::trainingEncoders();
    encoders[1].quirks.keepsIdentifiers = true;
    SharedCanBus bus(encoders);
    EXPECT_TRUE(bus.runLine(QStringLiteral("lss show --of can:6 --json"))
                    .json()[u"keptIdentifiers"]
                    .toArray()
                    .isEmpty());
    EXPECT_EQ(bus.runLine(QStringLiteral("od can:6 write 1010:1=save --yes")).exit, 0);
    EXPECT_EQ(bus.runLine(QStringLiteral("lss node 16 --of can:6 --yes")).exit, 0);
    EXPECT_EQ(bus.runLine(QStringLiteral("lss store --of can:6 --yes")).exit, 0);
    bus.runLine(QStringLiteral("nmt reset can:6 --yes"));
    const CliRun run = bus.runLine(QStringLiteral("lss show --of can:16"));
    EXPECT_THAT(run.out, HasSubstr("1014h:0 (EMCY) has the identifier 086h, and 090h is predefined"));
    EXPECT_THAT(run.out, HasSubstr("1800h:1 (TPDO1) has the identifier 186h, and 190h is predefined"));
    const QJsonArray kept =
        bus.runLine(QStringLiteral("lss show --of can:16 --json")).json()[u"keptIdentifiers"].toArray();
    ASSERT_EQ(kept.size(), 3);
    EXPECT_EQ(kept[0].toObject(), (QJsonObject{{QStringLiteral("object"), QStringLiteral("1014h:0")},
                                               {QStringLiteral("identifier"), 0x86},
                                               {QStringLiteral("predefined"), 0x90}}));
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

// Node 6 as of a make whose description says this of its rates. It has 3010h:1, with 0 and 1.
class CliRates : public testing::Test
{
protected:
    CliRates()
        : bus(encoders())
    {}
    void describe(const QByteArray &rates)
    {
        QFile generic(QStringLiteral(CODEWHEEL_ROOT "/resources/devices/canopen-406-multi-turn.json"));
        ASSERT_TRUE(generic.open(QIODevice::ReadOnly));
        QByteArray json = generic.readAll();
        json.replace("\"key\": \"canopen-406-multi-turn\",",
                     "\"key\": \"rotor\", \"vendor\": \"Rotor Works\", \"vendorNumber\": \"10Dh\", "
                     "\"productNumber\": \"25h\", " +
                         rates + ',');
        ASSERT_TRUE(bus.catalog().add(json, QStringLiteral("rotor.json")));
    }
    int object()
    {
        return bus.runLine(QStringLiteral("od can:6 read 3010:1 --json")).json()[u"value"].toInt(-1);
    }

    SharedCanBus bus;

private:
    static std::vector<canopen::CanopenEncoderPlan> encoders()
    {
        auto encoders = canopen::trainingEncoders();
        encoders[1].quirks.speedIsOff = true;
        return encoders;
    }
};

TEST_F(CliRates, AreWrittenToTheObjectThatTheDescriptionNames)
{
    describe(
        R"("rateObject": "3010:1", "rates": [{"number": 0, "rate": 125000}, {"number": 1, "rate": 100000}])");
    EXPECT_EQ(bus.runLine(QStringLiteral("lss rate 100000 --of can:6")).exit, 2) << "nobody to ask";
    EXPECT_EQ(object(), 0);
    const CliRun run = bus.runLine(QStringLiteral("lss rate 100000 --of can:6 --yes"));
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("Its maker has the rate in 3010h:1: 1 stands for 100000 Bd."));
    EXPECT_THAT(run.out, HasSubstr("codewheel-cli od can:6 write 1010:1=save"));
    EXPECT_EQ(object(), 1);
    const CliRun wrong = bus.runLine(QStringLiteral("lss rate 500000 --of can:6 --yes"));
    EXPECT_EQ(wrong.exit, 2);
    EXPECT_THAT(wrong.err, HasSubstr("in Bd: 125000, 100000."));
}

// The simulated one takes the numbers of CiA 305 only.
TEST_F(CliRates, OfLssMayHaveOtherNumbers)
{
    describe(R"("rates": [{"number": 5, "rate": 100000}])");
    EXPECT_EQ(errorKey(bus.runLine(QStringLiteral("lss rate 100000 --of can:6 --yes --json"))), "lssRefused");
    EXPECT_EQ(bus.runLine(QStringLiteral("lss rate 250000 --of can:6 --yes")).exit, 0);
    EXPECT_EQ(errorKey(bus.runLine(QStringLiteral("lss rate 100000 --of can:5 --yes --json"))),
              "lssRateWrong")
        << "another device";
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/kinds/esc/shared_line.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;

class CliLineLedger : public testing::Test
{
protected:
    CliRun run(const char *what, const Person &person = {})
    {
        return m_line.runLine(QStringLiteral("%1 --ledger %2").arg(QString::fromLatin1(what), m_file),
                              person);
    }
    QJsonArray accounts() const
    {
        return runLine(QStringLiteral("ledger --json --ledger %1").arg(m_file)).json()[u"accounts"].toArray();
    }
    // An encoder like the others, but its manual allows only few writes.
    static Catalog withBudget()
    {
        Catalog catalog = Catalog::builtIn();
        QFile file(QStringLiteral(CODEWHEEL_ROOT "/resources/devices/kuebler-esc-rs485.json"));
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        QJsonObject device = QJsonDocument::fromJson(file.readAll()).object();
        device[QStringLiteral("key")] = QStringLiteral("few-writes");
        QJsonObject can = device[QStringLiteral("capabilities")].toObject();
        can[QStringLiteral("eepromBudget")] = 1;
        can[QStringLiteral("eepromLimit")] = 2;
        device[QStringLiteral("capabilities")] = can;
        const auto added = catalog.add(QJsonDocument(device).toJson(), QStringLiteral("few-writes.json"));
        EXPECT_TRUE(added) << added.error().place().toStdString() << added.error().reason.toStdString();
        return catalog;
    }

    SharedLine m_line{withBudget()};
    QTemporaryDir m_folder;
    QString m_file = m_folder.filePath(QStringLiteral("eeprom.sqlite"));
};

TEST_F(CliLineLedger, CountsWritesBySerialNumber)
{
    EXPECT_EQ(run("write 05 steps=864 --yes").exit, 0); // and the factor
    EXPECT_EQ(run("preset 05 1000").exit, 0);
    ASSERT_EQ(accounts().size(), 1);
    EXPECT_EQ(accounts()[0][u"countedBy"], QStringLiteral("serialNumber"));
    EXPECT_EQ(accounts()[0][u"place"], QStringLiteral("esc:05"));
    EXPECT_EQ(accounts()[0][u"writes"], 3);
    EXPECT_EQ(accounts()[0][u"perhaps"], 0);
}

TEST_F(CliLineLedger, CountsWhatIsTyped)
{
    EXPECT_EQ(run("terminal 05GD1 05P 05GD0 --yes").exit, 0);
    ASSERT_EQ(accounts().size(), 1);
    EXPECT_EQ(accounts()[0][u"writes"], 2);
}

TEST_F(CliLineLedger, WhatIsTypedForAllCountsForTheOneThatIsThere)
{
    m_line.mute(0x03);
    m_line.mute(0x12);
    EXPECT_EQ(run("terminal 00GD1 --yes").exit, 0);
    ASSERT_EQ(accounts().size(), 1);
    EXPECT_EQ(accounts()[0][u"countedBy"], QStringLiteral("serialNumber"));
    EXPECT_EQ(accounts()[0][u"writes"], 1);
    EXPECT_EQ(run("terminal 00GD0 --yes --device few-writes").exit, 0);
    const CliRun limited = run("terminal 00GD1 --yes --device few-writes");
    EXPECT_EQ(limited.exit, 1);
    EXPECT_THAT(limited.err, HasSubstr("esc:00"));
    EXPECT_FALSE(m_line.registers(0x05).countsCcw);
}

TEST_F(CliLineLedger, WhatIsTypedForAllIsNotSentWhereNobodyKnowsWhoIsThere)
{
    const CliRun several = run("terminal 00GD1 --yes");
    EXPECT_EQ(several.exit, 1);
    EXPECT_THAT(several.err, HasSubstr("it is not known which there are. Nothing was sent."));
    const CliRun person = run("terminal", {true, "07GD1\ny\n00GD1\ny\n00GD1\ny\n"});
    EXPECT_FALSE(m_line.registers(0x05).countsCcw) << person.out;
    EXPECT_THAT(run("terminal 05GD0 00GD1 --yes").err, HasSubstr("Nothing was sent."))
        << "there may be others beside the one that was asked for";
}

TEST_F(CliLineLedger, AWriteThatMayHaveBeenDoneCounts)
{
    m_line.unplugAfter("05GD");
    EXPECT_EQ(run("write 05 direction=ccw --yes").exit, 1);
    ASSERT_EQ(accounts().size(), 1);
    EXPECT_EQ(accounts()[0][u"writes"].toInt() + accounts()[0][u"perhaps"].toInt(), 1);
}

TEST_F(CliLineLedger, TheGatesAreThoseOfTheRing)
{
    EXPECT_EQ(run("write 05 direction=ccw --yes --device few-writes").exit, 0);
    // The budget of 1 is used up: --yes or a person has to answer.
    EXPECT_EQ(errorKey(run("preset 05 1000 --json --device few-writes")), "eepromBudgetUsed");
    const CliRun warned = run("terminal 05GD0 --yes --device few-writes");
    EXPECT_EQ(warned.exit, 0);
    EXPECT_THAT(warned.err, HasSubstr("are used up"));
    // Nothing is guaranteed beyond 2: the place has to be typed.
    EXPECT_EQ(errorKey(run("write 05 direction=ccw --yes --json --device few-writes")), "eepromLimitPassed");
    const CliRun typed = run("terminal 05GD1 --yes --device few-writes");
    EXPECT_EQ(typed.exit, 1);
    EXPECT_THAT(typed.err, HasSubstr("esc:05"));
    EXPECT_FALSE(m_line.registers(0x05).countsCcw);
    EXPECT_EQ(run("write 05 direction=ccw --yes --device few-writes --beyond-eeprom-limit esc:05").exit, 0);
    EXPECT_TRUE(m_line.registers(0x05).countsCcw);
}

} // namespace
} // namespace codewheel

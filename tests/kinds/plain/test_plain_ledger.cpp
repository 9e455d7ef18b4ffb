// SPDX-License-Identifier: GPL-3.0-or-later
// EEPROM writes where one step stores all that was taken.
#include "journal/eeprom_cost.h"
#include "journal/ledger_keeper.h"
#include "tests/kinds/plain/plain_calls.h"

#include <QJsonArray>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

const Job twoLines = WriteParameters{.values = {{Parameter::steps, 100},
                                                {Parameter::direction, 1},
                                                {Parameter::of(u"2000:1"), -5},
                                                {Parameter::of(u"1008"), Value(QStringLiteral("Hoist"))}},
                                     .previous = {{Parameter::steps, 4'096}}};

class PlainLedger : public testing::Test
{
protected:
    PlainLedger() { bus.setOperate(true); }

    CliRun run(const QString &line) { return test::callOn(bus, line, file); }
    QJsonArray listed(const QString &command, QStringView key) { return run(command).json()[key].toArray(); }
    void proceed(int steps)
    {
        for (int step = 0; step < steps; ++step) {
            bus.advance(5ms);
            encoder.proceed();
        }
        bus.advance(5ms);
    }

    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("ledger.sqlite"));
    const Catalog catalog = Catalog::builtIn();
    test::PlainBus bus{catalog};
    EncoderSession &encoder = *bus.encoder(test::plainHoist);
};

TEST_F(PlainLedger, ListsOneWriteWithItsPlace)
{
    EXPECT_EQ(run(QStringLiteral("write n:1 2000:1=-5 1008=Hoist steps=100 --yes")).exit, 0);
    EXPECT_EQ(bus.node(test::plainHoist).writes(), 1);
    const QJsonArray entries = listed(QStringLiteral("ledger entries --json"), u"entries");
    ASSERT_EQ(entries.size(), 1);
    EXPECT_EQ(entries[0][u"writes"], 1);
    EXPECT_EQ(entries[0][u"perhaps"], 0);
    EXPECT_EQ(entries[0][u"bus"], 9);
    EXPECT_EQ(entries[0][u"place"], QStringLiteral("n:1"));
    EXPECT_EQ(entries[0][u"device"], QStringLiteral("plain-node"));
    EXPECT_EQ(run(QStringLiteral("write n:1 steps=200 --yes")).exit, 0);
    const QJsonArray accounts = listed(QStringLiteral("ledger --json"), u"accounts");
    ASSERT_EQ(accounts.size(), 1);
    EXPECT_EQ(accounts[0][u"writes"], 2);
    EXPECT_EQ(accounts[0][u"place"], QStringLiteral("n:1"));
    EXPECT_THAT(run(QStringLiteral("ledger")).out, testing::HasSubstr("n:1"));
}

TEST_F(PlainLedger, APositionThatIsNotStoredIsNoWrite)
{
    EXPECT_EQ(mostEepromWrites(encoder, SetPreset{.value = 500}), 0);
    EXPECT_EQ(run(QStringLiteral("preset n:1 500 --yes")).exit, 0);
    EXPECT_TRUE(listed(QStringLiteral("ledger entries --json"), u"entries").isEmpty());
}

TEST_F(PlainLedger, ANoteBeforeTheFirstLineCountsTheStepThatStores)
{
    EXPECT_EQ(mostEepromWrites(encoder, twoLines), 1);
    EXPECT_EQ(mostEepromWrites(encoder, ReadParameters{{Parameter::steps}}), 0);
    const LedgerKeeper keeper(bus, DatabasePlace::memory());
    ASSERT_TRUE(encoder.start(twoLines, Pace::byHand));
    proceed(1); // set
    EXPECT_EQ(encoder.eepromCount().perhaps, 1);
    EXPECT_EQ(encoder.eepromCount().writes, 0);
    proceed(3); // set, go, keep
    bus.advance(100ms);
    EXPECT_FALSE(encoder.runningJob());
    EXPECT_EQ(encoder.eepromCount().writes, 1);
    EXPECT_EQ(encoder.eepromCount().perhaps, 0);
}

TEST_F(PlainLedger, GivingBackCostsOneWriteMore)
{
    const LedgerKeeper keeper(bus, DatabasePlace::memory());
    Progress progress;
    QObject::connect(&encoder, &EncoderSession::progressed, &bus,
                     [&](const Progress &now) { progress = now; });
    ASSERT_TRUE(encoder.start(twoLines, Pace::byHand));
    bus.advance(5ms);
    EXPECT_EQ(mostWritesToRestore(encoder, {}), 0);
    proceed(2); // set, set
    EXPECT_EQ(mostWritesToRestore(encoder, progress), 1) << "two lines, one step that stores";
    proceed(2); // go, keep
    encoder.cancel(OnCancel::restorePrevious);
    bus.advance(100ms);
    EXPECT_FALSE(encoder.runningJob());
    EXPECT_EQ(encoder.eepromCount().writes, bus.node(test::plainHoist).writes());
    EXPECT_EQ(encoder.eepromCount().perhaps, 0);
}

} // namespace
} // namespace codewheel

// SPDX-License-Identifier: GPL-3.0-or-later
// Writes to the encoders of a serial line, on the simulated one.
#include "catalog/catalog.h"
#include "journal/ledger_keeper.h"
#include "kinds/esc/driver/esc_driver.h"
#include "kinds/esc/line/esc_line_session.h"
#include "kinds/esc/simulator/simulated_esc_line_link.h"
#include "tests/journal/journal_file.h"

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using test::JournalFile;

constexpr Place three = placeOnLine({0x03});
constexpr Place five = placeOnLine({0x05});
const QString rs485 = QStringLiteral("kuebler-esc-rs485");

class LineLedgerTest : public testing::Test
{
protected:
    LineLedgerTest()
    {
        EXPECT_TRUE(line.open({}, {}, EscLineSession::Start::operating, EscLineSession::Drive::byHand));
        add(five);
    }

    void add(Place place)
    {
        ASSERT_TRUE(line.add(EscLineAddress::of(place.node), rs485));
        line.advance(1s);
    }
    void keep(const DatabasePlace &place) { keeper = std::make_unique<LedgerKeeper>(line, place); }
    void run(Place place, const Job &job)
    {
        EncoderSession &encoder = *line.encoder(place);
        ASSERT_TRUE(encoder.start(job));
        for (int i = 0; i < 1'000 && encoder.runningJob(); ++i)
            line.advance(10ms);
        ASSERT_FALSE(encoder.runningJob());
    }
    void write(Place place, Parameter parameter, std::int64_t value)
    {
        run(place, WriteParameters{.values = {{parameter, value}}, .previous = {}});
    }
    EepromCount countAt(Place place) { return line.encoder(place)->eepromCount(); }
    EepromCount onDisk(Place place) { return Ledger::open(file.place())->writes(keeper->identity(place)); }

    const Catalog catalog = Catalog::builtIn();
    const std::shared_ptr<SimulatedEscLine> simulated = std::make_shared<SimulatedEscLine>();
    EscLineSession line{std::make_unique<SimulatedEscLineLink>(simulated), catalog,
                        QDateTime(QDate(2026, 3, 1), QTime(14, 2)),
                        [](const DeviceDescription &device, EscLineAddress address) {
                            return std::make_unique<EscDriver>(device, address);
                        }};
    const JournalFile file;
    std::unique_ptr<LedgerKeeper> keeper;
};

TEST_F(LineLedgerTest, CountsEachAcceptedWriteBySerialNumber)
{
    keep(DatabasePlace::memory());
    EXPECT_EQ(countAt(five).by, CountedBy::serialNumber);
    write(five, Parameter::direction, 1);
    EXPECT_EQ(countAt(five).writes, 1);
    write(five, Parameter::steps, 1'000); // and the scaling factor
    EXPECT_EQ(countAt(five).writes, 3);
    EXPECT_EQ(countAt(five).perhaps, 0);
    run(five, SetPreset{.value = 4'660});
    EXPECT_EQ(countAt(five).writes, 4);
    EXPECT_EQ(countAt(five).since.toLocalTime().date(), QDate(2026, 3, 1));
}

TEST_F(LineLedgerTest, CountsNoWriteThatWasRefused)
{
    keep(DatabasePlace::memory());
    line.send(
        {.to = EscLineAddress::of(five.node), .command = esc::Command::writeRevolutions, .data = 0}); // 05
    line.advance(1s);
    EXPECT_EQ(countAt(five).atMost(), 0);
    EXPECT_TRUE(keeper->ledger()->accounts().empty());
}

TEST_F(LineLedgerTest, NotesAJobWithItsFactorBeforeItSendsAnything)
{
    keep(file.place());
    ASSERT_TRUE(
        line.encoder(five)->start(WriteParameters{.values = {{Parameter::steps, 1'000}}, .previous = {}}));
    EXPECT_EQ(onDisk(five).perhaps, 2);
}

TEST_F(LineLedgerTest, NotesATypedWriteBeforeItIsSent)
{
    keep(file.place());
    line.send({.to = EscLineAddress::of(five.node), .command = esc::Command::writeDirection, .data = 1});
    EXPECT_EQ(onDisk(five).perhaps, 1);
    EXPECT_EQ(countAt(five).perhaps, 0); // it is under way
    line.advance(1s);
    EXPECT_EQ(onDisk(five).writes, 1);
    EXPECT_EQ(onDisk(five).perhaps, 0);
    const auto entries = keeper->ledger()->valuesBefore(keeper->identity(five));
    ASSERT_EQ(entries.size(), 1U);
    EXPECT_EQ(entries[0].written, (ParameterValues{{Parameter::direction, 1}}));
    EXPECT_TRUE(entries[0].settled);
}

TEST_F(LineLedgerTest, ATypedReadCostsNothing)
{
    keep(DatabasePlace::memory());
    line.send({.to = EscLineAddress::of(five.node), .command = esc::Command::version});
    EXPECT_TRUE(keeper->ledger()->accounts().empty());
}

TEST_F(LineLedgerTest, ATypedWriteThatIsNotAnsweredMayHaveBeenCarriedOut)
{
    keep(DatabasePlace::memory());
    simulated->setSilent(true);
    line.send({.to = EscLineAddress::of(five.node), .command = esc::Command::writeDirection, .data = 1});
    line.advance(1s);
    EXPECT_EQ(countAt(five).writes, 1);
}

TEST_F(LineLedgerTest, WhatWasTypedAndDroppedCostsNothing)
{
    keep(DatabasePlace::memory());
    line.send({.to = EscLineAddress::of(five.node), .command = esc::Command::writeDirection, .data = 1});
    line.alarmStop();
    line.advance(1s);
    EXPECT_TRUE(keeper->ledger()->accounts().empty());
    line.setOperate(false);
    line.send({.to = EscLineAddress::of(five.node), .command = esc::Command::writeDirection, .data = 1});
    line.advance(1s);
    EXPECT_TRUE(keeper->ledger()->accounts().empty());
}

TEST_F(LineLedgerTest, AtTheMasterAddressAWriteIsEachEncoders)
{
    add(three);
    keep(DatabasePlace::memory());
    line.send({.to = EscLineAddress::master(), .command = esc::Command::writeDirection, .data = 1});
    line.advance(1s);
    EXPECT_EQ(countAt(three).atMost(), 1);
    EXPECT_EQ(countAt(five).atMost(), 1);
}

// Whatever its own address: an encoder at the master address is the only one.
TEST_F(LineLedgerTest, AWriteToAnyAddressIsOfTheEncoderThatIsAlone)
{
    for (const std::uint8_t other : {std::uint8_t{0x03}, std::uint8_t{0x12}})
        simulated->withEncoder({other},
                               [](SimulatedEscEncoder &encoder) { encoder.condition().mute = true; });
    ASSERT_TRUE(line.remove(five));
    const Place alone = placeOnLine(EscLineAddress::master());
    add(alone);
    keep(DatabasePlace::memory());
    EXPECT_EQ(countAt(alone).by, CountedBy::serialNumber);
    write(alone, Parameter::direction, 1);
    line.send({.to = EscLineAddress::of(five.node), .command = esc::Command::writeDirection, .data = 0});
    line.advance(1s);
    EXPECT_EQ(countAt(alone).writes, 2);
    EXPECT_EQ(keeper->ledger()->accounts().size(), 1U);
}

TEST_F(LineLedgerTest, AWriteToAnAddressNobodyHasTakenOverIsItsEncodersOnceItIs)
{
    keep(file.place());
    line.send({.to = EscLineAddress::of(three.node), .command = esc::Command::writeDirection, .data = 1});
    EXPECT_EQ(onDisk(three).perhaps, 1); // before it is sent
    line.advance(1s);
    EXPECT_EQ(onDisk(three).writes, 1);
    EXPECT_EQ(onDisk(three).perhaps, 0);
    add(three);
    EXPECT_EQ(countAt(three).by, CountedBy::serialNumber);
    EXPECT_EQ(countAt(three).writes, 1);
    write(three, Parameter::direction, 0);
    EXPECT_EQ(countAt(three).writes, 2);
    EXPECT_EQ(keeper->ledger()->accounts().size(), 1U);
}

// Whatever is at that address on the first line.
TEST_F(LineLedgerTest, AWriteToAnAddressOfASecondLineIsOfThatLine)
{
    EscLineSession second(
        std::make_unique<SimulatedEscLineLink>(std::make_shared<SimulatedEscLine>()), catalog,
        QDateTime(QDate(2026, 3, 1), QTime(14, 2)),
        [](const DeviceDescription &device, EscLineAddress address) {
            return std::make_unique<EscDriver>(device, address);
        },
        nullptr, BusId{4});
    ASSERT_TRUE(second.open({}, {}, EscLineSession::Start::operating, EscLineSession::Drive::byHand));
    const LedgerKeeper itsKeeper(second, DatabasePlace::memory());
    second.send({.to = EscLineAddress::of(three.node), .command = esc::Command::writeDirection, .data = 1});
    second.advance(1s);
    EXPECT_EQ(itsKeeper.ledger()->writes(itsKeeper.identity(second.placeOf(three.node))).writes, 1);
}

TEST_F(LineLedgerTest, AWriteAnsweredAfterItsEncoderWasNamedIsNotLost)
{
    keep(file.place());
    line.send({.to = EscLineAddress::of(five.node), .command = esc::Command::writeDirection, .data = 1});
    ASSERT_TRUE(line.name(five, rs485));
    line.advance(1s);
    EXPECT_EQ(onDisk(five).writes, 1);
    EXPECT_EQ(onDisk(five).perhaps, 0);
}

TEST_F(LineLedgerTest, AWriteAnsweredAfterItsEncoderWasTakenOverIsNotLost)
{
    keep(DatabasePlace::memory());
    line.send({.to = EscLineAddress::of(three.node), .command = esc::Command::writeDirection, .data = 1});
    add(three);
    EXPECT_GE(countAt(three).writes, 1); // the session may have seen it too: better twice than never
    EXPECT_EQ(countAt(three).perhaps, 0);
}

TEST_F(LineLedgerTest, ARefusedWriteToAnAddressNobodyHasTakenOverCostsNothing)
{
    keep(DatabasePlace::memory());
    line.send(
        {.to = EscLineAddress::of(three.node), .command = esc::Command::writeRevolutions, .data = 0}); // 05
    line.advance(1s);
    line.setOperate(false);
    line.send(
        {.to = EscLineAddress::of(three.node), .command = esc::Command::writeDirection, .data = 1}); // Watch
    line.advance(1s);
    EXPECT_TRUE(keeper->ledger()->accounts().empty());
}

TEST_F(LineLedgerTest, AWriteToAnAddressNobodyHasTakenOverThatIsNotAnsweredMayHaveBeenCarriedOut)
{
    keep(DatabasePlace::memory());
    simulated->setSilent(true);
    line.send({.to = EscLineAddress::of(three.node), .command = esc::Command::writeDirection, .data = 1});
    line.advance(1s);
    EXPECT_EQ(keeper->ledger()->writes(keeper->identity(three)).writes, 0);
    EXPECT_EQ(keeper->ledger()->writes(keeper->identity(three)).perhaps, 1);
}

TEST_F(LineLedgerTest, AWriteTornByUnpluggingCounts)
{
    keep(file.place());
    ASSERT_TRUE(
        line.encoder(five)->start(WriteParameters{.values = {{Parameter::direction, 1}}, .previous = {}}));
    std::optional<Outcome> outcome;
    QObject::connect(line.encoder(five), &EncoderSession::finished, &line,
                     [&](const Outcome &ended) { outcome = ended; });
    const auto isSent = [&] {
        bool sent = false;
        simulated->withEncoder(EscLineAddress::of(five.node),
                               [&](SimulatedEscEncoder &encoder) { sent = encoder.registers().countsCcw; });
        return sent;
    };
    while (!isSent())
        line.advance(100us);
    simulated->setUnplugged(true); // before the answer has passed
    line.advance(50ms);
    ASSERT_TRUE(outcome);
    EXPECT_EQ(outcome->result.error().id, RefusalId::stoppedInWrite);
    EXPECT_EQ(onDisk(five).writes, 1);
    EXPECT_EQ(line.encoder(five)->known(Parameter::direction), std::nullopt);
}

TEST_F(LineLedgerTest, AnEncoderWithAnotherAddressIsTheSame)
{
    keep(DatabasePlace::memory());
    write(five, Parameter::direction, 1);
    write(five, Parameter::lineAddress, 7);
    constexpr Place seven = placeOnLine({0x07});
    ASSERT_NE(line.encoder(seven), nullptr);
    EXPECT_EQ(countAt(seven).writes, 2);
    write(seven, Parameter::direction, 0);
    EXPECT_EQ(countAt(seven).writes, 3);
    EXPECT_EQ(keeper->ledger()->accounts().size(), 1U);
}

TEST_F(LineLedgerTest, OthersGoOnWhileEncodersComeAndGo)
{
    keep(DatabasePlace::memory());
    write(five, Parameter::direction, 1);
    add(three);
    EXPECT_EQ(countAt(five).writes, 1);
    write(three, Parameter::direction, 1);
    ASSERT_TRUE(line.remove(three));
    write(five, Parameter::direction, 0);
    EXPECT_EQ(countAt(five).writes, 2);
    EXPECT_EQ(keeper->ledger()->accounts().size(), 2U);
}

TEST_F(LineLedgerTest, AnEncoderThatWasSilentIsNotTakenForTheSameBeforeItTellsItsNumber)
{
    keep(DatabasePlace::memory());
    simulated->setSilent(true);
    line.advance(3s);
    ASSERT_EQ(line.encoder(five)->latest().state, EncoderState::silent);
    simulated->setSilent(false);
    std::vector<CountedBy> seen;
    QObject::connect(line.encoder(five), &EncoderSession::eepromCountChanged, &line,
                     [&] { seen.push_back(countAt(five).by); });
    line.advance(3s);
    EXPECT_EQ(seen, (std::vector{CountedBy::place, CountedBy::serialNumber}));
}

} // namespace
} // namespace codewheel

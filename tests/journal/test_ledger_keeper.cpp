// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/word_channel.h"
#include "catalog/catalog.h"
#include "journal/eeprom_cost.h"
#include "journal/ledger_keeper.h"
#include "kinds/interbus/ring/ring_session.h"
#include "kinds/interbus/simulator/training_bus.h"
#include "tests/journal/journal_file.h"
#include "tests/support/places.h"

#include <QFile>
#include <QTemporaryDir>

namespace codewheel {
namespace {

using test::JournalFile;

constexpr Place fraba = "1.0"_ring;
constexpr Place baumer = "2.0"_ring;

class LedgerKeeperTest : public testing::Test
{
protected:
    LedgerKeeperTest()
    {
        EXPECT_TRUE(bus.open(RingSession::Start::operating));
        bus.advance(10);
        bus.encoder(fraba)->tell(Parameter::startUpMode, 1); // position mode
    }

    void run(Place place, const Job &job)
    {
        EncoderSession &encoder = *bus.encoder(place);
        ASSERT_TRUE(encoder.start(job));
        for (int i = 0; i < 1'000 && encoder.runningJob(); ++i)
            bus.advance(10);
        ASSERT_FALSE(encoder.runningJob());
    }
    void write(Place place, std::int64_t steps)
    {
        run(place, WriteParameters{.values = {{Parameter::steps, steps}}, .previous = {}});
    }
    void readSerialNumber() { run(fraba, ReadParameters{{Parameter::serialNumber}}); }
    EepromCount countAt(Place place) { return bus.encoder(place)->eepromCount(); }
    void keep(const DatabasePlace &place)
    {
        keeper = std::make_unique<LedgerKeeper>(bus, place);
        QObject::connect(keeper.get(), &LedgerKeeper::messaged, keeper.get(),
                         [this](const Message &message) { messages.push_back(message); });
    }

    const Catalog catalog = Catalog::builtIn();
    TrainingBus training = makeTrainingBus(catalog);
    RingSession bus{std::move(training.link), catalog, QDateTime(QDate(2026, 3, 1), QTime(14, 2))};
    const JournalFile file;
    std::vector<Message> messages;
    std::unique_ptr<LedgerKeeper> keeper;
};

TEST_F(LedgerKeeperTest, CountsWhatAJobWrites)
{
    keep(DatabasePlace::memory());
    EXPECT_EQ(countAt(fraba).writes, 0);
    write(fraba, 255);
    EXPECT_EQ(countAt(fraba).writes, 1);
    EXPECT_EQ(countAt(fraba).perhaps, 0);
    EXPECT_EQ(countAt(fraba).by, CountedBy::place);
    EXPECT_EQ(countAt(fraba).since.toLocalTime().date(), QDate(2026, 3, 1));
    EXPECT_EQ(countAt(baumer).writes, 0);
}

// A cam that an earlier job has set is stored once its program is left, perhaps when nobody looks any more.
TEST_F(LedgerKeeperTest, WhatIsInDoubtAfterAJobThatWritesNothingIsCounted)
{
    keep(DatabasePlace::memory());
    run(fraba, SwitchMode{Mode::cam, 1});
    run(fraba, SendWords{{0x4600'0015, 0x8000'0000, 0}});
    ASSERT_EQ(countAt(fraba).atMost(), 0);
    EncoderSession &encoder = *bus.encoder(fraba);
    InDoubt doubt;
    QObject::connect(&encoder, &EncoderSession::finished, &encoder,
                     [&](const Outcome &outcome) { doubt = outcome.inDoubt; });
    ASSERT_TRUE(encoder.start(ReadParameters{{Parameter::steps}}));
    bus.advance(1);
    bus.setRunning(false);
    bus.advance(10);
    ASSERT_EQ(doubt.eepromWrites, 1);
    EXPECT_EQ(countAt(fraba).perhaps, 1);
}

// What a read value settles is its own write: that of a cam program, say, stays in doubt.
TEST_F(LedgerKeeperTest, AWriteInDoubtIsSettledOnlyByTheValueThatItIsOf)
{
    struct
    {
        std::vector<Parameter> uncounted;
        int writes;
        int perhaps;
    } const rows[] = {{{Parameter::steps}, 2, 0}, {{}, 1, 1}};
    for (const auto &row : rows) {
        keep(DatabasePlace::memory());
        write(fraba, 255);
        Outcome cut;
        cut.inDoubt = {.values = {{Parameter::steps, 255}}, .eepromWrites = 1, .uncounted = row.uncounted};
        Q_EMIT bus.encoder(fraba)->finished(cut);
        EXPECT_EQ(countAt(fraba).perhaps, 1);
        run(fraba, ReadParameters{{Parameter::steps}});
        EXPECT_EQ(countAt(fraba).writes, row.writes);
        EXPECT_EQ(countAt(fraba).perhaps, row.perhaps);
        write(fraba, 256);
    }
}

// In another run, it may have been this encoder.
TEST_F(LedgerKeeperTest, WhatWasCountedByThePlaceIsNotLostWithTheSerialNumber)
{
    keep(file.place());
    write(fraba, 255);
    ASSERT_EQ(countAt(fraba).writes, 1);
    keeper.reset();
    keep(file.place());
    readSerialNumber();
    EXPECT_EQ(countAt(fraba).by, CountedBy::serialNumber);
    EXPECT_EQ(countAt(fraba).writes, 0);
    EXPECT_EQ(countAt(fraba).atPlace, 1);
    EXPECT_EQ(countAt(fraba).atMost(), 1);
    EXPECT_TRUE(countAt(fraba).since.isValid());
    EXPECT_TRUE(eepromCountText(countAt(fraba)).contains(QStringLiteral("counted by its place before")));
}

// What was written to the previous encoder is not the new one's; and whoever takes the replacement back has
// the one that was written to, whatever it was called meanwhile.
TEST_F(LedgerKeeperTest, AReplacementLeavesTheCountToThePreviousEncoder)
{
    keep(DatabasePlace::memory());
    write(fraba, 255);
    write(fraba, 256);
    ASSERT_EQ(countAt(fraba).writes, 2);
    ASSERT_TRUE(bus.replace(fraba, QStringLiteral("fraba-ocd-ib"), 4096, 8192));
    keeper->setLabel(fraba, QStringLiteral("99999"));
    EXPECT_EQ(countAt(fraba).by, CountedBy::labelSerialNumber);
    EXPECT_EQ(countAt(fraba).writes, 0);
    write(fraba, 257);
    EXPECT_EQ(countAt(fraba).writes, 1);
    EXPECT_EQ(countAt(fraba).atPlace, 2) << "perhaps: nobody knows whom the place meant";
    keeper->setLabel(fraba, {});
    EXPECT_EQ(countAt(fraba).by, CountedBy::place);
    EXPECT_EQ(countAt(fraba).writes, 3);
    keeper->setLabel(fraba, QStringLiteral("99999"));
    EXPECT_EQ(countAt(fraba).writes, 1);
}

TEST_F(LedgerKeeperTest, AJobThatWaitsForItsFirstStepHasWrittenNothing)
{
    keep(DatabasePlace::memory());
    EncoderSession &encoder = *bus.encoder(fraba);
    bool waits = false;
    QObject::connect(&encoder, &EncoderSession::progressed, &encoder,
                     [&](const Progress &progress) { waits = progress.waitsForUser; });
    ASSERT_TRUE(
        encoder.start(WriteParameters{.values = {{Parameter::steps, 255}}, .previous = {}}, Pace::byHand));
    bus.advance(50);
    ASSERT_TRUE(waits);
    ASSERT_EQ(bus.channel(fraba)->out(), 0U);
    EXPECT_EQ(countAt(fraba).atMost(), 0);
}

// What it has sent so far may have been written, whatever it does next.
TEST_F(LedgerKeeperTest, AJobThatWaitsForItsUserCountsAsPerhaps)
{
    keep(DatabasePlace::memory());
    EncoderSession &encoder = *bus.encoder(fraba);
    ASSERT_TRUE(
        encoder.start(WriteParameters{.values = {{Parameter::steps, 255}}, .previous = {}}, Pace::byHand));
    bus.advance(50);
    for (int i = 0; i < 10 && encoder.latest().state != EncoderState::parameterization; ++i) {
        encoder.proceed();
        bus.advance(200);
    }
    ASSERT_EQ(encoder.latest().state, EncoderState::parameterization);
    ASSERT_TRUE(encoder.runningJob());
    EXPECT_EQ(countAt(fraba).atMost(), 1);
    encoder.cancel(OnCancel::runWithWhatItHas);
    for (int i = 0; i < 100 && encoder.runningJob(); ++i)
        bus.advance(50);
    EXPECT_EQ(countAt(fraba).writes, 1);
    EXPECT_EQ(countAt(fraba).perhaps, 0);
}

// It may be the one that was written to.
TEST_F(LedgerKeeperTest, WhileItIsAskedWhetherItIsTheSameItsWritesCountAsPerhaps)
{
    keep(file.place());
    readSerialNumber();
    write(fraba, 255);
    ASSERT_EQ(countAt(fraba).by, CountedBy::serialNumber);
    const std::int64_t number = bus.encoder(fraba)->known(Parameter::serialNumber)->value.number();
    keeper.reset();
    TrainingBus another = makeTrainingBus(catalog);
    bus.useLink(std::move(another.link), bus.dateTime(bus.now()));
    ASSERT_TRUE(bus.open(RingSession::Start::operating));
    bus.advance(10);
    keep(file.place());
    EncoderSession &encoder = *bus.encoder(fraba);
    EXPECT_EQ(countAt(fraba).by, CountedBy::place);
    EXPECT_EQ(countAt(fraba).atMost(), 0);
    encoder.setKnownBefore(
        KnownBefore{.values = {{.parameter = Parameter::steps, .value = 255}}, .serialNumber = number});
    EXPECT_EQ(countAt(fraba).writes, 0);
    EXPECT_EQ(countAt(fraba).perhaps, 1);
    encoder.setKnownBefore({});
    EXPECT_EQ(countAt(fraba).atMost(), 0) << "another one";
}

TEST_F(LedgerKeeperTest, CountsWordsByHand)
{
    keep(DatabasePlace::memory());
    for (const Word word : {0x020000FFU, 0x80000000U, 0U}) {
        bus.channel(fraba)->stage(word);
        ASSERT_TRUE(bus.channel(fraba)->write());
        bus.advance(50);
    }
    EXPECT_EQ(countAt(fraba).writes, 1);
    EXPECT_EQ(countAt(fraba).perhaps, 0);
}

TEST_F(LedgerKeeperTest, NotesAWordByHandBeforeItIsSent)
{
    keep(file.place());
    bus.encoder(fraba)->tell(Parameter::steps, 8'192); // something to keep
    const auto noted = [&] { return Ledger::open(file.place())->writes(keeper->identity(fraba)); };
    const auto send = [&](Word word) {
        bus.channel(fraba)->stage(word);
        ASSERT_TRUE(bus.channel(fraba)->write());
    };
    send(0x020000FF);
    EXPECT_EQ(bus.channel(fraba)->out(), 0U);
    EXPECT_EQ(noted().perhaps, 1);
    EXPECT_EQ(countAt(fraba).perhaps, 1) << "from the moment it may be written";
    bus.advance(50);
    send(0x04000002);
    EXPECT_EQ(noted().atMost(), 2);
    bus.advance(50);
    EXPECT_EQ(noted().writes, 1); // the first one, when it left OUT
    send(0x80000000);
    bus.advance(50);
    send(0);
    bus.advance(50);
    EXPECT_EQ(noted().writes, 2);
    EXPECT_EQ(noted().perhaps, 0);
    EXPECT_FALSE(keeper->ledger()->valuesBefore(keeper->identity(fraba))[0].settled);
    for (int i = 0; i < 11; ++i)
        bus.advance(100);
    const Ledger::Entry entry = keeper->ledger()->valuesBefore(keeper->identity(fraba))[0];
    EXPECT_TRUE(entry.settled);
    EXPECT_EQ(entry.written, (ParameterValues{{Parameter::steps, 255}, {Parameter::revolutions, 2}}));
    EXPECT_EQ(keeper->ledger()->accounts()[0].count.writes, 2);
}

// 0x46000015 is refused in position mode: nothing was stored.
TEST_F(LedgerKeeperTest, ForgetsAWordByHandThatStoredNothing)
{
    keep(file.place());
    for (const Word word : {0x46000015U, 0x80000000U, 0U}) {
        bus.channel(fraba)->stage(word);
        ASSERT_TRUE(bus.channel(fraba)->write());
        bus.advance(50);
    }
    EXPECT_EQ(Ledger::open(file.place())->writes(keeper->identity(fraba)).perhaps, 1);
    for (int i = 0; i < 11; ++i)
        bus.advance(100);
    EXPECT_TRUE(keeper->ledger()->accounts().empty());
}

TEST_F(LedgerKeeperTest, AWordThatStillStandsMayBeStoredAfterwards)
{
    keep(file.place());
    bus.channel(fraba)->stage(0x020000FF);
    ASSERT_TRUE(bus.channel(fraba)->write());
    bus.advance(3'000);
    const EncoderIdentity identity = keeper->identity(fraba);
    keeper.reset();
    EXPECT_EQ(Ledger::open(file.place())->writes(identity).perhaps, 1);
}

TEST_F(LedgerKeeperTest, NotesWhatRestoringWillWriteBeside)
{
    keep(file.place());
    EncoderSession &encoder = *bus.encoder(fraba);
    ASSERT_TRUE(
        encoder.start(WriteParameters{.values = {{Parameter::steps, 255}, {Parameter::revolutions, 1}},
                                      .previous = {{Parameter::steps, 8192}}},
                      Pace::byHand));
    const auto noted = [&] { return Ledger::open(file.place())->writes(keeper->identity(fraba)).atMost(); };
    Progress progress;
    QObject::connect(&encoder, &EncoderSession::progressed, keeper.get(),
                     [&](const Progress &now) { progress = now; });
    for (int i = 0; i < 10 && progress.confirmed.empty(); ++i) {
        bus.advance(100);
        encoder.proceed();
    }
    EXPECT_EQ(noted(), 2);
    encoder.cancel(OnCancel::restorePrevious);
    EXPECT_GE(noted(), 3);
    for (int i = 0; i < 100 && encoder.runningJob(); ++i)
        bus.advance(10);
    EXPECT_EQ(noted(), 2); // steps, and the previous steps
    EXPECT_EQ(countAt(fraba).perhaps, 0);
}

TEST_F(LedgerKeeperTest, SaysSoWhereWhatRestoringWillWriteCannotBeNoted)
{
    keep(file.place());
    EncoderSession &encoder = *bus.encoder(fraba);
    ASSERT_TRUE(
        encoder.start(WriteParameters{.values = {{Parameter::steps, 255}, {Parameter::revolutions, 1}},
                                      .previous = {{Parameter::steps, 8192}}},
                      Pace::byHand));
    Progress progress;
    QObject::connect(&encoder, &EncoderSession::progressed, keeper.get(),
                     [&](const Progress &now) { progress = now; });
    for (int i = 0; i < 10 && progress.confirmed.empty(); ++i) {
        bus.advance(100);
        encoder.proceed();
    }
    ASSERT_TRUE(messages.empty());
    file.execute(QStringLiteral("CREATE TRIGGER full BEFORE UPDATE ON entry BEGIN "
                                "SELECT raise(ABORT, 'no room'); END"));
    encoder.cancel(OnCancel::restorePrevious);
    ASSERT_EQ(messages.size(), 1U) << "before anything is restored";
    EXPECT_EQ(messages[0].id, MessageId::keptBeside);
    for (int i = 0; i < 100 && encoder.runningJob(); ++i)
        bus.advance(10);
    EXPECT_FALSE(encoder.runningJob());
    EXPECT_EQ(encoder.known(Parameter::steps)->value, 8192) << "it is restored all the same";
    EXPECT_EQ(messages.size(), 1U);
}

// The confirmation is on its way from the bus when the encoder is named.
TEST_F(LedgerKeeperTest, CountsWhatComesWhileADeviceIsNamed)
{
    keep(DatabasePlace::memory());
    bus.channel(fraba)->stage(0x020000FF);
    ASSERT_TRUE(bus.channel(fraba)->write());
    bus.advance(50);
    bus.channel(fraba)->stage(0x80000000);
    bool wasNamed = false;
    QObject::connect(&bus, &RingSession::updated, &bus, [&] {
        if (!std::exchange(wasNamed, true)) {
            EXPECT_TRUE(bus.name(fraba, QStringLiteral("fraba-ocd-ib")));
        }
    });
    ASSERT_TRUE(bus.channel(fraba)->write());
    bus.advance(50);
    EXPECT_TRUE(wasNamed);
    bus.advance(50);
    EXPECT_EQ(countAt(fraba).writes, 1);
    EXPECT_EQ(bus.encoder(fraba)->eepromWrites(), 1);
}

TEST_F(LedgerKeeperTest, NotesAJobBeforeItSendsAnything)
{
    keep(file.place());
    ASSERT_TRUE(bus.encoder(fraba)->start(
        WriteParameters{.values = {{Parameter::steps, 255}, {Parameter::revolutions, 1}}, .previous = {}}));
    const auto other = Ledger::open(file.place()); // as after a crash
    ASSERT_TRUE(other);
    EXPECT_EQ(other->writes(keeper->identity(fraba)).perhaps, 2);
    EXPECT_EQ(countAt(fraba).perhaps, 0); // it may still end well
    EXPECT_EQ(bus.channel(fraba)->out(), 0U);
}

// By hand it stands in OUT until the user goes on, and is counted when it leaves.
TEST_F(LedgerKeeperTest, AnAlarmStopCountsAConfirmedValueInTheOutcomeToo)
{
    keep(DatabasePlace::memory());
    EncoderSession &encoder = *bus.encoder(fraba);
    std::optional<Outcome> outcome;
    bool isConfirmed = false;
    QObject::connect(&encoder, &EncoderSession::finished, &encoder,
                     [&](const Outcome &its) { outcome = its; });
    QObject::connect(&encoder, &EncoderSession::progressed, &encoder,
                     [&](const Progress &progress) { isConfirmed = !progress.confirmed.empty(); });
    ASSERT_TRUE(
        encoder.start(WriteParameters{.values = {{Parameter::steps, 255}}, .previous = {}}, Pace::byHand));
    for (int i = 0; i < 100 && !isConfirmed; ++i) {
        encoder.proceed();
        bus.advance(50);
    }
    ASSERT_TRUE(isConfirmed);
    bus.alarmStop();
    bus.advance(50);
    ASSERT_TRUE(outcome);
    EXPECT_EQ(outcome->eepromWrites, 1);
    EXPECT_EQ(countAt(fraba).writes, 1);
}

TEST_F(LedgerKeeperTest, GivesWhatWasWrittenToTheEncoderThatTellsItsSerialNumber)
{
    keep(file.place());
    write(fraba, 255);
    readSerialNumber();
    EXPECT_EQ(countAt(fraba).by, CountedBy::serialNumber);
    EXPECT_EQ(countAt(fraba).writes, 1);
    EXPECT_EQ(keeper->ledger()->accounts().size(), 1U);
    write(fraba, 256);
    EXPECT_EQ(countAt(fraba).writes, 2);
}

TEST_F(LedgerKeeperTest, SaysThatTheSerialNumberIsAnotherThanThatOfTheLabel)
{
    keep(DatabasePlace::memory());
    keeper->setLabel(fraba, QStringLiteral("20417"));
    readSerialNumber();
    EXPECT_TRUE(messages.empty());
    bus.encoder(fraba)->tell(Parameter::serialNumber, 1);
    keeper->setLabel(fraba, QStringLiteral("77777"));
    readSerialNumber();
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_EQ(messages.front().id, MessageId::serialNumberDiffers);
    EXPECT_EQ(messages.front().arguments,
              (std::vector<RefusalArgument>{QStringLiteral("77777"), QStringLiteral("20417")}));
}

// The link was lost, another project is opened, and nobody has said whether it is the same encoder.
TEST_F(LedgerKeeperTest, WhatWasWrittenBeforeALostLinkIsDoubtUntilTheUserSaysWhoseItIs)
{
    keep(DatabasePlace::memory());
    keeper->setProject(QStringLiteral("/night.codewheel"));
    write(fraba, 255);
    Q_EMIT bus.meetsAgain();
    keeper->setProject(QStringLiteral("/other.codewheel"));
    readSerialNumber();
    EXPECT_EQ(countAt(fraba).by, CountedBy::serialNumber);
    EXPECT_EQ(countAt(fraba).writes, 0);
    EXPECT_EQ(countAt(fraba).atMost(), 1);
    bus.encoder(fraba)->setKnownBefore(
        KnownBefore{.values = {{.parameter = Parameter::steps, .value = 255}}});
    bus.encoder(fraba)->takeKnownBefore();
    EXPECT_EQ(countAt(fraba).writes, 1);
    EXPECT_EQ(countAt(fraba).atMost(), 1);
}

TEST_F(LedgerKeeperTest, RemembersTheEncoderFromBefore)
{
    keep(file.place());
    write(fraba, 255);
    readSerialNumber();
    keeper.reset();
    bus.encoder(fraba)->setEepromCount({});
    keep(file.place());
    EXPECT_EQ(countAt(fraba).writes, 1);
}

TEST_F(LedgerKeeperTest, CountsByTheLabelWhereNothingWasRead)
{
    keep(DatabasePlace::memory());
    write(baumer, 4'096);
    keeper->setLabel(baumer, QStringLiteral(" 0815 "));
    EXPECT_EQ(countAt(baumer).by, CountedBy::labelSerialNumber);
    EXPECT_EQ(countAt(baumer).serialNumber, QStringLiteral("0815"));
    EXPECT_EQ(countAt(baumer).writes, 1);
    keeper->setLabel(baumer, {});
    EXPECT_EQ(countAt(baumer).by, CountedBy::place);
}

TEST_F(LedgerKeeperTest, CountsPlacesOfAProjectForThemselves)
{
    keep(DatabasePlace::memory());
    keeper->setProject(QStringLiteral("/plant.codewheel"));
    write(baumer, 4'096);
    EXPECT_EQ(countAt(baumer).writes, 1);
    keeper->setProject(QStringLiteral("/other.codewheel"));
    EXPECT_EQ(countAt(baumer).writes, 0);
    keeper->setProject(QStringLiteral("/plant.codewheel"));
    EXPECT_EQ(countAt(baumer).writes, 1);
}

TEST_F(LedgerKeeperTest, TheFirstFileOfAProjectTakesTheAccountAlong)
{
    keep(DatabasePlace::memory());
    bus.encoder(baumer)->tell(Parameter::steps, 8'192); // something to restore
    write(baumer, 4'096);
    keeper->projectSavedAs(QStringLiteral("/plant.codewheel"));
    EXPECT_EQ(countAt(baumer).writes, 1);
    EXPECT_FALSE(keeper->ledger()->valuesBefore(keeper->identity(baumer)).empty());
    keeper->setProject({});
    EXPECT_EQ(countAt(baumer).writes, 0); // it never belonged to another one
}

TEST_F(LedgerKeeperTest, WhatWasCountedBeforeAProjectHadAFileGoesAlongFromEarlierConnections)
{
    keep(file.place());
    write(baumer, 4'096);
    keeper.reset();
    keep(file.place());
    write(baumer, 8'192);
    EXPECT_EQ(countAt(baumer).writes, 2);
    keeper->setProject({}); // New
    EXPECT_EQ(countAt(baumer).writes, 2);
    keeper->projectSavedAs(QStringLiteral("/plant.codewheel"));
    EXPECT_EQ(countAt(baumer).writes, 2) << "it does not fall";
    keeper->projectSavedAs(QStringLiteral("/copy.codewheel"));
    EXPECT_EQ(countAt(baumer).writes, 2);
    keeper->setProject({});
    EXPECT_EQ(countAt(baumer).writes, 0) << "it belongs to those files";
}

// The next project without a file is another one, though the encoders are still connected.
TEST_F(LedgerKeeperTest, WhatBelongsToAFileDoesNotGoAlongWithTheNextProject)
{
    keep(file.place());
    write(baumer, 4'096);
    keeper->projectSavedAs(QStringLiteral("/first.codewheel"));
    keeper->setProject({}); // New
    keeper->projectSavedAs(QStringLiteral("/second.codewheel"));
    EXPECT_EQ(countAt(baumer).writes, 0);
    keeper->setProject(QStringLiteral("/first.codewheel"));
    EXPECT_EQ(countAt(baumer).writes, 1);
}

TEST_F(LedgerKeeperTest, AProjectSavedUnderAnotherNameGoesOnCounting)
{
    keep(file.place());
    keeper->setProject(QStringLiteral("/plant.codewheel"));
    write(baumer, 4'096);
    keeper.reset(); // writes of other days count as well
    keep(file.place());
    keeper->setProject(QStringLiteral("/plant.codewheel"));
    write(baumer, 8'192);
    for (int time = 0; time < 2; ++time) { // there and back: nothing is counted twice
        keeper->projectSavedAs(QStringLiteral("/copy.codewheel"));
        EXPECT_EQ(countAt(baumer).writes, 2);
        EXPECT_EQ(countAt(fraba).writes, 0);
        keeper->projectSavedAs(QStringLiteral("/plant.codewheel"));
        EXPECT_EQ(countAt(baumer).writes, 2);
    }
}

TEST_F(LedgerKeeperTest, AJobThatRunsWhileTheProjectIsSavedCountsOnce)
{
    keep(file.place());
    keeper->setProject(QStringLiteral("/plant.codewheel"));
    ASSERT_TRUE(
        bus.encoder(baumer)->start(WriteParameters{.values = {{Parameter::steps, 4'096}}, .previous = {}}));
    bus.advance(10);
    keeper->projectSavedAs(QStringLiteral("/copy.codewheel"));
    for (int i = 0; i < 100 && bus.encoder(baumer)->runningJob(); ++i)
        bus.advance(10);
    EXPECT_EQ(countAt(baumer).writes, 1);
    EXPECT_EQ(countAt(baumer).perhaps, 0);
    EXPECT_EQ(keeper->ledger()->accounts().size(), 1U);
}

TEST_F(LedgerKeeperTest, AWordByHandThatStandsWhileTheProjectIsSavedCountsOnce)
{
    keep(file.place());
    keeper->setProject(QStringLiteral("/plant.codewheel"));
    const auto send = [&](Word word) {
        bus.channel(fraba)->stage(word);
        ASSERT_TRUE(bus.channel(fraba)->write());
        bus.advance(50);
    };
    send(0x020000FF);
    keeper->projectSavedAs(QStringLiteral("/copy.codewheel"));
    ASSERT_EQ(keeper->ledger()->accounts().size(), 1U);
    EXPECT_EQ(keeper->ledger()->writes(keeper->identity(fraba)).atMost(), 1) << "it went along";
    send(0x80000000);
    send(0);
    for (int i = 0; i < 11; ++i)
        bus.advance(100);
    EXPECT_EQ(countAt(fraba).writes, 1);
    EXPECT_EQ(countAt(fraba).perhaps, 0);
    EXPECT_EQ(keeper->ledger()->accounts().size(), 1U);
}

// Another project is opened: what was begun in the previous one is counted there.
TEST_F(LedgerKeeperTest, AWordByHandThatStandsWhileAnotherProjectIsOpenedStaysWithTheFirst)
{
    keep(file.place());
    keeper->setProject(QStringLiteral("/plant.codewheel"));
    const auto send = [&](Word word) {
        bus.channel(fraba)->stage(word);
        ASSERT_TRUE(bus.channel(fraba)->write());
        bus.advance(50);
    };
    send(0x020000FF);
    keeper->setProject(QStringLiteral("/other.codewheel"));
    send(0x80000000);
    send(0);
    for (int i = 0; i < 11; ++i)
        bus.advance(100);
    EXPECT_EQ(countAt(fraba).atMost(), 0);
    keeper->setProject(QStringLiteral("/plant.codewheel"));
    EXPECT_EQ(countAt(fraba).writes, 1);
    EXPECT_EQ(countAt(fraba).perhaps, 0);
}

TEST_F(LedgerKeeperTest, ALinkToAProjectIsThatProject)
{
    keep(DatabasePlace::memory());
    QTemporaryDir folder;
    QFile project(folder.filePath(QStringLiteral("plant.codewheel")));
    ASSERT_TRUE(project.open(QIODevice::WriteOnly));
    const QString link = folder.filePath(QStringLiteral("link.codewheel"));
    ASSERT_TRUE(QFile::link(project.fileName(), link));
    keeper->setProject(project.fileName());
    write(baumer, 4'096);
    keeper->setProject(link);
    EXPECT_EQ(countAt(baumer).writes, 1);
}

TEST_F(LedgerKeeperTest, GoesOnWithTheSessionOfADeviceThatIsNamed)
{
    keep(DatabasePlace::memory());
    write(fraba, 255);
    ASSERT_TRUE(bus.name(fraba, QStringLiteral("generic-k3")));
    bus.advance(10);
    EXPECT_EQ(countAt(fraba).writes, 1);
    write(fraba, 256);
    EXPECT_EQ(countAt(fraba).writes, 2);
}

TEST_F(LedgerKeeperTest, GoesOnWithTheSessionsOfANewConnection)
{
    keep(DatabasePlace::memory());
    write(fraba, 255);
    bus.close();
    ASSERT_TRUE(bus.open(RingSession::Start::operating));
    bus.advance(10);
    EXPECT_EQ(countAt(fraba).writes, 1);
    write(fraba, 256);
    EXPECT_EQ(countAt(fraba).writes, 2);
}

TEST_F(LedgerKeeperTest, KeepsTheValuesFromBefore)
{
    keep(DatabasePlace::memory());
    run(fraba, ReadParameters{{Parameter::steps}});
    const std::int64_t before = bus.encoder(fraba)->known(Parameter::steps)->value.number();
    write(fraba, 255);
    const auto entries = keeper->ledger()->valuesBefore(keeper->identity(fraba));
    ASSERT_EQ(entries.size(), 1U);
    ASSERT_EQ(entries[0].before.size(), 1U);
    EXPECT_EQ(entries[0].before[0].value, before);
    EXPECT_EQ(entries[0].before[0].evidence, Evidence::read);
    EXPECT_EQ(entries[0].written, (ParameterValues{{Parameter::steps, 255}}));
}

TEST_F(LedgerKeeperTest, WarnsAsTheBudgetIsUsed)
{
    {
        auto ledger = Ledger::open(file.place());
        ASSERT_TRUE(ledger);
        EncoderIdentity identity{
            .by = CountedBy::place, .vendor = {}, .serialNumber = {}, .project = {}, .place = fraba};
        ASSERT_TRUE(ledger->begin({.at = QDateTime(QDate(2025, 1, 1), QTime(0, 0), Qt::UTC),
                                   .identity = identity.key(),
                                   .writes = 149,
                                   .settled = true}));
    }
    keep(file.place());
    EXPECT_EQ(eepromConcern(*bus.encoder(fraba), 1), EepromConcern::question);
    write(fraba, 255);
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_EQ(messages[0].id, MessageId::eepromThreeQuarters);
    EXPECT_EQ(messages[0].arguments, (std::vector<RefusalArgument>{std::int64_t{150}, std::int64_t{200}}));
    EXPECT_EQ(countAt(fraba).since, QDateTime(QDate(2025, 1, 1), QTime(0, 0), Qt::UTC));
    write(fraba, 256);
    EXPECT_EQ(messages.size(), 1U);
}

TEST_F(LedgerKeeperTest, GoesOnInMemoryAndSaysSoWhereTheFileCannotBeUsed)
{
    EXPECT_TRUE(MessageTable::open(file.place())); // a different kind of database
    keep(file.place());
    ASSERT_TRUE(keeper->problem());
    EXPECT_EQ(keeper->problem()->id, MessageId::notKept);
    write(fraba, 255);
    EXPECT_EQ(countAt(fraba).writes, 1);
}

TEST_F(LedgerKeeperTest, PutsADamagedFileAside)
{
    file.fill(JournalFile::header() + QByteArray(5'000, 'x'));
    keep(file.place());
    ASSERT_TRUE(keeper->problem());
    EXPECT_EQ(keeper->problem()->id, MessageId::databasePutAside);
    write(fraba, 255);
    EXPECT_EQ(Ledger::open(file.place())->writes(keeper->identity(fraba)).writes, 1);
}

} // namespace
} // namespace codewheel

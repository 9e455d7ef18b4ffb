// SPDX-License-Identifier: GPL-3.0-or-later
// The connection to a gateway is lost just behind a word: it has reached the encoder, and nobody sees the
// answer. What account and state say then is held against what the simulated encoder has done.
#include "bus/bus_outline.h"
#include "bus/word_channel.h"
#include "journal/known_keeper.h"
#include "journal/ledger_keeper.h"
#include "kinds/interbus/words/k3_word.h"
#include "tests/support/gateway_session.h"
#include "tests/support/passing_port.h"

namespace codewheel {
namespace {

using namespace test;
using namespace std::chrono_literals;

constexpr Place lostFraba = "1.0"_ring;
constexpr Place lostRod = "5.0"_ring;

// A port that is lost with the answer to a write, and opens again when it may.
class PortLostAtAWrite final : public PassingPort
{
public:
    struct Control
    {
        int writesLeft = -1; // until it is lost; -1: it is not
        bool isAway = false;
    };

    PortLostAtAWrite(std::unique_ptr<RegisterPort> port, std::shared_ptr<Control> control)
        : PassingPort(std::move(port))
        , m_control(std::move(control))
    {}

    Result<void> open() override
    {
        if (m_control->isAway)
            return refuse(RefusalKind::link, RefusalId::connectionRefused, {name()});
        return PassingPort::open();
    }
    Done read(RegisterArea area, int first, std::span<Register> to) override
    {
        return m_control->isAway ? lost() : PassingPort::read(area, first, to);
    }
    Done write(int first, std::span<const Register> from) override
    {
        if (m_control->isAway)
            return lost();
        auto written = PassingPort::write(first, from);
        return survives() ? written : lost();
    }
    Done writeAndRead(int writeFirst, std::span<const Register> from, int readFirst,
                      std::span<Register> to) override
    {
        if (m_control->isAway)
            return lost();
        auto written = PassingPort::writeAndRead(writeFirst, from, readFirst, to);
        return survives() ? written : lost();
    }

private:
    static Done lost() { return tl::unexpected(RegisterError{RegisterError::Kind::closed, 0, {}}); }
    bool survives()
    {
        if (m_control->writesLeft < 0 || m_control->writesLeft-- > 0)
            return true;
        m_control->isAway = true;
        return false;
    }

    std::shared_ptr<Control> m_control;
};

class LostGateway
{
public:
    LostGateway()
    {
        EXPECT_TRUE(session.bus->open(EncoderBus::Start::operating));
        session.bus->advance(200ms);
        session.encoder(lostFraba).tell(Parameter::startUpMode, 1); // position mode
        session.bus->advance(200ms);
    }
    // How the job ends if the connection is lost with the answer to its n-th write; empty: it ends before.
    std::optional<Outcome> lostAt(int write, Place place, const Job &job)
    {
        control->writesLeft = write;
        const Outcome outcome = session.finish(place, job);
        if (!control->isAway || outcome.result)
            return std::nullopt;
        session.bus->advance(1s); // the gateway goes on
        session.gateway->passUntil(session.bus->now());
        return outcome;
    }
    int writesOf(Place place) const
    {
        for (const auto &shaft : session.ring->shafts())
            if (shaft.number == place.node)
                return shaft.eepromWrites;
        for (const auto &rod : session.ring->rods())
            if (rod.number == place.node)
                return rod.eepromWrites;
        return -1;
    }
    // The link is back, in Watch: nobody has asked for anything.
    void giveLinkBack()
    {
        control->isAway = false;
        control->writesLeft = -1;
        session.bus->advance(5s);
    }
    void comeBack()
    {
        giveLinkBack();
        session.bus->setRunning(true);
        session.bus->setOperate(true);
        session.bus->advance(1s);
    }
    void bringBack(Place place)
    {
        session.bus->bringBack(place);
        session.bus->advance(100ms); // until it operates
        session.bus->advance(3s);
    }
    std::optional<Fault> faultThatOffers(FaultAction action) const
    {
        const std::vector<Fault> faults = session.bus->outline().faults();
        const auto found = std::ranges::find(faults, std::vector{action}, &Fault::actions);
        return found != faults.end() ? std::optional(*found) : std::nullopt;
    }
    std::optional<std::int64_t> read(Place place, Parameter parameter)
    {
        EXPECT_EQ(whyOf(session.finish(place, EndParameterization{})), "");
        return valueOf(session.finish(place, ReadParameters{{parameter}}).read, parameter);
    }

    std::shared_ptr<PortLostAtAWrite::Control> control = std::make_shared<PortLostAtAWrite::Control>();
    GatewaySession session{{}, [this](std::unique_ptr<RegisterPort> port) {
                               return std::make_unique<PortLostAtAWrite>(std::move(port), control);
                           }};
};

const WriteParameters writeSteps{.values = {{Parameter::steps, 255}}, .previous = {}};

// Behind each write of the job in turn: the words of the handshake, run among them, and those of before.
TEST(LostGateway, NoAccountDiffersFromWhatTheEncoderHasDone)
{
    int inDoubt = 0;
    int cuts = 0;
    for (int write = 0;; ++write) {
        SCOPED_TRACE(write);
        LostGateway gateway;
        const int before = gateway.writesOf(lostFraba);
        const auto outcome = gateway.lostAt(write, lostFraba, writeSteps);
        if (!outcome)
            break;
        ++cuts;
        ASSERT_FALSE(outcome->result);
        EXPECT_EQ(outcome->result.error().kind, RefusalKind::link);
        EXPECT_EQ(outcome->leftIn, EncoderState::unknown);
        const int done = gateway.writesOf(lostFraba) - before;
        EXPECT_GE(done, outcome->eepromWrites);
        EXPECT_LE(done, outcome->eepromWrites + outcome->inDoubt.eepromWrites);
        const bool isSaidWritten = valueOf(outcome->written, Parameter::steps).has_value();
        const bool isInDoubt = valueOf(outcome->inDoubt.values, Parameter::steps).has_value();
        const bool isConfirmed = valueOf(outcome->confirmed, Parameter::steps).has_value();
        inDoubt += isInDoubt ? 1 : 0;
        EXPECT_EQ(isInDoubt && gateway.session.encoder(lostFraba).known(Parameter::steps).has_value(), false);
        EXPECT_EQ(gateway.session.countOf(MessageId::inDoubt), isInDoubt ? 1u : 0u);
        gateway.comeBack();
        const bool hasIt = gateway.read(lostFraba, Parameter::steps) == 255;
        EXPECT_TRUE(!hasIt || isSaidWritten || isInDoubt || isConfirmed)
            << "the encoder has it, and nobody said so";
        EXPECT_TRUE(hasIt || !isSaidWritten) << "said to be written, and the encoder does not have it";
    }
    EXPECT_GE(cuts, 4);
    EXPECT_GE(inDoubt, 2) << "behind the parameter word, and behind run";
}

// Run is answered by 00000000 then, which proves nothing: the value is read back, unless the link is lost
// first.
TEST(LostGateway, WhatRunAtPositionZeroMayHaveMadeValidIsInDoubtUntilItIsReadBack)
{
    const WriteParameters writePreset{.values = {{Parameter::preset, 255}}, .previous = {}};
    int inDoubt = 0;
    for (int write = 0;; ++write) {
        SCOPED_TRACE(write);
        LostGateway gateway;
        ASSERT_TRUE(gateway.session.finish(lostFraba, SetPreset{.value = 0}).result);
        const auto outcome = gateway.lostAt(write, lostFraba, writePreset);
        if (!outcome)
            break;
        const bool isSaidWritten = valueOf(outcome->written, Parameter::preset).has_value();
        const bool isInDoubt = valueOf(outcome->inDoubt.values, Parameter::preset).has_value();
        const bool isConfirmed = valueOf(outcome->confirmed, Parameter::preset).has_value();
        inDoubt += isInDoubt ? 1 : 0;
        gateway.comeBack();
        const bool hasIt = gateway.read(lostFraba, Parameter::preset) == 255;
        EXPECT_TRUE(!hasIt || isSaidWritten || isInDoubt || isConfirmed);
        EXPECT_TRUE(hasIt || !isSaidWritten);
    }
    EXPECT_GE(inDoubt, 3) << "behind the parameter word, behind run, and before it was read back";
}

// Its word may have been about to go out, and goes out with the exchange that fails; or it is answered late.
TEST(LostGateway, AJobThatWasCancelledAccountsForTheWordThatWasUnderWay)
{
    const SendWords words{.words = {0x0200'00FF, k3::run, k3::normalRunning}};
    int lost = 0;
    int inDoubt = 0;
    for (const Job &job : {Job(writeSteps), Job(words), Job(ResetToDefault{})})
        for (Instant until = 10ms; until <= 150ms; until += 10ms)
            for (int write = 0; write < 3; ++write) {
                SCOPED_TRACE(testing::Message() << job.index() << ' ' << until.count() << ' ' << write);
                LostGateway gateway;
                EncoderSession &encoder = gateway.session.encoder(lostFraba);
                std::optional<Outcome> outcome;
                QObject::connect(&encoder, &EncoderSession::finished, &encoder,
                                 [&](const Outcome &how) { outcome = how; });
                const int before = gateway.writesOf(lostFraba);
                ASSERT_TRUE(encoder.start(job));
                gateway.session.bus->advance(until);
                gateway.control->writesLeft = write;
                encoder.cancel(OnCancel::leaveAsIs);
                gateway.session.bus->advance(2s);
                if (!outcome || !gateway.control->isAway || outcome->result)
                    continue;
                ++lost;
                gateway.session.gateway->passUntil(gateway.session.bus->now());
                const int done = gateway.writesOf(lostFraba) - before;
                EXPECT_GE(done, outcome->eepromWrites);
                EXPECT_LE(done, outcome->eepromWrites + outcome->inDoubt.eepromWrites);
                inDoubt += outcome->inDoubt.eepromWrites;
            }
    EXPECT_GT(lost, 30);
    EXPECT_GT(inDoubt, 10);
}

TEST(LostGateway, BehindRunTheValuesAreActiveAndStoredAndNotKnown)
{
    for (int write = 0;; ++write) {
        LostGateway gateway;
        const auto outcome = gateway.lostAt(write, lostFraba, writeSteps);
        ASSERT_TRUE(outcome) << "run was never lost";
        if (outcome->inDoubt.out.empty() || outcome->inDoubt.out.front() != k3::run)
            continue;
        EXPECT_EQ(outcome->inDoubt.values, writeSteps.values);
        EXPECT_TRUE(outcome->written.empty());
        EXPECT_EQ(outcome->eepromWrites, 1) << "it was confirmed";
        EXPECT_EQ(gateway.writesOf(lostFraba), 1);
        EXPECT_EQ(gateway.session.countOf(MessageId::outLeft), 1u);
        EXPECT_EQ(gateway.session.countOf(MessageId::leftInParameterization), 0u);
        gateway.comeBack();
        EXPECT_EQ(gateway.read(lostFraba, Parameter::steps), 255);
        break;
    }
}

// Until the value is read: then the account is settled.
TEST(LostGateway, TheLedgerCountsWhatIsInDoubtAsPerhaps)
{
    int inDoubt = 0;
    for (int write = 0;; ++write) {
        SCOPED_TRACE(write);
        LostGateway gateway;
        LedgerKeeper keeper(*gateway.session.bus, DatabasePlace::memory());
        const EncoderSession &encoder = gateway.session.encoder(lostFraba);
        const auto outcome = gateway.lostAt(write, lostFraba, writeSteps);
        if (!outcome)
            break;
        EXPECT_EQ(encoder.eepromCount().writes, outcome->eepromWrites);
        EXPECT_EQ(encoder.eepromCount().perhaps, outcome->inDoubt.eepromWrites);
        EXPECT_GE(encoder.eepromCount().atMost(), gateway.writesOf(lostFraba));
        if (outcome->inDoubt.eepromWrites == 0)
            continue;
        ++inDoubt;
        gateway.comeBack();
        gateway.read(lostFraba, Parameter::steps);
        EXPECT_EQ(encoder.eepromCount().perhaps, 0);
        EXPECT_GE(encoder.eepromCount().writes, gateway.writesOf(lostFraba));
    }
    EXPECT_GE(inDoubt, 1);
}

// A value that was confirmed reads as before until it runs, and is stored all the same.
TEST(LostGateway, ReadingWhatARunWouldChangeSettlesNothing)
{
    int stored = 0;
    for (int write = 0;; ++write) {
        SCOPED_TRACE(write);
        LostGateway gateway;
        LedgerKeeper keeper(*gateway.session.bus, DatabasePlace::memory());
        const EncoderSession &encoder = gateway.session.encoder(lostFraba);
        const auto outcome = gateway.lostAt(write, lostFraba, writeSteps);
        if (!outcome)
            break;
        gateway.comeBack();
        gateway.session.finish(lostFraba, ReadParameters{{Parameter::steps}});
        EXPECT_GE(encoder.eepromCount().atMost(), gateway.writesOf(lostFraba));
        const bool isPending = encoder.latest().state == EncoderState::parameterization;
        stored += isPending && outcome->inDoubt.eepromWrites > 0 && gateway.writesOf(lostFraba) > 0 ? 1 : 0;
        gateway.read(lostFraba, Parameter::steps);
        EXPECT_EQ(encoder.eepromCount().perhaps, 0);
        EXPECT_GE(encoder.eepromCount().writes, gateway.writesOf(lostFraba));
    }
    EXPECT_GE(stored, 1);
}

TEST(LostGateway, APresetThatWasSentIsInDoubt)
{
    int inDoubt = 0;
    for (int write = 0;; ++write) {
        SCOPED_TRACE(write);
        LostGateway gateway;
        const int before = gateway.writesOf(lostFraba);
        const auto outcome = gateway.lostAt(write, lostFraba, SetPreset{1000, PresetCommand::profile});
        if (!outcome)
            break;
        const int done = gateway.writesOf(lostFraba) - before;
        EXPECT_GE(done, outcome->eepromWrites);
        EXPECT_LE(done, outcome->eepromWrites + outcome->inDoubt.eepromWrites);
        inDoubt += outcome->inDoubt.position ? 1 : 0;
        EXPECT_TRUE(!outcome->inDoubt.position || outcome->inDoubt.out.front() == k3::initialisePreset);
    }
    EXPECT_GE(inDoubt, 1);
}

TEST(LostGateway, AResetThatWasSentIsInDoubt)
{
    int inDoubt = 0;
    for (int write = 0;; ++write) {
        LostGateway gateway;
        ASSERT_TRUE(gateway.read(lostFraba, Parameter::steps));
        const auto outcome = gateway.lostAt(write, lostFraba, ResetToDefault{});
        if (!outcome)
            break;
        inDoubt += outcome->inDoubt.reset ? 1 : 0;
        EXPECT_FALSE(outcome->inDoubt.reset && gateway.session.encoder(lostFraba).known(Parameter::steps))
            << "it may have another one";
    }
    EXPECT_GE(inDoubt, 2) << "behind 0E000000, and behind run";
}

CamProgram lostCams()
{
    CamProgram program;
    program.cam[0] = {.start = 100, .stop = 200, .active = true};
    return program;
}

// A program that was changed is stored when it is left, which nothing acknowledges.
TEST(LostGateway, ACamProgramThatMayHaveBeenStoredIsInDoubt)
{
    int inDoubt = 0;
    int stored = 0;
    for (int write = 0;; ++write) {
        SCOPED_TRACE(write);
        LostGateway gateway;
        LedgerKeeper keeper(*gateway.session.bus, DatabasePlace::memory());
        const EncoderSession &encoder = gateway.session.encoder(lostFraba);
        const auto outcome =
            gateway.lostAt(write, lostFraba, WriteCams{.programs = {lostCams()}, .afterwards = SwitchMode{}});
        if (!outcome)
            break;
        const int done = gateway.writesOf(lostFraba);
        EXPECT_GE(done, outcome->eepromWrites);
        EXPECT_LE(done, outcome->eepromWrites + outcome->inDoubt.eepromWrites);
        EXPECT_EQ(encoder.eepromCount().writes, outcome->eepromWrites);
        EXPECT_EQ(encoder.eepromCount().perhaps, outcome->inDoubt.eepromWrites);
        const bool isInDoubt = outcome->inDoubt.eepromWrites > 0;
        EXPECT_EQ(gateway.session.countOf(MessageId::writesInDoubt), isInDoubt ? 1u : 0u);
        if (isInDoubt) {
            EXPECT_EQ(outcome->inDoubt.camPrograms, std::vector{1u});
        }
        inDoubt += isInDoubt ? 1 : 0;
        stored += done > outcome->eepromWrites ? 1 : 0;
        const Word there = gateway.session.gateway->out().front();
        EXPECT_TRUE(there == 0 || std::ranges::count(outcome->inDoubt.out, there) == 1);
        gateway.comeBack();
        EXPECT_EQ(whyOf(gateway.session.finish(lostFraba, SwitchMode{})), "");
        EXPECT_GE(gateway.writesOf(lostFraba), encoder.eepromCount().writes);
        EXPECT_LE(gateway.writesOf(lostFraba), encoder.eepromCount().atMost());
    }
    EXPECT_GE(inDoubt, 3) << "behind the words of the cam, and behind 20800000";
    EXPECT_GE(stored, 1);
}

TEST(LostGateway, BehindAWordThatSwitchesTheModeItIsNotKnown)
{
    int unknown = 0;
    for (int write = 0;; ++write) {
        SCOPED_TRACE(write);
        LostGateway gateway;
        const auto outcome = gateway.lostAt(write, lostFraba, SwitchMode{.mode = Mode::cam, .camProgram = 1});
        if (!outcome)
            break;
        gateway.control->isAway = false;
        gateway.session.gateway->setOut(0, 0); // somebody cleans up
        gateway.giveLinkBack();
        const auto mode = gateway.session.encoder(lostFraba).latest().mode;
        unknown += mode ? 0 : 1;
        EXPECT_NE(mode, Mode::position);
    }
    EXPECT_GE(unknown, 1);
}

TEST(LostGateway, AWordThatLeadsToTheModeItIsInLeavesItKnown)
{
    int lost = 0;
    for (int write = 0;; ++write) {
        SCOPED_TRACE(write);
        LostGateway gateway;
        if (!gateway.lostAt(write, lostFraba, SendWords{{0x2040'0000}}))
            break;
        ++lost;
        EXPECT_EQ(gateway.session.encoder(lostFraba).latest().mode, Mode::position);
    }
    EXPECT_GE(lost, 1);
}

TEST(LostGateway, AServiceOfARodIsInDoubt)
{
    int inDoubt = 0;
    for (int write = 0;; ++write) {
        SCOPED_TRACE(write);
        LostGateway gateway;
        const int before = gateway.writesOf(lostRod);
        const auto outcome = gateway.lostAt(
            write, lostRod, WriteParameters{.values = {{Parameter::direction, 1}}, .previous = {}});
        if (!outcome)
            break;
        const int done = gateway.writesOf(lostRod) - before;
        EXPECT_GE(done, outcome->eepromWrites);
        EXPECT_LE(done, outcome->eepromWrites + outcome->inDoubt.eepromWrites);
        inDoubt += outcome->inDoubt.values.empty() ? 0 : 1;
    }
    EXPECT_GE(inDoubt, 1);
}

// What stays in OUT is told, and is still there when the link is back.
TEST(LostGateway, AWordLeftInOutIsTold)
{
    int told = 0;
    for (int write = 0;; ++write) {
        LostGateway gateway;
        const auto outcome = gateway.lostAt(write, lostFraba, ReadParameters{{Parameter::steps}});
        if (!outcome)
            break;
        const Word there = gateway.session.gateway->out().front();
        EXPECT_TRUE(there == 0 || std::ranges::count(outcome->inDoubt.out, there) == 1);
        told += there != 0 ? 1 : 0;
        gateway.comeBack();
        EXPECT_EQ(gateway.session.bus->latest().devices.front().leftOut.value_or(0), there);
    }
    EXPECT_GE(told, 1);
}

// A gateway keeps the word, and the controller gets no position for as long as the bus is stopped.
TEST(LostGateway, AJobThatIsCutByStoppingTheBusSaysWhatItLeaves)
{
    LostGateway gateway;
    RingSession &bus = *gateway.session.bus;
    ASSERT_TRUE(gateway.session.encoder(lostFraba).start(ReadParameters{{Parameter::steps}}));
    while (gateway.session.isOutZero())
        bus.advance(10ms);
    const Word left = gateway.session.gateway->out().front();
    bus.setRunning(false);
    bus.advance(1s);
    EXPECT_EQ(gateway.session.gateway->out().front(), left);
    EXPECT_EQ(gateway.session.countOf(MessageId::outLeft), 1u);
    EXPECT_EQ(bus.latest().devices.front().leftOut, left);
    bus.setRunning(true);
    bus.advance(1s);
    EXPECT_EQ(gateway.session.gateway->out().front(), left) << "nobody has asked for anything else";
    bus.bringBack(lostFraba);
    bus.advance(3s);
    EXPECT_TRUE(gateway.session.isOutZero());
    EXPECT_FALSE(bus.latest().devices.front().leftOut);
}

// Nothing is sent by itself. What is offered clears OUT, reads what is not known, and settles the account.
// What has gone out is in the trace, though nobody knows what came of it.
TEST(LostGateway, TheLastWordIsInTheTraceWithoutAnAnswer)
{
    int cuts = 0;
    for (int write = 0;; ++write) {
        SCOPED_TRACE(write);
        LostGateway gateway;
        std::vector<Exchange> rows;
        QObject::connect(&gateway.session.encoder(lostFraba), &EncoderSession::exchanged,
                         gateway.session.bus.get(), [&](const Exchange &row) { rows.push_back(row); });
        if (!gateway.lostAt(write, lostFraba, writeSteps))
            break;
        const Word left = gateway.session.gateway->out().front();
        if (rows.empty()) // before its first word
            continue;
        EXPECT_EQ(rows.back().out, left);
        cuts += rows.back().isAnswered ? 0 : 1;
    }
    EXPECT_GE(cuts, 4);
}

// The word reaches the encoder, which confirms and stores it.
TEST(LostGateway, AWordByHandIsToldAndCountedAsPerhaps)
{
    LostGateway gateway;
    LedgerKeeper keeper(*gateway.session.bus, DatabasePlace::memory());
    gateway.control->writesLeft = 0;
    WordChannel &channel = *gateway.session.bus->channel(lostFraba);
    channel.stage(0x0200'00FF);
    ASSERT_TRUE(channel.write());
    gateway.session.bus->advance(5s);
    ASSERT_EQ(gateway.session.bus->state(), BusState::lost);
    EXPECT_EQ(gateway.session.encoder(lostFraba).eepromCount().perhaps, 1);
    const auto told = std::ranges::find(gateway.session.messages, MessageId::outLeft, &Message::id);
    ASSERT_NE(told, gateway.session.messages.end());
    EXPECT_EQ(told->arguments, std::vector<RefusalArgument>{QStringLiteral("020000FF")});
    EXPECT_FALSE(channel.staged()) << "it is not to be sent once more";
    gateway.giveLinkBack();
    EXPECT_TRUE(gateway.faultThatOffers(FaultAction::bringBack));
    gateway.bringBack(lostFraba);
    gateway.session.finish(lostFraba, EndParameterization{});
    gateway.session.bus->advance(10s);
    EXPECT_EQ(gateway.writesOf(lostFraba), 1);
    EXPECT_EQ(gateway.session.encoder(lostFraba).eepromCount().atMost(), 1);
}

// Whoever says that it is the same encoder does not bring back what the word may have changed.
TEST(LostGateway, WhatAWordByHandMayHaveChangedIsNotKnown)
{
    struct ByHand
    {
        Word word;
        Parameter changes;
    };
    for (const auto &[word, changes] :
         {ByHand{0x0200'00FF, Parameter::steps}, ByHand{k3::initialisePreset, Parameter::zeroOffset}}) {
        SCOPED_TRACE(testing::Message() << std::hex << word);
        LostGateway gateway;
        EncoderSession &encoder = gateway.session.encoder(lostFraba);
        KnownKeeper keeper;
        keeper.watch(*gateway.session.bus);
        ASSERT_EQ(whyOf(gateway.session.finish(
                      lostFraba, WriteParameters{.values = {{Parameter::preset, 500}}, .previous = {}})),
                  "");
        ASSERT_EQ(
            whyOf(gateway.session.finish(
                lostFraba, ReadParameters{{Parameter::steps, Parameter::zeroOffset, Parameter::direction}})),
            "");
        const auto before = encoder.known(changes);
        ASSERT_TRUE(before);
        gateway.control->writesLeft = 0;
        WordChannel &channel = *gateway.session.bus->channel(lostFraba);
        channel.stage(word);
        ASSERT_TRUE(channel.write());
        gateway.session.bus->advance(5s);
        ASSERT_EQ(gateway.session.bus->state(), BusState::lost);
        EXPECT_FALSE(encoder.known(changes));
        EXPECT_EQ(gateway.session.countOf(MessageId::inDoubt), word == k3::initialisePreset ? 0u : 1u);
        EXPECT_EQ(gateway.session.countOf(MessageId::inDoubtForGood), word == k3::initialisePreset ? 1u : 0u);
        gateway.giveLinkBack();
        ASSERT_TRUE(encoder.knownBefore());
        encoder.takeKnownBefore();
        EXPECT_TRUE(encoder.known(Parameter::direction));
        EXPECT_FALSE(encoder.known(changes));
        gateway.comeBack();
        EXPECT_NE(gateway.read(lostFraba, changes), before->value);
    }
}

// The link was lost once more before it operated: nothing is sent by surprise when it does, much later.
TEST(LostGateway, WhatDidNotComeBackAtOnceIsNotBroughtBackLater)
{
    LostGateway gateway;
    ASSERT_TRUE(gateway.lostAt(2, lostFraba, writeSteps));
    gateway.giveLinkBack();
    ASSERT_TRUE(gateway.faultThatOffers(FaultAction::bringBack));
    gateway.control->isAway = true;
    gateway.session.bus->bringBack(lostFraba);
    gateway.session.bus->advance(5s);
    gateway.giveLinkBack();
    gateway.session.bus->setOperate(true);
    const std::vector<Word> before = gateway.session.gateway->out();
    gateway.session.bus->advance(5s);
    EXPECT_EQ(gateway.session.gateway->out(), before);
}

TEST(LostGateway, WhatWasLeftIsBroughtBackWhenTheUserSaysSo)
{
    int broughtBack = 0;
    for (int write = 0;; ++write) {
        SCOPED_TRACE(write);
        LostGateway gateway;
        RingSession &bus = *gateway.session.bus;
        const auto outcome = gateway.lostAt(write, lostFraba, writeSteps);
        if (!outcome)
            break;
        const Word left = gateway.session.gateway->out().front();
        gateway.giveLinkBack();
        EXPECT_EQ(gateway.session.gateway->out().front(), left) << "nobody has asked for anything";
        EXPECT_EQ(bus.latest().devices.front().leftOut.value_or(0), left);
        const auto offered = gateway.faultThatOffers(FaultAction::bringBack);
        ASSERT_EQ(offered.has_value(), left != 0);
        if (left == 0 || gateway.session.encoder(lostFraba).latest().state != EncoderState::operation)
            continue;
        ++broughtBack;
        EXPECT_EQ(offered->node, lostFraba.node);
        gateway.bringBack(lostFraba);
        EXPECT_TRUE(gateway.session.isOutZero())
            << (gateway.session.lastRefusal() ? refusalText(*gateway.session.lastRefusal()).toStdString()
                                              : "");
        EXPECT_FALSE(bus.latest().devices.front().leftOut);
        const bool wasInDoubt = valueOf(outcome->inDoubt.values, Parameter::steps).has_value();
        EXPECT_EQ(gateway.session.encoder(lostFraba).known(Parameter::steps).has_value(), wasInDoubt);
    }
    EXPECT_GE(broughtBack, 1);
}

// OUT is back at 0, and the encoder waits in parameterization: what run would make valid is said before it is
// sent.
TEST(LostGateway, AnEncoderLeftInParameterizationSaysWhatRunMakesValid)
{
    int run = 0;
    for (int write = 0;; ++write) {
        SCOPED_TRACE(write);
        LostGateway gateway;
        RingSession &bus = *gateway.session.bus;
        const auto outcome = gateway.lostAt(write, lostFraba, writeSteps);
        if (!outcome)
            break;
        gateway.giveLinkBack();
        if (gateway.session.encoder(lostFraba).latest().state != EncoderState::parameterization)
            continue;
        gateway.bringBack(lostFraba);
        ASSERT_TRUE(gateway.session.isOutZero());
        const auto left = gateway.faultThatOffers(FaultAction::run);
        ASSERT_TRUE(left);
        EXPECT_TRUE(left->text.contains(QLatin1String("Steps = "))) << left->text.toStdString();
        ++run;
        bus.sendRun(lostFraba);
        bus.advance(3s);
        EXPECT_EQ(gateway.session.encoder(lostFraba).latest().state, EncoderState::operation);
        EXPECT_FALSE(gateway.faultThatOffers(FaultAction::run));
    }
    EXPECT_GE(run, 1);
}

// The same word would confirm a parameter.
TEST(LostGateway, ACamWordThatWasLeftIsNotTakenForAParameter)
{
    int left = 0;
    for (int write = 0;; ++write) {
        SCOPED_TRACE(write);
        LostGateway gateway;
        if (!gateway.lostAt(write, lostFraba,
                            WriteCams{.programs = {lostCams()}, .afterwards = SwitchMode{}}))
            break;
        gateway.giveLinkBack();
        gateway.bringBack(lostFraba);
        const auto fault = gateway.faultThatOffers(FaultAction::run);
        if (!fault)
            continue;
        ++left;
        EXPECT_FALSE(fault->text.contains(QLatin1String("with the data"))) << fault->text.toStdString();
        EXPECT_FALSE(fault->text.contains(QLatin1String("Parameter "))) << fault->text.toStdString();
        EXPECT_TRUE(fault->text.contains(QLatin1String("says: Acknowledged: "))) << fault->text.toStdString();
        EXPECT_TRUE(fault->text.contains(QLatin1String("from here: cam program 1")))
            << fault->text.toStdString();
    }
    EXPECT_GE(left, 1);
}

} // namespace
} // namespace codewheel

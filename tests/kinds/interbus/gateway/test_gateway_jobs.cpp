// SPDX-License-Identifier: GPL-3.0-or-later
// What works on the training ring works behind a gateway that tears words and shows OUT late.
#include "bus/word_channel.h"
#include "kinds/interbus/ring/ring_messages.h"
#include "kinds/interbus/simulator/fraba_k3.h"
#include "tests/kinds/interbus/gateway/gateway_ring.h"
#include "tests/support/fraba_appendix.h"
#include "tests/support/gateway_session.h"
#include "tests/support/passing_port.h"

namespace codewheel {
namespace {

using namespace test;
using namespace std::chrono_literals;

constexpr Place frabaPlace = "1.0"_ring;
constexpr Place baumerPlace = "2.0"_ring;
constexpr Place rodPlace = "5.0"_ring;

struct GatewayKind
{
    const char *name;
    GatewayMaking making;
};
void PrintTo(const GatewayKind &kind, std::ostream *stream)
{
    *stream << kind.name;
}

class GatewayJobs : public testing::TestWithParam<GatewayKind>
{
protected:
    GatewayJobs()
        : ring(GetParam().making)
    {
        EXPECT_TRUE(ring.bus->open(EncoderBus::Start::operating));
        ring.bus->advance(200ms);
        ring.encoder(frabaPlace).tell(Parameter::startUpMode, 1); // position mode
        ring.bus->advance(200ms);
    }
    Outcome done(Place place, const Job &job)
    {
        Outcome outcome = ring.finish(place, job);
        EXPECT_EQ(whyOf(outcome), "");
        ring.bus->advance(500ms);
        return outcome;
    }
    std::optional<std::int64_t> read(Place place, Parameter parameter)
    {
        return valueOf(done(place, ReadParameters{{parameter}}).read, parameter);
    }

    GatewaySession ring;
};

// Acknowledges what it is to write, and has other registers.
class ElsewherePort final : public PassingPort
{
public:
    using PassingPort::PassingPort;
    Done write(int, std::span<const Register>) override { return {}; }
};

TEST(GatewayWithOtherRegisters, AnEncoderThatGetsNoWordNamesTheFirstRegisterOfOut)
{
    GatewaySession ring({.settings = {.readsBack = false}}, [](std::unique_ptr<RegisterPort> port) {
        return std::make_unique<ElsewherePort>(std::move(port));
    });
    ASSERT_TRUE(ring.bus->open(EncoderBus::Start::operating));
    ring.bus->advance(200ms);
    const Outcome outcome = ring.finish(frabaPlace, ReadParameters{{Parameter::steps}});
    EXPECT_EQ(whyOf(outcome), "noAnswerAtGateway");
    EXPECT_TRUE(refusalText(outcome.result.error()).contains(QLatin1String("first register of OUT")));
}

TEST_P(GatewayJobs, TheExampleOfTheManualIsCarriedOut)
{
    const Outcome outcome = done(frabaPlace, WriteParameters{.values = {{Parameter::steps, 255},
                                                                        {Parameter::revolutions, 1},
                                                                        {Parameter::direction, 3},
                                                                        {Parameter::preset, 0}},
                                                             .onlyWhatDiffers = false,
                                                             .previous = {},
                                                             .initialisePreset = true});
    EXPECT_EQ(ring.encoder(frabaPlace).latest().position, 0);
    EXPECT_EQ(ring.encoder(frabaPlace).eepromWrites(), outcome.eepromWrites);
    EXPECT_TRUE(ring.isOutZero());
    EXPECT_EQ(read(frabaPlace, Parameter::steps), 255);
}

TEST_P(GatewayJobs, ABaumerK3IsParameterized)
{
    done(baumerPlace, WriteParameters{.values = {{Parameter::steps, 4096}}, .previous = {}});
    ASSERT_TRUE(ring.encoder(baumerPlace).known(Parameter::steps));
    EXPECT_EQ(ring.encoder(baumerPlace).known(Parameter::steps)->value, 4096);
    EXPECT_TRUE(ring.isOutZero());
}

TEST_P(GatewayJobs, ARodIsParameterizedAndReadBack)
{
    done(rodPlace, WriteParameters{.values = {{Parameter::direction, 1}}, .previous = {}});
    EXPECT_EQ(read(rodPlace, Parameter::direction), 1);
    EXPECT_TRUE(ring.isOutZero());
}

// One right after the other: the answer to one is not taken for that to the next.
TEST_P(GatewayJobs, ManyValuesAreReadInOneJob)
{
    const Outcome outcome =
        done(frabaPlace, ReadParameters{{Parameter::steps, Parameter::revolutions, Parameter::direction,
                                         Parameter::preset, Parameter::serialNumber}});
    EXPECT_EQ(valueOf(outcome.read, Parameter::steps), 8192);
    EXPECT_EQ(valueOf(outcome.read, Parameter::direction), 3);
    EXPECT_EQ(valueOf(outcome.read, Parameter::serialNumber), 20'417);
}

TEST_P(GatewayJobs, APresetIsSetAndTheFrabaPresetIsNotOffered)
{
    const Outcome outcome = done(frabaPlace, SetPreset{1000, PresetCommand::profile});
    EXPECT_EQ(outcome.positionAfter, 1000);
    EXPECT_EQ(ring.encoder(frabaPlace).latest().position, 1000);
    const auto refused = ring.encoder(frabaPlace).start(SetPreset{{}, PresetCommand::manufacturer});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().id, RefusalId::linkDoesNotBoundCycles);
    ring.bus->channel(frabaPlace)->stage(0x6000'0000);
    ASSERT_TRUE(ring.bus->channel(frabaPlace)->write());
    ring.bus->advance(300ms);
    EXPECT_EQ(ring.lastRefusal()->id, RefusalId::linkDoesNotBoundCycles);
    EXPECT_TRUE(ring.isOutZero());
}

TEST_P(GatewayJobs, CamsAreWrittenAndReadBack)
{
    CamProgram program{.number = 2};
    program.cam[3] = {.start = 100, .stop = 2000, .active = true};
    done(frabaPlace, ReadParameters{{Parameter::steps, Parameter::preset}});
    done(frabaPlace, WriteCams{.programs = {program}, .afterwards = SwitchMode{.mode = Mode::position}});
    const Outcome read =
        done(frabaPlace, ReadCams{.programs = {2}, .afterwards = SwitchMode{.mode = Mode::position}});
    ASSERT_EQ(read.camsRead.size(), 1u);
    EXPECT_EQ(read.camsRead[0], program);
    EXPECT_TRUE(ring.encoder(frabaPlace).known(Parameter::steps)) << "a cam is no parameter";
    EXPECT_TRUE(ring.encoder(frabaPlace).known(Parameter::preset));
}

TEST_P(GatewayJobs, AJobEndsWheneverItIsCancelledAndTheNextOneWorks)
{
    int cancelled = 0;
    const WriteParameters job{.values = {{Parameter::steps, 255}, {Parameter::revolutions, 1}},
                              .previous = {}};
    for (const OnCancel how : {OnCancel::leaveAsIs, OnCancel::runWithWhatItHas, OnCancel::ifNothingTaken})
        for (Instant after = 0ms; after < 400ms; after += 23ms) {
            auto &encoder = ring.encoder(frabaPlace);
            std::optional<Outcome> outcome;
            const auto ended = QObject::connect(&encoder, &EncoderSession::finished, ring.bus.get(),
                                                [&](const Outcome &one) { outcome = one; });
            ASSERT_TRUE(encoder.start(job));
            ring.bus->advance(after);
            encoder.cancel(how);
            for (int i = 0; i < 2'000 && !outcome; ++i)
                ring.bus->advance(10ms);
            QObject::disconnect(ended);
            ASSERT_TRUE(outcome);
            cancelled += outcome->result ? 0 : 1;
            ring.bus->advance(100ms);
            EXPECT_TRUE(ring.isOutZero()) << after.count();
            done(frabaPlace, EndParameterization{});
        }
    EXPECT_GT(cancelled, 10);
    done(frabaPlace, job);
    EXPECT_EQ(ring.encoder(frabaPlace).known(Parameter::steps)->value, 255);
}

TEST_P(GatewayJobs, AnAlarmStopInTheMiddleZeroesOut)
{
    for (Instant after = 5ms; after < 500ms; after += 31ms) {
        auto &encoder = ring.encoder(frabaPlace);
        std::optional<Outcome> outcome;
        const auto ended = QObject::connect(&encoder, &EncoderSession::finished, ring.bus.get(),
                                            [&](const Outcome &one) { outcome = one; });
        ASSERT_TRUE(encoder.start(WriteParameters{
            .values = {{Parameter::steps, 255}, {Parameter::revolutions, 1}}, .previous = {}}));
        ring.bus->advance(after);
        ring.messages.clear();
        ring.bus->alarmStop();
        ring.bus->advance(1500ms);
        QObject::disconnect(ended);
        ASSERT_TRUE(outcome);
        if (!outcome->result) {
            EXPECT_EQ(outcome->result.error().id, RefusalId::alarmStop);
        }
        EXPECT_TRUE(ring.isOutZero());
        EXPECT_EQ(ring.countOf(RingMessageId::zerosReadBack), 1u) << after.count();
        done(frabaPlace, EndParameterization{});
    }
}

TEST_P(GatewayJobs, TheSpeedIsThatOfTheShaft)
{
    ring.encoder(frabaPlace).tell(Parameter::steps, 8192);
    ring.encoder(frabaPlace).tell(Parameter::revolutions, 1);
    ring.encoder(frabaPlace).tell(Parameter::direction, 3);
    for (const double turnsPerMinute : {30.0, 600.0, -1'500.0}) {
        ring.ring->setSpeed(frabaPlace.node, turnsPerMinute);
        ring.bus->advance(3s);
        const auto &reading = ring.encoder(frabaPlace).latest();
        ASSERT_TRUE(reading.stepsPerSecond) << turnsPerMinute;
        const double expected = turnsPerMinute / 60 * 8192;
        EXPECT_NEAR(*reading.stepsPerSecond, expected, std::abs(expected) * 0.01);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Gateways, GatewayJobs,
    testing::Values(GatewayKind{"usual", {.ways = {.tears = 0.2, .lag = 5ms}}},
                    GatewayKind{"late", {.ways = {.tears = 0.5, .lag = 120ms}}},
                    GatewayKind{"slow", {.ways = {.tears = 0.2, .lag = 30ms}, .transaction = 12ms}},
                    GatewayKind{"copies registers apart",
                                {.ways = {.copyApart = 2ms}, .transaction = std::chrono::microseconds(300)}},
                    GatewayKind{"copies registers far apart",
                                {.ways = {.copyApart = 8ms}, .transaction = std::chrono::microseconds(300)}},
                    GatewayKind{"delayed",
                                {.ways = {.tears = 0.2},
                                 .settings = {.pollInterval = 20ms, .reactionDelay = 10ms}}}));

bool isTransient(const AppendixRow &row)
{
    return row.cycles != AppendixRow{}.cycles;
}

// Through the link alone: each answer of the manual comes through a gateway as the encoder gave it.
TEST(GatewayAppendix, EveryRowOfTheManualIsAnsweredAsDocumented)
{
    int rows = 0;
    for (const AppendixRow &row : frabaAppendix()) {
        if (isTransient(row))
            continue;
        auto encoder = std::make_unique<FrabaK3>(
            PhysicalResolution{.stepsPerTurn = 8192, .turns = 4096}, 0x3039,
            FrabaPlate{.serialNumber = 4711, .operatingTime = 99},
            EncoderTiming{.startUp = row.happening == Happening::startsUp ? 1000 : 0});
        SimulatedDevice &device = *encoder;
        auto ring = std::make_shared<SimulatedRing>();
        ring->add(frabaAt(1), std::move(encoder));
        const auto gateway =
            std::make_shared<SimulatedGateway>(ring, SimulatedGateway::Ways{.tears = 0.3, .lag = 3ms});
        GatewayLink link(std::make_unique<SimulatedGatewayPort>(gateway), {},
                         gatewayDevices(*ring, builtInCatalog()));
        ASSERT_TRUE(link.open());
        ASSERT_TRUE(link.readBackOut());
        std::vector<Word> in(1);
        const auto hold = [&](Word out) {
            for (int i = 0; i < 8; ++i)
                ASSERT_TRUE(link.exchange(std::vector<Word>{out}, in));
        };
        hold(0);
        for (const Word word : row.before)
            hold(word);
        if (row.happening == Happening::turnsAt1500Rpm)
            device.setSpeed(1500);
        if (row.happening == Happening::turnsAt6000Rpm)
            device.setSpeed(6000);
        if (row.happening == Happening::losesItsParameters)
            device.loseParameters();
        if (row.happening == Happening::startsUp) {
            device.setPower(false);
            device.setPower(true);
        }
        hold(row.out);
        EXPECT_EQ(QString::number(in[0], 16), QString::number(row.in, 16))
            << row.section << ' ' << row.name << " OUT " << std::hex << row.out;
        ++rows;
    }
    EXPECT_GT(rows, 50);
}

} // namespace
} // namespace codewheel

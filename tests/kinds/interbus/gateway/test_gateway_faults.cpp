// SPDX-License-Identifier: GPL-3.0-or-later
// 24 hours of faults on the way to a gateway, in virtual time.
#include "journal/ledger_keeper.h"
#include "kinds/interbus/gateway/gateway_refusals.h"
#include "kinds/interbus/simulator/fraba_k3.h"
#include "kinds/interbus/simulator/simulated_ring.h"
#include "kinds/interbus/simulator/simulated_ring_link.h"
#include "kinds/interbus/words/k3_word.h"
#include "tests/kinds/interbus/gateway/checked_link.h"
#include "tests/kinds/interbus/gateway/gateway_ring.h"
#include "tests/support/gateway_session.h"

namespace codewheel {
namespace {

using namespace test;
using namespace std::chrono_literals;

constexpr int faultyEncoders = 4;
// This one gets the cam jobs. Its shaft stands: the gateway knows of positions only whether a shaft came by.
constexpr std::size_t withCams = 0;
constexpr auto runs = 10;
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool isSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
constexpr bool isSanitized = true;
#else
constexpr bool isSanitized = false;
#endif
#else
constexpr bool isSanitized = false;
#endif
constexpr Instant runTime = Instant(isSanitized ? 2h : 24h) / runs; // on the ring's clock

// A ring that somebody works with, while the link to its gateway fails in all ways.
class FaultyDays
{
public:
    explicit FaultyDays(unsigned seed)
        : m_random(seed)
        , m_watch(std::make_shared<FaultyRegisterPort::Watch>())
        , m_session(
              making(seed, m_encoders),
              [&](std::unique_ptr<RegisterPort> port) {
                  auto faulty = std::make_unique<FaultyRegisterPort>(std::move(port), seed, m_watch);
                  m_port = faulty.get();
                  return faulty;
              },
              [&](std::unique_ptr<ProcessDataLink> link) {
                  auto checked = std::make_unique<CheckedLink>(std::move(link), *m_watch, m_rules);
                  m_link = checked.get();
                  return checked;
              })
    {
        m_link->lookAt(m_session.gateway);
        m_session.gateway->written = [this, before = m_session.gateway->written] {
            before();
            countEdges();
        };
        m_rules.oldest = FaultyRegisterPort::latest + 2 * FaultyRegisterPort::timeOut;
    }

    void live()
    {
        ASSERT_TRUE(bus().open(EncoderBus::Start::watching));
        while (bus().now() < runTime && !testing::Test::HasFailure()) {
            act();
            m_rules.mayWrite = m_rules.mayWrite || bus().isOperating();
            const bool zerosWereDue = m_rules.zerosAreDue; // what was asked for after them waits
            bus().advance(Instant(pick(10, 3'000) * 1ms));
            if (!zerosWereDue && !m_rules.zerosAreDue)
                m_rules.mayWrite = bus().isOperating();
            m_session.gateway->passUntil(bus().now()); // the ring goes on, whoever looks
            expectThatWhatIsShownIsTrue();
            expectThatNothingWasWrittenUncounted();
            expectThatNothingIsLeftUnsaid();
            expectThatWhatIsKnownIsTrue();
            m_session.messages.clear();
        }
    }
    void expectThatEverythingWorksAgain()
    {
        m_port->make({});
        bus().setRunning(true);
        bus().advance(20s);
        m_rules.mayWrite = true;
        bus().setOperate(true);
        bus().advance(1s);
        ASSERT_TRUE(bus().isOperating());
        for (const Place place : bus().places()) {
            EncoderSession &encoder = m_session.encoder(place);
            if (encoder.runningJob()) {
                encoder.cancel(OnCancel::leaveAsIs);
                bus().advance(30s);
            }
            EXPECT_EQ(whyOf(m_session.finish(place, EndParameterization{})), "");
            EXPECT_EQ(whyOf(m_session.finish(place, SwitchMode{})), "");
            EXPECT_EQ(whyOf(m_session.finish(
                          place, WriteParameters{.values = {{Parameter::direction, 3}}, .previous = {}})),
                      "");
            EXPECT_TRUE(encoder.freshness().isLive());
        }
        EXPECT_TRUE(m_session.isOutZero());
    }
    const FaultyRegisterPort::Watch &watch() const { return *m_watch; }
    const CheckedLink::Rules &rules() const { return m_rules; }
    int reconnects() const { return static_cast<int>(m_session.bus->latest().figures->connections); }
    int jobs() const { return m_jobs; }
    int jobsThatWorked() const { return m_jobsThatWorked; }
    int foreignWords() const { return m_foreignWords; }
    int comparisons() const { return m_comparisons; }
    int camsWritten() const { return m_camsWritten; }
    int camsInDoubt() const { return m_camsInDoubt; }

private:
    // As the ring is made: those that the session does not see.
    static TrainingBus ringOf(std::vector<const FrabaK3 *> &encoders)
    {
        constexpr PhysicalResolution thirteenPlusTwelveBit{.stepsPerTurn = 8192, .turns = 4096};
        auto ring = std::make_shared<SimulatedRing>();
        for (std::size_t i = 0; i < faultyEncoders; ++i) {
            auto encoder =
                std::make_unique<FrabaK3>(thirteenPlusTwelveBit, 97 * static_cast<std::int64_t>(i),
                                          FrabaPlate{.serialNumber = 20'000 + static_cast<Word>(i)});
            encoder->setSpeed(i == withCams ? 0.0 : 3.0 + static_cast<double>(i));
            encoders.push_back(encoder.get());
            ring->add(frabaAt(static_cast<int>(i) + 1), std::move(encoder));
        }
        return {.link = std::make_unique<SimulatedRingLink>(ring), .controls = ring};
    }
    static GatewayMaking making(unsigned seed, std::vector<const FrabaK3 *> &encoders)
    {
        constexpr std::array intervals{40ms, 70ms, 100ms, 150ms};
        return {.ways = {.tears = 0.1, .lag = (seed % 3) * 60ms, .seed = seed, .passesOver = true},
                .settings = {.pollInterval = intervals.at(seed % intervals.size())},
                .transaction = std::chrono::milliseconds(1 + seed % 4),
                .makeRing = [&encoders] { return ringOf(encoders); }};
    }
    RingSession &bus() { return *m_session.bus; }
    int pick(int least, int most) { return std::uniform_int_distribution(least, most)(m_random); }

    // What the simulated encoders know.
    int writesOf(std::size_t device) const { return m_session.ring->shafts().at(device).eepromWrites; }

    // Run and preset act when they come into OUT.
    void countEdges()
    {
        const std::vector<Word> &out = m_session.gateway->out();
        for (std::size_t i = 0; i < out.size(); ++i) {
            const Word before = std::exchange(m_out[i], out[i]);
            if (out[i] != before)
                m_outChangedAt[i] = bus().now();
            for (const Word acts : {k3::run, k3::initialisePreset})
                if (out[i] == acts && before != acts)
                    ++m_edges[i][acts];
        }
    }
    void expectThatWhatIsShownIsTrue()
    {
        for (std::size_t i = 0; i < faultyEncoders; ++i) {
            const EncoderSession &encoder = m_session.encoder(bus().places()[i]);
            if (!encoder.freshness().isLive())
                continue;
            const Reading &shown = encoder.latest();
            EXPECT_TRUE(m_session.gateway->wasIn(i, shown.in, shown.at - m_rules.oldest))
                << "encoder " << i << " shows " << std::hex << shown.in;
        }
    }
    // No encoder has stored less than the ledger had counted by the last time, or more than it has, or
    // perhaps.
    void expectThatNothingWasWrittenUncounted()
    {
        for (std::size_t i = 0; i < faultyEncoders; ++i) {
            const EncoderSession &encoder = m_session.encoder(bus().places()[i]);
            const EepromCount count = encoder.eepromCount();
            EXPECT_LE(std::exchange(m_counted[i], count.writes), writesOf(i)) << "encoder " << i;
            if (encoder.runningJob())
                continue;
            EXPECT_LE(writesOf(i), count.writes + m_perhaps[i]) << "encoder " << i;
            EXPECT_LE(count.perhaps, m_perhaps[i]) << "encoder " << i;
        }
    }
    // In OUT, by a job that has ended without its user having said so. A word that was acknowledged and got
    // lost is named by the message that OUT is not ours.
    void expectThatNothingIsLeftUnsaid()
    {
        const bool isNamed = std::ranges::any_of(m_session.messages, [](const Message &message) {
            return message.refusal && message.refusal->id == GatewayRefusalId::outNotOurs;
        });
        for (std::size_t i = 0; i < faultyEncoders; ++i) {
            const Word out = m_session.gateway->out()[i];
            m_mayLeave[i] = (m_mayLeave[i] || isNamed) && out != 0;
            const auto &device = bus().latest().devices[i];
            const bool isSeen = bus().latest().connected && device.outIsKnown && !m_rules.zerosAreDue;
            const bool mustBeTold =
                out != 0 && isSeen && !m_mayLeave[i] && !m_session.encoder(bus().places()[i]).runningJob();
            EXPECT_TRUE(!mustBeTold || device.leftOut) << "encoder " << i << ": OUT is " << std::hex << out;
        }
    }
    // The mode, and the program in use, as soon as nothing is under way. What was shown before OUT changed
    // says what was then.
    void expectThatItsModeIsTrue(std::size_t i)
    {
        const EncoderSession &encoder = m_session.encoder(bus().places()[i]);
        const FrabaCams &has = m_encoders[i]->cams();
        const Reading &shown = encoder.latest();
        if (encoder.runningJob() || !shown.mode || !encoder.freshness().isLive() ||
            m_session.gateway->out()[i] != 0 || shown.at <= m_outChangedAt[i])
            return;
        EXPECT_EQ(shown.camProgram.value_or(0), has.program()) << "encoder " << i;
        const auto known = shown.camProgram ? encoder.cams(*shown.camProgram) : std::nullopt;
        if (!known || known->program.number != has.program())
            return;
        for (std::size_t cam = 0; cam < CamProgram::cams; ++cam) {
            const auto code = static_cast<Word>(cam);
            EXPECT_EQ(known->program.cam[cam].start, has.readOut(0x10 + code)) << "encoder " << i;
            EXPECT_EQ(known->program.cam[cam].stop, has.readOut(0x20 + code)) << "encoder " << i;
        }
        ++m_comparisons;
    }
    // What was read or confirmed, as soon as nothing is under way.
    void expectThatWhatIsKnownIsTrue()
    {
        for (std::size_t i = 0; i < faultyEncoders; ++i) {
            expectThatItsModeIsTrue(i);
            const EncoderSession &encoder = m_session.encoder(bus().places()[i]);
            const ParameterSet &has = m_encoders[i]->parameters();
            const std::pair<Parameter, std::int64_t> all[] = {{Parameter::steps, has.steps},
                                                              {Parameter::revolutions, has.revolutions},
                                                              {Parameter::direction, has.coding},
                                                              {Parameter::preset, has.preset}};
            for (const auto &[parameter, value] : all)
                if (const auto known = encoder.known(parameter);
                    known && known->evidence != Evidence::told && !encoder.runningJob()) {
                    EXPECT_EQ(known->value, value)
                        << "encoder " << i << ": " << parameterKey(parameter).toStdString();
                    ++m_comparisons;
                }
        }
    }
    struct JobSeen
    {
        std::size_t device = 0;
        int writes = 0; // of the encoder, before
        std::map<Word, int> edges;
        bool isOfWords = false; // of the user: one that is refused stays in OUT
    };
    void judge(const JobSeen &job, const Outcome &outcome)
    {
        const std::size_t i = job.device;
        m_perhaps[i] += outcome.inDoubt.eepromWrites;
        m_mayLeave[i] = m_mayLeave[i] || (job.isOfWords && !outcome.result &&
                                          outcome.result.error().kind == RefusalKind::device);
        m_camsWritten += outcome.camsWritten.empty() ? 0 : 1;
        m_camsInDoubt += outcome.inDoubt.camPrograms.empty() ? 0 : 1;
        if (m_isCancelled[i]) // and perhaps written back
            return;
        EXPECT_LE(writesOf(i) - job.writes, 2) << "a parameter, and what stores along";
        for (const auto &[word, edges] : m_edges[i])
            EXPECT_LE(edges - (job.edges.contains(word) ? job.edges.at(word) : 0), 1)
                << std::hex << word << " acted twice";
    }

    void act()
    {
        switch (pick(0, 11)) {
        case 0:
            m_port->make(RegisterFaults::ofAllKinds(
                std::array{0.0, 0.002, 0.01, 0.04}.at(static_cast<std::size_t>(pick(0, 3)))));
            break;
        case 1:
            if (!std::exchange(m_rules.zerosAreDue, true))
                bus().alarmStop();
            break;
        case 2:
            bus().setOperate(pick(0, 3) == 0 ? false : (m_rules.mayWrite = true));
            break;
        case 3:
            bus().setRunning(pick(0, 3) != 0);
            break;
        case 4:
            m_session.ring->setSpeed(somePlaceThatTurns().node, pick(-3'000, 3'000));
            break;
        case 5:
            cancelOne();
            break;
        default:
            startJob();
        }
    }
    void cancelOne()
    {
        const auto device = static_cast<std::size_t>(pick(0, faultyEncoders - 1));
        m_isCancelled[device] = m_mayLeave[device] = true;
        m_session.encoder(bus().places()[device]).cancel(static_cast<OnCancel>(pick(0, 3)));
    }
    // As somebody does who looks at the encoder.
    void tellMode(std::size_t device, EncoderSession &encoder) const
    {
        const unsigned program = m_encoders[device]->cams().program();
        if (!encoder.latest().mode && !encoder.runningJob() && m_session.gateway->out()[device] == 0)
            encoder.tell(Parameter::startUpMode, program == 0 ? 1 : 2 + std::int64_t{program});
    }
    unsigned someProgram() { return static_cast<unsigned>(pick(1, 2)); }
    SwitchMode someMode()
    {
        return pick(0, 3) != 0 ? SwitchMode{} : SwitchMode{.mode = Mode::cam, .camProgram = someProgram()};
    }
    CamProgram someCams()
    {
        CamProgram program{.number = someProgram(), .cam = {}, .shift = 0};
        program.cam[3] = {.start = pick(1, 50), .stop = pick(51, 99), .active = true};
        return program;
    }
    Place somePlace() { return bus().places().at(static_cast<std::size_t>(pick(0, faultyEncoders - 1))); }
    Place somePlaceThatTurns()
    {
        return bus().places().at(static_cast<std::size_t>(pick(1, faultyEncoders - 1)));
    }
    void startJob()
    {
        if (!bus().isOperating()) {
            bus().setRunning(true);
            bus().setOperate(m_rules.mayWrite = true);
            return;
        }
        const auto device = static_cast<std::size_t>(pick(0, faultyEncoders - 1));
        EncoderSession &encoder = m_session.encoder(bus().places()[device]);
        const std::array<Job, 9> some{
            ReadParameters{{Parameter::direction, Parameter::revolutions}},
            SendWords{
                .words = {0x0200'0000U | static_cast<Word>(pick(100, 8'000)), k3::run, k3::normalRunning}},
            ResetToDefault{},
            WriteParameters{.values = {{Parameter::steps, pick(100, 8'000)}}, .previous = {}},
            SetPreset{pick(0, 1'000), PresetCommand::profile},
            EndParameterization{},
            SwitchMode{},
            ReadCams{.programs = {someProgram()}, .afterwards = someMode()},
            WriteCams{.programs = {someCams()}, .afterwards = someMode()}};
        tellMode(device, encoder);
        const Job &chosen = some.at(static_cast<std::size_t>(device == withCams ? pick(4, 8) : pick(0, 5)));
        const auto id = encoder.start(chosen);
        if (!id)
            return;
        ++m_jobs;
        m_isCancelled[device] = false;
        const JobSeen job{device, writesOf(device), m_edges[device],
                          std::holds_alternative<SendWords>(chosen)};
        QObject::connect(&encoder, &EncoderSession::finished, &bus(),
                         [this, id, job](const Outcome &outcome) {
                             if (outcome.job != *id)
                                 return;
                             judge(job, outcome);
                             m_jobsThatWorked += outcome.result ? 1 : 0;
                             m_foreignWords += whyOf(outcome) == "outsOfOther" ? 1 : 0;
                         });
    }

    std::mt19937 m_random;
    std::shared_ptr<FaultyRegisterPort::Watch> m_watch;
    CheckedLink::Rules m_rules;
    FaultyRegisterPort *m_port = nullptr;
    std::vector<const FrabaK3 *> m_encoders; // what they really have
    int m_comparisons = 0;
    CheckedLink *m_link = nullptr;
    GatewaySession m_session;
    LedgerKeeper m_ledger{*m_session.bus, DatabasePlace::memory()};
    int m_jobs = 0;
    int m_jobsThatWorked = 0;
    int m_foreignWords = 0;
    int m_camsWritten = 0;
    int m_camsInDoubt = 0;
    std::array<Word, faultyEncoders> m_out{};
    std::array<Instant, faultyEncoders> m_outChangedAt{};
    std::array<std::map<Word, int>, faultyEncoders> m_edges;
    std::array<int, faultyEncoders> m_counted{};
    std::array<int, faultyEncoders> m_perhaps{};      // written, of what is in doubt
    std::array<bool, faultyEncoders> m_isCancelled{}; // the last job
    std::array<bool, faultyEncoders> m_mayLeave{};    // its word in OUT
};

TEST(GatewayFaults, ADayOfThemPutsNoWordWhereItDoesNotBelong)
{
    std::map<int, int> faults;
    int jobs = 0;
    int worked = 0;
    int foreign = 0;
    int connections = 0;
    int comparisons = 0;
    int camsWritten = 0;
    int camsInDoubt = 0;
    for (unsigned seed = 1; seed <= runs; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        FaultyDays days(seed);
        days.live();
        days.expectThatEverythingWorksAgain();
        for (const auto &[kind, count] : days.watch().faults)
            faults[kind] += count;
        jobs += days.jobs();
        worked += days.jobsThatWorked();
        foreign += days.foreignWords();
        connections += days.reconnects();
        comparisons += days.comparisons();
        camsWritten += days.camsWritten();
        camsInDoubt += days.camsInDoubt();
        if (HasFailure())
            return;
    }
    for (int kind = 0; kind < FaultyRegisterPort::kinds; ++kind)
        EXPECT_GT(faults[kind], 20) << "kind " << kind << ": of all of them there must be some";
    std::cout << jobs << " jobs, " << worked << " of them worked, " << foreign << " ended by a foreign word, "
              << connections << " connections; cams written " << camsWritten << ", in doubt " << camsInDoubt
              << '\n';
    EXPECT_GT(worked, jobs / 4);
    EXPECT_GT(connections, 100);
    EXPECT_GT(comparisons, jobs) << "of values known and had";
    if (!isSanitized) {
        EXPECT_GT(camsWritten, 30);
        EXPECT_GT(camsInDoubt, 10);
    }
    if (!isSanitized) {
        EXPECT_GT(jobs, 10'000);
    }
}

} // namespace
} // namespace codewheel

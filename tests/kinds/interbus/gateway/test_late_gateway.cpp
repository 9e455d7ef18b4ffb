// SPDX-License-Identifier: GPL-3.0-or-later
// A gateway that passes words on late, both ways, and the proof of a preset behind it.
#include "tests/support/gateway_session.h"

#include <deque>

namespace codewheel {
namespace {

using namespace test;
using namespace std::chrono_literals;

constexpr Place lateFraba = "1.0"_ring;
constexpr Place lateBaumer = "2.0"_ring;

// OUT reaches the ring that late, and IN shows what it was then.
class LatePort final : public RegisterPort
{
public:
    LatePort(std::unique_ptr<RegisterPort> port, Instant lateness)
        : m_port(std::move(port))
        , m_lateness(lateness)
    {}

    Result<void> open() override { return m_port->open(); }
    void close() override { m_port->close(); }
    Done read(RegisterArea area, int first, std::span<Register> to) override
    {
        passOn();
        if (area == RegisterArea::holding)
            return m_port->read(area, first, to);
        auto done = m_port->read(area, first, to);
        m_seen.push_back({m_port->now(), {to.begin(), to.end()}});
        while (m_seen.size() > 1 && m_seen[1].at <= m_port->now() - m_lateness)
            m_seen.pop_front();
        std::ranges::copy(m_seen.front().registers, to.begin());
        return done;
    }
    Done write(int first, std::span<const Register> from) override
    {
        passOn();
        m_waiting.push_back({m_port->now() + m_lateness, {from.begin(), from.end()}});
        m_first = first;
        m_port->wait(m_port->now() + 1ms);
        return {};
    }
    Done writeAndRead(int, std::span<const Register>, int, std::span<Register>) override
    {
        return tl::unexpected(RegisterError{RegisterError::Kind::exception, 1, {}});
    }
    Instant now() const override { return m_port->now(); }
    void wait(Instant until) override
    {
        while (!m_waiting.empty() && m_waiting.front().at <= until) {
            m_port->wait(m_waiting.front().at);
            passOn();
        }
        m_port->wait(until);
    }
    void interrupt() override { m_port->interrupt(); }
    QString name() const override { return m_port->name(); }

private:
    struct Image
    {
        Instant at{};
        std::vector<Register> registers;
    };

    void passOn()
    {
        for (; !m_waiting.empty() && m_waiting.front().at <= m_port->now(); m_waiting.pop_front())
            (void)m_port->write(m_first, m_waiting.front().registers);
    }

    std::unique_ptr<RegisterPort> m_port;
    Instant m_lateness;
    int m_first = 0;
    std::deque<Image> m_waiting;
    std::deque<Image> m_seen;
};

class LateGateway : public testing::TestWithParam<int>
{
protected:
    void SetUp() override
    {
        ASSERT_TRUE(session.bus->open(EncoderBus::Start::operating));
        session.bus->advance(1s);
        session.encoder(lateFraba).tell(Parameter::startUpMode, 1);
        session.bus->advance(1s);
    }

    GatewaySession session{{}, [](std::unique_ptr<RegisterPort> port) {
                               return std::make_unique<LatePort>(std::move(port), GetParam() * 1ms);
                           }};
};

TEST_P(LateGateway, APresetIsWaitedForAndProved)
{
    const Outcome outcome = session.finish(lateFraba, SetPreset{1000, PresetCommand::profile});
    EXPECT_EQ(whyOf(outcome), "");
    EXPECT_EQ(outcome.positionAfter, 1000);
    session.bus->advance(2s);
    EXPECT_EQ(session.encoder(lateFraba).latest().position, 1000);
    EXPECT_TRUE(session.isOutZero());
}

TEST_P(LateGateway, APresetOfABaumerNeedsItsOffset)
{
    session.ring->setSpeed(lateBaumer.node, 0);
    EncoderSession &baumer = session.encoder(lateBaumer);
    const Outcome unknown = session.finish(lateBaumer, SetPreset{100, PresetCommand::profile});
    ASSERT_FALSE(unknown.result);
    EXPECT_EQ(unknown.result.error().id, RefusalId::presetNotKnownWithout);
    for (const ParameterDescription &parameter : baumer.device().parameters)
        if (parameter.factory && !baumer.known(parameter.parameter))
            baumer.tell(parameter.parameter, *parameter.factory);
    session.bus->advance(1s);
    const Outcome known = session.finish(lateBaumer, SetPreset{200, PresetCommand::profile});
    EXPECT_EQ(whyOf(known), "");
    EXPECT_EQ(known.positionAfter, 200);
}

INSTANTIATE_TEST_SUITE_P(Milliseconds, LateGateway, testing::Values(0, 20, 100, 300));

// Each answer takes its time, 0.5 to 1.5 s with some: what is waited for goes by the pace of the link.
class SlowGateway : public testing::TestWithParam<int>
{};

TEST_P(SlowGateway, JobsAreCarriedOut)
{
    GatewaySession session({.transaction = GetParam() * 1ms});
    session.ring->setSpeed(lateBaumer.node, 0);
    ASSERT_TRUE(session.bus->open(EncoderBus::Start::operating));
    session.bus->advance(1min);
    std::optional<Outcome> outcome;
    QObject::connect(&session.encoder(lateFraba), &EncoderSession::finished, session.bus.get(),
                     [&](const Outcome &how) { outcome = how; });
    const WriteParameters job{.values = {{Parameter::steps, 255}}, .previous = {}};
    ASSERT_TRUE(session.encoder(lateFraba).start(job));
    for (int i = 0; i < 1'000 && !outcome; ++i)
        session.bus->advance(1s);
    ASSERT_TRUE(outcome);
    EXPECT_EQ(whyOf(*outcome), "");
    EXPECT_EQ(outcome->written, job.values);
}

// No two reads are alike, and the third comes late: its position is known all the same, and its values.
TEST_P(SlowGateway, AnEncoderWhoseShaftTurnsIsSeenAndRead)
{
    const Instant answer = std::chrono::milliseconds(GetParam());
    GatewaySession late({.settings = {.timeOut = 5s}, .transaction = answer});
    ASSERT_TRUE(late.bus->open(EncoderBus::Start::operating));
    late.ring->setSpeed(lateFraba.node, 20);
    late.bus->advance(16 * answer);
    for (int i = 0; i < 10; ++i) {
        late.bus->advance(8 * answer);
        const Reading &shown = late.encoder(lateFraba).latest();
        EXPECT_GT(shown.at, late.bus->now() - 8 * answer);
    }
    std::optional<Outcome> outcome;
    QObject::connect(&late.encoder(lateFraba), &EncoderSession::finished, late.bus.get(),
                     [&](const Outcome &how) { outcome = how; });
    ASSERT_TRUE(late.encoder(lateFraba).start(ReadParameters{{Parameter::steps}}));
    late.bus->advance(60 * answer);
    ASSERT_TRUE(outcome);
    EXPECT_EQ(whyOf(*outcome), "");
}

INSTANTIATE_TEST_SUITE_P(MillisecondsPerAnswer, SlowGateway, testing::Values(100, 200, 500, 1'000, 1'500));

} // namespace
} // namespace codewheel

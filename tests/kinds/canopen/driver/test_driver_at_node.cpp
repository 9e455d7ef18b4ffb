// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "kinds/canopen/driver/cia406_driver.h"
#include "kinds/canopen/protocol/canopen_refusals.h"
#include "kinds/canopen/simulator/simulated_node.h"

#include <gtest/gtest.h>

namespace codewheel::canopen {
namespace {

using namespace std::chrono_literals;

// A driver and a simulated encoder on a cable on which frames take no time.
struct DriverAtNode : ::testing::Test
{
    static CanopenEncoderPlan planned(NodeQuirks quirks = {})
    {
        return {.node = 5, .raw = 5000, .identity = {0x10D, 1, 0x10000, 12345}, .quirks = quirks};
    }
    void put(const CanopenEncoderPlan &plan)
    {
        node = std::make_unique<SimulatedNode>(plan);
        pass(1s);
    }
    void command(NmtCommand command)
    {
        const CanFrame frame = NmtRequest{command, 5}.frame();
        node->take(frame, now);
        driver.take(frame, now);
    }
    void pass(Instant time)
    {
        for (const Instant end = now + time; now < end; now += 100us)
            turn();
    }
    const Outcome &finish(const Job &job)
    {
        outcome.reset();
        if (const auto begun = driver.begin(++m_job, job, Pace::byItself, now); !begun) {
            outcome.emplace();
            outcome->result = begun;
        }
        for (const Instant end = now + 30s; !outcome && now < end; now += 100us)
            turn();
        if (!outcome)
            outcome.emplace();
        return *outcome;
    }
    void turn()
    {
        if (const auto wakes = node->wakesAt(); wakes && *wakes <= now)
            node->proceed(now);
        while (const CanFrame *sent = node->toSend()) {
            const CanFrame frame = *sent;
            node->sent(frame, now);
            if (!m_client.take(frame, now))
                driver.take(frame, now);
        }
        if (!m_request)
            ask();
        if (const auto frame = m_client.next(now)) {
            node->take(*frame, now);
            m_client.fate(m_client.given(), CanFate::done, now);
        }
        if (const auto told = m_client.takeOutcome())
            driver.answered(*std::exchange(m_request, std::nullopt), *told, now);
        for (const Event &event : driver.takeEvents())
            if (const auto *its = std::get_if<Outcome>(&event))
                outcome = *its;
    }

    Catalog catalog = Catalog::builtIn();
    Instant now{};
    std::unique_ptr<SimulatedNode> node;
    Cia406Driver driver{*catalog.find(u"canopen-406-multi-turn"), 5};
    std::optional<Outcome> outcome;

private:
    void ask()
    {
        m_request = driver.next(now);
        if (!m_request)
            return;
        if (const auto *sdo = std::get_if<SdoRequest>(&*m_request)) {
            m_client.begin(*sdo, now);
            return;
        }
        node->take(std::get<NmtRequest>(*m_request).frame(), now);
        driver.answered(*std::exchange(m_request, std::nullopt), {.kind = SdoOutcome::Kind::written}, now);
    }

    SdoClient m_client{SdoIdentifiers::predefined(5)};
    std::optional<NodeRequest> m_request;
    JobId m_job = 0;
};

const ParameterValues values{{Parameter::steps, 4000},
                             {Parameter::measuringRange, 4'000'000},
                             {Parameter::scaling, 1},
                             {Parameter::direction, 1}};

TEST_F(DriverAtNode, ReadsEverythingThatTheEncoderHas)
{
    put(planned());
    EXPECT_TRUE(driver.reading().position);
    EXPECT_EQ(driver.reading().state, EncoderState::operation) << "it does not tell whether it waits";
    const Outcome &read = finish(ReadParameters{catalog.find(u"canopen-406-multi-turn")->readableValues()});
    EXPECT_TRUE(read.result);
    EXPECT_EQ(valueOf(read.read, Parameter::serialNumber), 12345);
    EXPECT_EQ(findValue(read.read, Parameter::of(u"1008")), Value(QStringLiteral("SIM58-CO")));
    EXPECT_GT(read.read.size(), 20u);
}

TEST_F(DriverAtNode, WritesStoresAndSetsThePosition)
{
    put(planned());
    EXPECT_TRUE(finish(WriteParameters{.values = values, .previous = {}}).result);
    EXPECT_EQ(node->eepromWrites(), 1u);
    EXPECT_TRUE(finish(SetPreset{.value = 1234}).result);
    EXPECT_EQ(outcome->positionAfter, 1234);
    EXPECT_EQ(node->eepromWrites(), 2u);
    node->setOn(false);
    pass(100ms);
    node->setOn(true);
    pass(1s);
    EXPECT_EQ(driver.reading().position, 1234);
    EXPECT_TRUE(finish(WriteParameters{.values = values, .onlyWhatDiffers = true, .previous = {}}).result);
    EXPECT_EQ(outcome->alreadyThere.size() + outcome->stored.size(), values.size());
    EXPECT_TRUE(outcome->written.empty());
}

TEST_F(DriverAtNode, ThePositionComesByPdoOnceItRuns)
{
    put(planned());
    command(NmtCommand::start);
    EXPECT_EQ(driver.state(), NmtState::operational);
    const auto before = driver.reading().position;
    node->shaft().setSpeed(60);
    pass(2s);
    EXPECT_EQ(driver.reading().state, EncoderState::operation);
    EXPECT_NE(driver.reading().position, before);
}

TEST_F(DriverAtNode, FactoryValuesComeBack)
{
    put(planned());
    EXPECT_TRUE(finish(WriteParameters{.values = values, .previous = {}}).result);
    command(NmtCommand::preOperational);
    EXPECT_TRUE(finish(ResetToDefault{}).result);
    pass(100ms);
    EXPECT_TRUE(finish(ReadParameters{{Parameter::steps}}).result);
    EXPECT_NE(valueOf(outcome->read, Parameter::steps), 4000);
}

TEST_F(DriverAtNode, ANodeThatTakesValuesOnlyBeforeItRunsIsStoppedWithConsent)
{
    put(planned({.silenceWhileStoring = 400ms, .writesOnlyPreOperational = true}));
    command(NmtCommand::start);
    EXPECT_FALSE(finish(WriteParameters{.values = values, .previous = {}}).result);
    EXPECT_EQ(outcome->result.error().id, CanopenRefusalId::nodeWouldStop);
    driver.mayStopNode(true);
    EXPECT_TRUE(finish(WriteParameters{.values = values, .previous = {}}).result);
    EXPECT_EQ(node->state(), NmtState::operational);
    EXPECT_EQ(outcome->written.size(), values.size());
}

// It has booted, and no heartbeat that would tell.
TEST_F(DriverAtNode, OneThatMayRunIsNotResetUnasked)
{
    put(planned());
    EXPECT_FALSE(driver.state());
    EXPECT_FALSE(finish(ResetToDefault{}).result);
    EXPECT_EQ(outcome->result.error().id, CanopenRefusalId::nodeMayRun);
    EXPECT_EQ(node->eepromWrites(), 0u);
    driver.mayStopNode(true);
    EXPECT_TRUE(finish(ResetToDefault{}).result);
    EXPECT_EQ(node->state(), NmtState::operational);
}

TEST_F(DriverAtNode, CamsAreWrittenAndReadBack)
{
    put(planned());
    ASSERT_TRUE(finish(ReadCams{{1}, {}}).result);
    CamProgram program = outcome->camsRead.front();
    program.cam[2] = {.start = 100, .stop = 200, .active = true};
    ASSERT_TRUE(finish(WriteCams{{program}, true, {}}).result);
    ASSERT_TRUE(finish(ReadCams{{1}, {}}).result);
    EXPECT_EQ(outcome->camsRead.front(), program);
}

} // namespace
} // namespace codewheel::canopen

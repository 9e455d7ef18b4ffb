// SPDX-License-Identifier: GPL-3.0-or-later
// Session, runner, driver and simulated encoders together, in virtual time.
#include "catalog/catalog.h"
#include "jobs/values_to_write.h"
#include "kinds/esc/driver/esc_driver.h"
#include "kinds/esc/line/esc_line_session.h"
#include "kinds/esc/protocol/esc_messages.h"
#include "kinds/esc/simulator/simulated_esc_line_link.h"
#include "vocabulary/refusal_text.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr Place five = placeOnLine({0x05});

class EscLine : public testing::Test
{
protected:
    explicit EscLine(int fractionBits = 29)
        : simulated(std::make_shared<SimulatedEscLine>(std::vector<EscEncoderPlan>{
              {.address = {5}, .raw = 0x1235, .serialNumber = 4711, .fractionBits = fractionBits}}))
        , line(std::make_unique<SimulatedEscLineLink>(simulated), catalog,
               QDateTime(QDate(2026, 11, 21), QTime(12, 0)),
               [this](const DeviceDescription &device, EscLineAddress address) {
                   auto driver = std::make_unique<EscDriver>(device, address);
                   drivers.push_back(driver.get());
                   return driver;
               })
    {
        EXPECT_TRUE(line.open({}, {}, EscLineSession::Start::operating, EscLineSession::Drive::byHand));
        EXPECT_TRUE(line.add(EscLineAddress::of(five.node), QStringLiteral("kuebler-esc-rs485")));
        line.advance(1s);
        QObject::connect(&line, &EscLineSession::messaged, &line,
                         [this](const Message &message) { messages.push_back(message.id); });
        QObject::connect(&line, &EscLineSession::fractionBitsDetermined, &line,
                         [this](Place number, const Result<int> &bits) {
                             EXPECT_EQ(number, five);
                             determined.push_back(bits);
                         });
    }
    EncoderSession &encoder() { return *line.encoder(five); }

    const Catalog catalog = Catalog::builtIn();
    const std::shared_ptr<SimulatedEscLine> simulated;
    std::vector<EscDriver *> drivers;
    EscLineSession line;
    std::vector<MessageCode> messages;
    std::vector<Result<int>> determined;
};

class EscLineWith28Bits : public EscLine
{
protected:
    EscLineWith28Bits()
        : EscLine(28)
    {}
};

// Without it, one would be computed from the steps and sent.
TEST_F(EscLine, AFactorThatIsThereGoesAlongWithTheStepsThatAreNot)
{
    ASSERT_TRUE(encoder().start(ReadParameters{{Parameter::steps, Parameter::scalingFactor}}));
    line.advance(2s);
    const auto known = encoder().known(Parameter::scalingFactor);
    ASSERT_TRUE(known);
    const ParameterValue wantedFactor{Parameter::scalingFactor, known->value};
    const auto job = [&](std::int64_t steps) {
        return jobForWish(encoder(), {.wanted = {wantedFactor, {Parameter::steps, steps}}});
    };
    const std::int64_t steps = encoder().known(Parameter::steps)->value.number();
    EXPECT_TRUE(job(steps).values.empty()) << "all is there";
    EXPECT_EQ(job(4'096).values, (ParameterValues{{Parameter::steps, 4'096}, wantedFactor}));
    EXPECT_EQ(jobForWish(encoder(), {.wanted = {{Parameter::steps, 4'096}}}).values,
              (ParameterValues{{Parameter::steps, 4'096}}))
        << "none is wanted";
}

TEST_F(EscLine, GoesOnWhenTheAdapterIsBack)
{
    const Instant before = encoder().latest().at;
    ASSERT_EQ(encoder().latest().position, 0x1235);
    simulated->setUnplugged(true);
    line.advance(100ms);
    EXPECT_FALSE(line.isRunning());
    EXPECT_EQ(encoder().latest().state, EncoderState::notSeen);
    line.advance(1min);
    simulated->setUnplugged(false);
    line.advance(2s);
    EXPECT_TRUE(line.isRunning());
    EXPECT_EQ(messages, (std::vector<MessageCode>{EscMessageId::portLost, EscMessageId::portBack}));
    EXPECT_EQ(encoder().latest().state, EncoderState::operation);
    EXPECT_GT(encoder().latest().at, before + 1min);
    EXPECT_EQ(encoder().known(Parameter::serialNumber)->value, 4711);
    const auto answers = line.latest().figures.answers;
    line.advance(1s);
    EXPECT_GT(line.latest().figures.answers, answers + 50) << "at the old rate";
}

TEST_F(EscLine, AReadCutOffByUnpluggingIsNoWrite)
{
    std::optional<Outcome> outcome;
    QObject::connect(&encoder(), &EncoderSession::finished, &line,
                     [&](const Outcome &ended) { outcome = ended; });
    ASSERT_TRUE(encoder().start(
        ReadParameters{{Parameter::steps, Parameter::offset, Parameter::lowerLimit, Parameter::upperLimit}},
        Pace::byItself));
    line.advance(100ms);
    simulated->setUnplugged(true);
    line.advance(100ms);
    ASSERT_TRUE(outcome);
    EXPECT_EQ(outcome->result.error(),
              (Refusal{RefusalKind::link, RefusalId::portLost, {QStringLiteral("training")}}))
        << "in the language of whoever reads it";
    EXPECT_TRUE(refusalText(outcome->result.error())
                    .startsWith(QStringLiteral("The serial port training line is gone")));
    EXPECT_EQ(encoder().eepromWrites(), 0);
    EXPECT_EQ(encoder().start(ReadParameters{}, Pace::byItself).error().id, RefusalId::portLost);
}

TEST_F(EscLineWith28Bits, DeterminesTheFormatOfTheFactorAndUsesIt)
{
    ASSERT_TRUE(line.determineFractionBits(five));
    EXPECT_EQ(line.determineFractionBits(five).error().id, RefusalId::jobRunning);
    line.advance(2s);
    ASSERT_EQ(determined.size(), 1U);
    EXPECT_EQ(determined.front(), 28);
    EXPECT_EQ(drivers.front()->settings().fractionBits, 29) << "it sets nothing";
    line.setFractionBits(28);
    line.advance(10ms);
    EXPECT_EQ(drivers.front()->settings().fractionBits, 28);
}

// Manual, "Read Warning Parameters": an example reads 0098 as 9800h.
TEST_F(EscLine, TheWarningBytesOfOneEncoderAreSwapped)
{
    ASSERT_TRUE(line.add({3}, QStringLiteral("kuebler-esc-rs485")));
    line.advance(2s);
    ASSERT_EQ(encoder().latest().warnings, 0x8000);
    line.setSwapsWarningBytes(five, true);
    line.advance(2s);
    EXPECT_EQ(encoder().latest().warnings, 0x0080);
    EXPECT_EQ(encoder().known(Parameter::warnings)->value, 0x0080);
    EXPECT_TRUE(line.explainOptions().swaps({5}));
    EXPECT_FALSE(line.explainOptions().swaps({3}));

    ASSERT_TRUE(line.remove(five));
    EXPECT_FALSE(line.explainOptions().swaps({5})) << "it was a setting of that encoder";
    line.setSwapsWarningBytes(five, true); // no such encoder
}

TEST_F(EscLine, WhatCannotBeDeterminedIsTold)
{
    EXPECT_EQ(line.determineFractionBits(placeOnLine({7})).error().id, RefusalId::unknownDevice);
    simulated->setSilent(true);
    ASSERT_TRUE(line.determineFractionBits(five));
    line.advance(10s);
    ASSERT_EQ(determined.size(), 1U);
    EXPECT_EQ(determined.front().error().id, RefusalId::escNoAnswer);
}

} // namespace
} // namespace codewheel

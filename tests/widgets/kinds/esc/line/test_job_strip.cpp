// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/word_step.h"
#include "tests/widgets/kinds/esc/line/esc_line_bench.h"
#include "tests/widgets/training_bus_session.h"
#include "widgets/job/job_strip.h"

#include <QLabel>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

// What the strip shows for the first step of this job.
QString told(EncoderSession &encoder, const Step &step)
{
    JobStrip strip;
    strip.setEncoder(&encoder);
    strip.begin();
    Q_EMIT encoder.progressed({.job = 1, .steps = {step}, .confirmed = {}});
    return strip.findChild<QLabel *>()->text();
}

Step request(const char *line)
{
    return {.line = line};
}

TEST(JobStrip, TellsTheRequestsOfASerialEncoderAsWhatTheyAre)
{
    test::EscLineBench bench;
    bench.open();
    bench.addEncoder();
    EncoderSession &encoder = *bench.line->encoder(placeOnLine({5}));
    EXPECT_EQ(told(encoder, request("05P")), QStringLiteral("Step 1 of 1: 05: position?"));
    EXPECT_EQ(told(encoder, request("05GP00005200")),
              QStringLiteral("Step 1 of 1: 05: set preset to 5200h = 20992"));
}

TEST(JobStrip, TellsWordsAsTheWizardDoes)
{
    test::TrainingBusSession ring;
    EncoderSession &encoder = ring.encoder(test::fraba);
    EXPECT_EQ(told(encoder, {.effect = Effect::takes,
                             .kind = StepKind::parameter,
                             .out = 0x0200'00FF,
                             .parameters = {Parameter::steps}}),
              QStringLiteral("Step 1 of 1: Parameter 1 steps = 255"));
    EXPECT_EQ(told(encoder, {.effect = Effect::activates, .kind = StepKind::run, .out = 0x8000'0000}),
              QStringLiteral("Step 1 of 1: Run: the values become valid"));
}

} // namespace
} // namespace codewheel

// SPDX-License-Identifier: GPL-3.0-or-later
// A whole serial line in virtual time, with one byte in a hundred damaged: the driver, the runner, the
// exchange and an encoder that keeps the line's timing. Compares what was damaged and what was accepted,
// position by position.
#include "catalog/catalog.h"
#include "kinds/esc/driver/esc_driver.h"
#include "kinds/esc/line/esc_line_runner.h"
#include "kinds/esc/simulator/simulated_esc_line_link.h"
#include "kinds/interbus/make_driver.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr int polls = 10'000;
constexpr std::int64_t standsAt = 0x1235; // as in the manual's example
const QByteArray rightAnswer = "\r\n00001235\r\n";

struct Course
{
    int answersRight = 0;   // rows of the line
    int answersDamaged = 0; // well-formed, but with another value
    int takenWrong = 0;     // positions shown without a mark
    EscDriver::Figures guard;
    EscLineFigures line;
};

Course run(const EscLineFaults &faults)
{
    const Catalog catalog = Catalog::builtIn();
    const auto line = std::make_shared<SimulatedEscLine>();
    SimulatedEscLineLink link(line);
    EXPECT_TRUE(link.open({}));
    line->setFaults(faults);
    EscLineRunner runner(link, {}, {});
    auto made = std::make_unique<EscDriver>(*catalog.find(u"kuebler-esc-rs485"), EscLineAddress{5});
    const EscDriver &driver = *made;
    runner.post(line_command::AddDevice{std::move(made), QStringLiteral("encoder")});
    runner.post(line_command::SetRunning{true});

    Course run;
    bool asksPosition = false;
    Instant shownAt{};
    while (run.answersRight + run.answersDamaged < polls) {
        runner.turn(link.now() + 1ms);
        for (const EscLineEvent &event : runner.takeEvents()) {
            const auto *row = std::get_if<esc::EscLineRow>(&event.what);
            if (row && row->kind == esc::EscLineRow::Kind::sent)
                asksPosition = row->bytes.contains('P');
            if (row && row->kind == esc::EscLineRow::Kind::answer && asksPosition &&
                row->bytes.size() == rightAnswer.size())
                (row->bytes == rightAnswer ? run.answersRight : run.answersDamaged) += 1;
        }
        const Reading &reading = driver.reading();
        const bool isNew = std::exchange(shownAt, reading.at) != reading.at;
        if (isNew && reading.position && *reading.position != standsAt && !reading.suspect)
            ++run.takenWrong;
    }
    run.guard = driver.figures();
    run.line = runner.takeLatest()->figures;
    return run;
}

TEST(DamagedLine, ALineWithoutDamageLosesNothing)
{
    const Course clean = run({});
    EXPECT_EQ(clean.answersDamaged, 0);
    EXPECT_EQ(clean.takenWrong, 0);
    EXPECT_EQ(clean.line.timeOuts, 0U);
    EXPECT_EQ(clean.line.retries, 0U);
    EXPECT_EQ(clean.line.garbageBytes, 0U);
    EXPECT_EQ(clean.guard.suspect, 0);
    EXPECT_EQ(clean.line.requests, clean.line.answers);
}

TEST(DamagedLine, WhatIsNoAnswerIsNeverTakenAndWhatLooksRightIsMostlyCaught)
{
    const Course damaged = run({.corrupted = 10});
    // Every request ended in an answer or was counted as unanswered; every sending beyond the first is a
    // retry.
    EXPECT_EQ(damaged.line.requests, damaged.line.answers + damaged.line.unanswered + damaged.line.retries);
    EXPECT_GT(damaged.line.timeOuts, 0U);
    EXPECT_GT(damaged.line.garbageBytes, 0U);
    // The protocol has no checksum: some damaged digits look right.
    EXPECT_GT(damaged.answersDamaged, 0);
    EXPECT_GT(damaged.guard.suspect, 0);
    EXPECT_LT(damaged.takenWrong, damaged.answersDamaged);
    RecordProperty("answersRight", damaged.answersRight);
    RecordProperty("answersDamaged", damaged.answersDamaged);
    std::printf(
        "10 000 positions, 1 %% of bytes damaged: %d damaged values looked right, %d were marked suspect "
        "(%d refuted, %d confirmed), %d were taken: nearer than the shaft can turn; %llu requests, %llu "
        "time-outs, %llu "
        "retries, %llu unanswered, %llu garbage bytes\n",
        damaged.answersDamaged, damaged.guard.suspect, damaged.guard.refuted, damaged.guard.confirmed,
        damaged.takenWrong, static_cast<unsigned long long>(damaged.line.requests),
        static_cast<unsigned long long>(damaged.line.timeOuts),
        static_cast<unsigned long long>(damaged.line.retries),
        static_cast<unsigned long long>(damaged.line.unanswered),
        static_cast<unsigned long long>(damaged.line.garbageBytes));
}

} // namespace
} // namespace codewheel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/line/esc_line_runner.h"
#include "kinds/esc/line/esc_line_scan.h"
#include "kinds/esc/simulator/simulated_esc_line_link.h"

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using esc::Answer;
using esc::Command;

esc::ExchangeResult silence()
{
    return {.answer = {}, .sent = 1, .timeOuts = 1};
}

esc::ExchangeResult value(std::uint32_t value)
{
    esc::ExchangeResult result;
    result.answer = Answer{.kind = Answer::Kind::value, .value = value, .text = {}};
    result.sent = 1;
    return result;
}

using AnswerOf = std::function<esc::ExchangeResult(const EscLineScan::Step &)>;

std::vector<EscLineScan::Step> runThrough(EscLineScan &scan, const AnswerOf &answer)
{
    std::vector<EscLineScan::Step> steps;
    while (const auto step = scan.next()) {
        steps.push_back(*step);
        scan.answered(answer(*step));
        if (steps.size() > 1'000)
            break;
    }
    return steps;
}

TEST(EscLineScan, AsksEachAddressAtEachRateAndOnlyReads)
{
    EscLineScan scan({.baudRates = {19'200, 9'600, 4'800}});
    const auto steps = runThrough(scan, [](const auto &) { return silence(); });
    ASSERT_EQ(steps.size(), 2U * 3U * 31U) << "twice: there is nobody at all";
    EXPECT_EQ(steps.front().request.to, EscLineAddress{1});
    EXPECT_EQ(steps[30].request.to, EscLineAddress{31});
    EXPECT_EQ(steps[31].baudRate, 9'600);
    EXPECT_EQ(steps[31].request.to, EscLineAddress{1});
    EXPECT_EQ(steps[92].baudRate, 4'800);
    EXPECT_EQ(steps[93].baudRate, 19'200);
    EXPECT_EQ(steps.back().baudRate, 4'800);
    for (const auto &step : steps)
        EXPECT_FALSE(esc::shapeOf(step.request.command).writes);
    EXPECT_TRUE(scan.found().empty());
    EXPECT_EQ(scan.asked(), scan.total());
    EXPECT_EQ(scan.requests(), 186);
}

TEST(EscLineScan, AsksWhoAnswersForDeviceCodeAndVersion)
{
    EscLineScan scan({.baudRates = {9'600}, .first = {4}, .last = {6}});
    const auto steps = runThrough(scan, [](const EscLineScan::Step &step) {
        if (step.request.to != EscLineAddress{5})
            return silence();
        if (step.request.command == Command::serialNumber)
            return value(0x00123456);
        if (step.request.command == Command::deviceCode)
            return value(0x8000);
        esc::ExchangeResult version;
        version.answer = Answer{.kind = Answer::Kind::text, .value = 0, .text = "HW 1.2 SW 3.4"};
        return version;
    });
    const FoundEncoder expected{.address = {5},
                                .baudRate = 9'600,
                                .serialNumber = 0x00123456,
                                .deviceCode = 0x8000,
                                .version = QStringLiteral("HW 1.2 SW 3.4")};
    EXPECT_EQ(scan.found(), std::vector{expected});
    EXPECT_EQ(steps.size(), 2U + 3U * 2U) << "each value twice; an undamaged line is asked once";
}

// 03: the command is not known, so there is an encoder to say so.
TEST(EscLineScan, TakesARefusalForAnEncoderToo)
{
    EscLineScan scan({.baudRates = {19'200}, .first = {1}, .last = {1}});
    runThrough(scan, [](const auto &) {
        esc::ExchangeResult refused;
        refused.answer = Answer{.kind = Answer::Kind::unknownCommand, .value = 0, .text = "03"};
        return refused;
    });
    ASSERT_EQ(scan.found().size(), 1U);
    EXPECT_EQ(scan.found().front().serialNumber, std::nullopt);
    EXPECT_TRUE(scan.found().front().version.isEmpty());
}

TEST(EscLineScan, AsksAgainWhereOnlyGarbageCame)
{
    EscLineScan scan({.baudRates = {19'200}, .first = {1}, .last = {2}});
    const auto steps = runThrough(scan, [](const EscLineScan::Step &step) {
        auto result = silence();
        result.garbageBytes = step.request.to == EscLineAddress{1} ? 3 : 0;
        return result;
    });
    std::vector<int> addresses;
    addresses.reserve(steps.size());
    for (const auto &step : steps)
        addresses.push_back(step.request.to.value);
    EXPECT_EQ(addresses, (std::vector{1, 1, 1, 2, 2})) << "2 again at the end: the line is damaged";
}

// No checksum: a digit changed into another one looks right.
TEST(EscLineScan, TakesWhatTwoReadsAgreeOn)
{
    EscLineScan scan({.baudRates = {19'200}, .first = {5}, .last = {5}});
    std::map<Command, int> reads;
    runThrough(scan, [&](const EscLineScan::Step &step) {
        const bool isDamaged = ++reads[step.request.command] == 1;
        if (step.request.command == Command::serialNumber)
            return value(isDamaged ? 0x00923456 : 0x00123456);
        if (step.request.command == Command::deviceCode && isDamaged) {
            esc::ExchangeResult refused;
            refused.answer = Answer{.kind = Answer::Kind::unknownCommand, .value = 0, .text = "03"};
            return refused;
        }
        return value(0x8000);
    });
    ASSERT_EQ(scan.found().size(), 1U);
    EXPECT_EQ(scan.found().front().serialNumber, 0x00123456U);
    EXPECT_EQ(scan.found().front().deviceCode, 0x8000U);
}

TEST(EscLineScan, WhatNeverAgreesIsNotTold)
{
    EscLineScan scan({.baudRates = {19'200}, .first = {5}, .last = {5}});
    std::uint32_t code = 0x8000;
    const auto steps = runThrough(scan, [&](const EscLineScan::Step &step) {
        return value(step.request.command == Command::deviceCode ? ++code : 7);
    });
    ASSERT_EQ(scan.found().size(), 1U);
    EXPECT_EQ(scan.found().front().serialNumber, 7U);
    EXPECT_EQ(scan.found().front().deviceCode, std::nullopt);
    EXPECT_LT(steps.size(), 20U);
}

// The address in a request was damaged, and the encoder there answered.
TEST(EscLineScan, OneAnswerIsNoEncoder)
{
    EscLineScan scan({.baudRates = {19'200}, .first = {5}, .last = {6}});
    int asked = 0;
    runThrough(scan, [&](const EscLineScan::Step &step) {
        const bool isThere = step.request.to == EscLineAddress{5} || ++asked == 1;
        return isThere ? value(7) : silence();
    });
    ASSERT_EQ(scan.found().size(), 1U);
    EXPECT_EQ(scan.found().front().address, EscLineAddress{5});
}

TEST(EscLineScan, OnADamagedLineAsksAgainWhoSaidNothing)
{
    EscLineScan scan({.baudRates = {19'200, 9'600}, .first = {4}, .last = {6}});
    int asked = 0;
    const auto steps = runThrough(scan, [&](const EscLineScan::Step &step) {
        if (step.baudRate == 9'600)
            return silence();
        if (step.request.to == EscLineAddress{4})
            return ++asked == 1 ? silence() : value(4); // the first request was lost
        auto result = value(step.request.to.value);
        result.garbageBytes = 1;
        return result;
    });
    ASSERT_EQ(scan.found().size(), 3U);
    EXPECT_EQ(scan.found().front().address, EscLineAddress{4}) << "in order";
    EXPECT_EQ(std::ranges::count(steps, 9'600, &EscLineScan::Step::baudRate), 3);
    EXPECT_EQ(scan.total(), 7);
}

// One byte in a hundred: with one read per value, nearly every scan had an error.
TEST(EscLineScan, FindsTheTrainingLineThroughDamage)
{
    int right = 0;
    for (std::uint32_t seed = 1; seed <= 40; ++seed) {
        const auto line = std::make_shared<SimulatedEscLine>(trainingLine(), seed);
        SimulatedEscLineLink link(line);
        ASSERT_TRUE(link.open({}));
        line->setFaults({.corrupted = 10});
        EscLineRunner runner(link, {}, {});
        runner.post(line_command::Scan{{}});
        std::optional<ScanEnded> ended;
        while (!ended && link.now() < std::chrono::seconds(60)) {
            runner.turn(link.now() + std::chrono::milliseconds(100));
            for (const EscLineEvent &event : runner.takeEvents())
                if (const auto *end = std::get_if<ScanEnded>(&event.what))
                    ended = *end;
        }
        ASSERT_TRUE(ended);
        std::vector<std::pair<int, std::uint32_t>> found;
        for (const FoundEncoder &encoder : ended->found) {
            found.emplace_back(encoder.address.value, encoder.serialNumber.value_or(0));
            EXPECT_EQ(encoder.deviceCode, 0x8000U) << seed;
        }
        const bool isRight = found == std::vector<std::pair<int, std::uint32_t>>{
                                          {0x03, 0x0012D591}, {0x05, 0x0012D5A4}, {0x12, 0x00130008}};
        right += isRight ? 1 : 0;
        EXPECT_LT(link.now(), std::chrono::seconds(15)) << seed;
    }
    EXPECT_GE(right, 39) << "of 40";
}

TEST(EscLineScan, AsksAtTheMasterAddressFirstWhereThatIsWished)
{
    EscLineScan scan({.baudRates = {19'200}, .first = {1}, .last = {1}, .throughMaster = true});
    EXPECT_EQ(scan.total(), 2);
    const auto steps = runThrough(scan, [](const EscLineScan::Step &step) {
        return step.request.to.isMaster() ? value(7) : silence();
    });
    EXPECT_TRUE(steps.front().request.to.isMaster());
    ASSERT_EQ(scan.found().size(), 1U);
    EXPECT_TRUE(scan.found().front().address.isMaster());
}

} // namespace
} // namespace codewheel

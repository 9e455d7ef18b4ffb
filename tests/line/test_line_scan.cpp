// SPDX-License-Identifier: GPL-3.0-or-later
#include "line/line_scan.h"

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

using AnswerOf = std::function<esc::ExchangeResult(const LineScan::Step &)>;

std::vector<LineScan::Step> runThrough(LineScan &scan, const AnswerOf &answer)
{
    std::vector<LineScan::Step> steps;
    while (const auto step = scan.next()) {
        steps.push_back(*step);
        scan.answered(answer(*step));
        if (steps.size() > 1'000)
            break;
    }
    return steps;
}

TEST(LineScan, AsksEachAddressAtEachRateAndOnlyReads)
{
    LineScan scan({.baudRates = {19'200, 9'600, 4'800}});
    const auto steps = runThrough(scan, [](const auto &) { return silence(); });
    ASSERT_EQ(steps.size(), 3U * 31U);
    EXPECT_EQ(steps.front().request.to, LineAddress{1});
    EXPECT_EQ(steps[30].request.to, LineAddress{31});
    EXPECT_EQ(steps[31].baudRate, 9'600);
    EXPECT_EQ(steps[31].request.to, LineAddress{1});
    EXPECT_EQ(steps.back().baudRate, 4'800);
    for (const auto &step : steps)
        EXPECT_FALSE(esc::shapeOf(step.request.command).writes);
    EXPECT_TRUE(scan.found().empty());
    EXPECT_EQ(scan.asked(), scan.total());
    EXPECT_EQ(scan.requests(), 93);
}

TEST(LineScan, AsksWhoAnswersForDeviceCodeAndVersion)
{
    LineScan scan({.baudRates = {9'600}, .first = {4}, .last = {6}});
    runThrough(scan, [](const LineScan::Step &step) {
        if (step.request.to != LineAddress{5})
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
}

// 03: the command is not known, so there is an encoder that says so.
TEST(LineScan, TakesARefusalForAnEncoderToo)
{
    LineScan scan({.baudRates = {19'200}, .first = {1}, .last = {1}});
    runThrough(scan, [](const auto &) {
        esc::ExchangeResult refused;
        refused.answer = Answer{.kind = Answer::Kind::unknownCommand, .value = 0, .text = "03"};
        return refused;
    });
    ASSERT_EQ(scan.found().size(), 1U);
    EXPECT_EQ(scan.found().front().serialNumber, std::nullopt);
    EXPECT_TRUE(scan.found().front().version.isEmpty());
}

TEST(LineScan, AsksOnceMoreWhereOnlyGarbageCame)
{
    LineScan scan({.baudRates = {19'200}, .first = {1}, .last = {2}});
    const auto steps = runThrough(scan, [](const LineScan::Step &step) {
        auto result = silence();
        result.garbageBytes = step.request.to == LineAddress{1} ? 3 : 0;
        return result;
    });
    ASSERT_EQ(steps.size(), 3U);
    EXPECT_EQ(steps[1].request.to, LineAddress{1});
    EXPECT_EQ(steps[2].request.to, LineAddress{2});
}

TEST(LineScan, AsksAtTheMasterAddressFirstWhereThatIsWished)
{
    LineScan scan({.baudRates = {19'200}, .first = {1}, .last = {1}, .throughMaster = true});
    EXPECT_EQ(scan.total(), 2);
    const auto steps = runThrough(
        scan, [](const LineScan::Step &step) { return step.request.to.isMaster() ? value(7) : silence(); });
    EXPECT_TRUE(steps.front().request.to.isMaster());
    ASSERT_EQ(scan.found().size(), 1U);
    EXPECT_TRUE(scan.found().front().address.isMaster());
}

} // namespace
} // namespace codewheel

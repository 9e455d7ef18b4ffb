// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/esc/driver/esc_bench.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using State = EscPositionAgreement::State;

struct Agreed
{
    std::optional<std::int64_t> position; // nothing: never
    int reads = 0;

    friend bool operator==(const Agreed &, const Agreed &) = default;
};
void PrintTo(const Agreed &agreed, std::ostream *out)
{
    *out << agreed.position.value_or(-1) << " after " << agreed.reads;
}

// With a read every 20 ms.
Agreed agreementOf(const std::vector<std::int64_t> &positions, std::optional<std::int64_t> total = {})
{
    EscPositionGuard guard;
    guard.setScale({.total = total});
    EscPositionAgreement agreement;
    Agreed result;
    for (const std::int64_t position : positions) {
        const auto state = agreement.add({position, result.reads * 20ms}, guard);
        ++result.reads;
        if (state == State::agreed)
            result.position = agreement.last().position;
        if (state != State::wantsMore)
            break;
    }
    return result;
}

TEST(EscPositionAgreement, TakesWhatTwoReadsOrTheMovementOfThreeAgreeOn)
{
    EXPECT_EQ(agreementOf({4661, 4661}), (Agreed{4661, 2}));
    EXPECT_EQ(agreementOf({4661, 4677, 4661, 4661}), (Agreed{4661, 4})) << "1235 1245 1235";
    EXPECT_EQ(agreementOf({4660, 4661, 4661}), (Agreed{4661, 3})) << "1234 1235";
    EXPECT_EQ(agreementOf({20757, 4661, 4661}), (Agreed{4661, 3})) << "5115 1235";
    EXPECT_EQ(agreementOf({1000, 1160, 1320}), (Agreed{1320, 3})) << "it turns";
    EXPECT_EQ(agreementOf({1000, 1160, 1400}), (Agreed{1400, 3})) << "faster and faster";
    EXPECT_EQ(agreementOf({1000, 1160, 5416, 1480, 1640, 1800}), (Agreed{1800, 6})) << "one damaged";
    EXPECT_EQ(agreementOf({900, 60, 220}, 1000), (Agreed{220, 3})) << "over the end of the range";
    EXPECT_EQ(agreementOf({10, 11, 10}), (Agreed{10, 3})) << "at the edge of a step";
}

TEST(EscPositionAgreement, GivesUpWhereEachReadSaysSomethingElse)
{
    EXPECT_EQ(agreementOf({1, 500, 3, 4000, 90, 7000}), (Agreed{{}, 6}));
}

// Damages each digit of each answer to P once, with all other answers right.
class DamagedOnce
{
public:
    DamagedOnce(int damagedAnswer, std::uint32_t damage)
        : m_damagedAnswer(damagedAnswer)
        , m_damage(damage)
    {
        m_bench.position = [this](Instant) {
            const auto position = static_cast<std::uint32_t>(std::stoul(m_bench.has["P"], nullptr, 16));
            return m_answers++ == m_damagedAnswer ? position ^ m_damage : position;
        };
        m_bench.settle();
        m_damagedAnswer += m_answers;
    }
    const Outcome &finish(const Job &job)
    {
        m_bench.finish(job);
        m_wasReached = m_answers > m_damagedAnswer;
        return *m_bench.outcome;
    }
    bool wasReached() const { return m_wasReached; }

private:
    EscBench m_bench;
    int m_damagedAnswer;
    std::uint32_t m_damage;
    int m_answers = 0;
    bool m_wasReached = false;
};

void damageEach(const Job &job, std::int64_t after)
{
    for (const std::uint32_t damage : {0x1U, 0x8U, 0x10U, 0x80U, 0x400U, 0x1000U, 0x4000U, 0x10000U}) {
        bool isReached = true;
        for (int answer = 0; isReached; ++answer) {
            DamagedOnce line(answer, damage);
            const Outcome &outcome = line.finish(job);
            EXPECT_TRUE(outcome.result) << answer << ' ' << damage;
            EXPECT_EQ(outcome.positionBefore, 0x1235) << answer << ' ' << damage;
            EXPECT_EQ(outcome.positionAfter, after) << answer << ' ' << damage;
            isReached = line.wasReached();
            ASSERT_LT(answer, 100);
        }
    }
}

TEST(EscPositionAgreement, ADamagedDigitNeverReachesTheAccountOfAPreset)
{
    damageEach(SetPreset{.value = 0x5200}, 0x5200);
    damageEach(SetPreset{.value = 0x1300}, 0x1300);
}

TEST(EscPositionAgreement, ADamagedDigitNeverReachesTheAccountOfAWrite)
{
    damageEach(WriteParameters{.values = {{Parameter::lowerLimit, 0x200}}, .previous = {}}, 0x1235);
}

TEST(EscPositionAgreement, APositionThatIsNeverTheSameIsNotTold)
{
    EscBench bench;
    bench.settle();
    std::uint32_t random = 1;
    bench.position = [&](Instant) { return (random = random * 1'103'515'245U + 12'345U) >> 7; };
    const Outcome &written =
        bench.finish(WriteParameters{.values = {{Parameter::lowerLimit, 0x200}}, .previous = {}});
    EXPECT_TRUE(written.result);
    EXPECT_EQ(written.positionBefore, std::nullopt);
    EXPECT_EQ(written.positionAfter, std::nullopt);
    const Outcome &set = bench.finish(SetPreset{.value = 0x5200});
    EXPECT_TRUE(set.result) << "the preset value tells";
    EXPECT_EQ(set.positionAfter, std::nullopt);
}

TEST(EscPositionAgreement, WhatIsWrittenIsWrittenWhereThePositionIsSilent)
{
    EscBench bench;
    bench.settle();
    bench.always("P", EscBench::Fate::lost);
    const Outcome &outcome =
        bench.finish(WriteParameters{.values = {{Parameter::lowerLimit, 0x200}}, .previous = {}});
    EXPECT_TRUE(outcome.result);
    EXPECT_EQ(outcome.positionBefore, std::nullopt);
    EXPECT_EQ(outcome.written, (ParameterValues{{Parameter::lowerLimit, 0x200}}));
}

} // namespace
} // namespace codewheel

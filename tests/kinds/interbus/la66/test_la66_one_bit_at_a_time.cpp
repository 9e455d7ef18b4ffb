// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "kinds/interbus/la66/la66_driver.h"
#include "tests/kinds/interbus/words/driver_table.h"

#include <gtest/gtest.h>
#include <random>

// LA-66 manual 4, note 2: service bit and data never change in the same cycle. Random jobs, by themselves and
// by hand, cancelled and stopped, with an encoder that answers, refuses, is slow, talks nonsense or is dead:
// every pair of consecutive OUT words is checked.
namespace codewheel {
namespace {

constexpr Word serviceBit = 0x8000'0000;
constexpr int dataCycles = 2;

// Any encoder the driver may meet.
class RandomEncoder
{
public:
    explicit RandomEncoder(std::mt19937 &random)
        : m_random(random)
    {}

    Word cycle(Word out)
    {
        if (m_random() % 400 == 0)
            m_dead = m_random() % 2 == 0;
        if (m_random() % 400 == 0)
            m_slowness = 1 + static_cast<unsigned>(m_random() % 30);
        if (m_dead)
            return m_random() % 50 == 0 ? static_cast<Word>(m_random()) : m_in;
        if (m_random() % m_slowness != 0)
            return m_in;
        const bool asked = (out & serviceBit) != 0;
        if (asked && (m_in & serviceBit) == 0)
            m_in = answerTo(out);
        else if (!asked)
            m_in = m_random() % 10 == 0 ? pos | 0x2000'0000 : pos;
        return m_in;
    }

private:
    Word answerTo(Word out)
    {
        switch (m_random() % 8) {
        case 0:
            return out | 0x2000'0000;
        case 1:
            return static_cast<Word>(m_random()) | serviceBit;
        case 2:
            return out ^ 1;
        default:
            return out;
        }
    }

    std::mt19937 &m_random;
    bool m_dead = false;
    unsigned m_slowness = 1;
    Word m_in = pos;
};

// Checks what may change between consecutive words.
class OutWatch
{
public:
    void see(Word out, Word in)
    {
        const Word changed = m_out ^ out;
        const bool bitChanged = (changed & serviceBit) != 0;
        const bool restChanged = (changed & ~serviceBit) != 0;
        ASSERT_FALSE(bitChanged && restChanged) << std::hex << m_out << " -> " << out;
        if (restChanged)
            m_stoodFor = 0;
        if (bitChanged && (out & serviceBit) != 0) {
            ASSERT_GE(m_stoodFor, dataCycles) << std::hex << out;
            ASSERT_EQ(m_in & serviceBit, 0u) << "the answer before still stands; " << std::hex << out;
        }
        if (restChanged) {
            ASSERT_EQ((m_out | m_in) & serviceBit, 0u) << std::hex << m_out << " -> " << out;
        }
        ++m_stoodFor;
        m_out = out;
        m_in = in;
    }
    void alarmStop() // zeroes OUT at once: the one exception
    {
        m_out = 0;
        m_stoodFor = 0;
    }

private:
    Word m_out = 0; // of the last cycle, with the IN word beside it
    Word m_in = 0;
    int m_stoodFor = 1'000;
};

Word anyWord(std::mt19937 &random)
{
    const Word words[] = {0xC200'C350, 0x4200'C350, 0x8200'0000, 0x0000'0000, 0xC200'1388, 0x8800'0000};
    return random() % 3 == 0 ? static_cast<Word>(random()) : words[random() % std::size(words)];
}

Job anyJob(std::mt19937 &random)
{
    const auto length = static_cast<std::int64_t>(1 + random() % 0xFF'FFFF);
    const auto direction = static_cast<std::int64_t>(random() % 2);
    switch (random() % 5) {
    case 0:
        return ReadParameters{{Parameter::measuringLength, Parameter::errorStatus}};
    case 1:
        return SetPreset{.value = length};
    case 2: {
        SendWords send{.words = {}, .holdCycles = 1 + static_cast<int>(random() % 4)};
        for (unsigned i = 0; i < 1 + random() % 5; ++i)
            send.words.push_back(anyWord(random));
        return send;
    }
    case 3:
        return EndParameterization{};
    default:
        return WriteParameters{
            .values = {{Parameter::direction, direction}, {Parameter::measuringLength, length}},
            .onlyWhatDiffers = random() % 2 == 0,
            .previous = {{Parameter::direction, 0}, {Parameter::measuringLength, 50'000}}};
    }
}

TEST(La66OneBitAtATime, ServiceBitAndDataNeverChangeInOneCycle)
{
    const Catalog catalog = Catalog::builtIn();
    std::mt19937 random(66); // seeded: the same words in each run
    La66Driver driver(*catalog.find(u"tr-la66"), {.dataCycles = dataCycles, .timeOut = Instant{60'000}});
    RandomEncoder encoder(random);
    OutWatch watch;
    Word out = 0;
    int rising = 0;
    int finished = 0;
    for (int cycle = 1; cycle <= 500'000; ++cycle) {
        const Instant now = std::chrono::milliseconds(cycle);
        const Word in = encoder.cycle(out);
        watch.see(out, in);
        ASSERT_FALSE(testing::Test::HasFatalFailure()) << "cycle " << cycle;
        if (!driver.busy() && random() % 4 == 0)
            (void)driver.begin(1, anyJob(random), random() % 3 == 0 ? Pace::byHand : Pace::byItself, in, out,
                               now);
        if (random() % 3 == 0)
            driver.proceed();
        if (random() % 150 == 0 && driver.busy())
            driver.cancel(static_cast<OnCancel>(random() % 3), now);
        const Word next = driver.cycle(in, out, now);
        rising += (next & ~out & serviceBit) != 0;
        out = next;
        if (random() % 1'000 == 0) {
            driver.stop({RefusalKind::stopped, RefusalId::alarmStop, {}}, now);
            out = 0;
            watch.alarmStop();
        }
        for (const Event &event : driver.takeEvents())
            finished += std::holds_alternative<Outcome>(event);
    }
    EXPECT_GT(rising, 5'000) << "else nothing was asked";
    EXPECT_GT(finished, 5'000) << "else nothing came to its end";
}

} // namespace
} // namespace codewheel

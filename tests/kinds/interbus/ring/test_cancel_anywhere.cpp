// SPDX-License-Identifier: GPL-3.0-or-later
// Every job of every cyclic driver is cancelled between every two of its cycles. However early: the job ends,
// OUT is 0 again, and no command word goes out that was not there already.
#include "catalog/catalog.h"
#include "kinds/interbus/make_driver.h"
#include "kinds/interbus/simulator/simulated_la66.h"
#include "tests/kinds/interbus/ring/driven_encoder.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

namespace codewheel {
namespace {

constexpr int longestEnding = 20'000; // cycles

struct CancelledEncoder
{
    const char *name;
    const char16_t *device;
    std::unique_ptr<SimulatedDevice> (*make)();
    bool (*commands)(Word out);
    std::vector<std::pair<const char *, Job>> jobs;
};

std::unique_ptr<SimulatedDevice> fraba()
{
    return frabaK3();
}

std::unique_ptr<SimulatedDevice> baumer()
{
    return baumerK3();
}

std::unique_ptr<SimulatedDevice> rod()
{
    auto encoder = std::make_unique<SimulatedLa66>(500);
    encoder->moveMagnetTo(123.45);
    return encoder;
}

// A parameter number, the preset, or a word of the manufacturer's that is no read (2020....).
bool commandsK3(Word out)
{
    return (out & 0x5E00'0000) != 0 || ((out & 0x2000'0000) != 0 && (out & 0x00F0'0000) != 0x0020'0000);
}

// The write bit and the service bit.
bool commandsLa66(Word out)
{
    return (out & 0xC000'0000) == 0xC000'0000;
}

const CamProgram program{.number = 1, .cam = {Cam{100, 200, true}}};

const CancelledEncoder cancelledEncoders[] = {
    {"Fraba",
     u"fraba-ocd-ib",
     fraba,
     commandsK3,
     {{"read", ReadParameters{{Parameter::steps, Parameter::preset}}},
      {"write", WriteParameters{{{Parameter::steps, 255}, {Parameter::direction, 4}}, false, {}, true}},
      {"write what differs", WriteParameters{{{Parameter::steps, 255}}, true, {}, false}},
      {"preset", SetPreset{.value = 7}},
      {"manufacturer preset", SetPreset{{}, PresetCommand::manufacturer}},
      {"velocity", SwitchMode{Mode::velocity}},
      {"cam mode", SwitchMode{Mode::cam, 2}},
      {"reset", ResetToDefault{}},
      {"read cams", ReadCams{{1, 2}, SwitchMode{Mode::position}}},
      {"write cams", WriteCams{{program}, true, SwitchMode{Mode::position}}},
      {"words", SendWords{{0x0200'00FF, 0x8000'0000, 0x0000'0000}}}}},
    {"Baumer",
     u"baumer-gxp6w",
     baumer,
     commandsK3,
     {{"write", WriteParameters{{{Parameter::steps, 255}, {Parameter::coding, 4}}, false, {}, true}},
      {"preset", SetPreset{.value = 7}},
      {"words", SendWords{{0x0200'00FF, 0x8000'0000, 0x0000'0000}}}}},
    {"La66",
     u"tr-la66",
     rod,
     commandsLa66,
     {{"read", ReadParameters{{Parameter::measuringLength, Parameter::direction}}},
      {"write",
       WriteParameters{{{Parameter::measuringLength, 5'000}, {Parameter::direction, 1}}, false, {}, false}},
      {"write what differs", WriteParameters{{{Parameter::measuringLength, 5'000}}, true, {}, false}},
      {"preset", SetPreset{.value = 7}},
      {"words", SendWords{{0x4200'1388, 0xC200'1388, 0x4200'1388, 0x0000'0000}}}}},
};

// A driver with its encoder; the cycles before the job show it the encoder's position.
class CancelBench
{
public:
    CancelBench(const CancelledEncoder &what, int cyclesBefore)
        : m_encoder(what.make())
        , m_driver(makeDriver(device(what.device)))
    {
        m_driver->setKnown({{Parameter::startUpMode, 1, Evidence::told, {}}});
        cycles(cyclesBefore);
        sent.clear();
    }

    void begin(const Job &job) { ASSERT_TRUE(m_driver->begin(1, job, Pace::byItself, m_in, m_out, m_now)); }
    void cancel(OnCancel how) { m_driver->cancel(how, m_now); }
    void cycles(int count)
    {
        for (int i = 0; i < count; ++i)
            cycle();
    }
    bool finish()
    {
        for (int i = 0; i < longestEnding && !outcome; ++i)
            cycle();
        cycles(5);
        return outcome.has_value();
    }
    Word out() const { return m_out; }

    std::optional<Outcome> outcome;
    std::vector<Word> sent; // what was put into OUT, cycle by cycle

private:
    static const DeviceDescription &device(QStringView key)
    {
        static const Catalog catalog = Catalog::builtIn();
        return *catalog.find(key);
    }

    void cycle()
    {
        m_now += std::chrono::milliseconds(1);
        m_in = m_encoder->cycle(m_out);
        m_out = m_driver->cycle(m_in, m_out, m_now);
        sent.push_back(m_out);
        for (Event &event : m_driver->takeEvents())
            if (auto *ended = std::get_if<Outcome>(&event))
                outcome = std::move(*ended);
    }

    std::unique_ptr<SimulatedDevice> m_encoder;
    std::unique_ptr<CyclicDriver> m_driver;
    Word m_in = 0;
    Word m_out = 0;
    Instant m_now{};
};

class CancelAnywhere : public testing::TestWithParam<CancelledEncoder>
{
protected:
    static int lengthOf(const Job &job)
    {
        CancelBench bench(GetParam(), 10);
        bench.begin(job);
        EXPECT_TRUE(bench.finish());
        return static_cast<int>(bench.sent.size());
    }
};

constexpr OnCancel waysToCancel[] = {OnCancel::restorePrevious, OnCancel::runWithWhatItHas,
                                     OnCancel::leaveAsIs, OnCancel::ifNothingTaken};

TEST_P(CancelAnywhere, BeforeTheFirstCycleNothingIsEverSent)
{
    for (const auto &[name, job] : GetParam().jobs)
        for (const OnCancel how : waysToCancel)
            for (const int cyclesBefore : {0, 10}) {
                SCOPED_TRACE(name + std::string(", ") + std::to_string(static_cast<int>(how)) +
                             ", seen for " + std::to_string(cyclesBefore));
                CancelBench bench(GetParam(), cyclesBefore);
                bench.begin(job);
                bench.cancel(how);
                ASSERT_TRUE(bench.finish());
                ASSERT_FALSE(bench.outcome->result);
                EXPECT_EQ(bench.outcome->result.error().id, RefusalId::cancelled);
                EXPECT_EQ(bench.outcome->eepromWrites, 0);
                EXPECT_EQ(std::ranges::count_if(bench.sent, GetParam().commands), 0);
                EXPECT_EQ(bench.out(), 0u);
            }
}

TEST_P(CancelAnywhere, NothingIsCommandedThatDidNotStandInOut)
{
    for (const auto &[name, job] : GetParam().jobs) {
        const int length = lengthOf(job);
        for (int k = 0; k <= length && !HasFailure(); ++k) {
            SCOPED_TRACE(name + std::string(", cycle ") + std::to_string(k));
            CancelBench bench(GetParam(), 10);
            bench.begin(job);
            bench.cycles(k);
            const Word standing = bench.out();
            const bool wasOver = bench.outcome.has_value();
            bench.sent.clear();
            bench.cancel(OnCancel::leaveAsIs);
            ASSERT_TRUE(bench.finish());
            EXPECT_EQ(bench.out(), 0u);
            if (!wasOver) {
                ASSERT_FALSE(bench.outcome->result);
                EXPECT_EQ(bench.outcome->result.error().id, RefusalId::cancelled);
            }
            for (const Word word : bench.sent)
                EXPECT_TRUE(word == standing || !GetParam().commands(word)) << std::hex << word;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(EveryDriver, CancelAnywhere, testing::ValuesIn(cancelledEncoders),
                         [](const auto &each) { return each.param.name; });

} // namespace
} // namespace codewheel

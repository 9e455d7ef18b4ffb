// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "kinds/interbus/la66/la66_driver.h"
#include "kinds/interbus/ring/ring_watch.h"
#include "kinds/interbus/simulator/simulated_la66.h"
#include "kinds/interbus/words/word_refusals.h"

#include <gtest/gtest.h>

// The driver with a simulated LA-66: whatever happens to a job, its outcome reports what the encoder has.
namespace codewheel {
namespace {

constexpr int longest = 20'000; // cycles within which any job has ended

class DrivenRod
{
public:
    DrivenRod() { encoder.moveMagnetTo(123.45); }

    void begin(const Job &job)
    {
        cycle();
        ASSERT_TRUE(m_driver.begin(1, job, Pace::byItself, m_in, m_out, m_now));
    }
    void cycle()
    {
        m_now += std::chrono::milliseconds(1);
        m_in = encoder.cycle(m_out);
        m_out = m_driver.cycle(m_in, m_out, m_now);
        for (Event &event : m_driver.takeEvents()) {
            if (auto *ended = std::get_if<Outcome>(&event))
                outcome = std::move(*ended);
            else if (const auto *change = std::get_if<KnowledgeChanged>(&event))
                countedWrites += change->eepromWrites;
        }
    }
    void cancel(OnCancel how) { m_driver.cancel(how, m_now); }
    void finish()
    {
        for (int i = 0; i < longest && !outcome; ++i)
            cycle();
        ASSERT_TRUE(outcome) << "the job does not end";
    }
    void alarmStop()
    {
        m_driver.stop({RefusalKind::stopped, RefusalId::alarmStop, {}}, m_now);
        m_out = 0;
    }
    void expectWritten() const
    {
        for (const auto &[parameter, value] : outcome->written)
            EXPECT_EQ(parameter == Parameter::direction ? encoder.parameters().direction
                                                        : encoder.parameters().measuringLength,
                      value);
    }
    void expectTruth() const
    {
        expectWritten();
        EXPECT_EQ(countedWrites, encoder.eepromWrites());
        EXPECT_EQ(m_out, 0u);
    }
    const Reading &reading() const { return m_driver.reading(); }

    SimulatedLa66 encoder{500};
    std::optional<Outcome> outcome;
    int countedWrites = 0;

private:
    static const DeviceDescription &description()
    {
        static const Catalog catalog = Catalog::builtIn();
        return *catalog.find(u"tr-la66");
    }

    La66Driver m_driver{description()};
    Word m_in = 0;
    Word m_out = 0;
    Instant m_now{};
};

WriteParameters lengthAndDirection()
{
    return {.values = {{Parameter::measuringLength, 5'000}, {Parameter::direction, 1}},
            .onlyWhatDiffers = true,
            .previous = {}};
}

TEST(La66Jobs, AWriteIsThereAndReadBack)
{
    DrivenRod rod;
    rod.begin(lengthAndDirection());
    rod.finish();
    EXPECT_TRUE(rod.outcome->result);
    EXPECT_EQ(rod.outcome->written, lengthAndDirection().values);
    EXPECT_EQ(rod.outcome->eepromWrites, 2);
    EXPECT_EQ(rod.reading().position, 5'000 - 1'234);
    rod.expectTruth();
}

TEST(La66Jobs, CancelledInAnyCycleTheOutcomeTellsWhatTheEncoderHas)
{
    for (const OnCancel how : {OnCancel::restorePrevious, OnCancel::runWithWhatItHas, OnCancel::leaveAsIs})
        for (int when = 0; when < 60; ++when) {
            DrivenRod rod;
            rod.begin(lengthAndDirection());
            for (int i = 0; i < when && !rod.outcome; ++i)
                rod.cycle();
            const bool ended = rod.outcome.has_value();
            rod.cancel(how);
            rod.finish();
            rod.expectTruth();
            EXPECT_EQ(rod.reading().state, EncoderState::operation);
            if (how == OnCancel::restorePrevious && !ended) {
                EXPECT_EQ(rod.encoder.parameters().measuringLength, 50'000u) << when;
                EXPECT_EQ(rod.encoder.parameters().direction, 0u) << when;
            }
        }
}

TEST(La66Jobs, AfterAnAlarmStopInAnyCycleTheNextJobFindsItsWay)
{
    for (const bool slow : {false, true})
        for (int when = 0; when < 60; ++when) {
            DrivenRod rod;
            rod.encoder.setSlow(slow);
            rod.begin(lengthAndDirection());
            for (int i = 0; i < when && !rod.outcome; ++i)
                rod.cycle();
            rod.alarmStop();
            for (int i = 0; i < 200; ++i) // a slow one still works on its service
                rod.cycle();
            rod.outcome.reset();
            rod.begin(lengthAndDirection());
            rod.finish();
            EXPECT_TRUE(rod.outcome->result) << when;
            EXPECT_EQ(rod.encoder.parameters().measuringLength, 5'000u);
            EXPECT_EQ(rod.encoder.parameters().direction, 1u);
            rod.expectTruth();
        }
}

TEST(La66Jobs, APowerCycleInAnyCycleLeavesNothingUntrue)
{
    int failed = 0;
    for (int when = 0; when < 60; ++when) {
        SCOPED_TRACE(when);
        DrivenRod rod;
        rod.begin(lengthAndDirection());
        for (int i = 0; i < when && !rod.outcome; ++i)
            rod.cycle();
        rod.encoder.powerCycle();
        rod.finish();
        rod.expectWritten();
        if (rod.outcome->result) {
            EXPECT_EQ(rod.outcome->written, lengthAndDirection().values);
        }
        failed += rod.outcome->result ? 0 : 1;
    }
    EXPECT_GT(failed, 0);
    EXPECT_LT(failed, 60);
}

TEST(La66Jobs, ServicesGoOnWhileTheMagnetIsLost)
{
    DrivenRod rod;
    rod.encoder.setMagnetInRange(false);
    rod.begin(ReadParameters{{Parameter::errorStatus}});
    rod.finish();
    EXPECT_EQ(rod.outcome->read, (ParameterValues{{Parameter::errorStatus, 32}}));
    EXPECT_EQ(rod.reading().state, EncoderState::error);
    EXPECT_EQ(rod.reading().position, 12'345);

    rod.encoder.setMagnetInRange(true);
    rod.outcome.reset();
    rod.begin(ReadParameters{{Parameter::errorStatus}});
    rod.finish();
    rod.cycle();
    EXPECT_EQ(rod.reading().state, EncoderState::operation);
}

TEST(La66Jobs, AnInvalidWordIsRefusedByTheEncoderItself)
{
    DrivenRod rod;
    rod.begin(SendWords{{0xC200'0000, 0x0000'0000}, 3});
    rod.finish();
    ASSERT_FALSE(rod.outcome->result);
    EXPECT_EQ(
        rod.outcome->result.error(),
        (Refusal{RefusalKind::device, WordRefusalId::serviceRefused, {std::int64_t{2}, Word{0xE200'0000}}}));
    rod.outcome.reset();
    rod.begin(EndParameterization{});
    rod.finish();
    EXPECT_TRUE(rod.outcome->result);
    EXPECT_EQ(rod.outcome->leftIn, EncoderState::operation);
}

// A service in between says nothing about the magnet.
TEST(La66Jobs, ALostMagnetIsToldOnce)
{
    const auto reading = [](EncoderState state) {
        Reading shown;
        shown.state = state;
        if (state == EncoderState::error)
            shown.errorNumber = 5;
        return shown;
    };
    FaultWatch watch(1);
    EXPECT_TRUE(watch.look(0, reading(EncoderState::error)));
    EXPECT_FALSE(watch.look(0, reading(EncoderState::service)));
    EXPECT_FALSE(watch.look(0, reading(EncoderState::error)));
    EXPECT_TRUE(watch.look(0, reading(EncoderState::operation)));
}

} // namespace
} // namespace codewheel

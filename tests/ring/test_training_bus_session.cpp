// SPDX-License-Identifier: GPL-3.0-or-later
// The whole way of the main job below the window: session, runner, driver, simulated encoder.
#include "catalog/catalog.h"
#include "ring/bus_session.h"
#include "simulator/training_bus.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

const DeviceNumber fraba{1, 0};

class TrainingBusSession : public testing::Test
{
protected:
    TrainingBusSession()
    {
        EXPECT_TRUE(m_bus.open(BusSession::Start::operating));
        QObject::connect(m_bus.encoder(fraba), &EncoderSession::finished, &m_bus,
                         [this](const Outcome &outcome) { m_outcome = outcome; });
        encoder().tell(Parameter::startUpMode, 1); // position mode
        m_bus.advance(10);
    }
    EncoderSession &encoder() { return *m_bus.encoder(fraba); }
    // At most 5 s of bus time.
    void finish(const Job &job)
    {
        m_outcome.reset();
        ASSERT_TRUE(encoder().start(job));
        for (int i = 0; i < 500 && !m_outcome; ++i)
            m_bus.advance(10);
        ASSERT_TRUE(m_outcome);
    }

    const Catalog m_catalog = Catalog::builtIn();
    TrainingBus m_training = makeTrainingBus(m_catalog);
    BusSession m_bus{std::move(m_training.link), m_catalog, QDateTime(QDate(2026, 3, 1), QTime(14, 2))};
    std::optional<Outcome> m_outcome;
};

TEST_F(TrainingBusSession, Sets255StepsAndReadsThemBack)
{
    finish(WriteParameters{.values = {{Parameter::steps, 255},
                                      {Parameter::revolutions, 1},
                                      {Parameter::direction, 3},
                                      {Parameter::preset, 0}},
                           .onlyWhatDiffers = false,
                           .previous = {},
                           .initialisePreset = true});
    EXPECT_TRUE(m_outcome->result);
    EXPECT_EQ(encoder().latest().position, 0);
    EXPECT_EQ(encoder().eepromWrites(), m_outcome->eepromWrites);
    EXPECT_EQ(m_bus.devicesWithOut().size(), 0u);

    finish(ReadParameters{{Parameter::steps}});
    EXPECT_EQ(valueOf(m_outcome->read, Parameter::steps), 255);
    ASSERT_TRUE(encoder().known(Parameter::steps));
    EXPECT_EQ(encoder().known(Parameter::steps)->value, 255);
    EXPECT_EQ(encoder().known(Parameter::steps)->evidence, Evidence::read);
}

TEST_F(TrainingBusSession, AnEncoderThatLosesItsParametersIsKnownNoMore)
{
    finish(ReadParameters{{Parameter::steps}});
    ASSERT_TRUE(encoder().known(Parameter::steps));
    m_training.controls->loseParameters(fraba);
    m_bus.advance(10);
    EXPECT_EQ(encoder().latest().state, EncoderState::error);
    EXPECT_FALSE(encoder().known(Parameter::steps));
}

TEST_F(TrainingBusSession, AlarmStopInTheMiddleOfAHandshakeZeroesOut)
{
    ASSERT_TRUE(encoder().start(WriteParameters{{{Parameter::steps, 255}}, false, {}, false}));
    m_bus.advance(3);
    ASSERT_EQ(m_bus.devicesWithOut(), std::vector<DeviceNumber>{fraba});
    m_bus.alarmStop();
    m_bus.advance(1);
    EXPECT_TRUE(m_bus.devicesWithOut().empty());
    ASSERT_TRUE(m_outcome);
    EXPECT_EQ(m_outcome->result.error().id, RefusalId::alarmStop);
}

} // namespace
} // namespace codewheel

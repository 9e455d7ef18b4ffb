// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "history/histories.h"
#include "kinds/interbus/ring/ring_session.h"
#include "kinds/interbus/simulator/training_bus.h"
#include "tests/support/places.h"
#include "trend/trend_csv.h"
#include "trend/trend_origin.h"

#include <QBuffer>

#include <gmock/gmock.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

const Catalog &builtInDevices()
{
    static const Catalog builtIn = Catalog::builtIn();
    return builtIn;
}

const QDateTime opened(QDate(2026, 3, 1), QTime(13, 2), Qt::UTC);
const Place turning = "4.0"_ring;

class TrendOfBus : public testing::Test
{
protected:
    TrendOfBus()
    {
        buses.add(ring);
        EXPECT_TRUE(ring.open(EncoderBus::Start::operating));
        training.controls->setSpeed(turning.node, 60);
        for (Instant passed{}; passed < 1s; passed += 20ms)
            ring.advance(20ms);
    }

    TrainingBus training = makeTrainingBus(builtInDevices());
    RingSession ring{std::move(training.link), builtInDevices(), opened};
    Buses buses;
    Histories histories{buses};
};

TEST_F(TrendOfBus, HasEveryCycle)
{
    const TrendExtract extract{.columns = {{{turning, Channel::position, {}}, {}, {}},
                                           {{turning, Channel::in, {}}, {}, {}},
                                           {{"99.0"_ring, Channel::in, {}}, {}, {}}},
                               .span = *histories.span()};
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    TrendCsv csv(buffer, extract, historyOf(histories));
    while (csv.writeSome()) {
    }
    EXPECT_NEAR(static_cast<double>(csv.rows()), 1'000, 30);
    const QStringList rows = QString::fromUtf8(buffer.data()).split(QStringLiteral("\r\n"));
    EXPECT_TRUE(rows[1].startsWith(QStringLiteral("17723701"))) << rows[1].toStdString();
    const QStringList last = rows[rows.size() - 2].split(u',');
    EXPECT_EQ(last[1].toLongLong(), histories.of(turning)->of(Channel::position).newest()->value);
    EXPECT_EQ(last[2].toLongLong(), histories.of(turning)->of(Channel::in).newest()->value);
    EXPECT_EQ(last[3], QString());
}

TEST_F(TrendOfBus, KnowsItsEncoder)
{
    EncoderSession &encoder = *ring.encoder(turning);
    encoder.tell(Parameter::steps, 4'096);
    const TrendEncoder told = trendEncoder(encoder);
    EXPECT_EQ(told.place, turning);
    EXPECT_EQ(told.device, encoder.device().key);
    EXPECT_EQ(told.deviceName, encoder.device().fullName());
    EXPECT_THAT(told.values,
                testing::Contains(testing::AllOf(testing::Field(&TrendValue::parameter, Parameter::steps),
                                                 testing::Field(&TrendValue::value, 4'096),
                                                 testing::Field(&TrendValue::evidence, Evidence::told))));
}

} // namespace
} // namespace codewheel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/ring_refusals.h"
#include "kinds/interbus/simulator/fault_plan.h"
#include "kinds/interbus/simulator/training_bus.h"
#include "tests/support/faulty_ring.h"
#include "vocabulary/refusal_text.h"

#include <QFile>
#include <QTemporaryDir>

#include <gtest/gtest.h>
#include <sys/stat.h>

namespace codewheel {
namespace {

QByteArray planOf(const char *steps)
{
    return QByteArray("{\n\"format\": \"codewheel-faults\",\n\"version\": 1,\n\"steps\": [\n") + steps +
           "\n]}";
}

class AFaultPlan : public testing::Test
{
protected:
    Result<FaultPlan> read(const QByteArray &json) const
    {
        return faultPlanFromJson(json, QStringLiteral("lesson.json"), m_training.controls->places());
    }
    // The line and key of the error.
    std::pair<std::int64_t, QString> fault(const QByteArray &json) const
    {
        const auto refused = read(json);
        if (refused)
            return {-1, QStringLiteral("taken")};
        EXPECT_EQ(refused.error().id, RingRefusalId::faultPlanBroken);
        return {std::get<std::int64_t>(refused.error().arguments[1]),
                std::get<QString>(refused.error().arguments[2])};
    }

    const Catalog m_catalog = Catalog::builtIn();
    TrainingBus m_training = makeTrainingBus(m_catalog);
};

TEST_F(AFaultPlan, HoldsItsStepsAsTheyAreWritten)
{
    const auto plan = read(planOf(R"({"at": 0, "fault": "crcErrors", "place": "2.0", "perThousand": 5},
        {"at": 1500, "fault": "wireBreak", "place": "6.1"},
        {"at": 1500, "fault": "wireBreak", "place": "6.1", "on": false})"));
    ASSERT_TRUE(plan) << refusalText(plan.error()).toStdString();
    using std::chrono::milliseconds;
    EXPECT_EQ(plan->steps, (std::vector<FaultStep>{
                               {milliseconds(0), TrainingFault::crcErrors, NodeId("2.0"), 5},
                               {milliseconds(1'500), TrainingFault::wireBreak, NodeId("6.1"), 1},
                               {milliseconds(1'500), TrainingFault::wireBreak, NodeId("6.1"), 0},
                           }));
}

TEST_F(AFaultPlan, APipeIsNoFile)
{
    const QTemporaryDir folder;
    const QString pipe = folder.filePath(QStringLiteral("pipe"));
    ASSERT_EQ(::mkfifo(pipe.toLocal8Bit().constData(), 0600), 0);
    const auto refused = loadFaultPlan(pipe, m_training.controls->places());
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().id, RefusalId::fileNotReadable);
    EXPECT_EQ(refusalText(refused.error()), pipe + QStringLiteral(" cannot be read: It is not a file."));
}

TEST_F(AFaultPlan, IsRefusedWithLineAndKey)
{
    const auto at = [](std::int64_t line, const char *key) {
        return std::pair(line, QString::fromLatin1(key));
    };
    EXPECT_EQ(fault("{"), at(1, ""));
    EXPECT_EQ(fault(R"({"format": "codewheel-cams"})"), at(1, "format"));
    EXPECT_EQ(fault(planOf("")), at(4, "steps"));
    EXPECT_EQ(fault(planOf(R"({"at": 1, "fault": "fire", "place": "1.0"})")), at(5, "steps[0].fault"));
    EXPECT_EQ(fault(planOf(R"({"at": 1, "fault": "wireBreak", "place": "9.0"})")), at(5, "steps[0].place"));
    EXPECT_EQ(fault(planOf(R"({"at": -1, "fault": "wireBreak", "place": "1.0"})")), at(5, "steps[0].at"));
    EXPECT_EQ(fault(planOf(R"({"at": 1, "fault": "batteryLow", "place": "1.0"})")), at(5, "steps[0].fault"));
    EXPECT_EQ(fault(planOf(R"({"at": 1, "fault": "crcErrors", "place": "1.0", "on": true})")),
              at(5, "steps[0].on"));
    EXPECT_EQ(fault(planOf(R"({"at": 1, "fault": "crcErrors", "place": "1.0", "perThousand": 101})")),
              at(5, "steps[0].perThousand"));
    EXPECT_EQ(fault(planOf(R"({"at": 1, "fault": "parametersLost", "place": "1.0", "on": false})")),
              at(5, "steps[0].on"));
    EXPECT_EQ(fault(planOf("{\"at\": 2, \"fault\": \"wireBreak\", \"place\": \"1.0\"},\n"
                           "{\"at\": 1, \"fault\": \"wireBreak\", \"place\": \"1.0\"}")),
              at(6, "steps[1].at"));
}

TEST_F(AFaultPlan, OfTheExamplesIsSound)
{
    QFile file(QStringLiteral(":/examples/faults.json"));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const auto plan = read(file.readAll());
    EXPECT_TRUE(plan) << refusalText(plan.error()).toStdString();
}

// In exactly the cycle of its time, whether the ring runs or not.
TEST(ARunningFaultPlan, IsCarriedOutByTheClockOfTheRing)
{
    FaultyRing faulty;
    ASSERT_TRUE(faulty.link->open());
    using std::chrono::milliseconds;
    faulty.ring->startFaultPlan({{},
                                 {{milliseconds(10), TrainingFault::wireBreak, NodeId("2.0"), 1},
                                  {milliseconds(60), TrainingFault::wireBreak, NodeId("2.0"), 0}}});
    MasterLink &master = *faulty.link->master();
    const std::vector<Word> out(FaultyRing::devices);
    std::vector<Word> in(FaultyRing::devices);
    for (int i = 0; i < 10; ++i)
        ASSERT_TRUE(faulty.link->exchange(out, in)) << i;
    EXPECT_EQ(faulty.ring->planProgress().next, 0U);
    EXPECT_EQ(faulty.ring->planProgress().elapsed, milliseconds(9));
    EXPECT_FALSE(faulty.link->exchange(out, in));
    EXPECT_EQ(faulty.ring->planProgress().next, 1U);
    for (int i = 11; i < 60; ++i)
        master.idleCycle();
    EXPECT_EQ(master.status().parameter, 0x0180);
    EXPECT_TRUE(faulty.ring->planProgress().isRunning);
    master.idleCycle();
    EXPECT_EQ(master.status().state, MasterState::ready);
    EXPECT_FALSE(faulty.ring->planProgress().isRunning);
}

TEST(ARunningFaultPlan, CanBeStopped)
{
    FaultyRing faulty;
    ASSERT_TRUE(faulty.link->open());
    faulty.ring->startFaultPlan(
        {{}, {{std::chrono::milliseconds(2), TrainingFault::wireBreak, NodeId("2.0"), 1}}});
    faulty.ring->stopFaultPlan();
    const std::vector<Word> out(FaultyRing::devices);
    std::vector<Word> in(FaultyRing::devices);
    for (int i = 0; i < 10; ++i)
        EXPECT_TRUE(faulty.link->exchange(out, in));
}

TEST(AFaultThatFits, IsToldByPlace)
{
    FaultyRing faulty;
    const auto faults = [&](NodeId number) {
        std::vector<TrainingFault> found;
        for (const TrainingPlace &place : faulty.ring->places())
            if (place.number == number)
                for (const auto &standing : place.faults)
                    found.push_back(standing.fault);
        return found;
    };
    EXPECT_EQ(faults(NodeId("3.0")), (std::vector{TrainingFault::wireBreak, TrainingFault::crcErrors,
                                                  TrainingFault::noSupply, TrainingFault::peripheralFault}));
    EXPECT_EQ(
        faults(NodeId("3.1")),
        (std::vector{TrainingFault::wireBreak, TrainingFault::noSupply, TrainingFault::wrongDevice,
                     TrainingFault::peripheralFault, TrainingFault::powerOff, TrainingFault::slowConfirmation,
                     TrainingFault::parametersLost, TrainingFault::camOutOfRange}));
}

// FRABA manual 10.4: manufacturer error, a cam's start or stop above the largest position
TEST(ACamOutOfRange, ShowsByItselfUntilRunAfterItIsGone)
{
    FrabaK3 encoder({}, 12'345, {});
    encoder.cycle(0);
    encoder.setCamOutOfRange(true);
    EXPECT_EQ(encoder.cycle(0), 0x9800'0004U);
    for (int i = 0; i < 10; ++i)
        encoder.cycle(0x8000'0000);
    EXPECT_EQ(encoder.cycle(0), 0x9800'0004U);
    encoder.setCamOutOfRange(false);
    for (int i = 0; i < 10; ++i)
        encoder.cycle(0);
    EXPECT_EQ(encoder.cycle(0), 0x9800'0004U);
    for (int i = 0; i < 10; ++i)
        encoder.cycle(0x8000'0000);
    EXPECT_EQ(encoder.cycle(0), 12'345U);
}

} // namespace
} // namespace codewheel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/places.h"
#include "tests/transfer/transfer_bus.h"
#include "transfer/last_positions.h"

namespace codewheel {
namespace {

using test::fraba;

class LastPositionsOfTheRing : public test::TransferBus
{
protected:
    void pass(int milliseconds)
    {
        for (int i = 0; i < milliseconds / 33 + 1; ++i)
            bus.advance(33);
    }
    LastPositions positions{buses};
};

TEST_F(LastPositionsOfTheRing, AreThoseTheEncodersShow)
{
    pass(100);
    ASSERT_TRUE(positions.at(fraba));
    EXPECT_EQ(positions.at(fraba)->position, encoder(fraba).latest().position);
    EXPECT_FALSE(positions.at(fraba)->beforeItWent);
    EXPECT_FALSE(positions.at("9.0"_ring));
}

TEST_F(LastPositionsOfTheRing, ThePositionBeforeAnEncoderWentIsKeptWhenAnotherOneIsThere)
{
    pass(100);
    const auto before = encoder(fraba).latest().position;
    training.controls->setFault(TrainingFault::powerOff, fraba.node, 1);
    pass(3000);
    ASSERT_TRUE(positions.at(fraba));
    EXPECT_EQ(positions.at(fraba)->position, before);
    EXPECT_TRUE(positions.at(fraba)->beforeItWent);

    training.controls->turnBy(fraba.node, 100);
    training.controls->setFault(TrainingFault::powerOff, fraba.node, 0);
    pass(3000);
    EXPECT_NE(encoder(fraba).latest().position, before);
    EXPECT_EQ(positions.at(fraba)->position, before);
}

TEST_F(LastPositionsOfTheRing, APositionThatIsZeroForAMomentIsNoEncoderThatWent)
{
    pass(100);
    training.controls->setFault(TrainingFault::powerOff, fraba.node, 1);
    pass(300);
    training.controls->setFault(TrainingFault::powerOff, fraba.node, 0);
    pass(100);
    EXPECT_FALSE(positions.at(fraba)->beforeItWent);
}

TEST_F(LastPositionsOfTheRing, AreKeptWithTheProjectWhenItIsSaved)
{
    Project project;
    for (const Participant &participant : bus.structure()) {
        project.devices.emplace_back().participant = participant;
        project.devices.back().lastPosition = {1, QDateTime(QDate(2026, 2, 1), QTime(8, 0), Qt::UTC)};
    }
    pass(100);
    const auto before = encoder(fraba).latest().position;
    EXPECT_EQ(withLastPositions(project, positions, buses).devices[0].lastPosition->position, before);

    training.controls->setFault(TrainingFault::powerOff, fraba.node,
                                1); // it dies, and is replaced later
    pass(3000);
    EXPECT_EQ(withLastPositions(project, positions, buses).devices[0].lastPosition->position, before);
    training.controls->turnBy(fraba.node, 100);
    training.controls->setFault(TrainingFault::powerOff, fraba.node, 0);
    pass(3000);
    EXPECT_EQ(withLastPositions(project, positions, buses).devices[0].lastPosition->position,
              encoder(fraba).latest().position);

    project.devices[0].participant.deviceCode = 0x0236; // another kind is now planned there
    EXPECT_EQ(withLastPositions(project, positions, buses).devices[0].lastPosition->position, 1);
}

} // namespace
} // namespace codewheel

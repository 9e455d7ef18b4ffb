// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the encoder at a place is the project's, and what that means for transfers.
#include "kinds/interbus/plan/project_take_over.h"
#include "report/live_encoders.h"
#include "tests/support/places.h"
#include "tests/transfer/transfer_bus.h"
#include "transfer/project_places.h"
#include "transfer/replacement.h"
#include "transfer/values_before.h"
#include "vocabulary/refusal_text.h"

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;
using test::singleTurn;

class PlacesOfAProject : public test::TransferBus
{
protected:
    // One more device in front of all others, which changes their numbers.
    Project shiftedBy(const Participant &front) const
    {
        Project shifted = projectOf(bus.structure());
        for (ProjectDevice &device : shifted.devices)
            device.participant.number = nextSegment(device.participant.number);
        ProjectDevice &first = *shifted.devices.emplace(shifted.devices.begin());
        first.participant = front;
        first.participant.number = NodeId("1.0");
        return shifted;
    }
    Participant at(Place place) const
    {
        return *std::ranges::find(bus.structure(), place.node, &RingDevice::number);
    }
    std::string hindrance(const Project &project, Place place) const
    {
        const auto why = ProjectPlaces(project, buses).hindrance(place);
        return why ? refusalText(*why).toStdString() : std::string();
    }
};

TEST_F(PlacesOfAProject, AllStandAtTheirPlacesWhereTheBusIsAsConfigured)
{
    const Project project = projectOf(bus.structure());
    const ProjectPlaces places(project, buses);
    for (const ProjectDevice &device : project.devices) {
        EXPECT_FALSE(places.hindrance(device.place()));
        EXPECT_TRUE(places.isAtItsPlace(device.place()));
    }
    EXPECT_FALSE(places.hindrance("9.0"_ring)); // not in the project
    EXPECT_FALSE(places.isAtItsPlace("9.0"_ring));
}

TEST_F(PlacesOfAProject, ADeviceWithAnotherNumberIsNotTheOneThatHasItNow)
{
    const Project project = shiftedBy(at(singleTurn));
    EXPECT_EQ(
        hindrance(project, "1.0"_ring),
        "1.0: configured is FRABA OCD-IB K1 (missing now), found was FRABA OCD-IB K3. Compare, and take "
        "over what is right.");
    EXPECT_EQ(hindrance(project, "2.0"_ring),
              "2.0: configured is FRABA OCD-IB K3 (its number is 1.0 now), found was Baumer GXP6W K3. "
              "Compare, and take over what is right.");
    EXPECT_EQ(hindrance(project, "8.0"_ring), "");
}

TEST_F(PlacesOfAProject, OfARowOfOneKindWithOneMissingNobodyCanSayWhichItIs)
{
    Project project = projectOf(bus.structure());
    ProjectDevice third = project.devices[1];
    third.participant.number = NodeId("3.0");
    project.devices.insert(project.devices.begin() + 2, third);
    for (std::size_t i = 3; i < project.devices.size(); ++i)
        project.devices[i].participant.number = nextSegment(project.devices[i].participant.number);
    EXPECT_EQ(hindrance(project, fraba),
              "1.0: configured is FRABA OCD-IB K3, found was perhaps another one: beside it, one of the same "
              "kind is missing or additional. Compare, and take over what is right.");
}

TEST_F(PlacesOfAProject, NothingGoesFromAProjectToAnotherEncoderNorBack)
{
    Project project = shiftedBy(at(singleTurn));
    project.devices[1].wanted = {{Parameter::steps, 4096}};
    project.devices[1].stored = {{Parameter::steps, 4096, Evidence::read, {}}};
    const ProjectPlaces places(project, buses);
    const ProjectDevice &hoist = project.devices[1];
    const Replacement same{&encoder(baumer).device(), 0, 0, {}};
    const ValuesBefore before{"2.0"_ring, {}, {}, {{Parameter::steps, 4096}}};
    for (const TransferWish &wish :
         {wishOf(hoist, TransferSource::wanted, places, catalog),
          wishOf(hoist, TransferSource::stored, places, catalog),
          wishToReplace(hoist, same, std::nullopt, places), wishToRestore(before, places)}) {
        const TransferPlan plan = planTransfer(buses, {wish});
        ASSERT_TRUE(plan[0].hindrance);
        EXPECT_EQ(plan[0].hindrance->id, RefusalId::ringDiffers);
        EXPECT_FALSE(plan[0].write.rows[0].known);
        EXPECT_TRUE(jobsOf(plan).empty());
    }
    EXPECT_TRUE(connectedEncoders(project, buses).empty());
    EXPECT_EQ(connectedEncoders(projectOf(bus.structure()), buses).size(), 6u);
}

} // namespace
} // namespace codewheel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/plan/project_take_over.h"
#include "kinds/interbus/ring/ring_edit.h"
#include "kinds/interbus/words/device_number.h"
#include "project/project_json.h"
#include "tests/support/places.h"
#include "tests/support/plans.h"
#include "widgets/project/project_document.h"

#include <QSignalSpy>

#include <gtest/gtest.h>
#include <random>

namespace codewheel {
namespace {

RingDevice encoder(int segment)
{
    return {DeviceNumber{segment, 0}.node(), 0x0237, 2, 2, {}};
}

Project plant(int devices)
{
    Project project;
    for (int segment = 1; segment <= devices; ++segment) {
        ProjectDevice device;
        device.participant = encoder(segment);
        project.devices.push_back(device);
    }
    return project;
}

class Document : public testing::Test
{
protected:
    Document() { document.setProject(plant(4), {}); }

    void setStation(std::size_t place, const QString &station, ProjectDocument::Gesture gesture = {})
    {
        Project after = document.project();
        after.devices[place].station = station;
        document.edit(after, QStringLiteral("station"), gesture);
    }
    // The devices after an edit of the ring.
    void apply(const EditedRing &edited)
    {
        Project after = document.project();
        after.devices.clear();
        for (std::size_t i = 0; i < edited.structure.size(); ++i) {
            ProjectDevice device =
                edited.from[i] ? document.project().devices[*edited.from[i]] : ProjectDevice();
            device.participant = edited.structure[i];
            after.devices.push_back(device);
        }
        document.edit(after, firstBus, edited.from, QStringLiteral("ring"));
    }
    std::vector<ProjectDocument::DeviceId> ringIds() const
    {
        const auto ids = document.ids(firstBus);
        return {ids.begin(), ids.end()};
    }

    ProjectDocument document;
    QUndoStack &undo = document.undoStack();
};

TEST_F(Document, AnotherProjectIsSavedAndHasNothingToUndo)
{
    setStation(0, QStringLiteral("hoist"));
    EXPECT_FALSE(document.isSaved());
    QSignalSpy replaced(&document, &ProjectDocument::replaced);
    document.setProject(plant(2), QStringLiteral("a.codewheel"));
    EXPECT_TRUE(document.isSaved());
    EXPECT_FALSE(undo.canUndo());
    EXPECT_EQ(document.file(), QStringLiteral("a.codewheel"));
    EXPECT_EQ(replaced.count(), 1);
}

TEST_F(Document, IsSavedWhereItStandsInItsHistory)
{
    QSignalSpy saved(&document, &ProjectDocument::savedChanged);
    setStation(0, QStringLiteral("hoist"));
    EXPECT_FALSE(document.isSaved());
    document.setFile(QStringLiteral("a.codewheel"));
    EXPECT_TRUE(document.isSaved());
    undo.undo();
    EXPECT_FALSE(document.isSaved());
    undo.redo();
    EXPECT_TRUE(document.isSaved());
    EXPECT_GE(saved.count(), 4);
}

// They were seen, and are not edited: undoing brings none back that is older.
TEST_F(Document, TheLastPositionsThatWereSavedAreNoStep)
{
    const auto at = [](int hour) { return QDateTime(QDate(2026, 3, 1), QTime(hour, 0), Qt::UTC); };
    const Place place = document.project().devices[0].place();
    const auto save = [&](std::int64_t position, int hour) {
        Project saved = document.project();
        saved.devices[0].lastPosition = {position, at(hour)};
        document.takeLastPositions(saved);
        document.setFile(QStringLiteral("a.codewheel"));
    };
    save(4711, 8);
    EXPECT_FALSE(undo.canUndo());
    EXPECT_TRUE(document.isSaved());
    setStation(0, QStringLiteral("hoist"));
    save(3533, 9);
    undo.undo();
    EXPECT_EQ(document.device(place).lastPosition->position, 3533);
    EXPECT_EQ(document.device(place).station, QString());
    undo.redo();
    EXPECT_TRUE(document.isSaved());
    EXPECT_EQ(document.device(place).lastPosition->position, 3533);
}

TEST_F(Document, ARecoveredProjectIsNotSaved)
{
    document.setRecovered();
    EXPECT_FALSE(document.isSaved());
    document.setFile(QStringLiteral("a.codewheel"));
    EXPECT_TRUE(document.isSaved());
}

TEST_F(Document, IsNotSavedWhileValuesAreInNoFile)
{
    const Place fifth = "5.0"_ring;
    const auto want = [&](std::int64_t steps) {
        document.editDevice(fifth, QStringLiteral("steps"), [&](ProjectDevice &device) {
            device.wanted = {{Parameter::steps, steps}};
        });
    };
    want(100);
    EXPECT_EQ(document.notPlanned(), std::vector{fifth});
    document.setFile(QStringLiteral("a.codewheel"));
    EXPECT_FALSE(document.isSaved());
    undo.undo();
    EXPECT_TRUE(document.notPlanned().empty());
    undo.redo();

    // Once planned, the device gets its values.
    Project after = document.project();
    after.devices.emplace_back().participant = encoder(5);
    document.edit(after, QStringLiteral("take over"));
    EXPECT_EQ(document.project().devices.back().wanted, (ParameterValues{{Parameter::steps, 100}}));
    EXPECT_EQ(document.project().devices.back().participant, encoder(5));
    EXPECT_TRUE(document.notPlanned().empty());
    document.setFile(QStringLiteral("a.codewheel"));
    EXPECT_TRUE(document.isSaved());
    undo.undo();
    EXPECT_EQ(document.project().devices.size(), 4U);
    EXPECT_EQ(document.device(fifth).wanted, (ParameterValues{{Parameter::steps, 100}}));
}

TEST_F(Document, WhatChangesNothingIsNoStep)
{
    setStation(0, {});
    EXPECT_EQ(undo.count(), 0);
    EXPECT_TRUE(document.isSaved());
}

TEST_F(Document, TypingInOneFieldIsOneStep)
{
    const ProjectDocument::Gesture typing = document.newGesture();
    for (const char *text : {"h", "ho", "hoi", "hoist"})
        setStation(0, QString::fromLatin1(text), typing);
    setStation(1, QStringLiteral("x"), typing);
    setStation(0, QStringLiteral("crane"), document.newGesture());
    EXPECT_EQ(undo.count(), 3);
    undo.undo();
    EXPECT_EQ(document.project().devices[0].station, QStringLiteral("hoist"));
    undo.undo();
    undo.undo();
    EXPECT_EQ(document.project(), plant(4));
}

TEST_F(Document, TypingBackToWhatItWasLeavesNoStep)
{
    const ProjectDocument::Gesture typing = document.newGesture();
    setStation(2, QStringLiteral("a"), typing);
    setStation(2, {}, typing);
    EXPECT_EQ(undo.count(), 0);
}

TEST_F(Document, ADeviceKeepsItsIdWhereverItGoes)
{
    const std::vector<ProjectDocument::DeviceId> before = ringIds();
    apply(*moveDevices(structureOf(document.project()), std::vector<std::size_t>{0}, {{}, false, 4}));
    EXPECT_EQ(ringIds(), (std::vector{before[1], before[2], before[3], before[0]}));
    apply(*insertDevice(structureOf(document.project()), encoder(1), {{}, false, 0}));
    EXPECT_EQ(document.indexOf(before[0]), 4u);
    undo.undo();
    undo.undo();
    EXPECT_EQ(ringIds(), before);
}

TEST_F(Document, DevicesThatAreNotTheProjectsAreKeptBesideIt)
{
    constexpr Place stranger = "9.0"_ring;
    document.editDevice(stranger, QStringLiteral("want"), [](ProjectDevice &device) {
        device.wanted = {{Parameter::steps, 255}};
    });
    EXPECT_EQ(valueOf(document.device(stranger).wanted, Parameter::steps), 255);
    EXPECT_EQ(document.project(), plant(4)) << "no file gets it";
    undo.undo();
    EXPECT_TRUE(document.device(stranger).wanted.empty());
    undo.redo();
    document.setProject(plant(1), {});
    EXPECT_TRUE(document.device(stranger).wanted.empty());
}

// Every edit is undone step by step, and redone.
TEST_F(Document, AnEncoderOfTheSerialLineIsEditedLikeOneOfTheRing)
{
    constexpr Place place = placeOnLine({0x12});
    Project after = document.project();
    setLinePlan(after, firstLine, {});
    after.devices.emplace_back().standAt(place);
    document.edit(after, QStringLiteral("add"));
    document.editDevice(place, QStringLiteral("station"),
                        [](ProjectDevice &device) { device.station = QStringLiteral("Slide"); });
    EXPECT_EQ(encodersOnLine(document.project())[0].station, QStringLiteral("Slide"));
    EXPECT_EQ(document.device(place).station, QStringLiteral("Slide"));
    std::vector<Place> visited;
    document.forEachDevice([&](Place number, const ProjectDevice &) { visited.push_back(number); });
    EXPECT_EQ(visited.back(), place);
    EXPECT_EQ(visited.size(), 5u);
    document.undoStack().undo();
    EXPECT_EQ(document.project(), after);
    document.undoStack().undo();
    EXPECT_FALSE(linePlan(document.project(), firstLine));
}

TEST_F(Document, AnEncoderOfAnotherAddressKeepsWhatIsPlannedForIt)
{
    constexpr Place from = placeOnLine({0x12});
    constexpr Place to = placeOnLine({7});
    Project before = document.project();
    setLinePlan(before, firstLine, {});
    for (const int address : {9, 0x12}) {
        ProjectDevice &encoder = before.devices.emplace_back();
        encoder.standAt(placeOnLine({static_cast<std::uint8_t>(address)}));
        encoder.station = QString::number(address);
    }
    document.edit(before, QStringLiteral("add"));
    document.renumber(from, to, QStringLiteral("address"));
    ASSERT_EQ(encodersOnLine(document.project()).size(), 2u);
    EXPECT_EQ(encodersOnLine(document.project())[0].place(), to) << "by address";
    EXPECT_EQ(document.device(to).station, QStringLiteral("18"));
    EXPECT_TRUE(document.device(from).station.isEmpty());
    EXPECT_EQ(document.undoStack().undoText(), QStringLiteral("address"));
    document.undoStack().undo();
    EXPECT_EQ(document.project(), before);

    document.renumber(to, from, QStringLiteral("there is none"));
    EXPECT_EQ(document.project(), before);
}

TEST_F(Document, WhatIsPlannedForAnEncoderBesideTheProjectGoesAlongToo)
{
    constexpr Place from = placeOnLine({3});
    constexpr Place to = placeOnLine({7});
    document.editDevice(from, QStringLiteral("want"), [](ProjectDevice &device) {
        device.wanted = {{Parameter::steps, 255}};
    });
    document.renumber(from, to, QStringLiteral("address"));
    EXPECT_EQ(valueOf(document.device(to).wanted, Parameter::steps), 255);
    EXPECT_TRUE(document.device(from).wanted.empty());
    document.undoStack().undo();
    EXPECT_EQ(valueOf(document.device(from).wanted, Parameter::steps), 255);
}

TEST_F(Document, OfAnotherAddressWhatWasWantedThereIsGone)
{
    constexpr Place from = placeOnLine({3});
    constexpr Place to = placeOnLine({7});
    const auto want = [](ProjectDevice &device) { device.wanted = {{Parameter::steps, 255}}; };
    Project planned = document.project();
    setLinePlan(planned, firstLine, {});
    planned.devices.emplace_back().standAt(from);
    document.edit(planned, QStringLiteral("add"));
    document.editDevice(to, QStringLiteral("want"), want);
    document.renumber(from, to, QStringLiteral("address"));
    EXPECT_TRUE(document.device(to).wanted.empty());
    document.edit(plant(4), QStringLiteral("remove"));
    EXPECT_TRUE(document.device(to).wanted.empty()) << "not even once the encoder is removed";
}

TEST_F(Document, RandomEditsAreTakenBackToTheSameProject)
{
    std::mt19937 random(17);
    const auto below = [&](std::size_t end) {
        return std::uniform_int_distribution<std::size_t>(0, end - 1)(random);
    };
    std::vector<Project> history{document.project()};
    std::vector<std::vector<ProjectDocument::DeviceId>> ids{ringIds()};
    while (history.size() < 300) {
        const RingStructure ring = structureOf(document.project());
        const RingPlace place{.terminal = {}, .onLocalBus = false, .row = below(8)};
        switch (ring.size() < 3 ? 0 : below(4)) {
        case 0:
            apply(*insertDevice(ring, encoder(1), place));
            break;
        case 1:
            apply(*moveDevices(ring, std::vector{below(ring.size())}, place));
            break;
        case 2:
            apply(*removeDevices(ring, std::vector{below(ring.size())}));
            break;
        default:
            setStation(below(ring.size()), QString::number(random()));
        }
        if (document.project() != history.back() || ringIds() != ids.back()) {
            history.push_back(document.project());
            ids.push_back(ringIds());
        }
    }
    ASSERT_EQ(undo.count() + 1, std::ssize(history));
    for (std::size_t i = history.size(); i-- > 1;) {
        ASSERT_EQ(document.project(), history[i]) << i;
        ASSERT_EQ(ringIds(), ids[i]) << i;
        undo.undo();
    }
    ASSERT_EQ(projectToJson(document.project()), projectToJson(history.front()));
    while (undo.canRedo())
        undo.redo();
    EXPECT_EQ(projectToJson(document.project()), projectToJson(history.back()));
}

} // namespace
} // namespace codewheel

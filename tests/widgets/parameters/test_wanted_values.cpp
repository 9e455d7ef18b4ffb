// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/training_bus_session.h"
#include "widgets/parameters/wanted_values.h"
#include "widgets/project/project_document.h"

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;

TEST(WantedValues, AreKeptForEachDevice)
{
    ProjectDocument project;
    WantedValues wanted(project);
    wanted.set(fraba, Parameter::steps, 255);
    EXPECT_EQ(wanted.value(fraba, Parameter::steps), 255);
    EXPECT_EQ(wanted.value(fraba, Parameter::preset), std::nullopt);
    EXPECT_EQ(wanted.value(baumer, Parameter::steps), std::nullopt);
    wanted.set(fraba, Parameter::steps, std::nullopt);
    EXPECT_EQ(wanted.value(fraba, Parameter::steps), std::nullopt);
}

TEST(WantedValues, TellOnlyOfARealChange)
{
    ProjectDocument project;
    WantedValues wanted(project);
    std::vector<Place> told;
    QObject::connect(&wanted, &WantedValues::changed, [&](Place number) { told.push_back(number); });
    wanted.set(fraba, Parameter::steps, 255);
    wanted.set(fraba, Parameter::steps, 255);
    wanted.clear(baumer);
    EXPECT_EQ(told, std::vector{fraba});
    wanted.clear(fraba);
    EXPECT_EQ(told, (std::vector{fraba, fraba}));
    EXPECT_TRUE(wanted.values(fraba).empty());
}

TEST(WantedValues, EachChangeIsTakenBackByUndo)
{
    ProjectDocument project;
    WantedValues wanted(project);
    wanted.set(fraba, Parameter::steps, 255);
    wanted.set(fraba, Parameter::steps, 256);
    wanted.clear(fraba);
    std::vector<Place> told;
    QObject::connect(&wanted, &WantedValues::changed, [&](Place number) { told.push_back(number); });
    project.undoStack().undo();
    EXPECT_EQ(wanted.value(fraba, Parameter::steps), 256);
    project.undoStack().undo();
    EXPECT_EQ(wanted.value(fraba, Parameter::steps), 255);
    project.undoStack().redo();
    EXPECT_EQ(wanted.value(fraba, Parameter::steps), 256);
    EXPECT_EQ(told, (std::vector{fraba, fraba, fraba}));
}

TEST(WantedValues, ComeInTheOrderOfTheParameters)
{
    ProjectDocument project;
    WantedValues wanted(project);
    wanted.set(fraba, Parameter::preset, 0);
    wanted.set(fraba, Parameter::steps, 255);
    EXPECT_EQ(wanted.values(fraba), (ParameterValues{{Parameter::steps, 255}, {Parameter::preset, 0}}));
}

} // namespace
} // namespace codewheel

// SPDX-License-Identifier: GPL-3.0-or-later
// What is wanted of the encoders of the training line, once it is taken into the project, and when they move.
#include "app/window/window_actions.h"
#include "project/project_file.h"
#include "tests/app/planned_encoder.h"
#include "tests/app/window_test.h"
#include "tests/support/plans.h"
#include "widgets/comparison/comparison_page.h"
#include "widgets/kinds/esc/training/esc_line_training_panel.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/label_text.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/wanted_values.h"
#include "widgets/structure/structure_view.h"

#include <QComboBox>
#include <QPushButton>
#include <QTableView>
#include <QTest>

#include <gtest/gtest.h>
#include <stdexcept>
#include <vector>

namespace codewheel {
namespace {

const Place third = placeOnLine({3});
const Place fifth = placeOnLine({5});
const Place seventh = placeOnLine({7});
const Place twelfth = placeOnLine({0x12});

class EscLineInProject : public test::WindowTest
{
protected:
    EscLineInProject() { advance(200); }

    Project project() { return shown->project().project(); }
    EscLineSession &line() { return *shown->line().session(); }
    void want(Place place, Parameter parameter, std::int64_t value)
    {
        window().findChild<WantedValues *>()->set(place, parameter, value);
    }
    ParameterValues wanted(Place place) { return shown->project().device(place).wanted; }
    void choose(Place place)
    {
        window().findChild<StructureView *>()->choose(place);
        advance(50);
    }
    void plan(const EscLinePlan &line)
    {
        Project planned = project();
        setEncodersOnLine(planned, {test::plannedEncoder(third), test::plannedEncoder(fifth),
                                    test::plannedEncoder(twelfth)});
        setLinePlan(planned, firstLine, line);
        shown->project().setProject(planned, {});
        advance(50);
    }
    ComparisonPage &comparison()
    {
        window().findChild<StructureView *>()->choose(firstLine);
        advance(2000);
        QTest::keyClick(&window(), Qt::Key_F9);
        advance(50);
        for (auto *page : window().findChildren<ComparisonPage *>())
            if (page->isVisible())
                return *page;
        throw std::logic_error("no comparison");
    }
    void click(QPushButton *button)
    {
        ASSERT_TRUE(button != nullptr && button->isEnabled());
        QTest::mouseClick(button, Qt::LeftButton);
        advance(50);
    }
    // By the parameter panel.
    void writeAddress(Place place, const EscLineAddress &address)
    {
        choose(place);
        want(place, Parameter::lineAddress, address.value);
        advance(50);
        auto &panel = *window().findChild<ParameterPanel *>();
        for (auto *button : panel.findChildren<QPushButton *>())
            if (plainLabel(button->text()) == QStringLiteral("Write…"))
                click(button);
        click(panel.findChild<QPushButton *>(QStringLiteral("confirmWrite")));
        advance(10'000);
        ASSERT_NE(line().encoder(placeOnLine(address)), nullptr);
        ASSERT_FALSE(line().encoder(placeOnLine(address))->runningJob());
    }
};

TEST_F(EscLineInProject, AllIntoTheProjectTakesWhatIsWantedAlong)
{
    want(third, Parameter::steps, 600);
    want(fifth, Parameter::steps, 3000);
    click(comparison().findChild<QPushButton *>(QStringLiteral("allIntoProject")));
    ASSERT_EQ(encodersOnLine(project()).size(), 3U);
    EXPECT_EQ(encodersOnLine(project())[0].wanted, (ParameterValues{{Parameter::steps, 600}}));
    EXPECT_EQ(encodersOnLine(project())[1].wanted, (ParameterValues{{Parameter::steps, 3000}}));
    shown->project().undoStack().undo();
    EXPECT_EQ(linePlan(project(), firstLine), nullptr);
    EXPECT_EQ(wanted(third), (ParameterValues{{Parameter::steps, 600}}));
}

TEST_F(EscLineInProject, WhatIsWantedOnATrainingLineIsInNoFileUntilTheLineIsTakenIntoTheProject)
{
    const auto notice = [this] {
        return window().findChild<InlineMessage *>(QStringLiteral("notice"))->sentence();
    };
    const QString file = folder.filePath(QStringLiteral("line.codewheel"));
    shown->project().setFile(file);
    want(fifth, Parameter::steps, 3000);
    actions().saveProject->trigger();
    EXPECT_TRUE(notice().startsWith(QStringLiteral("What is planned for esc:05 is in no file")))
        << notice().toStdString();
    EXPECT_TRUE(notice().contains(QStringLiteral("(F9)"))) << notice().toStdString();
    click(comparison().findChild<QPushButton *>(QStringLiteral("allIntoProject")));
    actions().saveProject->trigger();
    EXPECT_EQ(notice(), QString());
    const auto saved = loadProject(file);
    ASSERT_TRUE(saved);
    const ProjectDevice *device = findDevice(*saved, fifth);
    ASSERT_NE(device, nullptr);
    EXPECT_EQ(device->wanted, (ParameterValues{{Parameter::steps, 3000}}));
}

TEST_F(EscLineInProject, TheFirstChosenEncoderTakesWhatIsWantedAlongToo)
{
    want(third, Parameter::steps, 600);
    want(fifth, Parameter::steps, 3000);
    ComparisonPage &page = comparison();
    for (const int row : {0, 1}) {
        page.findChild<QTableView *>()->selectRow(row);
        click(page.findChild<QPushButton *>(QStringLiteral("linesIntoProject")));
    }
    ASSERT_EQ(encodersOnLine(project()).size(), 2U);
    EXPECT_EQ(encodersOnLine(project())[0].wanted, (ParameterValues{{Parameter::steps, 600}}));
    EXPECT_EQ(encodersOnLine(project())[1].wanted, (ParameterValues{{Parameter::steps, 3000}}));
}

TEST_F(EscLineInProject, APlannedEncoderMovesToItsNewAddressAndBack)
{
    plan({});
    want(fifth, Parameter::steps, 3000);
    writeAddress(fifth, {7});
    EXPECT_EQ(shown->project().idAt(fifth), std::nullopt);
    ASSERT_NE(shown->project().idAt(seventh), std::nullopt);
    EXPECT_EQ(wanted(seventh), (ParameterValues{{Parameter::steps, 3000}})) << "the address is written";
    writeAddress(seventh, {5});
    EXPECT_EQ(encodersOnLine(project()).size(), 3U);
    EXPECT_EQ(wanted(fifth), (ParameterValues{{Parameter::steps, 3000}}));
    EXPECT_TRUE(wanted(seventh).empty());
    EXPECT_TRUE(shown->project().notPlanned().empty());
}

TEST_F(EscLineInProject, OfAnUnplannedEncoderTheWrittenAddressIsNotWantedEither)
{
    writeAddress(fifth, {7});
    EXPECT_TRUE(shown->project().notKept().empty());
    want(seventh, Parameter::steps, 3000);
    writeAddress(seventh, {9});
    EXPECT_EQ(wanted(placeOnLine({9})), (ParameterValues{{Parameter::steps, 3000}}));
    EXPECT_EQ(shown->project().notKept(), std::vector{placeOnLine({9})});
}

TEST_F(EscLineInProject, TheTrainingPanelFollowsAnEncoderToItsNewAddress)
{
    auto &training = *window().findChild<EscLineTrainingPanel *>();
    const auto *device = training.findChild<QComboBox *>();
    const auto rawOf = [this](const EscLineAddress &address) {
        std::int64_t raw = -1;
        shown->line().training()->withEncoder(
            address, [&](SimulatedEscEncoder &encoder) { raw = encoder.shaft().raw(); });
        return raw;
    };
    const auto turn = [&training] {
        for (auto *button : training.findChildren<QAbstractButton *>())
            if (button->accessibleName() == QStringLiteral("1 turn clockwise"))
                button->click();
    };
    writeAddress(fifth, {7});
    EXPECT_EQ(device->currentText(), QStringLiteral("esc:07"));
    EXPECT_LT(device->findText(QStringLiteral("esc:05")), 0);
    choose(third);
    EXPECT_EQ(device->currentText(), QStringLiteral("esc:03"));
    choose(seventh);
    EXPECT_EQ(device->currentText(), QStringLiteral("esc:07"));
    const std::int64_t before = rawOf({7});
    turn();
    EXPECT_EQ(rawOf({7}), before + 8192);
}

TEST_F(EscLineInProject, TheTrainingPanelStaysAtAnotherEncoderThatWasChosenInIt)
{
    auto *device = window().findChild<EscLineTrainingPanel *>()->findChild<QComboBox *>();
    choose(fifth);
    device->setCurrentIndex(device->findText(QStringLiteral("esc:12")));
    ASSERT_TRUE(line().encoder(third)->start(
        WriteParameters{.values = {{Parameter::lineAddress, 9}}, .previous = {}}));
    advance(4'000);
    ASSERT_NE(line().encoder(placeOnLine({9})), nullptr);
    EXPECT_EQ(device->currentText(), QStringLiteral("esc:12"));
    EXPECT_GE(device->findText(QStringLiteral("esc:09")), 0);
}

TEST_F(EscLineInProject, OfALineAtAPortNothingMovesWithTheTrainingLine)
{
    EscLinePlan atPort;
    atPort.settings.port = QStringLiteral("/dev/ttyHALL");
    plan(atPort);
    lineActions().training->trigger();
    advance(200);
    const Project before = project();
    ASSERT_NE(shown->line().training(), nullptr);
    ASSERT_TRUE(line().encoder(fifth)->start(
        WriteParameters{.values = {{Parameter::lineAddress, 7}}, .previous = {}}));
    advance(4'000);
    ASSERT_NE(line().encoder(seventh), nullptr);
    EXPECT_EQ(project(), before);
}

} // namespace
} // namespace codewheel

// SPDX-License-Identifier: GPL-3.0-or-later
// The parameter panel with a TR LA-66 in virtual time.
#include "tests/support/model_tester.h"
#include "tests/widgets/rod_bus.h"
#include "vocabulary/sentence.h"
#include "widgets/dial/rod_view.h"
#include "widgets/job/review_table.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/label_text.h"
#include "widgets/parameters/parameter_model.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_table.h"
#include "widgets/parameters/preset_review.h"
#include "widgets/parameters/value_input.h"
#include "widgets/parameters/wanted_values.h"
#include "widgets/parameters/write_review.h"
#include "widgets/project/project_document.h"

#include <QAbstractButton>
#include <QAbstractItemModel>
#include <QAction>
#include <QApplication>
#include <QCoreApplication>
#include <QEvent>
#include <QLabel>
#include <QLatin1Char>
#include <QLocale>
#include <QMenu>
#include <QModelIndex>
#include <QPushButton>
#include <QTest>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::rodPlace;

class ParametersOfARod : public testing::Test
{
protected:
    ParametersOfARod()
    {
        panel.resize(290, 480);
        panel.show();
        panel.setEncoder(&rod());
    }

    EncoderSession &rod() { return ring.encoder(rodPlace); }
    ParameterTable &table() { return *panel.findChild<ParameterTable *>(); }
    QModelIndex indexOf(Parameter parameter, int column)
    {
        QAbstractItemModel &model = *table().model();
        for (int row = 0; row < model.rowCount(); ++row)
            if (model.index(row, ParameterModel::nameColumn).data().toString() == parameterName(parameter))
                return model.index(row, column);
        ADD_FAILURE() << "no " << parameterName(parameter).toStdString();
        return {};
    }
    QString textAt(Parameter parameter, int column)
    {
        return indexOf(parameter, column).data(Qt::AccessibleTextRole).toString();
    }
    void typeWanted(Parameter parameter, const QString &text)
    {
        const QModelIndex cell = indexOf(parameter, ParameterModel::wantedColumn);
        table().scrollTo(cell);
        QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, table().visualRect(cell).center());
        auto *field = table().viewport()->findChild<ValueInput *>();
        ASSERT_NE(field, nullptr);
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
        QCoreApplication::processEvents();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    void click(const QString &text)
    {
        for (auto *found : panel.findChildren<QAbstractButton *>())
            if (found->isVisible() && plainLabel(found->text()) == text) {
                ASSERT_TRUE(found->isEnabled()) << text.toStdString();
                QTest::mouseClick(found, Qt::LeftButton);
                return;
            }
        ADD_FAILURE() << "no " << text.toStdString();
    }
    QAction *setPosition()
    {
        for (QAction *action : panel.findChild<QMenu *>(QStringLiteral("moreMenu"))->actions())
            if (action->text().contains(QStringLiteral("Set the position")))
                return action;
        return nullptr;
    }
    void finishJob()
    {
        for (int i = 0; i < 500 && rod().runningJob(); ++i)
            ring.bus.advance(10);
        ASSERT_FALSE(rod().runningJob());
    }

    test::TrainingBusSession ring{RingSession::Start::operating, test::makeRodBus};
    ProjectDocument project;
    WantedValues wanted{project};
    ParameterPanel panel{ring.buses, wanted};
};

TEST_F(ParametersOfARod, ReadsAllAndNamesTheErrorStatus)
{
    const test::ModelTester tester(*table().model());
    ring.controls->setFault(TrainingFault::magnetLost, rodPlace.node, 1);
    ring.bus.advance(50);
    click(QStringLiteral("Read from encoder"));
    finishJob();
    EXPECT_TRUE(textAt(Parameter::errorStatus, ParameterModel::knownColumn)
                    .contains(QStringLiteral("magnet outside the measuring range")))
        << textAt(Parameter::errorStatus, ParameterModel::knownColumn).toStdString();
    EXPECT_TRUE(
        textAt(Parameter::measuringLength, ParameterModel::knownColumn).contains(QStringLiteral("read")));
    EXPECT_EQ(textAt(Parameter::errorStatus, ParameterModel::wantedColumn), QStringLiteral("read only"));
}

TEST_F(ParametersOfARod, TheLengthOfTheRodIsToldInMillimetresAndNeverWanted)
{
    const test::ModelTester tester(*table().model());
    EXPECT_EQ(textAt(Parameter::rodLength, ParameterModel::wantedColumn),
              QStringLiteral("set it from its label"));
    typeWanted(Parameter::rodLength, QLocale().toString(650.5, 'f', 1));
    ASSERT_TRUE(rod().known(Parameter::rodLength));
    EXPECT_EQ(rod().known(Parameter::rodLength)->value, 650'500);
    EXPECT_EQ(rod().known(Parameter::rodLength)->evidence, Evidence::told);
    EXPECT_TRUE(textAt(Parameter::rodLength, ParameterModel::knownColumn)
                    .startsWith(QStringLiteral("650.500 mm by hand")))
        << textAt(Parameter::rodLength, ParameterModel::knownColumn).toStdString();
    EXPECT_TRUE(wanted.values(rodPlace).empty());
    EXPECT_EQ(ring.channel(rodPlace).out(), 0u);
}

TEST_F(ParametersOfARod, TheReviewShowsTheWordsOfTheServicesAndWritesThem)
{
    typeWanted(Parameter::measuringLength, QStringLiteral("C350h")); // LA-66 manual 3.2
    typeWanted(Parameter::externalPreset, QStringLiteral("500"));
    click(QStringLiteral("Write…"));
    const QAbstractItemModel &review = *panel.findChild<WriteReview *>()->findChild<ReviewTable *>();
    ASSERT_EQ(review.rowCount(), 2);
    EXPECT_EQ(review.index(0, 3).data(), QStringLiteral("C200C350"));
    EXPECT_EQ(review.index(1, 3).data(), QStringLiteral("C40001F4"));
    click(QStringLiteral("Write these 2 values"));
    finishJob();
    EXPECT_EQ(rod().known(Parameter::measuringLength)->value, 50'000);
    EXPECT_EQ(rod().known(Parameter::externalPreset)->value, 500);
    EXPECT_TRUE(panel.findChild<InlineMessage *>(QStringLiteral("panelMessage"))
                    ->sentence()
                    .contains(QStringLiteral("read back")));
    EXPECT_EQ(ring.channel(rodPlace).out(), 0u);
}

TEST_F(ParametersOfARod, InWatchThePositionIsNotAskedFor)
{
    ring.bus.setOperate(false);
    ring.bus.advance(50);
    setPosition()->trigger();
    EXPECT_TRUE(panel.findChild<InlineMessage *>(QStringLiteral("panelMessage"))
                    ->sentence()
                    .contains(QStringLiteral("Switch to Operate first")));
    EXPECT_EQ(panel.findChild<ValueInput *>(QStringLiteral("toldValue")), nullptr);
}

TEST_F(ParametersOfARod, ThePositionIsSetToWhatIsTyped)
{
    QAction *set = setPosition();
    ASSERT_NE(set, nullptr);
    ASSERT_TRUE(set->isVisible());
    ring.controls->moveMagnetTo(rodPlace.node, 200);
    ring.bus.advance(50);
    set->trigger();
    auto *field = panel.findChild<ValueInput *>(QStringLiteral("toldValue"));
    auto *take = panel.findChild<QPushButton *>(QStringLiteral("takeValue"));
    EXPECT_FALSE(take->isEnabled()) << "without a value nothing is set";
    QTest::keyClicks(field, QStringLiteral("1000"));
    const auto before = rod().latest().position;
    QTest::keyClick(field, Qt::Key_Return);
    ring.bus.advance(50);
    EXPECT_FALSE(rod().runningJob()) << "it is shown first what that does";
    EXPECT_EQ(rod().latest().position, before);
    const auto *shown = panel.findChild<PresetReview *>();
    const QAbstractItemModel &review = *shown->findChild<ReviewTable *>();
    EXPECT_TRUE(shown->isVisible());
    const auto *picture = shown->findChild<RodView *>();
    EXPECT_TRUE(picture->isVisible());
    EXPECT_EQ(picture->state().position, before);
    EXPECT_EQ(picture->state().then, RodState::Then{1000});
    EXPECT_EQ(review.index(0, 1).data().toString(), numberText(before.value_or(-1)));
    EXPECT_EQ(review.index(0, 2).data().toString(), numberText(1000));
    EXPECT_EQ(shown->findChild<QLabel *>(QStringLiteral("positionChange"))->text(),
              QStringLiteral("Position of %1: now %2, then %3.")
                  .arg(rodPlace.shown(), numberText(before.value_or(-1)), numberText(1000)));
    QApplication::setDoubleClickInterval(10 * 60 * 1'000);
    click(QStringLiteral("Set this position"));
    EXPECT_FALSE(rod().runningJob()) << "the second of two quick presses";
    QApplication::setDoubleClickInterval(0);
    click(QStringLiteral("Set this position"));
    finishJob();
    EXPECT_EQ(rod().latest().position, 1000);
    EXPECT_EQ(rod().eepromWrites(), 1);
    panel.setEncoder(&ring.encoder(test::fraba));
    EXPECT_FALSE(set->isVisible()) << "a K3 sets the position to its programmed preset";
}

} // namespace
} // namespace codewheel

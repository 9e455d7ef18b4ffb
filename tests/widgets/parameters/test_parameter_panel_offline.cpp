// SPDX-License-Identifier: GPL-3.0-or-later
// The parameter panel for an encoder that is planned but not connected.
#include "catalog/catalog.h"
#include "kinds/interbus/plan/project_take_over.h"
#include "project/project.h"
#include "tests/support/model_tester.h"
#include "tests/support/places.h"
#include "tests/widgets/training_bus_session.h"
#include "widgets/look/label_text.h"
#include "widgets/parameters/parameter_model.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_table.h"
#include "widgets/parameters/value_input.h"
#include "widgets/project/project_document.h"

#include <QAbstractButton>
#include <QAbstractItemModel>
#include <QAction>
#include <QCoreApplication>
#include <QLabel>
#include <QMenu>
#include <QModelIndex>
#include <QTest>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::fraba;

constexpr Place rod = "5.0"_ring;

class OfflineParameters : public testing::Test
{
protected:
    OfflineParameters()
    {
        project.setProject(projectOf(ring.bus.structure()), {});
        panel.resize(310, 480);
        panel.show();
        show(fraba);
    }

    void show(Place number)
    {
        panel.setEncoder({number, *plannedDescription(project.device(number), ring.catalog)});
    }
    ParameterTable &table() { return *panel.findChild<ParameterTable *>(); }
    QAbstractItemModel &model() { return *table().model(); }
    QModelIndex indexOf(Parameter parameter, int column)
    {
        for (int row = 0; row < model().rowCount(); ++row)
            if (model().index(row, ParameterModel::nameColumn).data().toString() == parameterName(parameter))
                return model().index(row, column);
        return {};
    }
    QString textAt(Parameter parameter, int column)
    {
        return indexOf(parameter, column).data(Qt::AccessibleTextRole).toString();
    }
    void want(Parameter parameter, const QString &text)
    {
        table().edit(indexOf(parameter, ParameterModel::wantedColumn));
        auto *field = panel.findChild<ValueInput *>();
        ASSERT_NE(field, nullptr);
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
        QCoreApplication::processEvents();
    }
    bool isSaid(const QString &part)
    {
        for (const QLabel *label : panel.findChildren<QLabel *>())
            if (label->isVisible() && label->text().contains(part))
                return true;
        return false;
    }

    test::TrainingBusSession ring;
    ProjectDocument project;
    WantedValues wanted{project};
    ParameterPanel panel{ring.buses, wanted};
};

TEST_F(OfflineParameters, WhatIsWantedIsEditedInTheProjectAndUndone)
{
    const test::ModelTester tester(model());
    EXPECT_EQ(textAt(Parameter::steps, ParameterModel::knownColumn), QStringLiteral("unknown"));
    want(Parameter::steps, QStringLiteral("4096"));
    EXPECT_EQ(project.device(fraba).wanted, (ParameterValues{{Parameter::steps, 4096}}));
    EXPECT_EQ(textAt(Parameter::steps, ParameterModel::wantedColumn), QStringLiteral("4096 not compared"));
    EXPECT_EQ(project.undoStack().undoText(), QStringLiteral("Steps wanted for 1.0"));
    project.undoStack().undo();
    EXPECT_EQ(textAt(Parameter::steps, ParameterModel::wantedColumn), QStringLiteral("unchanged"));
    project.undoStack().redo();
    for (QAction *action : panel.findChild<QMenu *>(QStringLiteral("moreMenu"))->actions())
        if (action->text() == QStringLiteral("&Leave all unchanged"))
            action->trigger();
    EXPECT_TRUE(project.device(fraba).wanted.empty());
}

TEST_F(OfflineParameters, WhatSendsIsGreyedAndSaysWhy)
{
    int buttons = 0;
    for (const auto *button : panel.findChildren<QAbstractButton *>()) {
        const QString text = plainLabel(button->text());
        if (text != QStringLiteral("Read from encoder") && text != QStringLiteral("Write…") &&
            text != QStringLiteral("Wizard…"))
            continue;
        ++buttons;
        EXPECT_FALSE(button->isEnabled()) << text.toStdString();
        EXPECT_TRUE(button->toolTip().startsWith(QStringLiteral("Not connected:"))) << text.toStdString();
    }
    EXPECT_EQ(buttons, 3);
    EXPECT_TRUE(isSaid(QStringLiteral("Not connected: nothing can be read or written.")));
    QStringList enabled;
    for (const QAction *action : panel.findChild<QMenu *>(QStringLiteral("moreMenu"))->actions())
        if (action->isEnabled() && action->isVisible() && !action->isSeparator())
            enabled << action->text();
    EXPECT_EQ(enabled,
              (QStringList{QStringLiteral("&Leave all unchanged"),
                           QStringLiteral("Copy as &two words of a PLC"), QStringLiteral("Copy &as")}));
}

TEST_F(OfflineParameters, WhatTheLabelTellsIsToldOnceItIsConnected)
{
    const test::ModelTester tester(model());
    show(rod);
    const QModelIndex length = [this] {
        for (int row = 0; row < model().rowCount(); ++row)
            if (const QModelIndex index = model().index(row, ParameterModel::wantedColumn);
                index.data(Qt::AccessibleTextRole).toString() == QStringLiteral("from its label"))
                return index;
        return QModelIndex();
    }();
    ASSERT_TRUE(length.isValid());
    EXPECT_FALSE(length.flags().testFlag(Qt::ItemIsEditable));
    EXPECT_TRUE(length.data(Qt::ToolTipRole).toString().contains(QStringLiteral("connected")));
    panel.setEncoder(ring.bus.encoder(rod));
    EXPECT_TRUE(
        model().index(length.row(), ParameterModel::wantedColumn).flags().testFlag(Qt::ItemIsEditable));
}

TEST_F(OfflineParameters, AnEncoderThatOnlyTellsItsPositionSaysSo)
{
    show(test::singleTurn);
    EXPECT_FALSE(table().isVisible());
    EXPECT_TRUE(isSaid(QStringLiteral("3.0 has no parameters here")));
}

TEST_F(OfflineParameters, ConnectedItCanSendAgain)
{
    want(Parameter::steps, QStringLiteral("4096"));
    panel.setEncoder(ring.bus.encoder(fraba));
    int buttons = 0;
    for (const auto *button : panel.findChildren<QAbstractButton *>())
        if (button->isVisible() && button->text() == QStringLiteral("&Write…")) {
            ++buttons;
            EXPECT_TRUE(button->isEnabled());
            EXPECT_EQ(button->toolTip(),
                      QStringLiteral("Shows what will be written before anything is sent"));
        }
    EXPECT_EQ(buttons, 1);
    EXPECT_FALSE(isSaid(QStringLiteral("Not connected")));
    EXPECT_EQ(textAt(Parameter::steps, ParameterModel::wantedColumn), QStringLiteral("4096 not compared"));
}

TEST_F(OfflineParameters, WhatTheWantedValuesBringAboutIsSaid)
{
    panel.setEncoder({fraba, *ring.catalog.find(u"fraba-ocd-ib")});
    wanted.set(fraba, Parameter::steps, 1000);
    EXPECT_FALSE(isSaid(QStringLiteral("jumps")));
    wanted.set(fraba, Parameter::revolutions, 3);
    EXPECT_TRUE(isSaid(QStringLiteral("the position jumps by a fraction of a step after turn")));
    wanted.clear(fraba);
    EXPECT_FALSE(isSaid(QStringLiteral("jumps")));
}

} // namespace
} // namespace codewheel

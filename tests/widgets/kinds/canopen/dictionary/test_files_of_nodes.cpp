// SPDX-License-Identifier: GPL-3.0-or-later
// Which file or description the objects of each node are taken from.
#include "tests/widgets/kinds/canopen/dictionary/dictionary_view_test.h"

#include <QSignalSpy>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

class FilesOfNodes : public test::DictionaryViewTest
{
protected:
    FilesOfNodes() { operate(); }
};

TEST_F(FilesOfNodes, AnOpenedFileIsToldWithItsNode)
{
    QSignalSpy chosen(&view, &DictionaryView::fileChosen);
    view.setNode(6);
    const QString path = fileOf(test::rotorFile);
    ASSERT_TRUE(view.openFile(path));
    ASSERT_EQ(chosen.size(), 1);
    EXPECT_EQ(chosen.front(), (QVariantList{6, path}));
    EXPECT_FALSE(view.openFile(folder.filePath(QStringLiteral("none.eds"))));
    EXPECT_EQ(chosen.size(), 1);
}

TEST_F(FilesOfNodes, TheFileOfTheProjectIsOpenedWithItsNode)
{
    view.setPlanned({.files = {{5, QString()}, {6, fileOf(test::rotorFile)}}});
    view.setNode(6);
    EXPECT_EQ(table->model()->rowCount(), 5);
    view.setNode(5);
    EXPECT_GT(table->model()->rowCount(), 90);
}

TEST_F(FilesOfNodes, TwoNodesHaveTheSameFileAndTheirOwnValues)
{
    const QString path = fileOf(test::rotorFile);
    view.setPlanned({.files = {{5, path}, {6, path}}});
    view.setNode(6);
    choose("6001h:0");
    action("Read")->trigger();
    pass(200ms);
    EXPECT_EQ(valueOf("6001h:0"), QStringLiteral("00002000h = 8192"));
    view.setNode(5);
    EXPECT_EQ(table->model()->rowCount(), 5);
    EXPECT_EQ(valueOf("6001h:0"), QStringLiteral("\u2013"));
}

TEST_F(FilesOfNodes, AFileThatIsNotThereIsSaidAndTriedAgain)
{
    const QString path = folder.filePath(QStringLiteral("rotor.eds"));
    view.setPlanned({.files = {{6, path}}});
    view.setNode(6);
    EXPECT_TRUE(message->sentence().contains(path)) << message->sentence().toStdString();
    EXPECT_TRUE(message->sentence().contains(QStringLiteral("It stays in the project")));
    EXPECT_GT(table->model()->rowCount(), 90) << "those of the standards";
    view.setNode(5);
    fileOf(test::rotorFile);
    view.setNode(6);
    EXPECT_EQ(table->model()->rowCount(), 5);
    EXPECT_EQ(message->sentence(), QString());
}

TEST_F(FilesOfNodes, WhatWasReadStaysWhenTheProjectHasAnotherFile)
{
    view.setNode(6);
    choose("6001h:0");
    action("Read")->trigger();
    pass(200ms);
    view.setPlanned({.files = {{6, fileOf(test::rotorFile)}}});
    ASSERT_EQ(table->model()->rowCount(), 5);
    EXPECT_EQ(valueOf("6001h:0"), QStringLiteral("00002000h = 8192"));
    view.setPlanned({.files = {{6, QString()}}});
    EXPECT_GT(table->model()->rowCount(), 90) << "undone";
    EXPECT_EQ(valueOf("6001h:0"), QStringLiteral("00002000h = 8192"));
}

} // namespace
} // namespace codewheel

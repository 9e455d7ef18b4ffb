// SPDX-License-Identifier: GPL-3.0-or-later
// Objects beside what the project wants and what other files have.
#include "tests/widgets/kinds/canopen/dictionary/dictionary_view_test.h"

#include <QLabel>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using canopen::WantedObject;

class ObjectsCompared : public test::DictionaryViewTest
{
protected:
    ObjectsCompared()
    {
        operate();
        view.setNode(6);
    }
    void read(const char *object)
    {
        choose(object);
        action("Read")->trigger();
        pass(200ms);
    }
    QString toolTip(const char *object, int column) const
    {
        return table->model()->index(rowOf(object), column).data(Qt::ToolTipRole).toString();
    }
};

TEST_F(ObjectsCompared, WhatTheProjectWantsStandsBesideWhatWasRead)
{
    EXPECT_TRUE(table->isColumnHidden(ObjectModel::project));
    view.setPlanned({.wanted = {{6, {WantedObject{{0x6001, 0}, {std::int64_t{4096}}, 0}}}}});
    EXPECT_FALSE(table->isColumnHidden(ObjectModel::project));
    EXPECT_EQ(cell(rowOf("6001h:0"), ObjectModel::project), QStringLiteral("00001000h = 4096"));
    EXPECT_EQ(cell(rowOf("6002h:0"), ObjectModel::project), QString());
    read("6001h:0");
    EXPECT_TRUE(
        toolTip("6001h:0", ObjectModel::project).contains(QStringLiteral("but the node has 00002000h")))
        << toolTip("6001h:0", ObjectModel::project).toStdString();
    view.setNode(5);
    EXPECT_TRUE(table->isColumnHidden(ObjectModel::project)) << "it wants nothing of this one";
}

TEST_F(ObjectsCompared, WhatDiffersFromTheProjectIsListed)
{
    view.setPlanned({.wanted = {{6,
                                 {WantedObject{{0x6000, 0}, {std::int64_t{1}}, 1},
                                  WantedObject{{0x6001, 0}, {std::int64_t{4096}}, 0},
                                  WantedObject{{0x6002, 0}, {std::int64_t{1}}, 0}}}}});
    read("6001h:0");
    ASSERT_TRUE(action("Differences")->isEnabled());
    action("Differences")->trigger();
    ASSERT_EQ(table->model()->rowCount(), 1);
    EXPECT_EQ(cell(0, ObjectModel::object), QStringLiteral("6001h:0"));
    EXPECT_EQ(message->sentence(),
              QStringLiteral("Of 3 objects that the project wants, 1 differ, and 2 have not been read."));
}

TEST_F(ObjectsCompared, OfBitsOnlyThoseThatAreWantedCount)
{
    view.setPlanned({.wanted = {{6, {WantedObject{{0x6000, 0}, {std::int64_t{4}}, 4}}}}});
    EXPECT_EQ(cell(rowOf("6000h:0"), ObjectModel::project), QStringLiteral("bit 2 = 1"));
    read("6000h:0");
    const bool isScaled = (cell(rowOf("6000h:0"), ObjectModel::value).section(u'=', 1).toInt() & 4) != 0;
    action("Differences")->trigger();
    EXPECT_EQ(table->model()->rowCount(), isScaled ? 0 : 1);
}

TEST_F(ObjectsCompared, WithNothingToCompareWithThereAreNoDifferences)
{
    EXPECT_FALSE(action("Differences")->isEnabled());
    view.setPlanned({.wanted = {{6, {WantedObject{{0x6001, 0}, {std::int64_t{4096}}, 0}}}}});
    action("Differences")->trigger();
    view.setNode(5);
    EXPECT_FALSE(action("Differences")->isChecked());
    EXPECT_GT(table->model()->rowCount(), 90);
}

TEST_F(ObjectsCompared, WhatOnlyTheProjectWantsIsARowThatIsNotWritten)
{
    ASSERT_TRUE(view.openFile(fileOf(test::rotorFile)));
    view.setPlanned({.wanted = {{6, {WantedObject{{0x6002, 0}, {std::int64_t{4096}}, 0}}}}});
    ASSERT_EQ(table->model()->rowCount(), 6);
    EXPECT_EQ(cell(rowOf("6002h:0"), ObjectModel::project), QStringLiteral("1000h = 4096"));
    choose("6002h:0");
    EXPECT_FALSE(write->isEnabled());
}

TEST_F(ObjectsCompared, TheValuesOfADcfAreAColumn)
{
    ASSERT_TRUE(view.openFile(fileOf(test::rotorFile)));
    EXPECT_TRUE(table->isColumnHidden(ObjectModel::inFile));
    QByteArray configured = test::rotorFile;
    configured.replace("DefaultValue=1000", "DefaultValue=1000\nParameterValue=500");
    ASSERT_TRUE(view.openFile(fileOf(configured, "six.dcf")));
    EXPECT_FALSE(table->isColumnHidden(ObjectModel::inFile));
    EXPECT_EQ(cell(rowOf("6001h:0"), ObjectModel::inFile), QStringLiteral("000001F4h = 500"));
    read("6001h:0");
    action("Differences")->trigger();
    ASSERT_EQ(table->model()->rowCount(), 1);
    EXPECT_TRUE(toolTip("6001h:0", ObjectModel::inFile).contains(QStringLiteral("but the node has")));
}

TEST_F(ObjectsCompared, WhatOnlyTheOtherFileHasIsARow)
{
    ASSERT_TRUE(view.openFile(fileOf(test::rotorFile)));
    QByteArray other = test::rotorFile;
    other += "[6002]\nParameterName=Range\nDataType=7\nAccessType=rw\nDefaultValue=8192\n";
    ASSERT_TRUE(view.compareWith(fileOf(other, "other.eds")));
    ASSERT_EQ(table->model()->rowCount(), 6);
    EXPECT_EQ(cell(rowOf("6002h:0"), ObjectModel::name), QStringLiteral("Range"));
    EXPECT_EQ(cell(rowOf("6002h:0"), ObjectModel::other), QStringLiteral("00002000h = 8192"));
    EXPECT_TRUE(cell(rowOf("6002h:0"), ObjectModel::meaning).startsWith(QStringLiteral("Only in the file")));
    choose("6002h:0");
    EXPECT_FALSE(write->isEnabled()) << "nothing says that this node has it";
    const QString path = folder.filePath(QStringLiteral("six.dcf"));
    ASSERT_TRUE(view.exportTo(path));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_FALSE(file.readAll().contains("[6002]"));
}

// The others are those of another device.
TEST_F(ObjectsCompared, OtherValuesAreListedBeforeWhatOneOfBothDoesNotHave)
{
    ASSERT_TRUE(view.openFile(fileOf(test::rotorFile)));
    read("6001h:0");
    QByteArray other = test::rotorFile;
    other.replace("SupportedObjects=4\n1=0x6001\n2=0x6004\n3=0x1010",
                  "SupportedObjects=3\n1=0x6001\n2=0x6004");
    other.replace("\n4=0x6503", "\n3=0x6503");
    other.replace("[1010]\nObjectType=9\nSubNumber=1\n"
                  "[1010sub1]\nParameterName=Save all\nDataType=7\nAccessType=rw\n",
                  "");
    other.replace("DefaultValue=1000", "DefaultValue=1000\nParameterValue=500");
    ASSERT_TRUE(view.compareWith(fileOf(other, "other.dcf")));
    action("Differences")->trigger();
    ASSERT_EQ(table->model()->rowCount(), 2);
    EXPECT_EQ(cell(0, ObjectModel::object), QStringLiteral("6001h:0"));
    EXPECT_EQ(cell(1, ObjectModel::object), QStringLiteral("1010h:1"));
    EXPECT_TRUE(std::ranges::any_of(view.findChildren<QLabel *>(), [](const QLabel *each) {
        return each->text().startsWith(QStringLiteral("1 differ, then 1 that are not in both"));
    }));
    action("Differences")->trigger();
    EXPECT_EQ(cell(0, ObjectModel::object), QStringLiteral("1010h:1"));
}

TEST_F(ObjectsCompared, TheChosenObjectStaysChosenWhenAFileIsComparedWith)
{
    choose("6001h:0");
    ASSERT_TRUE(view.compareWith(fileOf(test::rotorFile)));
    EXPECT_EQ(cell(table->currentIndex().row(), ObjectModel::object), QStringLiteral("6001h:0"));
}

} // namespace
} // namespace codewheel

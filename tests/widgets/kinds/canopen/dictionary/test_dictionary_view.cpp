// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/eds/device_file_reader.h"
#include "tests/widgets/kinds/canopen/dictionary/dictionary_view_test.h"

#include <QComboBox>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using test::DictionaryViewTest;
using test::rotorFile;

TEST_F(DictionaryViewTest, WithoutAFileTheStandardsSayWhatThereIs)
{
    operate();
    EXPECT_EQ(table->model()->rowCount(), 0);
    view.setNode(6);
    EXPECT_GT(table->model()->rowCount(), 90);
    EXPECT_EQ(cell(rowOf("6001h:0"), ObjectModel::name), QStringLiteral("Measuring units per revolution"));
    EXPECT_EQ(cell(rowOf("6004h:0"), ObjectModel::access), QStringLiteral("read"));
}

TEST_F(DictionaryViewTest, TheChosenObjectIsRead)
{
    operate();
    view.setNode(6);
    choose("6001h:0");
    action("Read")->trigger();
    pass(200ms);
    EXPECT_EQ(valueOf("6001h:0"), QStringLiteral("00002000h = 8192"));
    EXPECT_EQ(valueOf("6002h:0"), QStringLiteral("\u2013"));
    EXPECT_FALSE(cell(rowOf("6001h:0"), ObjectModel::readAt).isEmpty());
    view.setNode(5);
    view.setNode(6);
    EXPECT_EQ(valueOf("6001h:0"), QStringLiteral("00002000h = 8192")) << "it is kept";
}

TEST_F(DictionaryViewTest, AllListedObjectsAreReadButNoneThatCanOnlyBeWritten)
{
    operate();
    view.setNode(6);
    ASSERT_TRUE(view.openFile(fileOf(rotorFile)));
    ASSERT_EQ(table->model()->rowCount(), 5);
    const int before = sentTo(0x606);
    action("Read all")->trigger();
    pass(1s);
    EXPECT_EQ(valueOf("6001h:0"), QStringLiteral("00002000h = 8192"));
    EXPECT_EQ(valueOf("6503h:0"), QStringLiteral("0000h = 0"));
    EXPECT_EQ(valueOf("2300h:0"), QStringLiteral("\u2013"));
    EXPECT_TRUE(std::ranges::none_of(link->sent, [](const CanFrame &frame) {
        return frame.id == 0x606 && frame.bytes[1] == 0x00 && frame.bytes[2] == 0x23;
    }));
    EXPECT_GE(sentTo(0x606) - before, 4);
    EXPECT_TRUE(table->model()
                    ->index(rowOf("6001h:0"), ObjectModel::value)
                    .data(Qt::ToolTipRole)
                    .toString()
                    .contains(QStringLiteral("not the default: 000003E8h = 1000")));
}

TEST_F(DictionaryViewTest, OnlyListedGroupsAreRead)
{
    operate();
    view.setNode(6);
    view.findChild<QComboBox *>(QStringLiteral("objectGroup"))->setCurrentIndex(3);
    action("Read all")->trigger();
    pass(4s);
    view.findChild<QComboBox *>(QStringLiteral("objectGroup"))->setCurrentIndex(0);
    EXPECT_EQ(valueOf("1000h:0"), QStringLiteral("\u2013"));
    EXPECT_NE(valueOf("6500h:0"), QStringLiteral("\u2013"));
    EXPECT_FALSE(cell(rowOf("6005h:1"), ObjectModel::meaning).isEmpty()) << "why there is no value";
}

TEST_F(DictionaryViewTest, ReadingIsCancelled)
{
    operate();
    view.setNode(6);
    action("Read all")->trigger();
    action("Cancel")->trigger();
    pass(1s);
    EXPECT_EQ(valueOf("6500h:0"), QStringLiteral("\u2013"));
    EXPECT_TRUE(action("Read all")->isEnabled());
}

TEST_F(DictionaryViewTest, TheFilterFindsNamesAndObjects)
{
    operate();
    view.setNode(6);
    auto *text = view.findChild<QLineEdit *>(QStringLiteral("objectText"));
    text->setText(QStringLiteral("hysteresis"));
    EXPECT_EQ(table->model()->rowCount(), 8);
    text->setText(QStringLiteral("6003h"));
    EXPECT_EQ(table->model()->rowCount(), 1);
}

TEST_F(DictionaryViewTest, AnObjectIsWrittenOnceItIsAgreedTo)
{
    operate();
    view.setNode(6);
    choose("6001h:0");
    enter("2048");
    EXPECT_TRUE(
        question->sentence().contains(QStringLiteral("00002000h = 8192 and becomes 00000800h = 2048")))
        << question->sentence().toStdString();
    answer(QStringLiteral("Do &not write"));
    choose("6004h:0");
    choose("6001h:0");
    action("Read")->trigger();
    pass(200ms);
    EXPECT_EQ(valueOf("6001h:0"), QStringLiteral("00002000h = 8192"));
    enter("2048");
    answer(QStringLiteral("W&rite it"));
    EXPECT_EQ(valueOf("6001h:0"), QStringLiteral("00000800h = 2048"));
    EXPECT_EQ(written->sentence(), QStringLiteral("Written, and read back."));
}

TEST_F(DictionaryViewTest, TheQuestionSaysWhatMoreAWriteDoes)
{
    operate();
    view.setNode(6);
    choose("6003h:0");
    enter("0");
    EXPECT_TRUE(question->sentence().contains(QStringLiteral("sets the position")));
    choose("1010h:1");
    enter("save");
    EXPECT_TRUE(question->sentence().contains(QStringLiteral("EEPROM")));
    ASSERT_TRUE(view.openFile(fileOf(rotorFile)));
    choose("2300h:0");
    enter("1");
    EXPECT_TRUE(question->sentence().contains(QStringLiteral("object of the maker")));
    choose("6001h:0");
    enter("9000");
    EXPECT_TRUE(question->sentence().contains(QStringLiteral("outside of the limits")));
}

TEST_F(DictionaryViewTest, WhatCanOnlyBeReadIsNotWritten)
{
    operate();
    view.setNode(6);
    choose("6004h:0");
    EXPECT_FALSE(write->isEnabled());
    EXPECT_FALSE(field->isEnabled());
    EXPECT_TRUE(write->toolTip().contains(QStringLiteral("only be read")));
}

TEST_F(DictionaryViewTest, AValueThatDoesNotFitIsSaid)
{
    operate();
    view.setNode(6);
    choose("6000h:0");
    enter("65536");
    EXPECT_TRUE(question->sentence().isEmpty());
    EXPECT_TRUE(written->sentence().contains(QStringLiteral("\"65536\" is no value for 6000h:0")));
}

TEST_F(DictionaryViewTest, InWatchNothingIsReadOrWritten)
{
    open(EncoderBus::Start::watching);
    view.setNode(6);
    choose("6001h:0");
    EXPECT_FALSE(action("Read")->isEnabled());
    EXPECT_FALSE(action("Read all")->isEnabled());
    EXPECT_FALSE(write->isEnabled());
}

TEST_F(DictionaryViewTest, ARefusedFileIsSaidWithItsReason)
{
    view.setNode(6);
    EXPECT_FALSE(view.openFile(fileOf("[DeviceInfo]\n")));
    EXPECT_TRUE(message->sentence().contains(QStringLiteral("rotor.eds")))
        << message->sentence().toStdString();
    EXPECT_GT(table->model()->rowCount(), 90) << "what was there stays";
}

TEST_F(DictionaryViewTest, WhatAFileHasOtherwiseIsMarked)
{
    operate();
    view.setNode(6);
    ASSERT_TRUE(view.openFile(fileOf(rotorFile)));
    QByteArray other = rotorFile;
    other.replace("DefaultValue=1000", "DefaultValue=1000\nParameterValue=500");
    ASSERT_TRUE(view.compareWith(fileOf(other, "other.dcf")));
    EXPECT_TRUE(message->sentence().contains(QStringLiteral("1 values differ")));
    action("Differences")->trigger();
    ASSERT_EQ(table->model()->rowCount(), 1);
    EXPECT_EQ(cell(0, ObjectModel::other), QStringLiteral("000001F4h = 500"));
}

TEST_F(DictionaryViewTest, WhatWasReadIsExported)
{
    operate();
    view.setNode(6);
    ASSERT_TRUE(view.openFile(fileOf(rotorFile)));
    action("Read all")->trigger();
    pass(1s);
    const QString path = folder.filePath(QStringLiteral("six.dcf"));
    ASSERT_TRUE(view.exportTo(path));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const auto saved = canopen::readDeviceFile(file.readAll());
    ASSERT_TRUE(saved);
    EXPECT_EQ(saved->commissioning.node, 6);
    EXPECT_EQ(saved->find({0x6001, 0})->value, canopen::FileValue{std::int64_t{8192}});
}

TEST_F(DictionaryViewTest, EachObjectOfALargeFileIsARow)
{
    QByteArray large;
    for (int i = 0; i < 1'300; ++i)
        large += QStringLiteral("[%1]\nParameterName=Object\nDataType=7\nAccessType=rw\nDefaultValue=%2\n")
                     .arg(0x2000 + i, 4, 16, QLatin1Char('0'))
                     .arg(i)
                     .toLatin1();
    view.setNode(6);
    const QString path = fileOf(large, "large.eds");
    ASSERT_TRUE(view.openFile(path));
    EXPECT_EQ(table->model()->rowCount(), 1'300);
}

} // namespace
} // namespace codewheel

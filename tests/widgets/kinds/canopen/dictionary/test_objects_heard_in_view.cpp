// SPDX-License-Identifier: GPL-3.0-or-later
// Objects while another master is at work.
#include "tests/widgets/kinds/canopen/dictionary/dictionary_view_test.h"

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using test::canFrame;

class ObjectsHeardInView : public test::DictionaryViewTest
{
protected:
    void watch()
    {
        open(EncoderBus::Start::watching);
        bus->advance(2s); // they start
    }
    // As another master asks and writes.
    void otherReads(std::uint8_t low, std::uint8_t high, std::uint8_t sub = 0)
    {
        say(canFrame(0x606, {0x40, low, high, sub, 0, 0, 0, 0}));
        pass(200ms);
    }
    void otherWrites6001(std::uint8_t second)
    {
        say(canFrame(0x606, {0x23, 0x01, 0x60, 0, 0, second, 0, 0}));
        pass(200ms);
    }
    QString timeOf(const char *object) const { return cell(rowOf(object), ObjectModel::readAt); }
};

TEST_F(ObjectsHeardInView, WhatANodeAnswersToAnotherMasterIsHeardNotRead)
{
    watch();
    view.setNode(6);
    otherReads(0x01, 0x60);
    EXPECT_EQ(valueOf("6001h:0"), QStringLiteral("00002000h = 8192"));
    EXPECT_TRUE(timeOf("6001h:0").startsWith(QStringLiteral("heard, at ")))
        << timeOf("6001h:0").toStdString();
    EXPECT_EQ(sentTo(0x606), 0);
    const QString path = folder.filePath(QStringLiteral("six.dcf"));
    ASSERT_TRUE(view.exportTo(path));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_FALSE(file.readAll().contains("ParameterValue=0x2000")) << "only what was read";
}

TEST_F(ObjectsHeardInView, WhatWeReadIsNotHeard)
{
    operate();
    view.setNode(6);
    choose("6001h:0");
    action("Read")->trigger();
    pass(200ms);
    EXPECT_FALSE(timeOf("6001h:0").contains(QStringLiteral("heard")));
}

TEST_F(ObjectsHeardInView, ANewerValueOfAnotherMasterIsShownUntilItIsReadAgain)
{
    operate();
    view.setNode(6);
    choose("6001h:0");
    action("Read")->trigger();
    pass(200ms);
    otherWrites6001(0x10);
    EXPECT_EQ(valueOf("6001h:0"), QStringLiteral("00001000h = 4096"));
    EXPECT_TRUE(table->model()
                    ->index(rowOf("6001h:0"), ObjectModel::readAt)
                    .data(Qt::ToolTipRole)
                    .toString()
                    .contains(QStringLiteral("00002000h = 8192")));
}

TEST_F(ObjectsHeardInView, APdoIsShownByTheMappingThatWasHeard)
{
    operate(4s);
    view.setNode(6);
    bus->send(canFrame(0, {1, 6})); // start
    pass(500ms);
    EXPECT_TRUE(timeOf("6004h:0").startsWith(QStringLiteral("heard, at ")))
        << timeOf("6004h:0").toStdString();
    EXPECT_NE(valueOf("6004h:0"), QStringLiteral("\u2013"));
}

TEST_F(ObjectsHeardInView, WhatWasHeardOfAnotherNodeIsThereOnceItIsChosen)
{
    watch();
    view.setNode(5);
    otherReads(0x01, 0x60);
    EXPECT_EQ(valueOf("6001h:0"), QStringLiteral("\u2013"));
    view.setNode(6);
    pass(50ms);
    EXPECT_EQ(valueOf("6001h:0"), QStringLiteral("00002000h = 8192"));
}

TEST_F(ObjectsHeardInView, AQuestionIsWithdrawnWhenAnotherMasterWritesTheObject)
{
    operate();
    view.setNode(6);
    choose("6001h:0");
    enter("2048");
    ASSERT_FALSE(question->sentence().isEmpty());
    otherWrites6001(0x10);
    EXPECT_TRUE(question->sentence().isEmpty());
    EXPECT_TRUE(written->sentence().contains(QStringLiteral("00001000h = 4096")))
        << written->sentence().toStdString();
    EXPECT_EQ(field->text(), QStringLiteral("2048"));
}

} // namespace
} // namespace codewheel

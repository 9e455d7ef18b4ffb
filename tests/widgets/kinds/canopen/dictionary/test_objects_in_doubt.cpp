// SPDX-License-Identifier: GPL-3.0-or-later
// Objects of nodes that fall silent or refuse, files of other devices, and values that are none.
#include "tests/widgets/kinds/canopen/dictionary/dictionary_view_test.h"

namespace codewheel {
namespace {

using namespace std::chrono_literals;

// The rotor file, as that of another maker, with the number of its node.
QByteArray fileOfAnother()
{
    QByteArray file = test::rotorFile;
    file.replace("VendorName=Rotor Works\n",
                 "VendorName=Rotor Works\nVendorNumber=0x1A2\nProductNumber=0x7\n");
    return file + "[1018]\nObjectType=9\nSubNumber=3\n"
                  "[1018sub1]\nParameterName=Vendor\nDataType=7\nAccessType=ro\n"
                  "[1018sub2]\nParameterName=Product\nDataType=7\nAccessType=ro\n"
                  "[DeviceComissioning]\nNodeID=9\n";
}

class ObjectsInDoubt : public test::DictionaryViewTest
{
protected:
    ObjectsInDoubt()
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
};

TEST_F(ObjectsInDoubt, ANodeThatGoesAwayWhileAllAreReadEndsThat)
{
    action("Read all")->trigger();
    pass(100ms);
    EXPECT_NE(valueOf("1000h:0"), QStringLiteral("\u2013"));
    plant->withEncoder(1, [](canopen::SimulatedNode &node) { node.setOn(false); });
    pass(10s);
    EXPECT_TRUE(action("Read all")->isEnabled()) << "it has ended";
    EXPECT_TRUE(message->sentence().contains(QStringLiteral("6"))) << message->sentence().toStdString();
    EXPECT_EQ(valueOf("6500h:0"), QStringLiteral("\u2013"));
    EXPECT_EQ(cell(rowOf("6500h:0"), ObjectModel::readAt), QString()) << "nobody asked for it any more";
}

TEST_F(ObjectsInDoubt, AnAbortInTheMiddleLeavesTheOthersToBeRead)
{
    ASSERT_TRUE(view.openFile(
        fileOf(test::rotorFile + "[6005]\nParameterName=Not there\nDataType=7\nAccessType=ro\n")));
    action("Read all")->trigger();
    pass(1s);
    EXPECT_EQ(valueOf("6005h:0"), QStringLiteral("\u2013"));
    EXPECT_FALSE(cell(rowOf("6005h:0"), ObjectModel::meaning).isEmpty());
    EXPECT_EQ(valueOf("6503h:0"), QStringLiteral("0000h = 0"));
}

TEST_F(ObjectsInDoubt, AWriteWhoseLinkIsLostBehindItIsNotKnown)
{
    choose("1017h:0");
    enter("700");
    link->goneAfter = [](const CanFrame &frame) { return frame.id == 0x606 && frame.bytes[1] == 0x17; };
    answer(QStringLiteral("W&rite it"));
    pass(3s);
    EXPECT_EQ(bus->state(), BusState::lost);
    EXPECT_EQ(written->sentence(), QStringLiteral("No answer: whether it was written is not known."));
    EXPECT_EQ(valueOf("1017h:0"), QStringLiteral("\u2013")) << "the value of before tells nothing";
    const Message told{.place = six,
                       .severity = Severity::attention,
                       .id = CanopenBusMessageId::objectInDoubt,
                       .arguments = {QStringLiteral("1017h:0"), QStringLiteral("02BCh")}};
    EXPECT_EQ(std::ranges::count_if(messages,
                                    [&](Message each) {
                                        each.at = {};
                                        return each == told;
                                    }),
              1);
}

TEST_F(ObjectsInDoubt, WhatIsNoNumberIsNotWritten)
{
    choose("6001h:0");
    for (const char *typed : {"1.000", "1,5", "0x", "-1", "h", "12 34"}) {
        enter(typed);
        EXPECT_TRUE(question->sentence().isEmpty()) << typed;
        EXPECT_TRUE(written->sentence().contains(QStringLiteral("is no value"))) << typed;
    }
}

TEST_F(ObjectsInDoubt, AFileOfAnotherDeviceIsSaidOnceTheNodeHasToldWhatItIs)
{
    ASSERT_TRUE(view.openFile(fileOf(fileOfAnother(), "other.dcf")));
    EXPECT_EQ(message->sentence(),
              QStringLiteral("other.dcf is the configuration of node 9, and this is node 6."));
    read("1018h:1");
    const QString doubt =
        QStringLiteral("other.dcf is for another device: vendor 1A2h, product 7h. Node 6 says vendor 10Dh");
    EXPECT_TRUE(message->sentence().startsWith(doubt)) << message->sentence().toStdString();
    choose("2300h:0");
    enter("1");
    EXPECT_TRUE(question->sentence().contains(doubt)) << question->sentence().toStdString();
    EXPECT_EQ(message->sentence(), QString()) << "it is said once, and leaves room for the question";
    ASSERT_TRUE(view.exportTo(folder.filePath(QStringLiteral("node6.dcf"))));
    EXPECT_TRUE(message->sentence().contains(doubt)) << message->sentence().toStdString();
}

TEST_F(ObjectsInDoubt, WhoTheNodeIsIsAskedBeforeAWriteByAFileThatNamesItsDevice)
{
    ASSERT_TRUE(view.openFile(fileOf(fileOfAnother(), "other.eds")));
    choose("6001h:0");
    enter("2048");
    EXPECT_TRUE(question->sentence().contains(
        QStringLiteral("other.eds is for another device: vendor 1A2h, product 7h. Node 6 says vendor 10Dh, "
                       "product 25h.")))
        << question->sentence().toStdString();
}

TEST_F(ObjectsInDoubt, WhatTheNodeDoesNotHaveIsNotAskedAbout)
{
    ASSERT_TRUE(view.openFile(
        fileOf(test::rotorFile + "[6005]\nParameterName=Not there\nDataType=7\nAccessType=rw\n")));
    choose("6005h:0");
    enter("1");
    EXPECT_EQ(question->sentence(), QString());
    EXPECT_TRUE(written->sentence().contains(QStringLiteral("no such object")))
        << written->sentence().toStdString();
}

TEST_F(ObjectsInDoubt, AComparedFileOfAnotherDeviceIsSaid)
{
    read("1018h:1");
    ASSERT_TRUE(view.compareWith(fileOf(fileOfAnother(), "other.dcf")));
    EXPECT_TRUE(message->sentence().contains(QStringLiteral("other.dcf is for another device")))
        << message->sentence().toStdString();
}

TEST_F(ObjectsInDoubt, AFileOfThisDeviceIsNotDoubted)
{
    QByteArray own = fileOfAnother();
    own.replace("0x1A2", "0x10D")
        .replace("ProductNumber=0x7", "ProductNumber=0x25")
        .replace("NodeID=9", "NodeID=6");
    ASSERT_TRUE(view.openFile(fileOf(own, "own.dcf")));
    read("1018h:1");
    read("1018h:2");
    EXPECT_EQ(message->sentence(), QString());
}

} // namespace
} // namespace codewheel

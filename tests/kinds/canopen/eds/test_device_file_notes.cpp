// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/canopen/eds/file_literal.h"

#include <gmock/gmock.h>

namespace codewheel::canopen {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct OddRow
{
    const char *lines; // behind the first five, of 6004h
    NoteRow note;
};

class OddLines : public testing::TestWithParam<OddRow>
{};

TEST_P(OddLines, AreToldWithLineAndKeyAndTheRestIsRead)
{
    const DeviceFile file = fileOf(fileWith(GetParam().lines));
    EXPECT_THAT(notesOf(file), ElementsAre(GetParam().note)) << GetParam().lines;
    EXPECT_EQ(file.objects.size(), 1U);
    EXPECT_EQ(file.objects.front().name, QStringLiteral("Position"));
    for (const EdsNote &note : file.notes.kept())
        EXPECT_FALSE(note.text().contains(u'?')) << note.text().toStdString();
}

INSTANTIATE_TEST_SUITE_P(
    Eds, OddLines,
    testing::Values(OddRow{"no equal sign\n", {6, "no equal sign", EdsFault::noEqualSign}},
                    OddRow{"Unit=steps\n", {6, "Unit", EdsFault::unknownKey}},
                    OddRow{"DataType=7\nDATATYPE=5\n", {7, "DATATYPE", EdsFault::keyTwice}},
                    OddRow{"[6004]\nParameterName=Other\n", {6, "6004", EdsFault::sectionTwice}},
                    OddRow{"[Extras]\nColour=red\n", {6, "Extras", EdsFault::unknownSection}},
                    OddRow{"[M1SubExt1027]\n1=2\n", {6, "M1SubExt1027", EdsFault::ofModule}},
                    OddRow{"[SupportedModules]\nNrOfEntries=0\n",
                           {6, "SupportedModules", EdsFault::ofModule}},
                    OddRow{"[Comments\nLines=0\n", {6, "Comments", EdsFault::bracketOpen}},
                    OddRow{"[Comments] Lines=0\n", {6, "Comments", EdsFault::behindBracket}},
                    OddRow{"DataType=7 ; long\n", {6, "DataType", EdsFault::commentBehind}},
                    OddRow{"DataType=0x40\n", {6, "DataType", EdsFault::unknownType}},
                    OddRow{"ObjectType=0x77\n", {6, "ObjectType", EdsFault::unknownObjectType}},
                    OddRow{"AccessType=maybe\n", {6, "AccessType", EdsFault::unknownAccess}},
                    OddRow{"PDOMapping=2\n", {6, "PDOMapping", EdsFault::unknownMapping}},
                    OddRow{"PDOMapping=yes\n", {6, "PDOMapping", EdsFault::notANumber}},
                    OddRow{"DataType=5\nDefaultValue=300\n", {7, "DefaultValue", EdsFault::doesNotFit}},
                    OddRow{"DataType=5\nDefaultValue=010\n", {7, "DefaultValue", EdsFault::leadingZero}},
                    OddRow{"DataType=5\nLowLimit=9\nHighLimit=3\n", {7, "LowLimit", EdsFault::lowOverHigh}},
                    OddRow{"DataType=0x40\nDefaultValue=5\n", {6, "DataType", EdsFault::unknownType}}));

TEST(DeviceFileNotes, OfCommentsNamesAndTheHeadThereAreNone)
{
    EXPECT_THAT(notesOf(fileOf(fileWith("DataType=9\nDefaultValue=a;b#c\nObjFlags=0x0\n"
                                        "[Comments]\nLines=1\nLine4=a\nline5=b\n"
                                        "[DummyUsage]\nDummy0001=0\n[DeviceInfo]\nVendorNumber=\n"))),
                IsEmpty());
    EXPECT_EQ(fileOf(fileWith("DataType=9\nDefaultValue=a;b#c\n")).objects.front().factory,
              FileValue{QStringLiteral("a;b#c")});
}

TEST(DeviceFileNotes, LowOverHighLeavesNoLimit)
{
    const FileObject object = fileOf(fileWith("DataType=5\nLowLimit=9\nHighLimit=3\n")).objects.front();
    EXPECT_EQ(object.minimum, std::nullopt);
    EXPECT_EQ(object.maximum, std::nullopt);
    const FileObject isSigned = fileOf(fileWith("DataType=2\nLowLimit=0xFF\nHighLimit=0\n")).objects.front();
    EXPECT_EQ(isSigned.minimum, FileValue{std::int64_t{-1}});
    const FileObject large =
        fileOf(fileWith("DataType=0x1B\nLowLimit=1\nHighLimit=0xFFFFFFFFFFFFFFFF\n")).objects.front();
    EXPECT_TRUE(large.maximum);
}

TEST(DeviceFileNotes, ListsAreComparedWithTheSections)
{
    const DeviceFile file = fileOf("[MandatoryObjects]\nSupportedObjects=3\n1=0x1000\n2=0x1001\n"
                                   "[OptionalObjects]\nSupportedObjects=1\n1=0x2000\n2=none\n3=24580\n"
                                   "[1000]\nDataType=7\n[2000]\nDataType=5\n[6004]\nDataType=7\n"
                                   "[6500]\nDataType=6\n");
    EXPECT_THAT(notesOf(file),
                ElementsAre(NoteRow{2, "SupportedObjects", EdsFault::wrongCount},
                            NoteRow{4, "2", EdsFault::noSection},
                            NoteRow{6, "SupportedObjects", EdsFault::wrongCount},
                            NoteRow{7, "1", EdsFault::inWrongList}, NoteRow{8, "2", EdsFault::notInList},
                            NoteRow{16, "6500", EdsFault::inNoList}));
    EXPECT_EQ(file.objects.size(), 4U);
}

TEST(DeviceFileNotes, WithoutListsTheSectionsDecide)
{
    const DeviceFile file = fileOf("[1008]\nDataType=9\nAccessType=R\n[6004]\nDataType=7\n");
    EXPECT_EQ(file.objects.size(), 2U);
    EXPECT_THAT(notesOf(file), ElementsAre(NoteRow{0, "", EdsFault::noLists}));
}

TEST(DeviceFileNotes, CountsOfSubindexesAreCompared)
{
    const QByteArray list = "[ManufacturerObjects]\nSupportedObjects=1\n1=0x2100\n";
    EXPECT_THAT(notesOf(fileOf(list + "[2100]\nObjectType=9\nSubNumber=8\n[2100sub1]\nDataType=5\n")),
                ElementsAre(NoteRow{6, "SubNumber", EdsFault::subsDiffer}));
    const DeviceFile alone = fileOf(list + "[2100sub1]\nDataType=5\n");
    EXPECT_THAT(notesOf(alone), ElementsAre(NoteRow{4, "2100sub1", EdsFault::subAlone}));
    EXPECT_EQ(alone.objects.size(), 1U);
    const DeviceFile empty = fileOf(list + "[2100]\nObjectType=9\nSubNumber=2\n[2200]\nDataType=5\n");
    EXPECT_THAT(notesOf(empty),
                ElementsAre(NoteRow{4, "2100", EdsFault::noSubs}, NoteRow{7, "2200", EdsFault::inNoList}));
    EXPECT_EQ(empty.objects.size(), 1U);
    const DeviceFile many = fileOf(list + "[2100]\nDataType=5\nCompactSubObj=300\n");
    EXPECT_THAT(notesOf(many), ElementsAre(NoteRow{6, "CompactSubObj", EdsFault::tooManySubs}));
    EXPECT_EQ(many.objects.size(), 255U);
}

TEST(DeviceFileNotes, IdentifiersWithoutTheNodeAreNeverWritten)
{
    const auto fileFor = [](const QByteArray &index, const QByteArray &value) {
        return fileOf("[OptionalObjects]\nSupportedObjects=1\n1=0x" + index + "\n[" + index + "]\n[" + index +
                      "sub1]\nDataType=7\nAccessType=rw\nDefaultValue=" + value + "\n");
    };
    const auto bare = fileFor("1800", "0x00000180");
    EXPECT_THAT(notesOf(bare), ElementsAre(NoteRow{8, "DefaultValue", EdsFault::nodeMissing}));
    EXPECT_FALSE(bare.find({0x1800, 1})->canBeWritten());
    EXPECT_THAT(notesOf(fileFor("1401", "0x40000300")),
                ElementsAre(NoteRow{8, "DefaultValue", EdsFault::nodeMissing}));
    for (const char *sound : {"$NODEID+0x180", "0x185", "0x80000000", "0"})
        EXPECT_THAT(notesOf(fileFor("1800", sound)), IsEmpty()) << sound;
    EXPECT_THAT(notesOf(fileFor("6000", "0x180")), IsEmpty());
    EXPECT_TRUE(fileFor("1800", "$NODEID+0x180").find({0x1800, 1})->canBeWritten());
}

TEST(DeviceFileNotes, LinesBeforeTheFirstSectionAreSkipped)
{
    EXPECT_THAT(notesOf(fileOf("DataType=5\n" + fileWith("DataType=7\n"))),
                ElementsAre(NoteRow{1, "DataType", EdsFault::beforeSections}));
}

TEST(DeviceFileNotes, OfAFileFullOfFaultsAThousandAreKept)
{
    QByteArray lines;
    for (int line = 0; line < 1'500; ++line)
        lines += "nothing\n";
    const DeviceFile file = fileOf(fileWith(lines));
    EXPECT_EQ(file.notes.kept().size(), 1'000U);
    EXPECT_EQ(file.notes.left(), 500U);
}

} // namespace
} // namespace codewheel::canopen

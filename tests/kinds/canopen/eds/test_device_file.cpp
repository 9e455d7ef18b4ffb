// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/canopen/eds/file_literal.h"

#include <gmock/gmock.h>

namespace codewheel::canopen {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> namesIn(const DeviceFile &file)
{
    std::vector<std::string> names;
    for (const FileObject &object : file.objects)
        names.push_back((objectName(object.object) + u' ' + object.name).toStdString());
    return names;
}

// As a tool writes it: every list, a record, a value of the node.
const QByteArray wholeFile = "[FileInfo]\r\n"
                             "FileName=rotor.dcf\r\n"
                             "FileVersion=-\r\n"
                             "FileRevision=07\r\n"
                             "[DeviceInfo]\r\n"
                             "VendorName=Rotor Works\r\n"
                             "VendorNumber=0x1A2\r\n"
                             "ProductName=Rotor 12\r\n"
                             "ProductNumber=37\r\n"
                             "RevisionNumber=\r\n"
                             "BaudRate_100=1\r\n"
                             "[DeviceComissioning]\r\n"
                             "NodeID=0x1F\r\n"
                             "NodeName=hoist\r\n"
                             "Baudrate=250\r\n"
                             "[MandatoryObjects]\r\n"
                             "SupportedObjects=1\r\n"
                             "1=0x1018\r\n"
                             "[OptionalObjects]\r\n"
                             "SupportedObjects=2\r\n"
                             "1=0x1800\r\n"
                             "2=0x6004\r\n"
                             "[ManufacturerObjects]\r\n"
                             "SupportedObjects=1\r\n"
                             "1=0x2000\r\n"
                             "[1018]\r\n"
                             "ParameterName=Identity\r\n"
                             "ObjectType=0x9\r\n"
                             "SubNumber=2\r\n"
                             "[1018sub0]\r\n"
                             "ParameterName=Count\r\n"
                             "DataType=0x0005\r\n"
                             "AccessType=const\r\n"
                             "DefaultValue=3\r\n"
                             "[1018sub3]\r\n"
                             "ParameterName=Revision\r\n"
                             "DataType=0x0007\r\n"
                             "AccessType=ro\r\n"
                             "DefaultValue=0x20001\r\n"
                             "[1800]\r\n"
                             "ParameterName=TPDO 1\r\n"
                             "ObjectType=9\r\n"
                             "SubNumber=1\r\n"
                             "[1800sub1]\r\n"
                             "ParameterName=Identifier\r\n"
                             "DataType=7\r\n"
                             "AccessType=rw\r\n"
                             "DefaultValue=$NODEID+0x180\r\n"
                             "ParameterValue=$NodeID + 384\r\n"
                             "[2000]\r\n"
                             "ParameterName=Number\r\n"
                             "DataType=5\r\n"
                             "AccessType=rww\r\n"
                             "LowLimit=1\r\n"
                             "HighLimit=0x7F\r\n"
                             "ParameterValue=31\r\n"
                             "[6004]\r\n"
                             "ParameterName=Position\r\n"
                             "ObjectType=7\r\n"
                             "DataType=0x07\r\n"
                             "AccessType=ro\r\n"
                             "PDOMapping=1\r\n";

TEST(DeviceFiles, SayWhatObjectsThereAre)
{
    const DeviceFile file = fileOf(wholeFile);
    EXPECT_THAT(namesIn(file), ElementsAre("1018:0 Count", "1018:3 Revision", "1800:1 Identifier",
                                           "2000:0 Number", "6004:0 Position"));
    EXPECT_THAT(notesOf(file), IsEmpty());
    const FileObject *number = file.find({0x2000, 0});
    ASSERT_NE(number, nullptr);
    EXPECT_EQ(number->type, DataType::u8);
    EXPECT_EQ(number->access, FileAccess::readAndWrite);
    EXPECT_EQ(number->minimum, FileValue{std::int64_t{1}});
    EXPECT_EQ(number->maximum, FileValue{std::int64_t{127}});
    EXPECT_EQ(number->value, FileValue{std::int64_t{31}});
    EXPECT_FALSE(number->factory);
    EXPECT_FALSE(number->isMapped);
    EXPECT_TRUE(file.find({0x6004, 0})->isMapped);
    EXPECT_EQ(file.find({0x1800, 1})->value, (FileValue{std::int64_t{384}, true}));
    EXPECT_EQ(file.find({0x1018, 1}), nullptr);
}

TEST(DeviceFiles, SayWhoTheDeviceIs)
{
    const DeviceFile file = fileOf(wholeFile);
    EXPECT_EQ(file.identity.vendorName, QStringLiteral("Rotor Works"));
    EXPECT_EQ(file.identity.productName, QStringLiteral("Rotor 12"));
    EXPECT_EQ(file.identity.vendor, 0x1A2U);
    EXPECT_EQ(file.identity.product, 37U);
    EXPECT_EQ(file.identity.revision, 0x20001U) << "of 1018h:3, where the head is blank";
    EXPECT_EQ(file.fileVersion, QStringLiteral("-"));
    EXPECT_EQ(file.commissioning, (Commissioning{31, 250'000, QStringLiteral("hoist")}));
}

TEST(DeviceFiles, EndTheirLinesInAnyWay)
{
    QByteArray unixLike = wholeFile;
    unixLike.replace("\r\n", "\n");
    QByteArray old = wholeFile;
    old.replace("\r\n", "\r");
    QByteArray cut = wholeFile;
    cut.chop(2);
    for (const QByteArray &bytes : {unixLike, old, cut}) {
        EXPECT_EQ(namesIn(fileOf(bytes)), namesIn(fileOf(wholeFile)));
        EXPECT_TRUE(fileOf(bytes).find({0x6004, 0})->isMapped);
        EXPECT_THAT(notesOf(fileOf(bytes)), IsEmpty());
    }
}

TEST(DeviceFiles, MayHaveBlanksCommentsAndAnyCase)
{
    const DeviceFile file = fileOf("\n; of a tool\n  [optionalOBJECTS]  \n\tsupportedobjects = 1 \n"
                                   "# 2=0x6005\n1\t=\t0X6004\t\n[ 6004 ] ; the position\n;ObjectType=9\n"
                                   "PARAMETERNAME =  Position\t\n dataType = 0x7\t\t\n accesstype=RO\n");
    EXPECT_THAT(namesIn(file), ElementsAre("6004:0 Position"));
    EXPECT_EQ(file.objects.front().type, DataType::u32);
    EXPECT_EQ(file.objects.front().access, FileAccess::readOnly);
    EXPECT_THAT(notesOf(file), IsEmpty());
}

TEST(DeviceFiles, AccessIsWrittenInManyWays)
{
    using enum FileAccess;
    const auto accessOf = [](const QByteArray &written) {
        return fileOf(fileWith("AccessType=" + written + "\n")).objects.front().access;
    };
    EXPECT_EQ(accessOf("R"), readOnly);
    EXPECT_EQ(accessOf("RO"), readOnly);
    EXPECT_EQ(accessOf("W"), writeOnly);
    EXPECT_EQ(accessOf("wo"), writeOnly);
    EXPECT_EQ(accessOf("RW"), readAndWrite);
    EXPECT_EQ(accessOf("rww"), readAndWrite);
    EXPECT_EQ(accessOf("rwr"), readAndWrite);
    EXPECT_EQ(accessOf("Const"), constant);
    EXPECT_EQ(accessOf(""), std::nullopt);
}

TEST(DeviceFiles, WithoutAWordOfAnObjectItIsAVariableOfWhichNothingIsKnown)
{
    const DeviceFile file = fileOf("[OptionalObjects]\nSupportedObjects=1\n1=0x6004\n[6004]\n");
    ASSERT_EQ(file.objects.size(), 1U);
    const FileObject &object = file.objects.front();
    EXPECT_EQ(object.name, QStringLiteral("6004:0"));
    EXPECT_EQ(object.type, std::nullopt);
    EXPECT_EQ(object.access, std::nullopt);
    EXPECT_EQ(object.factory, std::nullopt);
    EXPECT_EQ(object.minimum, std::nullopt);
    EXPECT_EQ(object.value, std::nullopt);
    EXPECT_FALSE(object.isMapped);
    EXPECT_THAT(notesOf(file), IsEmpty());
}

TEST(DeviceFiles, BlankValuesAreNotStated)
{
    const DeviceFile file = fileOf(fileWith("DataType=7\nAccessType=rw\nDefaultValue=\nLowLimit= "
                                            "\nHighLimit=\t\nParameterValue=\nPDOMapping=\n"));
    const FileObject &object = file.objects.front();
    EXPECT_EQ(object.factory, std::nullopt);
    EXPECT_EQ(object.minimum, std::nullopt);
    EXPECT_EQ(object.maximum, std::nullopt);
    EXPECT_EQ(object.value, std::nullopt);
    EXPECT_FALSE(object.isMapped);
    EXPECT_THAT(notesOf(file), IsEmpty());
}

TEST(DeviceFiles, SubindexesAreHexadecimalAndMayHaveGaps)
{
    const DeviceFile file = fileOf("[ManufacturerObjects]\nSupportedObjects=1\n1=0x2602\n"
                                   "[2602]\nParameterName=Table\nObjectType=8\nSubNumber=0x2\n"
                                   "[2602subC]\nDataType=5\n[2602SUB10]\nDataType=5\n");
    EXPECT_THAT(namesIn(file), ElementsAre("2602:12 2602:12", "2602:16 2602:16"));
    EXPECT_THAT(notesOf(file), IsEmpty());
}

TEST(DeviceFiles, CompactSubindexesAreMade)
{
    const DeviceFile file = fileOf("[ManufacturerObjects]\nSupportedObjects=1\n1=0x2300\n"
                                   "[2300]\nParameterName=Limit\nObjectType=8\nDataType=6\nAccessType=rw\n"
                                   "DefaultValue=9\nCompactSubObj=3\n"
                                   "[2300Name]\nNrOfEntries=1\n2=Upper\n"
                                   "[2300Value]\nNrOfEntries=1\n3=0x21\n"
                                   "[2300sub1]\nParameterName=Own\nDataType=5\n");
    EXPECT_THAT(namesIn(file),
                ElementsAre("2300:0 NrOfObjects", "2300:1 Own", "2300:2 Upper", "2300:3 Limit 3"));
    EXPECT_EQ(file.objects[0].type, DataType::u8);
    EXPECT_EQ(file.objects[0].factory, FileValue{std::int64_t{3}});
    EXPECT_EQ(file.objects[1].type, DataType::u8);
    EXPECT_EQ(file.objects[2].type, DataType::u16);
    EXPECT_EQ(file.objects[2].access, FileAccess::readAndWrite);
    EXPECT_EQ(file.objects[2].factory, FileValue{std::int64_t{9}});
    EXPECT_EQ(file.objects[2].value, std::nullopt);
    EXPECT_EQ(file.objects[3].value, FileValue{std::int64_t{33}});
    EXPECT_THAT(notesOf(file), IsEmpty());
}

TEST(DeviceFiles, CompactSubindexesNeedNoSectionOfNamesOrValues)
{
    const DeviceFile file = fileOf("[OptionalObjects]\nSupportedObjects=1\n1=0x1003\n"
                                   "[1003]\nObjectType=8\nDataType=7\nAccessType=ro\nCompactSubObj=0x7\n");
    EXPECT_EQ(file.objects.size(), 8U);
    EXPECT_THAT(notesOf(file), IsEmpty());
}

TEST(DeviceFiles, TextsAreUtf8OrLatin1)
{
    EXPECT_EQ(fileOf(fileWith("Denotation=Z\xC3\xA4hler\n")).objects.front().name, QStringLiteral("Zähler"));
    EXPECT_THAT(notesOf(fileOf(fileWith("Denotation=Z\xC3\xA4hler\n"))), IsEmpty());
    const DeviceFile latin = fileOf(fileWith("Denotation=Z\xE4hler\n"));
    EXPECT_EQ(latin.objects.front().name, QStringLiteral("Zähler"));
    EXPECT_THAT(notesOf(latin), ElementsAre(NoteRow{6, "", EdsFault::notUtf8}));
    const DeviceFile lost = fileOf(fileWith("Denotation=Z\xEF\xBF\xBDhler\n"));
    EXPECT_THAT(notesOf(lost), ElementsAre(NoteRow{6, "", EdsFault::lettersLost}));
    const DeviceFile marked = fileOf("\xEF\xBB\xBF" + fileWith("DataType=5\n"));
    EXPECT_EQ(marked.objects.front().type, DataType::u8);
    EXPECT_THAT(notesOf(marked), IsEmpty());
}

TEST(DeviceFiles, NodeAndRateMayBeUnderEitherName)
{
    const QByteArray objects = fileWith("DataType=7\n");
    EXPECT_EQ(fileOf(objects + "[DeviceCommissioning]\nNodeID=5\nBaudrate=1000\n").commissioning,
              (Commissioning{5, 1'000'000, {}}));
    EXPECT_EQ(fileOf(objects + "[DeviceComissioning]\nNodeID=\nBaudrate=100\n").commissioning,
              (Commissioning{{}, 100'000, {}}));
    EXPECT_EQ(fileOf(objects).commissioning, Commissioning());
    const DeviceFile both = fileOf(objects + "[DeviceComissioning]\nNodeID=5\n"
                                             "[DeviceCommissioning]\nNodeID=6\nBaudrate=20\n");
    EXPECT_EQ(both.commissioning, (Commissioning{5, 20'000, {}}));
    EXPECT_THAT(notesOf(both), ElementsAre(NoteRow{9, "DeviceCommissioning", EdsFault::otherCommissioning}));
}

struct CommissioningRow
{
    const char *line;
    const char *key;
    EdsFault fault;
};

class CommissioningRefused : public testing::TestWithParam<CommissioningRow>
{};

TEST_P(CommissioningRefused, IsNotGuessedAndTheRestIsRead)
{
    const DeviceFile file = fileOf(fileWith("DataType=7\n") + "[DeviceComissioning]\n" + GetParam().line);
    EXPECT_THAT(rowsOf(file.refused), ElementsAre(NoteRow{8, GetParam().key, GetParam().fault}));
    EXPECT_EQ(file.commissioning, Commissioning());
    EXPECT_EQ(file.objects.size(), 1U);
}

INSTANTIATE_TEST_SUITE_P(Eds, CommissioningRefused,
                         testing::Values(CommissioningRow{"NodeID=0\n", "NodeID", EdsFault::badNode},
                                         CommissioningRow{"NodeID=128\n", "NodeID", EdsFault::badNode},
                                         CommissioningRow{"NodeId=-1\n", "NodeId", EdsFault::badNode},
                                         CommissioningRow{"Baudrate=0\n", "Baudrate", EdsFault::badRate},
                                         CommissioningRow{"Baudrate=16960\n", "Baudrate", EdsFault::badRate},
                                         CommissioningRow{"BaudRate=125000\n", "BaudRate", EdsFault::badRate},
                                         CommissioningRow{"Baudrate=125k\n", "Baudrate", EdsFault::badRate}));

TEST(DeviceFiles, WithoutObjectsAreRefused)
{
    for (const QByteArray &bytes : {QByteArray(), QByteArray("PK\3\4 no text"), QByteArray("{\"key\": 1}\n"),
                                    QByteArray("[FileInfo]\nFileName=a.eds\n"), QByteArray(3, '\0')}) {
        const auto file = readDeviceFile(bytes);
        ASSERT_FALSE(file);
        EXPECT_EQ(file.error().fault, EdsFault::noObjects);
        EXPECT_FALSE(file.error().text().isEmpty());
    }
}

TEST(DeviceFiles, WithMoreObjectsThanAnyEncoderHasAreRefused)
{
    QByteArray bytes;
    for (int index = 0x2000; index < 0x2200; ++index)
        bytes += '[' + QByteArray::number(index, 16) + "]\nCompactSubObj=254\nDataType=5\n";
    const auto file = readDeviceFile(bytes);
    ASSERT_FALSE(file);
    EXPECT_EQ(file.error().fault, EdsFault::tooManyObjects);
    EXPECT_GT(file.error().line, 0);
}

} // namespace
} // namespace codewheel::canopen

// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/eds/compare_files.h"
#include "kinds/canopen/eds/dcf_writer.h"
#include "kinds/canopen/eds/typed_value.h"
#include "tests/kinds/canopen/eds/file_literal.h"

#include <gmock/gmock.h>

namespace codewheel::canopen {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

DcfHead headOf(const char *name)
{
    return {.fileName = QString::fromLatin1(name),
            .ofFile = QStringLiteral("rotor.eds"),
            .now = QDateTime(QDate(2027, 2, 1), QTime(14, 5))};
}

std::string writtenBy(const DeviceFile &file)
{
    return dcfOf(file, headOf("hoist.dcf")).toStdString();
}

DeviceFile smallFile()
{
    DeviceFile file =
        fileOf("[DeviceInfo]\nVendorName=Rotor Works\nBaudRate_50=1\n"
               "[1000]\nParameterName=Device type\nDataType=7\nAccessType=ro\nDefaultValue=0x20196\n"
               "[1800]\nParameterName=TPDO 1\nObjectType=9\n"
               "[1800sub1]\nDataType=7\nAccessType=rw\nDefaultValue=$NODEID+0x180\n"
               "[200F]\nParameterName=Table\nObjectType=8\n"
               "[200Fsub10]\nParameterName=Row\nDataType=3\nAccessType=rw\nLowLimit=-5\n");
    file.commissioning = {9, 250'000, QStringLiteral("hoist")};
    return file;
}

TEST(DcfWriter, WritesWhatThereIs)
{
    DeviceFile file = smallFile();
    file.objects.back().value = FileValue{std::int64_t{-3}};
    EXPECT_EQ(writtenBy(file),
              "[FileInfo]\r\nFileName=hoist.dcf\r\nFileVersion=1\r\nFileRevision=1\r\n"
              "EDSVersion=4.0\r\nCreationTime=02:05PM\r\nCreationDate=02-01-2027\r\n"
              "CreatedBy=Codewheel\r\nLastEDS=rotor.eds\r\n"
              "\r\n[DeviceInfo]\r\nVendorName=Rotor Works\r\nBaudRate_50=1\r\n"
              "\r\n[DeviceComissioning]\r\nNodeID=9\r\nNodeName=hoist\r\nBaudrate=250\r\n"
              "NetNumber=0\r\nCANopenManager=0\r\n"
              "\r\n[MandatoryObjects]\r\nSupportedObjects=1\r\n1=0x1000\r\n"
              "\r\n[OptionalObjects]\r\nSupportedObjects=1\r\n1=0x1800\r\n"
              "\r\n[ManufacturerObjects]\r\nSupportedObjects=1\r\n1=0x200F\r\n"
              "\r\n[1000]\r\nParameterName=Device type\r\nObjectType=0x7\r\nDataType=0x0007\r\n"
              "AccessType=ro\r\nDefaultValue=131478\r\nPDOMapping=0\r\n"
              "\r\n[1800]\r\nParameterName=TPDO 1\r\nObjectType=0x9\r\nSubNumber=1\r\n"
              "\r\n[1800sub1]\r\nParameterName=1800:1\r\nObjectType=0x7\r\nDataType=0x0007\r\n"
              "AccessType=rw\r\nDefaultValue=$NODEID+384\r\nPDOMapping=0\r\n"
              "\r\n[200F]\r\nParameterName=Table\r\nObjectType=0x8\r\nSubNumber=1\r\n"
              "\r\n[200Fsub10]\r\nParameterName=Row\r\nObjectType=0x7\r\nDataType=0x0003\r\n"
              "AccessType=rw\r\nLowLimit=-5\r\nPDOMapping=0\r\nParameterValue=-3\r\n");
}

TEST(DcfWriter, WhatItWritesIsReadAgain)
{
    DeviceFile file = smallFile();
    for (FileObject &object : file.objects)
        object.value = FileValue{std::int64_t{7}};
    const DeviceFile again = fileOf(QByteArray::fromStdString(writtenBy(file)));
    EXPECT_THAT(notesOf(again), IsEmpty());
    EXPECT_THAT(compareFiles(file, again), IsEmpty());
    EXPECT_EQ(again.commissioning, file.commissioning);
    EXPECT_EQ(again.objects.size(), file.objects.size());
    for (std::size_t i = 0; i < file.objects.size(); ++i)
        EXPECT_EQ(again.objects[i].value, file.objects[i].value);
}

TEST(DcfWriter, TextsKeepBlanksAndQuotesAndStayInTheirLine)
{
    DeviceFile file = fileOf("[1008]\nDataType=9\n[1009]\nDataType=9\n[100A]\nDataType=9\n");
    file.objects[0].value = FileValue{QStringLiteral(" padded ")};
    file.objects[1].value = FileValue{QStringLiteral("\"quoted\"")};
    file.objects[2].value = FileValue{QStringLiteral("one\r\n[2000]")};
    const DeviceFile again = fileOf(QByteArray::fromStdString(writtenBy(file)));
    ASSERT_EQ(again.objects.size(), 3U);
    EXPECT_EQ(again.objects[0].value, file.objects[0].value);
    EXPECT_EQ(again.objects[1].value, file.objects[1].value);
    EXPECT_EQ(again.objects[2].value, FileValue{QStringLiteral("one  [2000]")});
}

TEST(DcfWriter, TextsThatLookLikeNumbersOrNothingStayTexts)
{
    const DeviceFile file = fileOf("[2000]\nParameterName=\"\"quoted\"\"\nDefaultValue=\"12\"\n"
                                   "[2001]\nDataType=9\nDefaultValue=\"\"\n");
    EXPECT_EQ(file.objects[0].factory, FileValue{QStringLiteral("12")});
    EXPECT_EQ(file.objects[1].factory, FileValue{QString()});
    const DeviceFile again = fileOf(QByteArray::fromStdString(writtenBy(file)));
    EXPECT_EQ(again.objects[0].name, QStringLiteral("\"quoted\""));
    EXPECT_EQ(again.objects[0].factory, file.objects[0].factory);
    EXPECT_EQ(again.objects[1].factory, file.objects[1].factory);
}

TEST(DcfWriter, AKeyOfTheHeadBecomesNoSection)
{
    const DeviceFile file =
        fileOf("[DeviceInfo]\nVendorName=Rotor\n\xEF\xBB\xBF[2001]=1\n[2000]\nDataType=5\n");
    EXPECT_THAT(writtenBy(file), HasSubstr("[DeviceInfo]\r\nVendorName=Rotor\r\n\r\n"));
}

// Another program that loads the DCF into a device writes what has a value.
TEST(DcfWriter, LeavesOutWhatMustNotBeWritten)
{
    DeviceFile file =
        fileOf("[1010]\nObjectType=8\n[1010sub1]\nDataType=7\nAccessType=rw\n"
               "[1011]\nObjectType=8\n[1011sub1]\nDataType=7\nAccessType=rw\n"
               "[1800]\nObjectType=9\n[1800sub1]\nDataType=7\nAccessType=rw\nDefaultValue=0x180\n"
               "[2300]\nDataType=7\nAccessType=wo\n"
               "[6003]\nDataType=7\nAccessType=rw\n");
    for (FileObject &object : file.objects)
        object.value = object.lacksNode ? object.factory : FileValue{std::int64_t{77}};
    EXPECT_EQ(file.objects.size(), 5U);
    EXPECT_THAT(writtenBy(file), Not(HasSubstr("ParameterValue")));
}

TEST(CompareFiles, ByValueHoweverItIsWritten)
{
    const auto one = fileOf("[2000]\nDataType=7\nDefaultValue=0x10\n[2001]\nDataType=8\nDefaultValue=1\n"
                            "[2002]\nDataType=7\nDefaultValue=5\n[2003]\nDataType=5\n[2004]\nDataType=5\n");
    const auto other = fileOf("[2000]\nDataType=7\nDefaultValue=16\n[2001]\nDataType=8\nDefaultValue=1.0\n"
                              "[2002]\nDataType=7\nDefaultValue=5\nParameterValue=6\n"
                              "[2003]\nDataType=5\nDefaultValue=1\n[2005]\nDataType=5\nDefaultValue=2\n");
    const auto differences = compareFiles(one, other);
    using Kind = ObjectDifference::Kind;
    ASSERT_EQ(differences.size(), 3U);
    EXPECT_EQ(differences[0].kind, Kind::differs);
    EXPECT_EQ(differences[0].object, (SdoObject{0x2002, 0}));
    EXPECT_EQ(differences[0].value, FileValue{std::int64_t{5}});
    EXPECT_EQ(differences[0].other, FileValue{std::int64_t{6}});
    EXPECT_EQ(differences[1].kind, Kind::missing);
    EXPECT_EQ(differences[1].object, (SdoObject{0x2004, 0}));
    EXPECT_EQ(differences[2].kind, Kind::additional);
    EXPECT_EQ(differences[2].other, FileValue{std::int64_t{2}});
}

TEST(CompareFiles, ResolvesTheNodeWhereOneOfThemKnowsIt)
{
    const auto eds = fileOf("[1014]\nDataType=7\nDefaultValue=$NODEID+0x80\n");
    DeviceFile dcf = fileOf("[1014]\nDataType=7\nParameterValue=0x85\n");
    EXPECT_EQ(compareFiles(eds, dcf).size(), 1U);
    dcf.commissioning.node = 5;
    EXPECT_THAT(compareFiles(eds, dcf), IsEmpty());
    EXPECT_THAT(compareFiles(dcf, eds), IsEmpty());
    dcf.commissioning.node = 6;
    EXPECT_EQ(compareFiles(eds, dcf).front().value, FileValue{std::int64_t{0x86}});
}

TEST(OctetsOfADevice, AreReadByTheTypeOfTheFileAndTheirOwnWidth)
{
    using Bytes = std::vector<std::uint8_t>;
    EXPECT_EQ(fileValueOf(DataType::u32, Bytes{0x88, 0x13, 0, 0}), FileValue{std::int64_t{5'000}});
    EXPECT_EQ(fileValueOf(DataType::i32, Bytes{0xFE, 0xFF}), FileValue{std::int64_t{-2}});
    EXPECT_EQ(fileValueOf(DataType::u16, Bytes{0, 0, 1, 0}), FileValue{std::int64_t{65'536}});
    EXPECT_EQ(fileValueOf(DataType::real32, Bytes{0, 0, 0xC0, 0x3F}), FileValue{1.5});
    EXPECT_EQ(fileValueOf(DataType::text, Bytes{'a', 'b', 0, 0}), FileValue{QStringLiteral("ab")});
    EXPECT_EQ(fileValueOf(DataType::octets, Bytes{0x0A, 0xFF}), FileValue{QStringLiteral("0aff")});
    EXPECT_EQ(fileValueOf({}, Bytes{1, 2}), FileValue{std::int64_t{513}});
    EXPECT_EQ(fileValueOf(DataType::u32, Bytes(9, 1)), FileValue{QStringLiteral("010101010101010101")});
    EXPECT_EQ(fileValueOf(DataType::u8, Bytes{}), FileValue{QString()});
}

} // namespace
} // namespace codewheel::canopen

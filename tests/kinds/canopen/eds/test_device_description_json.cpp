// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "kinds/canopen/eds/device_description_json.h"
#include "kinds/canopen/protocol/canopen_reach.h"
#include "kinds/canopen/protocol/described_node.h"
#include "kinds/canopen/protocol/device_of_type.h"
#include "tests/kinds/canopen/eds/file_literal.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>

#include <gmock/gmock.h>

namespace codewheel::canopen {
namespace {

const QByteArray encoderFile = "[FileInfo]\nFileVersion=3\n"
                               "[DeviceInfo]\nVendorName=Rotor Works & Co.\nVendorNumber=0x1A2\n"
                               "ProductName=Rotor 12\nProductNumber=0x25\nRevisionNumber=0x20001\n"
                               "[1000]\nDataType=7\nAccessType=ro\nDefaultValue=0x00010196\n"
                               "[1017]\nParameterName=Heartbeat\nDataType=6\nAccessType=ro\n"
                               "[2000]\nParameterName=Node\nDataType=5\nAccessType=rw\nDefaultValue=1\n"
                               "[2001]\nParameterName=Save\nDataType=7\nAccessType=wo\n"
                               "[2002]\nParameterName=Wide\nDataType=0x1B\nAccessType=ro\n"
                               "[2003]\nParameterName=Curve\nObjectType=8\n"
                               "[2003sub0]\nDataType=5\nAccessType=ro\n"
                               "[2003sub1]\nDataType=3\nAccessType=rw\n"
                               "[6000]\nDataType=6\nAccessType=rw\nDefaultValue=4\n"
                               "[6001]\nDataType=6\nAccessType=rw\nLowLimit=1\nHighLimit=4096\n"
                               "DefaultValue=1024\n"
                               "[6004]\nDataType=7\nAccessType=ro\nPDOMapping=1\n";

QJsonObject genericRow(const QString &key)
{
    QFile resource(QStringLiteral(":/devices/%1.json").arg(key));
    EXPECT_TRUE(resource.open(QIODevice::ReadOnly));
    return QJsonDocument::fromJson(resource.readAll()).object();
}

// As the catalog takes it.
DeviceDescription descriptionBy(const QByteArray &bytes)
{
    const DeviceFile file = fileOf(bytes);
    const QString generic = deviceOfType(deviceTypeIn(file).value_or(0));
    const QJsonObject json = descriptionOf(file, genericRow(generic), descriptionKeyOf(file.identity),
                                           QStringLiteral("rotor.eds"));
    Catalog catalog;
    const auto added = catalog.add(QJsonDocument(json).toJson(), QStringLiteral("made.json"));
    EXPECT_TRUE(added) << (added ? std::string()
                                 : (added.error().place() + added.error().reason).toStdString());
    return added ? catalog.devices().front() : DeviceDescription();
}

TEST(DescriptionOfAFile, SaysWhoTheDeviceIs)
{
    const DeviceDescription device = descriptionBy(encoderFile);
    EXPECT_EQ(device.key, QStringLiteral("rotor-works-co-rotor-12"));
    EXPECT_EQ(device.fullName(), QStringLiteral("Rotor Works & Co. Rotor 12"));
    EXPECT_EQ(device.manual, QStringLiteral("rotor.eds, 3"));
    EXPECT_EQ(canopenDevice(device).vendor, 0x1A2U);
    EXPECT_EQ(canopenDevice(device).product, 0x25U);
    EXPECT_EQ(canopenDevice(device).revision, 0x20001U);
    EXPECT_EQ(device.physicalTurns, 1) << "single-turn";
}

TEST(DescriptionOfAFile, HasTheParametersThatTheFileHasObjectsFor)
{
    const DeviceDescription device = descriptionBy(encoderFile);
    const ParameterDescription *steps = device.find(Parameter::steps);
    ASSERT_NE(steps, nullptr);
    EXPECT_TRUE(steps->canBeWritten);
    EXPECT_EQ(steps->minimum, 1);
    EXPECT_EQ(steps->maximum, 4096);
    EXPECT_EQ(steps->factory, 1024);
    EXPECT_EQ(canopenReach(*steps)->type, ObjectType::u16);
    EXPECT_EQ(device.find(Parameter::scaling)->factory, 1) << "bit 2 of 6000h";
    EXPECT_EQ(device.find(Parameter::direction)->factory, 0);
    EXPECT_EQ(device.find(Parameter::measuringRange), nullptr);
    EXPECT_EQ(device.find(Parameter::preset), nullptr);
    EXPECT_FALSE(device.capabilities.presets);
    EXPECT_FALSE(device.capabilities.resets);
    EXPECT_FALSE(device.capabilities.cams);
    EXPECT_FALSE(device.find(Parameter::of(u"1017"))->canBeWritten) << "ro in the file";
}

TEST(DescriptionOfAFile, HasObjectsOfTheMakerAsDetailsThatAreOnlyRead)
{
    const DeviceDescription device = descriptionBy(encoderFile);
    const ParameterDescription *node = device.find(Parameter::of(u"2000"));
    ASSERT_NE(node, nullptr);
    EXPECT_TRUE(node->isDetail);
    EXPECT_TRUE(node->canBeRead);
    EXPECT_FALSE(node->canBeWritten);
    EXPECT_EQ(node->maximum, 255);
    EXPECT_EQ(node->factory, 1);
    EXPECT_EQ(device.find(Parameter::of(u"2001")), nullptr) << "can only be written";
    EXPECT_EQ(device.find(Parameter::of(u"2002")), nullptr) << "64 bits";
    EXPECT_EQ(device.find(Parameter::of(u"2003")), nullptr) << "a count";
    EXPECT_NE(device.find(Parameter::of(u"2003:1")), nullptr);
    EXPECT_EQ(device.find(Parameter::of(u"6004")), nullptr) << "the position";
}

TEST(DescriptionOfAFile, IsOfTheFormOfItsDeviceType)
{
    EXPECT_EQ(deviceOfType(0x0001'0196).toStdString(), "canopen-406-single-turn");
    EXPECT_EQ(deviceOfType(0x0002'0196).toStdString(), "canopen-406-multi-turn");
    EXPECT_EQ(deviceOfType(0x0008'0196).toStdString(), "canopen-406-linear");
    EXPECT_EQ(deviceOfType(0x0001'019A).toStdString(), "") << "an inclinometer";
    EXPECT_EQ(deviceTypeIn(fileOf("[1000]\nDataType=7\nDefaultValue=0\n")), std::nullopt);
    EXPECT_EQ(deviceTypeIn(fileOf("[1000]\nDataType=7\n")), std::nullopt);
}

TEST(DescriptionOfAFile, HasAKeyInAnyCase)
{
    EXPECT_EQ(descriptionKeyOf({.vendorName = QStringLiteral("Ünder")}),
              QStringLiteral("nder-canopen-encoder"));
    EXPECT_EQ(descriptionKeyOf({.vendor = 0x1A2, .product = 7}), QStringLiteral("vendor-1a2h-product-7h"));
    EXPECT_EQ(descriptionKeyOf({.vendorName = QStringLiteral("編碼"), .productName = QStringLiteral("器")}),
              QStringLiteral("canopen-device"));
}

TEST(DescribedNodes, AreRecognisedByVendorProductAndRevision)
{
    const auto deviceWith = [](const char *key, std::optional<std::uint32_t> revision) {
        DeviceDescription device = descriptionBy(encoderFile);
        device.key = QString::fromLatin1(key);
        device.ofKind = KindData(CanopenDevice{.vendor = 0x1A2, .product = 0x25, .revision = revision});
        return device;
    };
    const std::vector<DeviceDescription> devices{*Catalog::builtIn().find(u"canopen-406-multi-turn"),
                                                 deviceWith("any", {}), deviceWith("second", 0x20001),
                                                 deviceWith("third", 0x30000)};
    const auto named = [&](const ToldIdentity &node) {
        const DeviceDescription *device = describedNode(devices, node);
        return device != nullptr ? device->key.toStdString() : std::string("none");
    };
    EXPECT_EQ(named({0x1A2, 0x25, 0x20001, 5}), "second");
    EXPECT_EQ(named({0x1A2, 0x25, 0x20007, 5}), "second");
    EXPECT_EQ(named({0x1A2, 0x25, 0x30001, {}}), "third");
    EXPECT_EQ(named({0x1A2, 0x25, 0x40000, 5}), "any");
    EXPECT_EQ(named({0x1A2, 0x25, {}, {}}), "any");
    EXPECT_EQ(named({0x1A2, 0x26, 0x20001, 5}), "none");
    EXPECT_EQ(named({0x1A3, 0x25, 0x20001, 5}), "none");
    EXPECT_EQ(named({}), "none");
    EXPECT_TRUE(describesNodes(devices));
    EXPECT_FALSE(describesNodes(std::span(devices).first(1)));
    EXPECT_FALSE(describesNodes(Catalog::builtIn().devices()));
}

} // namespace
} // namespace codewheel::canopen

// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/device_description.h"
#include "kinds/interbus/ring/id_code.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

struct Register
{
    unsigned deviceCode;
    int inWords;
    int outWords;
    const char *name;
};

// Data sheets of the devices; ../shared/spec/interbus.md in words: ID code, then length code.
class IdRegister : public testing::TestWithParam<Register>
{};

TEST_P(IdRegister, TellsWordsAndKindOfADevice)
{
    const Register &expected = GetParam();
    const RingDevice device = deviceOf(expected.deviceCode);
    EXPECT_EQ(device.deviceCode, expected.deviceCode);
    EXPECT_EQ(device.idCode(), expected.deviceCode & 0xFF);
    EXPECT_EQ(device.inWords, expected.inWords);
    EXPECT_EQ(device.outWords, expected.outWords);
    EXPECT_EQ(idCodeName(device.idCode()), QLatin1String(expected.name));
    EXPECT_EQ(ringDevice(Participant(device)), device) << "as everybody keeps it";
}

INSTANTIATE_TEST_SUITE_P(
    Codes, IdRegister,
    testing::Values(
        Register{0x0136, 1, 0, "encoder K1 or K2"}, Register{0x0236, 2, 0, "encoder K1 or K2"},
        Register{0x0237, 2, 2, "encoder K3"}, Register{0x03F7, 2, 2, "encoder K4"}, // 3 words, 1 of them PCP
        Register{0x01B2, 1, 0, "encoder K1 or K2, Loop 2"}, Register{0x02B3, 2, 2, "encoder K3, Loop 2"},
        Register{0x0233, 2, 2, "analog input and output"}, Register{0x0131, 0, 1, "analog output"},
        Register{0x0432, 4, 0, "analog input"}, Register{0x0101, 0, 1, "digital output"},
        Register{0x0202, 2, 0, "digital input"}, Register{0x0103, 1, 1, "digital input and output"},
        Register{0x000C, 0, 0, "bus terminal"}, Register{0x81BE, 1, 0, "Inline digital input"}, // 1 byte
        Register{0x83BE, 2, 0, "Inline digital input"},                                         // 3 bytes
        Register{0x42BE, 1, 0, "Inline digital input"},                                         // 2 nibbles
        Register{0xC2BE, 1, 0, "Inline digital input"},                                         // 2 bits
        Register{0x06E0, 4, 4, "drive with PCP"}, // 2 words of PCP
        Register{0x06E1, 2, 2, "drive with PCP"}, // 4
        Register{0x06E3, 5, 5, "drive with PCP"}, // 1
        Register{0x0100, 0, 0, ""}, Register{0x027F, 2, 2, ""}));

TEST(IdCode, NamesADeviceWithoutADescriptionByItsKind)
{
    EXPECT_EQ(ringDeviceName(deviceOf(0x81BE), nullptr), QStringLiteral("Inline digital input"));
    EXPECT_EQ(ringDeviceName(deviceOf(0x027F), nullptr), QStringLiteral("device not known"));
    DeviceDescription described;
    described.name = QStringLiteral("OCD-IB K3");
    EXPECT_EQ(ringDeviceName(deviceOf(0x0237), &described), described.fullName());
}

TEST(IdCode, TheLengthCodeCountsWordsBytesNibblesAndBits)
{
    EXPECT_EQ(lengthBits(0x02), 32);
    EXPECT_EQ(lengthBits(0x81), 8);
    EXPECT_EQ(lengthBits(0x43), 12);
    EXPECT_EQ(lengthBits(0xC5), 5);
    EXPECT_EQ(lengthBits(0x3F), 63 * 16);
    EXPECT_EQ(lengthBits(0x00), 0);
}

TEST(IdCode, APcpDeviceTellsTheWidthOfItsChannel)
{
    EXPECT_EQ(pcpWords(0xE0), 2);
    EXPECT_EQ(pcpWords(0xE1), 4);
    EXPECT_EQ(pcpWords(0xE3), 1);
    EXPECT_EQ(pcpWords(0xF7), 1);
    EXPECT_EQ(pcpWords(0xE2), std::nullopt);
    EXPECT_EQ(pcpWords(0x37), 0);
    EXPECT_FALSE(isPcp(0xB3));
}

TEST(IdCode, Loop2AndInlineStandOnALocalBus)
{
    for (const unsigned code : {0xB2U, 0xB3U, 0xBEU})
        EXPECT_TRUE(standsOnLocalBus(code)) << std::hex << code;
    for (const unsigned code : {0x36U, 0x37U, 0x33U, 0x0CU, 0xF7U, 0x7FU})
        EXPECT_FALSE(standsOnLocalBus(code)) << std::hex << code;
}

} // namespace
} // namespace codewheel

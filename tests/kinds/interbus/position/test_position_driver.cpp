// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "kinds/interbus/make_driver.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

class PositionDrivers : public testing::Test
{
protected:
    Reading reading(QStringView device, Word in)
    {
        const auto driver = makeDriver(*catalog.find(device));
        EXPECT_EQ(driver->cycle(in, 0, Instant{7}), 0U);
        return driver->reading();
    }

    const Catalog catalog = Catalog::builtIn();
};

TEST_F(PositionDrivers, TellTheRawPosition)
{
    const Reading turned = reading(u"fraba-ocd-ib-k1", 0x0000'0FFF);
    EXPECT_EQ(turned.state, EncoderState::operation);
    EXPECT_EQ(turned.position, 4095);
    EXPECT_EQ(turned.in, 0x0000'0FFFU);
    EXPECT_EQ(turned.at, Instant{7});
    EXPECT_EQ(turned.coding, PositionCoding::binary);
    EXPECT_EQ(reading(u"fraba-ocd-ib-k2", 0x00FF'FFFF).position, 16'777'215);
    EXPECT_EQ(reading(u"generic-k1", 0x0000'FFFF).position, 65'535);
    EXPECT_EQ(reading(u"generic-k2", 0x01FF'FFFF).position, 33'554'431);
    EXPECT_EQ(reading(u"generic-k2", 0x0200'0000).position, std::nullopt);
    EXPECT_EQ(reading(u"twk-k4", 0x8200'00FF).position, 0x8200'00FF);
}

TEST_F(PositionDrivers, TellNoPositionWhereTheDescriptionDoesNotFit)
{
    const Reading odd = reading(u"fraba-ocd-ib-k1", 0x0000'1234);
    EXPECT_EQ(odd.state, EncoderState::unknown);
    EXPECT_EQ(odd.position, std::nullopt);
    EXPECT_EQ(odd.in, 0x0000'1234U);
}

TEST_F(PositionDrivers, DecodeAsTheDescriptionSays)
{
    DeviceDescription gray = *catalog.find(u"fraba-ocd-ib-k2");
    gray.coding = PositionCoding::gray;
    const auto driver = makeDriver(gray);
    driver->cycle(0x0000'0214, 0, {});
    EXPECT_EQ(driver->reading().position, 999);
    EXPECT_EQ(driver->reading().coding, PositionCoding::gray);
}

TEST_F(PositionDrivers, NeverChangeOut)
{
    for (const auto key : {u"fraba-ocd-ib-k1", u"fraba-ocd-ib-k2", u"twk-k4"})
        for (const Word out : {0x0000'0000u, 0x0200'00FFu, 0x8000'0000u, 0xFFFF'FFFFu}) {
            const auto driver = makeDriver(*catalog.find(QStringView(key)));
            EXPECT_FALSE(driver->begin(1, SetPreset{}, Pace::byItself, 0, out, {}));
            EXPECT_EQ(driver->cycle(0x123, out, {}), out);
            EXPECT_FALSE(driver->busy());
            EXPECT_TRUE(driver->takeEvents().empty());
        }
}

TEST_F(PositionDrivers, RefuseEveryJobWithItsReason)
{
    struct Row
    {
        const char16_t *device;
        Job job;
        RefusalCode id;
    };
    const Row rows[] = {
        {u"fraba-ocd-ib-k1", ReadParameters{{Parameter::steps}}, RefusalId::readingNotSupported},
        {u"fraba-ocd-ib-k1", WriteParameters{}, RefusalId::writingNotSupported},
        {u"fraba-ocd-ib-k1", EndParameterization{}, RefusalId::writingNotSupported},
        {u"fraba-ocd-ib-k1", SetPreset{100}, RefusalId::presetNotSupported},
        {u"fraba-ocd-ib-k1", ResetToDefault{}, RefusalId::resetNotSupported},
        {u"fraba-ocd-ib-k1", SwitchMode{}, RefusalId::velocityNotSupported},
        {u"fraba-ocd-ib-k1", SwitchMode{Mode::cam, 1}, RefusalId::camsNotSupported},
        {u"fraba-ocd-ib-k1", ReadCams{}, RefusalId::camsNotSupported},
        {u"fraba-ocd-ib-k1", WriteCams{}, RefusalId::camsNotSupported},
        {u"fraba-ocd-ib-k1", SendWords{{0x0200'00FF}}, RefusalId::sendingNotSupported},
        {u"fraba-ocd-ib-k2", SendWords{{0x0200'00FF}}, RefusalId::sendingNotSupported},
        {u"twk-k4", SendWords{{0x0200'00FF}}, RefusalId::jobNotSupported},
        {u"twk-k4", WriteParameters{}, RefusalId::writingNotSupported},
    };
    for (const Row &row : rows) {
        const DeviceDescription &device = *catalog.find(QStringView(row.device));
        const auto refused = makeDriver(device)->begin(1, row.job, Pace::byItself, 0, 0, {});
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error(), (Refusal{RefusalKind::notSupported, row.id, {device.fullName()}}));
    }
}

} // namespace
} // namespace codewheel

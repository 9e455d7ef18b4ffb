// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/links/project_adapter.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using Ports = std::vector<PortInfo>;

PortInfo adapter(const char *path, const char *serialNumber, const char *usbPath)
{
    return {.path = QString::fromLatin1(path),
            .description = QStringLiteral("FT232R USB UART"),
            .serialNumber = QString::fromLatin1(serialNumber),
            .usbPath = QString::fromLatin1(usbPath),
            .vendor = 0x0403,
            .product = 0x6001};
}

const QString usb0 = QStringLiteral("/dev/ttyUSB0");
const PortInfo ours = adapter("/dev/ttyUSB0", "A50285BI", "1-2:1.0");
const PortInfo nameless = adapter("/dev/ttyUSB0", "", "1-2:1.0");

RefusalCode idOf(const Result<QString> &found)
{
    return found ? RefusalId::nothingToDo : found.error().id;
}

TEST(KeptAdapter, TakesWhateverIsAtThePortFirst)
{
    KeptAdapter kept(usb0);
    EXPECT_EQ(kept.find({ours}), usb0);
}

TEST(KeptAdapter, FindsTheSameOneAtAnotherPort)
{
    KeptAdapter kept(usb0);
    ASSERT_TRUE(kept.find({ours}));
    EXPECT_EQ(idOf(kept.find({})), RefusalId::portNotFound);
    EXPECT_EQ(kept.find({adapter("/dev/ttyUSB3", "A50285BI", "1-4:1.0")}), QStringLiteral("/dev/ttyUSB3"));
    EXPECT_EQ(kept.path(), QStringLiteral("/dev/ttyUSB3"));
}

TEST(KeptAdapter, TakesNoOtherAtItsPortUnasked)
{
    KeptAdapter kept(usb0);
    ASSERT_TRUE(kept.find({ours}));
    const PortInfo other = adapter("/dev/ttyUSB0", "B7", "1-2:1.0");
    const auto refused = kept.find({other});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error(),
              (Refusal{RefusalKind::link, RefusalId::portOfOther, {other.label(), ours.label()}}));
    EXPECT_EQ(idOf(kept.find({other})), RefusalId::portOfOther) << "each time";

    kept.takeOther();
    EXPECT_EQ(kept.find({other}), usb0);
    EXPECT_EQ(idOf(kept.find({ours})), RefusalId::portOfOther) << "that is the other one now";
}

TEST(KeptAdapter, WithoutASerialNumberItAsksWhereItIsPluggedInElsewhere)
{
    KeptAdapter kept(usb0);
    ASSERT_TRUE(kept.find({nameless}));
    const PortInfo elsewhere = adapter("/dev/ttyUSB1", "", "1-4:1.0");
    EXPECT_EQ(idOf(kept.find({elsewhere})), RefusalId::portOfOther);
    kept.takeOther();
    EXPECT_EQ(kept.find({elsewhere}), elsewhere.path);
}

TEST(KeptAdapter, WhatWentAwayMeanwhileIsNotTaken)
{
    KeptAdapter kept(usb0);
    ASSERT_TRUE(kept.find({ours}));
    ASSERT_FALSE(kept.find({adapter("/dev/ttyUSB0", "B7", "1-2:1.0")}));
    EXPECT_EQ(idOf(kept.find({})), RefusalId::portNotFound);
    kept.takeOther(); // the answer comes late
    EXPECT_EQ(kept.find({ours}), usb0);
}

TEST(KeptAdapter, OneThatWasKeptIsLookedForFromTheBeginning)
{
    KeptAdapter kept(ours);
    EXPECT_EQ(idOf(kept.find({adapter("/dev/ttyUSB0", "B7", "1-2:1.0")})), RefusalId::portOfOther);
    EXPECT_EQ(kept.find({adapter("/dev/ttyUSB7", "A50285BI", "2-1:1.0")}), QStringLiteral("/dev/ttyUSB7"));
}

TEST(KeptAdapter, AProjectKeepsIt)
{
    EscLinePlan line;
    line.settings.port = QStringLiteral("ttyUSB0");
    KeptAdapter first = keptAdapterOf(line);
    EXPECT_FALSE(first.adapter());
    ASSERT_TRUE(first.find({adapter("/dev/ttyUSB1", "B7", "1-4:1.0"), ours}));
    line.adapter = lineAdapter(first.adapter());
    EXPECT_EQ(line.adapter, (EscLineAdapter{0x0403, 0x6001, ours.serialNumber, ours.usbPath}));
    KeptAdapter kept = keptAdapterOf(line);
    EXPECT_EQ(kept.path(), usb0);
    const PortInfo elsewhere = adapter("/dev/ttyUSB4", "A50285BI", "1-9:1.0");
    EXPECT_EQ(kept.find({adapter("/dev/ttyUSB0", "B7", "1-2:1.0"), elsewhere}), elsewhere.path);
    EXPECT_EQ(kept.adapter(), elsewhere) << "not the one at its path of before";

    line.adapter = lineAdapter({});
    EXPECT_EQ(line.adapter, EscLineAdapter());
    EXPECT_EQ(keptAdapterOf(line).find({adapter("/dev/ttyUSB0", "B7", "1-2:1.0")}), usb0) << "any";
}

TEST(KeptAdapter, APathWithoutAnAdapterStaysWhatItIs)
{
    const QString pty = QStringLiteral("/dev/pts/7");
    KeptAdapter kept(pty);
    EXPECT_EQ(kept.find({ours}), pty);
    EXPECT_EQ(kept.find({}), pty);
}

} // namespace
} // namespace codewheel

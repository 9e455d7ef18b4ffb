// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/plan/process_addresses.h"
#include "kinds/interbus/ring/ring_device.h"
#include "tests/support/plans.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using Unit = AddressRules::Unit;

ProjectDevice device(int inWords, int outWords)
{
    ProjectDevice made;
    made.participant = RingDevice{.number = {}, .inWords = inWords, .outWords = outWords, .deviceKey = {}};
    return made;
}

QString shown(const std::vector<DeviceAddresses> &addresses)
{
    QStringList texts;
    const auto text = [](const std::optional<AddressRange> &range) {
        return range ? QStringLiteral("%1..%2%3")
                           .arg(range->first)
                           .arg(range->last())
                           .arg(range->byHand ? QStringLiteral("!") : QString())
                     : QStringLiteral("-");
    };
    for (const DeviceAddresses &each : addresses)
        texts << text(each.in) + u'/' + text(each.out);
    return texts.join(u' ');
}

TEST(ProcessAddresses, AutomaticOnesFollowTheRing)
{
    Project project;
    project.devices = {device(2, 2), device(1, 0), device(0, 0), device(2, 2)};
    EXPECT_EQ(shown(processAddresses(project)).toStdString(), "0..3/0..3 4..5/- -/- 6..9/4..7");
    changeRing(project, [&](RingPlan &ring) { ring.addresses.first = 128; });
    EXPECT_EQ(shown(processAddresses(project)).toStdString(),
              "128..131/128..131 132..133/- -/- 134..137/132..135");
    changeRing(project, [&](RingPlan &ring) { ring.addresses.first = 7; });
    EXPECT_EQ(shown(processAddresses(project)).toStdString(), "8..11/8..11 12..13/- -/- 14..17/12..15")
        << "word aligned";
}

TEST(ProcessAddresses, AutomaticOnesGoRoundThoseGivenByHand)
{
    Project project;
    project.devices = {device(2, 2), device(2, 2), device(2, 2)};
    project.devices[1].set(GivenAddresses{.in = 2, .out = 128});
    EXPECT_EQ(shown(processAddresses(project)).toStdString(), "6..9/0..3 2..5!/128..131! 10..13/4..7");
    project.devices[1].set(GivenAddresses{.in = 5, .out = 128});
    EXPECT_EQ(shown(processAddresses(project)).toStdString(), "0..3/0..3 5..8!/128..131! 10..13/4..7");
}

TEST(ProcessAddresses, AreShownAndTypedInBytesOrWords)
{
    EXPECT_EQ(addressText(12, Unit::byte), QStringLiteral("12"));
    EXPECT_EQ(addressText(12, Unit::word), QStringLiteral("6"));
    EXPECT_EQ(addressText(13, Unit::word), QStringLiteral("6 + 1"));
    EXPECT_EQ(parseAddress(u" 12 ", Unit::byte), 12);
    EXPECT_EQ(parseAddress(u"12", Unit::word), 24);
    EXPECT_EQ(parseAddress(u"65535", Unit::byte), 65'535);
    for (const char *text : {"", "-1", "x", "1.5", "65536", "99999999999"})
        EXPECT_EQ(parseAddress(QString::fromLatin1(text), Unit::byte), std::nullopt) << text;
    EXPECT_EQ(parseAddress(u"32768", Unit::word), std::nullopt);
}

} // namespace
} // namespace codewheel

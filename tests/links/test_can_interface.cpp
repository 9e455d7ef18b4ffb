// SPDX-License-Identifier: GPL-3.0-or-later
#include "links/can_interface.h"
#include "tests/doctor/made_computer.h"

namespace codewheel {
namespace {

void makeInterface(MadeComputer &made, const QString &name, const QByteArray &type, const QByteArray &flags,
                   bool isVirtual = false)
{
    const QString folder = (isVirtual ? QStringLiteral("/sys/devices/virtual/net/")
                                      : QStringLiteral("/sys/devices/pci0000:00/1-2/net/")) +
                           name;
    made.file(folder + QStringLiteral("/type"), type);
    made.file(folder + QStringLiteral("/flags"), flags);
    made.link(QStringLiteral("/sys/class/net/") + name,
              "../../.." + folder.mid(4).toLatin1().prepend("/sys"));
}

const CanStatusOf atHalfARate = [](const QString &name) {
    return name == QStringLiteral("can0") ? std::optional(CanStatus{.rate = 500'000}) : std::nullopt;
};

TEST(CanInterfaces, AreThoseForCan)
{
    MadeComputer made;
    makeInterface(made, QStringLiteral("can0"), "280", "0x40080");
    makeInterface(made, QStringLiteral("can1"), "280", "0x400c1");
    makeInterface(made, QStringLiteral("eth0"), "1", "0x1003");
    makeInterface(made, QStringLiteral("vcan0"), "280", "0xc1", true);
    const std::vector<CanInterface> interfaces{
        {.name = QStringLiteral("can0"), .isConfirming = true, .status = {.rate = 500'000}},
        {.name = QStringLiteral("can1"), .isUp = true, .isConfirming = true},
        {.name = QStringLiteral("vcan0"), .isUp = true, .isVirtual = true}};
    EXPECT_EQ(canInterfaces(made.computer(), atHalfARate), interfaces);
    EXPECT_FALSE(canInterface(QStringLiteral("eth0"), made.computer(), atHalfARate));
    EXPECT_FALSE(canInterface(QStringLiteral("../net/can0"), made.computer(), atHalfARate));
}

TEST(CanInterfaces, CommandsAreForTheUser)
{
    const CanInterface real{.name = QStringLiteral("can0")};
    const CanInterface virtualOne{.name = QStringLiteral("vcan0"), .isVirtual = true};
    EXPECT_EQ(switchOnCommand(real, 250'000).toStdString(),
              "sudo ip link set can0 up type can bitrate 250000");
    EXPECT_EQ(switchOnCommand(virtualOne, 250'000).toStdString(), "sudo ip link set vcan0 up");
    EXPECT_EQ(restartCommand(QStringLiteral("can0")).toStdString(), "sudo ip link set can0 type can restart");
}

// RTM_NEWLINK with IFLA_IFNAME "can0" and IFLA_LINKINFO, whose IFLA_INFO_DATA has the bit timing (500000),
// the mode, the state and the counters.
const QByteArray ofCan0 = QByteArray::fromHex("94000000 1000 0000 01000000 00000000"  // nlmsghdr
                                              "00 00 1801 03000000 c1000400 00000000" // ifinfomsg
                                              "0900 0300 63616e30 00000000"           // name
                                              "6800 1200"                             // link info
                                              "0800 0100 63616e00"                    // kind
                                              "5c00 0200"                             // data
                                              "2400 0100 20a10700 6b030000 7d000000"  // bit timing
                                              "06000000 07000000 02000000 01000000 01000000"
                                              "0800 0400 02000000"                     // state: passive
                                              "0c00 0500 00000000 02000000"            // listens only
                                              "0800 0800 8200 0700"                    // counters
                                              "0800 0700 00000000"                     // restart
                                              "1000 0600 00000000 00000000 00000000"); // others

TEST(CanStatusOfSystem, IsReadFromItsAnswer)
{
    EXPECT_EQ(canStatusOf(ofCan0), (CanStatus{.state = CanState::passive,
                                              .transmitErrors = 130,
                                              .receiveErrors = 7,
                                              .rate = 500'000,
                                              .listensOnly = true}));
}

TEST(CanStatusOfSystem, AnAnswerThatIsCutOffIsNone)
{
    for (qsizetype size = 0; size < ofCan0.size(); ++size)
        EXPECT_FALSE(canStatusOf(ofCan0.first(size))) << size;
}

TEST(CanStatusOfSystem, WithoutItsPartsItSaysNothing)
{
    QByteArray ofVirtual = ofCan0;
    ofVirtual.replace(QByteArray("can\0", 4), QByteArray("vcan", 4));
    EXPECT_FALSE(canStatusOf(ofVirtual));
    EXPECT_FALSE(canStatus(QStringLiteral("lo")));
    EXPECT_FALSE(canStatus(QStringLiteral("none-such")));
}

} // namespace
} // namespace codewheel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/can_refusals.h"
#include "doctor/hindrance_of_refusal.h"
#include "tests/doctor/made_computer.h"
#include "vocabulary/refusal_text.h"

namespace codewheel {
namespace {

Refusal refusal(RefusalCode id, std::vector<RefusalArgument> arguments)
{
    return {RefusalKind::link, id, std::move(arguments)};
}

TEST(HindranceOfRefusal, HasTheSentenceOfTheRefusalAndACommand)
{
    const struct
    {
        Refusal why;
        const char *key;
        const char *command;
    } rows[] = {
        {refusal(RefusalId::hostNotFound, {QStringLiteral("gateway")}), "hostUnknown",
         "getent hosts gateway"},
        {refusal(RefusalId::connectionRefused, {QStringLiteral("10.0.0.5:502")}), "hostRefuses",
         "nc -vz 10.0.0.5 502"},
        {refusal(RefusalId::connectionRefused, {QStringLiteral("[fe80::1]:502")}), "hostRefuses",
         "nc -vz fe80::1 502"},
        {refusal(RefusalId::connectionSilent, {QStringLiteral("10.0.0.5:502"), std::int64_t{3}}),
         "hostSilent", "ping -c 3 10.0.0.5"},
        {refusal(RefusalId::serverPortTaken, {std::int64_t{502}}), "serverPortTaken",
         "ss -ltnp \"sport = :502\""},
        {refusal(RefusalId::portInUse, {QStringLiteral("/dev/ttyNobody")}), "portTaken",
         "sudo fuser -v /dev/ttyNobody"},
        {refusal(RefusalId::portNotFound, {QStringLiteral("/dev/ttyNobody")}), "portMissing",
         "ls -l /dev/serial/by-id"},
        {refusal(CanRefusalId::interfaceMissing, {QStringLiteral("can3")}), "canMissing", "ip link"},
        {refusal(CanRefusalId::notInKernel, {QStringLiteral("can3")}), "noCan", "sudo modprobe can_raw"},
        {refusal(CanRefusalId::pluginMissing, {}), "noCanPlugin", "sudo apt install libqt6serialbus6"},
    };
    const MadeComputer made;
    for (const auto &row : rows) {
        const auto found = hindranceOf(row.why, made.computer());
        ASSERT_TRUE(found) << row.key;
        EXPECT_EQ(hindranceKey(found->id), QLatin1String(row.key));
        EXPECT_EQ(found->sentence, refusalText(row.why));
        EXPECT_EQ(found->command, QLatin1String(row.command));
    }
}

TEST(HindranceOfRefusal, ACanInterfaceIsSwitchedOnByItsCommand)
{
    const auto found = hindranceOf(refusal(
        CanRefusalId::interfaceDown, {QStringLiteral("can0"), QStringLiteral("sudo ip link set can0 up")}));
    ASSERT_TRUE(found);
    EXPECT_EQ(hindranceKey(found->id), QStringLiteral("canDown"));
    EXPECT_EQ(found->about, QStringLiteral("can0"));
    EXPECT_EQ(found->command, QStringLiteral("sudo ip link set can0 up"));
    EXPECT_FALSE(hindranceOf(refusal(CanRefusalId::adapterSilent, {QStringLiteral("/dev/ttyACM0")})));
}

TEST(HindranceOfRefusal, AMissingPortIsThatOfAnAdapterThatHasNone)
{
    MadeComputer made;
    made.adapter(QStringLiteral("1-2"), "1a86", "7523", "USB Serial");
    const auto found =
        hindranceOf(refusal(RefusalId::portNotFound, {QStringLiteral("/dev/ttyUSB0")}), made.computer());
    ASSERT_TRUE(found);
    EXPECT_EQ(found->id, HindranceId::noDriver);
}

TEST(HindranceOfRefusal, TellsByWhomAPortIsTaken)
{
    MadeComputer made;
    made.process(4711, "screen");
    made.link(QStringLiteral("/proc/4711/fd/5"), "/dev/ttyUSB0");
    const auto found =
        hindranceOf(refusal(RefusalId::portInUse, {QStringLiteral("/dev/ttyUSB0")}), made.computer());
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->sentence.contains(u"screen (process 4711)"));
}

TEST(HindranceOfRefusal, AServersPortBelow1024CanBeAllowed)
{
    const auto found = hindranceOf(refusal(RefusalId::serverPortPrivileged, {std::int64_t{502}}));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->command, QStringLiteral("sudo sysctl net.ipv4.ip_unprivileged_port_start=502"));
}

TEST(HindranceOfRefusal, OtherRefusalsAreNoHindrancesOfTheComputer)
{
    EXPECT_FALSE(hindranceOf(refusal(RefusalId::encoderSilent, {QStringLiteral("1.0")})));
    EXPECT_FALSE(hindranceOf(refusal(RefusalId::linkFailed, {QStringLiteral("text")})));
}

} // namespace
} // namespace codewheel

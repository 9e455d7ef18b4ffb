// SPDX-License-Identifier: GPL-3.0-or-later
#include "links/port_access.h"
#include "links/port_driver.h"

#include <cerrno>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

TEST(PortAccess, TellsWhatAnErrorOfTheSystemMeans)
{
    const std::pair<int, RefusalCode> rows[] = {
        {ENOENT, RefusalId::portNotFound}, {ENODEV, RefusalId::portNotFound},
        {ENXIO, RefusalId::portNotFound},  {ENOTDIR, RefusalId::portNotFound},
        {EACCES, RefusalId::portNoRights}, {EPERM, RefusalId::portNoRights},
        {EBUSY, RefusalId::portInUse},     {EWOULDBLOCK, RefusalId::portInUse},
        {EIO, RefusalId::linkFailed},      {ENOTTY, RefusalId::linkFailed},
        {EINVAL, RefusalId::linkFailed},
    };
    for (const auto &[error, id] : rows)
        EXPECT_EQ(portRefusalOf(error), id) << error;
}

TEST(PortAccess, TellsWhatTheAdapterSaidToLowLatency)
{
    const struct
    {
        int getting;
        int setting;
        LowLatency result;
    } rows[] = {
        {0, 0, LowLatency::granted},
        {0, EPERM, LowLatency::refused},
        {0, EOPNOTSUPP, LowLatency::refused},
        {EIO, 0, LowLatency::refused},
        {ENOTTY, 0, LowLatency::notApplicable},
    };
    for (const auto &row : rows)
        EXPECT_EQ(lowLatencyOf(row.getting, row.setting), row.result) << row.getting << ' ' << row.setting;
}

TEST(PortAccess, APortIsNamedShortOrByItsPath)
{
    EXPECT_EQ(portPath(QStringLiteral("ttyUSB0")), QStringLiteral("/dev/ttyUSB0"));
    EXPECT_EQ(portPath(QStringLiteral("/dev/pts/3")), QStringLiteral("/dev/pts/3"));
    EXPECT_EQ(portPath(QStringLiteral("./line")), QStringLiteral("./line"));
}

} // namespace
} // namespace codewheel

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

namespace codewheel {

// Without the rights of the user running the tests, or of root.
class WithoutRights
{
public:
    WithoutRights()
    {
        if (m_wasRoot) {
            EXPECT_EQ(::setresuid(nobody, nobody, 0), 0);
        }
    }
    ~WithoutRights()
    {
        if (m_wasRoot) {
            EXPECT_EQ(::setresuid(0, 0, 0), 0);
        }
    }
    WithoutRights(const WithoutRights &) = delete;
    WithoutRights &operator=(const WithoutRights &) = delete;

private:
    static constexpr uid_t nobody = 65'534;
    bool m_wasRoot = ::getuid() == 0;
};

} // namespace codewheel

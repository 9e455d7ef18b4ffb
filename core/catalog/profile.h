// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include <string_view>
#include <vector>

namespace codewheel {

// The protocol of an encoder, by the name that descriptions have for it. Each kind has constants for its own;
// protocol_rules.h and jobs/protocol.h tell what they know.
class Profile
{
public:
    constexpr Profile() = default; // of no protocol
    explicit constexpr Profile(std::string_view name)
        : m_name(name)
    {}

    constexpr std::string_view name() const { return m_name; }

    friend constexpr bool operator==(const Profile &, const Profile &) = default;

private:
    std::string_view m_name; // of a literal
};

inline QString profileName(Profile profile)
{
    return QString::fromLatin1(profile.name().data(), static_cast<qsizetype>(profile.name().size()));
}

// Those of all kinds (kinds/protocols.cpp), in the order in which they are named to the user.
std::vector<Profile> allProfiles();

} // namespace codewheel

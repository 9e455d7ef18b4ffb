// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <type_traits>

namespace codewheel {

// A value of an enumeration that one protocol has for itself. It means nothing to anybody else.
class OwnKind
{
public:
    constexpr OwnKind() = default;
    template <typename Kind>
    requires std::is_enum_v<Kind>
    constexpr OwnKind(Kind kind) // NOLINT(google-explicit-constructor)
        : m_number(static_cast<std::uint8_t>(kind))
    {}

    template <typename Kind>
    requires std::is_enum_v<Kind>
    constexpr Kind as() const { return static_cast<Kind>(m_number); }

    friend constexpr bool operator==(OwnKind, OwnKind) = default;

private:
    std::uint8_t m_number = 0;
};

} // namespace codewheel

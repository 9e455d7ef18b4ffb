// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/protocol/esc_exchange.h"

#include <QString>

#include <optional>
#include <vector>

namespace codewheel {

// Searches for an encoder whose address or baud rate was changed: asks for the serial number at each place
// where it may be now, several times over. If its serial number is known, no other encoder is taken for it.
class EscSearch
{
public:
    struct Place
    {
        EscLineAddress address;
        std::optional<int> baudRate; // empty: that of the line

        friend bool operator==(const Place &, const Place &) = default;
    };
    enum class State : std::uint8_t { searching, found, nowhere };

    EscSearch(std::vector<Place> places, int rounds, std::optional<std::int64_t> serialNumber)
        : m_places(std::move(places))
        , m_left(static_cast<int>(m_places.size()) * rounds)
        , m_serialNumber(serialNumber)
    {}

    const Place &place() const { return m_places[m_index]; }
    esc::Request request() const { return {place().address, esc::Command::serialNumber}; }
    State answered(const esc::ExchangeResult &result);
    // Where it was looked for, for the user: "15h (21), 0Fh (15)".
    QString placesText() const;

private:
    bool isTheOne(const esc::ExchangeResult &result) const;

    std::vector<Place> m_places;
    std::size_t m_index = 0;
    int m_left;
    std::optional<std::int64_t> m_serialNumber;
};

} // namespace codewheel

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <array>
#include <compare>
#include <map>
#include <optional>
#include <span>
#include <string_view>

namespace codewheel {

// One of the buses a program works with; in a project a bus keeps its number. 0: none.
struct BusId
{
    int number = 0;

    // clang-tidy 14 takes the 0 in a defaulted <=> for a null pointer.
    // NOLINTNEXTLINE(modernize-use-nullptr)
    friend constexpr auto operator<=>(const BusId &, const BusId &) = default;
};

// The bus of a program that was told of no others, and of files from before buses were numbered.
inline constexpr BusId firstBus{1};
inline constexpr BusId firstLine{2};

// Where a device is on its bus, as that kind of bus writes it: "6.1" on INTERBUS, "esc:12" on a serial line.
// Ordered number by number, so 10.0 comes after 2.0. Empty: nowhere.
class NodeId
{
public:
    static constexpr std::size_t mostCharacters = 11;

    constexpr NodeId() = default;
    explicit constexpr NodeId(std::string_view text) // printable ASCII characters; cut off if too long
    {
        for (std::size_t i = 0; i < text.size() && i < mostCharacters; ++i)
            m_text.at(i) = text[i];
    }

    constexpr bool isEmpty() const { return m_text.front() == '\0'; }
    constexpr std::string_view text() const { return {m_text.data()}; }
    QString toString() const;

    friend bool operator==(const NodeId &, const NodeId &) = default;
    friend std::strong_ordering operator<=>(const NodeId &one, const NodeId &other);

private:
    std::array<char, mostCharacters + 1> m_text{};
};

// How a kind of bus writes its places, and which bus a place without a bus number is on.
struct PlaceFormat
{
    BusId bus;
    std::optional<NodeId> (*node)(QStringView text); // empty: no place of this kind
};
std::span<const PlaceFormat> placeFormats();

// Where a device is: on which bus, and where on it. Without a node: the bus itself.
struct Place
{
    BusId bus{};
    NodeId node{};

    bool isEmpty() const { return node.isEmpty(); }
    // An address, with the prefix of its kind of bus: "esc:12"; otherwise a number in a ring: "6.1".
    bool isAddress() const { return node.text().find(':') != std::string_view::npos; }

    friend bool operator==(const Place &, const Place &) = default;
    friend std::strong_ordering operator<=>(const Place &,
                                            const Place &) = default; // NOLINT(modernize-use-nullptr)

    QString toString() const { return node.toString(); }
    // As kept in files and databases: "1.0" on the first ring, "esc:12" on the first line, elsewhere with the
    // number of the bus: "4/esc:12".
    QString key() const;
    // From a key, or from what a user types: "12" on the first line. Empty for anything else.
    static std::optional<Place> parse(QStringView text);
    // The same, and of the key of a bus itself: "3/".
    static std::optional<Place> ofKey(QStringView key);
    // As shown to people: "1.0", or "Crane 2/1.0" where another bus may have it too; for a bus its name, or
    // nothing where it has none (setBusNames()).
    QString shown() const;
};

// The names of the buses that may have the same places as others, and of those that are named when they
// themselves are meant. Called, like shown(), by the thread of the window or of the command line.
void setBusNames(std::map<BusId, QString> ofPlaces, std::map<BusId, QString> ofBuses = {});
// The name of a bus that may have the same places as another; empty: no other has them.
QString nameAmongOthers(BusId bus);

} // namespace codewheel

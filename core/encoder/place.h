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

// Which bus, of those a program works with; in a project a bus keeps its number. 0: none.
struct BusId
{
    int number = 0;

    // clang-tidy 14 takes the 0 in a defaulted <=> for a null pointer.
    // NOLINTNEXTLINE(modernize-use-nullptr)
    friend constexpr auto operator<=>(const BusId &, const BusId &) = default;
};

// The buses of a program that was not told of others, and of files from before buses were numbered.
inline constexpr BusId firstRing{1};
inline constexpr BusId firstLine{2};

// Where a device stands on its bus, as that kind of bus writes it: "6.1" on INTERBUS, "esc:12" on a serial
// line. In order number by number, so 10.0 comes after 2.0. Empty: nowhere.
class NodeId
{
public:
    static constexpr std::size_t mostCharacters = 11;

    constexpr NodeId() = default;
    explicit constexpr NodeId(std::string_view text) // of the printable characters of ASCII; cut off
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

// How a kind of bus writes its places, and the bus that one without a number means.
struct PlaceFormat
{
    BusId bus;
    std::optional<NodeId> (*node)(QStringView text); // nothing: no place of this kind
};
std::span<const PlaceFormat> placeFormats();

// Where a device stands: on which bus, and where there. Without a node: the bus itself.
struct Place
{
    BusId bus{};
    NodeId node{};

    bool isEmpty() const { return node.isEmpty(); }
    // Of an address, with the prefix of its kind of bus: "esc:12"; else by its number in a ring: "6.1".
    bool isAddress() const { return node.text().find(':') != std::string_view::npos; }

    friend bool operator==(const Place &, const Place &) = default;
    friend std::strong_ordering operator<=>(const Place &,
                                            const Place &) = default; // NOLINT(modernize-use-nullptr)

    QString toString() const { return node.toString(); }
    // As files and databases keep it: "1.0" on the first ring, "esc:12" on the first line, elsewhere with the
    // number of its bus: "4/esc:12".
    QString key() const;
    // Of a key; and of what is typed: "12" on the first line. Nothing for anything else.
    static std::optional<Place> parse(QStringView text);
    // As people are told it: "1.0", or "Crane 2/1.0" where another bus may have it too; of a bus its name, or
    // nothing where it has none (setBusNames()).
    QString shown() const;
};

// The names of the buses that may have the same places as others, and of those that are told by name when
// they are meant themselves. By the thread of the window or of the command line, as shown().
void setBusNames(std::map<BusId, QString> ofPlaces, std::map<BusId, QString> ofBuses = {});
// The name of a bus that may have the same places as another; empty: no other has them.
QString nameAmongOthers(BusId bus);

} // namespace codewheel

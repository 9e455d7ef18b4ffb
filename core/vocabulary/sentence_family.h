// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

// Refusals and messages come in families: one of what everybody shares (RefusalId, MessageId), and those that
// a kind has in its room. `Said` is Refusal or Message.
namespace codewheel {

// %1, %2, ... are the arguments in the order given beside the enumerator.
struct SentenceRow
{
    template <typename Id>
    requires std::is_enum_v<Id>
    constexpr SentenceRow(Id number, const char *keyText, const char *sentence, const char *bare = nullptr)
        : id(static_cast<std::uint8_t>(number))
        , key(keyText)
        , text(sentence)
        , textWithoutArguments(bare)
    {}

    std::uint8_t id;
    const char *key;                  // in JSON and in the journal, so that of no other family
    const char *text;                 // English, of the translation context "Refusal" or "Message"
    const char *textWithoutArguments; // where some or all of them may be left out
};

// One object per enumeration, initialised at compile time; familyOf(), beside the enumeration, names it.
template <typename Said>
struct SentenceFamily
{
    std::span<const SentenceRow> rows;         // in the order of the enumeration
    QString (*textOf)(const Said &) = nullptr; // empty: rowText() says all of them
};

template <typename Id, typename Said>
concept IdOfFamily = std::is_enum_v<Id> && requires(Id id)
{
    {
        familyOf(id)
        } -> std::same_as<const SentenceFamily<Said> &>;
};

// A value of the enumeration of any family.
template <typename Said>
class SentenceCode
{
public:
    template <IdOfFamily<Said> Id>
    constexpr SentenceCode(Id id) // NOLINT(google-explicit-constructor)
        : m_family(&familyOf(id))
        , m_number(static_cast<std::uint8_t>(id))
    {}
    constexpr SentenceCode(const SentenceFamily<Said> &family, const SentenceRow &row)
        : m_family(&family)
        , m_number(row.id)
    {}

    constexpr const SentenceFamily<Said> &family() const { return *m_family; }
    constexpr const SentenceRow &row() const { return m_family->rows[m_number]; }

    // Empty: it is of another family.
    template <IdOfFamily<Said> Id>
    constexpr std::optional<Id> as() const
    {
        const Id id = static_cast<Id>(m_number);
        return m_family == &familyOf(id) ? std::optional(id) : std::nullopt;
    }

    friend constexpr bool operator==(const SentenceCode &, const SentenceCode &) = default;

private:
    const SentenceFamily<Said> *m_family;
    std::uint8_t m_number;
};

template <typename Said>
std::vector<SentenceCode<Said>> codesOf(std::span<const SentenceFamily<Said> *const> families)
{
    std::vector<SentenceCode<Said>> codes;
    for (const SentenceFamily<Said> *family : families)
        for (const SentenceRow &row : family->rows)
            codes.emplace_back(*family, row);
    return codes;
}

} // namespace codewheel

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <concepts>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>

namespace codewheel {

// What a parameter holds: a whole number, which may be negative, or a text. How wide it is on its bus, its
// protocol knows; which of them the parameter takes, its description says.
class Value
{
public:
    template <std::integral Number>
    Value(Number number) // NOLINT(google-explicit-constructor)
        : m_value(static_cast<std::int64_t>(number))
    {}
    explicit Value(QString text)
        : m_value(std::move(text))
    {}

    bool isText() const { return std::holds_alternative<QString>(m_value); }
    std::optional<std::int64_t> asNumber() const
    {
        const auto *number = std::get_if<std::int64_t>(&m_value);
        return number != nullptr ? std::optional(*number) : std::nullopt;
    }
    // 0 if it is a text: for protocols whose descriptions have numbers only.
    std::int64_t number() const { return asNumber().value_or(0); }
    // The text, or the number in digits, the same in every language.
    QString toString() const { return isText() ? std::get<QString>(m_value) : QString::number(number()); }

    friend bool operator==(const Value &, const Value &) = default;

private:
    std::variant<std::int64_t, QString> m_value;
};

} // namespace codewheel

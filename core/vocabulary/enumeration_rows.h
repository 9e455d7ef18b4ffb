// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLatin1String>
#include <QStringView>

#include <cstddef>
#include <iterator>

namespace codewheel {

// Whether the rows of a table are in the order of the enumeration whose value each holds in `id`, so that the
// value is the index of its row. Checked at compile time by the tables of keys and texts.
template <typename Rows, typename Row, typename Id>
constexpr bool areInOrder(const Rows &rows, Id Row::*id)
{
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (static_cast<std::size_t>(rows[i].*id) != i)
            return false;
    return true;
}

// And whether there is one for each value up to the last.
template <typename Rows, typename Row, typename Id, typename Last>
constexpr bool areInOrder(const Rows &rows, Id Row::*id, Last last)
{
    return areInOrder(rows, id) && rows.size() == static_cast<std::size_t>(last) + 1;
}

// A row of such a table: what files and JSON call a value, and its English text.
template <typename Id>
struct KeyedText
{
    Id id;
    const char *key;
    const char *text;
};

// Without a key.
template <typename Id>
struct TextOf
{
    Id id;
    const char *text;
};

template <typename Rows, typename Id>
constexpr const auto &rowOf(const Rows &rows, Id id)
{
    return rows.at(static_cast<std::size_t>(id));
}

// By what files and JSON call its value; null: there is none. The table outlives it.
template <typename Rows>
constexpr auto *rowByKey(const Rows &rows, QStringView key)
{
    for (const auto &row : rows)
        if (key == QLatin1String(row.key))
            return &row;
    return static_cast<decltype(&*std::begin(rows))>(nullptr);
}

// Of a table that has rows for some values only.
template <typename Rows, typename Id>
constexpr const char *textFor(const Rows &rows, Id id, const char *otherwise)
{
    for (const auto &row : rows)
        if (row.id == id)
            return row.text;
    return otherwise;
}

} // namespace codewheel

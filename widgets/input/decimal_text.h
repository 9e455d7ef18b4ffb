// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>
#include <tl/expected.hpp>

class QLocale;

namespace codewheel {

// A number as somebody typed it, with point or comma, whatever the country, and spaces between digits.
// Refused with a sentence: anything that is no number, and a sign that could be a thousands separator as well
// as a decimal point ("1,000" in English: 1000 or 1.000).
tl::expected<double, QString> readDecimal(const QString &text, const QLocale &locale);

// A whole number: digits, with spaces between them if somebody likes, or hexadecimal with its mark ("0x1F",
// "1Fh"). A point or a comma is refused, whatever it may mean.
tl::expected<std::int64_t, QString> readWhole(const QString &text);

} // namespace codewheel

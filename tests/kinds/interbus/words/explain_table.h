// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/words/k3_explain.h"

#include <gtest/gtest.h>
#include <ostream>
#include <span>

namespace codewheel {

inline void PrintTo(const Meaning &meaning, std::ostream *out)
{
    *out << "meaning " << static_cast<int>(meaning.id) << " (" << meaning.number[0] << ", "
         << meaning.number[1] << ", " << meaning.number[2] << ")";
}

inline void PrintTo(const Explanation &explanation, std::ostream *out)
{
    for (const Meaning &meaning : explanation) {
        PrintTo(meaning, out);
        *out << "; ";
    }
}

inline Explanation meanings(std::initializer_list<Meaning> all)
{
    Explanation explanation;
    for (const Meaning &each : all)
        explanation.add(each);
    return explanation;
}

} // namespace codewheel

namespace codewheel::k3 {

// One cycle of a manual's handshake table, and its meaning in either direction.
struct HandshakeRow
{
    Word out;
    Word in;
    Meaning outMeans;
    Meaning inMeans;
};

inline void expectHandshake(std::span<const HandshakeRow> rows, Dialect dialect, std::optional<Mode> mode,
                            PositionCoding coding)
{
    for (const HandshakeRow &row : rows) {
        EXPECT_EQ(explain(row.out, {WordDirection::out, dialect, mode, coding, row.in}), row.outMeans)
            << std::hex << row.out;
        EXPECT_EQ(explain(row.in, {WordDirection::in, dialect, mode, coding, row.out}), row.inMeans)
            << std::hex << row.out << " / " << row.in;
    }
}

} // namespace codewheel::k3

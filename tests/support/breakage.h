// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/refusal.h"

#include <QByteArray>

#include <gtest/gtest.h>
#include <ostream>

namespace codewheel {

// A damaged place in a valid file, and what has to be reported about it.
struct Breakage
{
    const char *from;
    const char *to;
    int line;
    const char *key;
    const char *reason; // part of it
};

inline void PrintTo(const Breakage &breakage, std::ostream *out)
{
    *out << breakage.from << " -> " << breakage.to;
}

enum class Occurs { once, firstOfSeveral };

inline QByteArray brokenBy(const Breakage &breakage, QByteArray sound, Occurs occurs = Occurs::once)
{
    const qsizetype at = sound.indexOf(breakage.from);
    EXPECT_GE(at, 0) << breakage.from;
    if (occurs == Occurs::once) {
        EXPECT_EQ(sound.count(breakage.from), 1) << breakage.from;
    }
    return at < 0 ? sound : sound.replace(at, static_cast<qsizetype>(qstrlen(breakage.from)), breakage.to);
}

// What was reported: file, line, key and reason, as in Catalog::Fault.
template <typename Fault>
void expectNamed(const Breakage &breakage, const Fault &said, const QString &file)
{
    EXPECT_EQ(said.file, file);
    EXPECT_EQ(said.line, breakage.line);
    EXPECT_EQ(said.key.toStdString(), breakage.key);
    EXPECT_TRUE(said.reason.contains(QLatin1String(breakage.reason))) << said.reason.toStdString();
}

// The same four, as arguments of a refusal.
inline void expectNamed(const Breakage &breakage, const Refusal &refusal, RefusalCode id, const QString &file)
{
    struct Said
    {
        QString file;
        std::int64_t line;
        QString key;
        QString reason;
    };
    EXPECT_EQ(refusal.kind, RefusalKind::badInput);
    EXPECT_EQ(refusal.id, id);
    const std::vector<RefusalArgument> &told = refusal.arguments;
    ASSERT_EQ(told.size(), 4U);
    expectNamed(breakage,
                Said{std::get<QString>(told[0]), std::get<std::int64_t>(told[1]), std::get<QString>(told[2]),
                     std::get<QString>(told[3])},
                file);
}

} // namespace codewheel

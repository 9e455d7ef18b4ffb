// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include <vector>

namespace codewheel {

struct Subcommand;

// The arguments of a command that are not options, from its usage: at each position what may stand there.
// "PLACE read|write [FILE]" has PLACE, then read and write, then FILE.
class UsageWords
{
public:
    explicit UsageWords(const Subcommand &command);

    QStringList at(qsizetype position) const;   // empty: nothing may
    static bool isLiteral(const QString &word); // to be typed as it is: "on", not "PLACE"

private:
    void add(std::size_t position, const QString &word);

    std::vector<QStringList> m_words;
    bool m_repeats = false; // the last position
};

} // namespace codewheel

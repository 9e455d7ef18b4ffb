// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include <vector>

namespace codewheel {

struct Terminal;

// What a word of a call may be. One that ends in =, : or , goes on.
struct Candidate
{
    QString text;
    QString help{}; // in the user's language; may be empty

    friend bool operator==(const Candidate &, const Candidate &) = default;
};

// For shells: what the last of these words may be, as far as it is typed. They are the words behind
// "codewheel-cli". Opens no link and sends nothing; a call that makes no sense has no candidates. ":files",
// with a suffix behind it if only those make sense, stands for names of files, which the shell knows; ":files
// log:" for names that stand behind that.
std::vector<Candidate> candidates(const QStringList &words);

// "complete -- WORD...", which the completion of the shells calls and no help mentions: prints a candidate
// per line, with its help behind a tab.
bool isCompletion(const QStringList &words);
int complete(const QStringList &words, const Terminal &terminal);

} // namespace codewheel

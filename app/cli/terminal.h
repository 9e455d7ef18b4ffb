// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <iosfwd>

namespace codewheel {

// Where the command line reads and writes. A test gives it streams of its own and answers its questions.
struct Terminal
{
    std::istream &in;
    std::ostream &out;
    std::ostream &err;
    bool isInteractive = false; // somebody can answer a question

    void print(const QString &text) const;    // as it is
    void complain(const QString &text) const; // one line on err
    // Asks for yes or no. Anything but yes is no, the end of the input too.
    bool confirms(const QString &question) const;
    // What is typed in answer; empty at the end of the input.
    QString answer(const QString &question) const;
};

} // namespace codewheel

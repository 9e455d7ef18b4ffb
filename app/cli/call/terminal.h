// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <iosfwd>

namespace codewheel {

// Where the command line reads and writes. A test provides its own streams and answers the questions. All
// output goes through here, and none of it can control a terminal (vocabulary/shown_text.h): JSON stays what
// it was, since the escapes are JSON's own.
struct Terminal
{
    std::istream &in;
    std::ostream &out;
    std::ostream &err;
    bool isInteractive = false; // somebody can answer a question
    int inputDescriptor = -1;   // of `in`, to wait for what is typed; below 0: it has none
    mutable int printError = 0; // errno of the first print that failed; 0: none did

    void print(const QString &text) const; // all of it at once
    bool canPrint() const { return printError == 0; }
    QString whyNotPrinted() const;            // the system's reason
    void complain(const QString &text) const; // one line on err
    // One line on err replacing the previous one, if somebody sees it; empty: removes it.
    void showProgress(const QString &text) const;
    static bool isYes(const QString &typed);
    // Asks for yes or no. Anything but yes is no, including the end of the input.
    bool confirms(const QString &question) const;
    // What is typed in answer; empty at the end of the input.
    QString answer(const QString &question) const;
};

} // namespace codewheel

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <iosfwd>

namespace codewheel {

// Where the command line reads and writes. A test gives it streams of its own and answers its questions.
// Whatever is said goes through here, and steers no terminal (encoder/shown_text.h): JSON stays what it was,
// since the escapes are its own.
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
    QString whyNotPrinted() const;            // the reason of the system
    void complain(const QString &text) const; // one line on err
    // One line on err in place of the one before, where somebody sees it; empty: none any more.
    void showProgress(const QString &text) const;
    static bool isYes(const QString &typed);
    // Asks for yes or no. Anything but yes is no, the end of the input too.
    bool confirms(const QString &question) const;
    // What is typed in answer; empty at the end of the input.
    QString answer(const QString &question) const;
};

} // namespace codewheel

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace codewheel {

// What is wrong and what to do: a sentence, and one command for a terminal; empty: there is none.
struct Trouble
{
    Trouble(QString itsSentence = {}, QString itsCommand = {})
        : sentence(std::move(itsSentence))
        , command(std::move(itsCommand))
    {}

    QString sentence;
    QString command;

    friend bool operator==(const Trouble &, const Trouble &) = default;
};

} // namespace codewheel

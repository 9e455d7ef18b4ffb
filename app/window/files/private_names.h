// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace codewheel {

// What identifies a person or a computer in a text to be given away.
struct PrivateNames
{
    QString home; // "/home/erika"
    QString user; // "erika"
    QString host;

    static PrivateNames ofThisComputer();
};

// The text with the home folder as ~, the user's name in paths as "user", and the computer's as "computer".
QString withoutPrivateNames(QString text, const PrivateNames &names);

} // namespace codewheel

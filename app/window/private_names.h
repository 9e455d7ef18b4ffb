// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace codewheel {

// What tells of a person or a computer in a text that is given away.
struct PrivateNames
{
    QString home; // "/home/erika"
    QString user; // "erika"
    QString host;

    static PrivateNames ofThisComputer();
};

// The text with the home folder as ~, the name of the user in paths as "user", and that of the computer as
// "computer".
QString withoutPrivateNames(QString text, const PrivateNames &names);

} // namespace codewheel

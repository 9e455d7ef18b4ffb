// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMap>
#include <QString>

namespace codewheel {

// A text of a device description, by language ("en", "de"). A text that is the same in every language ("DO1",
// "10 ... 30 V DC") is under "" alone; any other has at least English.
struct LocalText
{
    QMap<QString, QString> byLanguage;

    bool isEmpty() const { return byLanguage.isEmpty(); }
    // In the language of the user interface, or in English.
    QString toString() const;

    friend bool operator==(const LocalText &, const LocalText &) = default;
};

} // namespace codewheel

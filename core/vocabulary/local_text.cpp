// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/local_text.h"

#include <QCoreApplication>

namespace codewheel {

QString LocalText::toString() const
{
    const QString language =
        QCoreApplication::translate("DeviceDescription", "en", "code of the language of these texts");
    for (const QString &each : {language, QStringLiteral("en"), QString()})
        if (const auto found = byLanguage.find(each); found != byLanguage.end())
            return *found;
    return {};
}

} // namespace codewheel

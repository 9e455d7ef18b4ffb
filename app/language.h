// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTranslator>

namespace codewheel {

// The language of the texts and the format of numbers; both programs keep one object of it while they run.
// Texts without a translation stay English.
class Language
{
public:
    // "de", "en", or empty for the system's setting. `decimalSign`: "." or "," instead of the language's.
    // Existing texts stay as they are: a window has to make its texts again. Needs a QCoreApplication.
    void use(const QString &chosen, QStringView decimalSign = {});

private:
    QTranslator m_ours;
    QTranslator m_qts; // buttons of Qt's own dialogs
};

} // namespace codewheel

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTranslator>

namespace codewheel {

// The language of the texts and the form of the numbers; both programs have one object of it as long as they
// run. Texts that no translation has stay English.
class Language
{
public:
    // "de", "en", or empty for what the system is set to. `decimalSign`: "." or "," instead of the
    // language's. Texts made before stay as they are: a window has to make its texts again. Needs a
    // QCoreApplication.
    void use(const QString &chosen, QStringView decimalSign = {});

private:
    QTranslator m_ours;
    QTranslator m_qts; // buttons of Qt's own dialogs
};

} // namespace codewheel

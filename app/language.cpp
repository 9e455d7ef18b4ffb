// SPDX-License-Identifier: GPL-3.0-or-later
#include "language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>

namespace codewheel {
namespace {

const QString separator = QStringLiteral("_");

// English also has a file (for singulars), so that somebody who prefers English to German gets English.
bool loadOurs(QTranslator &translator, const QLocale &locale)
{
    const QString name = QStringLiteral("codewheel");
    const QString folder = QStringLiteral(":/i18n");
    return translator.load(locale, name, separator, folder) ||
           translator.load(QLocale(QLocale::English), name, separator, folder);
}

// A locale cannot be invented, so this takes that of a country which writes the language that way: German
// with a point in Switzerland. If no country does, numbers are written as in English.
QLocale withSign(const QLocale &locale, QStringView sign)
{
    if (sign.isEmpty() || locale.decimalPoint() == sign)
        return locale;
    for (const QLocale::Language language : {locale.language(), QLocale::English})
        for (const QLocale &other :
             QLocale::matchingLocales(language, QLocale::AnyScript, QLocale::AnyTerritory))
            if (other.decimalPoint() == sign)
                return other;
    return locale;
}

// A system may be German with the numbers of another country (LC_NUMERIC), or of none. Beside German texts
// "12,345" would be a fraction, so they bring the numbers of their language in that country; the settings can
// say otherwise.
QLocale numbersBeside(const QTranslator &texts, const QLocale &system)
{
    const QLocale language(texts.language());
    if (language.language() == QLocale::English)
        return system;
    const QLocale there(language.language(), system.territory());
    return there.decimalPoint() == system.decimalPoint() && there.groupSeparator() == system.groupSeparator()
               ? system
               : there;
}

} // namespace

void Language::use(const QString &chosen, QStringView decimalSign)
{
    QCoreApplication::removeTranslator(&m_ours);
    QCoreApplication::removeTranslator(&m_qts);

    const QLocale locale = chosen.isEmpty() ? QLocale::system() : QLocale(chosen);
    const bool hasTexts = loadOurs(m_ours, locale);
    QLocale::setDefault(withSign(hasTexts ? numbersBeside(m_ours, locale) : locale, decimalSign));
    if (!hasTexts)
        return;
    // Qt's texts are in the language of ours, not in one that only Qt has.
    if (m_qts.load(QLocale(m_ours.language()), QStringLiteral("qtbase"), separator,
                   QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(&m_qts);
    QCoreApplication::installTranslator(&m_ours);
}

} // namespace codewheel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "other_language.h"

#include <QFile>
#include <QXmlStreamReader>

#include <utility>

namespace codewheel {
namespace {

QString withoutMnemonic(QString text)
{
    return text.remove(u'&');
}

} // namespace

void OtherLanguage::read()
{
    QFile file(QStringLiteral(":/texts/codewheel_de.ts"));
    if (!file.open(QIODevice::ReadOnly))
        return;
    QString source;
    const auto relate = [this](const QString &shown, const QString &other) {
        if (QStringList &others = m_others[shown]; shown != other && !others.contains(other))
            others << other;
    };
    for (QXmlStreamReader texts(&file); !texts.atEnd();) {
        if (texts.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (texts.name() == QStringLiteral("source"))
            source = withoutMnemonic(texts.readElementText());
        else if (texts.name() == QStringLiteral("translation"))
            if (const QString translation =
                    withoutMnemonic(texts.readElementText(QXmlStreamReader::SkipChildElements));
                !translation.trimmed().isEmpty()) {
                relate(source, translation);
                relate(translation, source);
            }
    }
}

QString OtherLanguage::of(const QString &shown)
{
    if (!std::exchange(m_isRead, true))
        read();
    return m_others.value(withoutMnemonic(shown)).join(QStringLiteral(", "));
}

} // namespace codewheel

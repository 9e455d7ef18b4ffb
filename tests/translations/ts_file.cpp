// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/translations/ts_file.h"

#include <QFile>
#include <QXmlStreamReader>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

QStringList readTranslations(QXmlStreamReader &xml, bool hasNumber)
{
    if (!hasNumber)
        return {xml.readElementText()};
    QStringList forms;
    while (xml.readNextStartElement())
        forms << xml.readElementText();
    return forms;
}

TsText readText(QXmlStreamReader &xml, const QString &context)
{
    TsText text;
    text.context = context;
    text.hasNumber = xml.attributes().value(QLatin1String("numerus")) == QLatin1String("yes");
    while (xml.readNextStartElement()) {
        if (xml.name() == QLatin1String("source")) {
            text.source = xml.readElementText();
        } else if (xml.name() == QLatin1String("comment")) {
            text.comment = xml.readElementText();
        } else if (xml.name() == QLatin1String("translation")) {
            text.isFinished = !xml.attributes().hasAttribute(QLatin1String("type"));
            text.translations = readTranslations(xml, text.hasNumber);
        } else {
            xml.skipCurrentElement();
        }
    }
    return text;
}

} // namespace

QString TsText::name() const
{
    const QString name = QStringLiteral("%1: %2").arg(context, source);
    return comment.isEmpty() ? name : QStringLiteral("%1 (%2)").arg(name, comment);
}

std::vector<TsText> readTs(QIODevice &device)
{
    std::vector<TsText> texts;
    QXmlStreamReader xml(&device);
    QString context;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (xml.name() == QLatin1String("name"))
            context = xml.readElementText();
        else if (xml.name() == QLatin1String("message"))
            texts.push_back(readText(xml, context));
    }
    EXPECT_FALSE(xml.hasError()) << qPrintable(xml.errorString()) << " in line " << xml.lineNumber();
    return texts;
}

std::vector<TsText> readTs(const QString &path)
{
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << qPrintable(path);
    return readTs(file);
}

QSet<QString> namesOf(const std::vector<TsText> &texts)
{
    QSet<QString> names;
    for (const TsText &text : texts)
        names.insert(text.name());
    return names;
}

} // namespace codewheel

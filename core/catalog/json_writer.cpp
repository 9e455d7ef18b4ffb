// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/json_writer.h"

#include <QLocale>
#include <QStringList>

namespace codewheel {
namespace {

QByteArray escaped(const QString &text)
{
    QByteArray result("");
    for (const char c : text.toUtf8()) {
        if (c == '"' || c == '\\')
            result += '\\';
        if (c == '\n')
            result += "\\n";
        else if (c == '\t')
            result += "\\t";
        else if (static_cast<unsigned char>(c) < 0x20)
            result += "\\u00" + QByteArray(1, c).toHex();
        else
            result += c;
    }
    return result;
}

QByteArray quoted(const QString &text)
{
    return '"' + escaped(text) + '"';
}

} // namespace

JsonWriter::JsonWriter()
    : m_json("{")
    , m_levels{{Form::lines, true}}
{}

void JsonWriter::member(const char *key, const QString &text)
{
    raw(key, quoted(text));
}

void JsonWriter::member(const QString &key, const QString &text)
{
    raw(escaped(key), quoted(text));
}

void JsonWriter::member(const char *key, const char *text)
{
    raw(key, quoted(QString::fromLatin1(text)));
}

void JsonWriter::member(const char *key, double number)
{
    raw(key, QByteArray::number(number, 'g', QLocale::FloatingPointShortest));
}

void JsonWriter::value(const char *key, const Value &value)
{
    raw(key, value.isText() ? quoted(value.toString()) : QByteArray::number(qlonglong{value.number()}));
}

void JsonWriter::texts(const char *key, const QStringList &texts)
{
    begin(key, '[', Form::lines);
    for (const QString &text : texts)
        raw({}, quoted(text));
    end(']');
}

QByteArray JsonWriter::finish()
{
    end('}');
    return m_json + '\n';
}

void JsonWriter::raw(const QByteArray &key, const QByteArray &value)
{
    startValue(key);
    m_json += value;
}

void JsonWriter::begin(const QByteArray &key, char bracket, Form form)
{
    startValue(key);
    m_json += bracket;
    m_levels.push_back({form, true});
}

void JsonWriter::end(char bracket)
{
    const Level level = m_levels.back();
    m_levels.pop_back();
    if (!level.isEmpty && level.form == Form::lines)
        newLine();
    m_json += bracket;
}

void JsonWriter::startValue(const QByteArray &key)
{
    Level &level = m_levels.back();
    if (!level.isEmpty)
        m_json += ',';
    if (level.form == Form::lines)
        newLine();
    else if (!level.isEmpty)
        m_json += ' ';
    level.isEmpty = false;
    if (!key.isNull())
        m_json += '"' + key + "\": ";
}

void JsonWriter::newLine()
{
    m_json += '\n';
    m_json.append(2 * static_cast<qsizetype>(m_levels.size()), ' ');
}

} // namespace codewheel

// SPDX-License-Identifier: GPL-3.0-or-later
// docs/sequence-files.md
#include "encoder/hex.h"
#include "widgets/sequence/word_list.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <json/reader.h>

namespace codewheel {

namespace {

constexpr char formatName[] = "codewheel-sequence";
constexpr int formatVersion = 1;
constexpr int deepestNesting = 8;

class SequenceFile
{
    Q_DECLARE_TR_FUNCTIONS(SequenceFile)

public:
    explicit SequenceFile(const QByteArray &json)
        : m_json(json)
    {}

    Parsed<WordList> read() const;

private:
    QString fault(const Json::Value &where, const QString &what) const;
    Parsed<Json::Value> parse() const;
    Parsed<void> checkKeys(const Json::Value &root) const;
    Parsed<void> readHold(const Json::Value &root, WordList &list) const;
    Parsed<void> readWords(const Json::Value &words, WordList &list) const;

    const QByteArray &m_json;
};

QString atLine(qsizetype line, const QString &what)
{
    return QCoreApplication::translate("SequenceFile", "Line %1: %2").arg(QString::number(line), what);
}

QString SequenceFile::fault(const Json::Value &where, const QString &what) const
{
    return atLine(1 + m_json.left(where.getOffsetStart()).count('\n'), what);
}

Parsed<Json::Value> SequenceFile::parse() const
{
    Json::CharReaderBuilder builder;
    Json::CharReaderBuilder::strictMode(&builder.settings_);
    builder["failIfExtra"] = true;
    builder["rejectDupKeys"] = true;
    builder["stackLimit"] = deepestNesting;
    const std::unique_ptr<Json::CharReader> reader(builder.newCharReader());
    Json::Value root;
    std::string report; // "* Line 3, Column 5\n  Missing ',' ..."
    try {
        if (reader->parse(m_json.constData(), m_json.constData() + m_json.size(), &root, &report))
            return root;
    } catch (const Json::Exception &) {
        return tl::unexpected(atLine(1, tr("The file is nested too deeply.")));
    }
    const QString text = QString::fromStdString(report);
    const qsizetype line = text.section(QStringLiteral("Line "), 1).section(QLatin1Char(','), 0, 0).toInt();
    return tl::unexpected(
        atLine(std::max<qsizetype>(line, 1),
               tr("This is not valid JSON: %1").arg(text.section(QLatin1Char('\n'), 1, 1).trimmed())));
}

Parsed<void> SequenceFile::checkKeys(const Json::Value &root) const
{
    if (!root.isObject() || root["format"] != formatName)
        return tl::unexpected(fault(
            root,
            tr("This is no sequence of words: \"format\" is not \"%1\".").arg(QLatin1String(formatName))));
    if (root["version"] != formatVersion)
        return tl::unexpected(
            fault(root["version"], tr("Only version %1 of the format can be read.").arg(formatVersion)));
    for (const std::string &key : root.getMemberNames())
        if (key != "format" && key != "version" && key != "holdCycles" && key != "words")
            return tl::unexpected(
                fault(root[key], tr("The key \"%1\" is not known.").arg(QString::fromStdString(key))));
    return {};
}

Parsed<void> SequenceFile::readHold(const Json::Value &root, WordList &list) const
{
    if (!root.isMember("holdCycles"))
        return {};
    const Json::Value &hold = root["holdCycles"];
    if (!hold.isInt() || hold.asInt() < 1 || hold.asInt() > WordList::longestHold)
        return tl::unexpected(
            fault(hold, tr("\"holdCycles\" is a whole number from 1 to %1.").arg(WordList::longestHold)));
    list.holdCycles = hold.asInt();
    return {};
}

Parsed<void> SequenceFile::readWords(const Json::Value &words, WordList &list) const
{
    if (!words.isArray() || words.size() > WordList::mostWords)
        return tl::unexpected(
            fault(words, tr("\"words\" is a list of at most %1 words.").arg(WordList::mostWords)));
    for (const Json::Value &value : words) {
        const std::optional<Word> word =
            value.isString() ? parseHexWord(QString::fromStdString(value.asString())) : std::nullopt;
        if (!word)
            return tl::unexpected(
                fault(value, tr("A word is a text of up to 8 hexadecimal digits, such as \"020000FF\".")));
        list.words.push_back(*word);
    }
    return {};
}

Parsed<WordList> SequenceFile::read() const
{
    const Parsed<Json::Value> root = parse();
    if (!root)
        return tl::unexpected(root.error());
    WordList list;
    return checkKeys(*root)
        .and_then([&] { return readHold(*root, list); })
        .and_then([&] { return readWords((*root)["words"], list); })
        .map([&] { return list; });
}

} // namespace

QByteArray sequenceToJson(const WordList &list)
{
    QJsonArray words;
    for (const Word word : list.words)
        words.append(hexWord(word));
    return QJsonDocument(QJsonObject{{QStringLiteral("format"), QLatin1String(formatName)},
                                     {QStringLiteral("version"), formatVersion},
                                     {QStringLiteral("holdCycles"), list.holdCycles},
                                     {QStringLiteral("words"), words}})
        .toJson();
}

Parsed<WordList> sequenceFromJson(const QByteArray &json)
{
    return SequenceFile(json).read();
}

} // namespace codewheel

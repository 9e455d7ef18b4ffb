// SPDX-License-Identifier: GPL-3.0-or-later
// docs/sequence-files.md
#include "project/word_list_json.h"

#include "catalog/json_writer.h"
#include "catalog/strict_json.h"
#include "vocabulary/hex.h"

namespace codewheel {
namespace {

constexpr char wordListFormat[] = "codewheel-sequence";
constexpr std::int64_t wordListVersion = 1;

class SequenceFile
{
    Q_DECLARE_TR_FUNCTIONS(SequenceFile)

public:
    // Before anything else: a file of another kind has other keys.
    static void checkFormat(const Json::Value &root, FaultKeeper &faults);
    static WordList read(const JsonObject &json);
    static QString textOf(const Catalog::Fault &fault);
};

void SequenceFile::checkFormat(const Json::Value &root, FaultKeeper &faults)
{
    if (root.isObject() && root["format"] == Json::Value(wordListFormat))
        return;
    faults.report(
        root, QString(),
        tr("This is not a sequence of words: \"format\" is not \"%1\".").arg(QLatin1String(wordListFormat)));
}

WordList SequenceFile::read(const JsonObject &json)
{
    if (json.number("version") != wordListVersion)
        json.report("version", tr("Only version %1 of the format can be read.").arg(wordListVersion));
    return readWordList(json);
}

QString SequenceFile::textOf(const Catalog::Fault &fault)
{
    if (fault.key.isEmpty())
        return tr("Line %1: %2").arg(QString::number(fault.line), fault.reason);
    return tr("Line %1, %2: %3").arg(QString::number(fault.line), fault.key, fault.reason);
}

} // namespace

WordList readWordList(const JsonObject &json)
{
    WordList list;
    list.holdCycles = static_cast<int>(
        json.optionalNumber("holdCycles", 1, WordList::longestHold).value_or(list.holdCycles));
    list.words = json.words("words", WordList::mostWords);
    return list;
}

void writeWordList(JsonWriter &json, const WordList &list)
{
    QStringList words;
    for (const Word word : list.words)
        words << hexWord(word);
    json.member("holdCycles", list.holdCycles);
    json.texts("words", words);
}

QByteArray sequenceToJson(const WordList &list)
{
    JsonWriter json;
    json.member("format", wordListFormat);
    json.member("version", wordListVersion);
    writeWordList(json, list);
    return json.finish();
}

Parsed<WordList> sequenceFromJson(const QByteArray &json)
{
    FaultKeeper faults(json, QString());
    const Json::Value root = parseStrictly(json, faults);
    WordList list;
    if (!faults.first())
        SequenceFile::checkFormat(root, faults);
    if (!faults.first())
        list = SequenceFile::read(
            JsonObject(root, QString(), {"format", "version", "holdCycles", "words"}, faults));
    if (const auto &fault = faults.first())
        return tl::unexpected(SequenceFile::textOf(*fault));
    return list;
}

} // namespace codewheel

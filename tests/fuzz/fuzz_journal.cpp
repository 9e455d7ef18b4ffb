// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes are a database of messages or of EEPROM writes, or are refused with a sentence; whatever such a
// database contains can be shown, searched, written to and dropped. The first byte chooses which.
#include "journal/argument_json.h"
#include "journal/eeprom_cost.h"
#include "journal/ledger.h"
#include "journal/message_search.h"
#include "journal/message_writer.h"
#include "tests/fuzz/must.h"

#include <QBuffer>
#include <QFile>
#include <QJsonDocument>
#include <QTemporaryDir>

using namespace codewheel;

namespace {

void readArguments(const QByteArray &bytes)
{
    const auto arguments = argumentsFromJson(QJsonDocument::fromJson(bytes).array());
    const auto again = argumentsFromJson(argumentsToJson(arguments));
    must(argumentsToJson(again) == argumentsToJson(arguments), "what was kept is the same");
    const StoredMessage stored{.code = QStringLiteral("deviceFault"),
                               .arguments = QString::fromUtf8(bytes),
                               .refusal = QString::fromUtf8(bytes)};
    must(!messageText(stored).isNull(), "there is a text");
}

void readMessages(const DatabasePlace &place)
{
    auto table = MessageTable::open(place);
    if (!table) {
        must(!table.error().reason.isEmpty(), "there is a sentence");
        return;
    }
    const auto span = table->span();
    const auto messages = table->read(-100, 1'000);
    QBuffer page;
    page.open(QIODevice::WriteOnly);
    MessageWriter writer(page, MessageWriter::Format::html);
    if (messages)
        must(writer.begin() && writer.write(*messages) && writer.end(), "it can be exported");
    MessageTextMatcher matcher(QStringLiteral("a"));
    (void)fittingIds(*table, {.text = QStringLiteral("a")}, matcher, -100, 1'000);
    (void)table->places();
    (void)table->append(
        {StoredMessage{.code = QStringLiteral("busStarted"), .arguments = QStringLiteral("[]")}});
    if (span)
        (void)table->dropUpTo(span->first);
}

void readLedger(const DatabasePlace &place)
{
    auto ledger = Ledger::open(place);
    if (!ledger) {
        must(!ledger.error().reason.isEmpty(), "there is a sentence");
        return;
    }
    for (const Ledger::Account &account : ledger->accounts())
        must(!eepromCountText(account.count).isEmpty(), "there is a text");
    const EncoderIdentity identity{.by = CountedBy::place,
                                   .vendor = {},
                                   .serialNumber = {},
                                   .project = {},
                                   .place = {firstBus, NodeId("1.0")}};
    (void)ledger->valuesBefore(identity);
    const auto id = ledger->begin({.at = {}, .identity = identity.key(), .planned = 1});
    if (id)
        (void)ledger->settle(*id, {});
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    static const QTemporaryDir folder;
    if (size == 0)
        return 0;
    const QByteArray bytes(reinterpret_cast<const char *>(data) + 1, static_cast<qsizetype>(size) - 1);
    if (*data == 'A') {
        readArguments(bytes);
        return 0;
    }
    const QString path = folder.filePath(QStringLiteral("journal.sqlite"));
    for (const char *suffix : {"", "-wal", "-shm", "-journal"})
        QFile::remove(path + QLatin1String(suffix));
    QFile file(path);
    must(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size(), "the file can be written");
    file.close();
    if (*data == 'L')
        readLedger(DatabasePlace::file(path));
    else
        readMessages(DatabasePlace::file(path));
    return 0;
}

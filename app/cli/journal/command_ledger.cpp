// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/call/json.h"
#include "cli/call/keys.h"
#include "cli/call/text_table.h"
#include "cli/call/texts.h"
#include "cli/commands.h"
#include "cli/journal/ledger_files.h"
#include "cli/project/project_of_call.h"
#include "vocabulary/freshness_text.h"
#include "vocabulary/sentence.h"

#include <QFileInfo>
#include <QLocale>

#include <array>

namespace codewheel {
namespace {

constexpr const char *ledgerExamples[] = {"ledger",
                                          "ledger --ledger eeprom-writes.sqlite --json",
                                          "ledger entries",
                                          "ledger export counts.json",
                                          "ledger import hall-3.json hall-4.json",
                                          "ledger merge /srv/codewheel"};

constexpr std::array ledgerOptions{
    Option{"--ledger", "FILE",
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "of this file, in place of the user's own")},
    Option{"--yes", nullptr,
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "export: replace the file if it is there")},
};

QString countedByName(CountedBy by)
{
    switch (by) {
    case CountedBy::serialNumber:
        return CommandLine::tr("serial number, read");
    case CountedBy::labelSerialNumber:
        return CommandLine::tr("serial number of the label");
    default:
        return CommandLine::tr("place");
    }
}

constexpr NamedValue<CountedBy> countedByKeys[] = {
    {"place", CountedBy::place},
    {"serialNumber", CountedBy::serialNumber},
    {"label", CountedBy::labelSerialNumber},
};

QJsonObject toJson(const Ledger::Account &account)
{
    return {{QStringLiteral("identity"), account.identity},
            {QStringLiteral("countedBy"), keyOf(countedByKeys, account.count.by)},
            {QStringLiteral("bus"), account.place.bus.number},
            {QStringLiteral("place"), account.place.toString()},
            {QStringLiteral("device"), account.device},
            {QStringLiteral("writes"), account.count.writes},
            {QStringLiteral("perhaps"), account.count.perhaps},
            {QStringLiteral("since"), account.count.since.toString(Qt::ISODateWithMs)}};
}

// By its file or, for a serial number, by the device that the project has there.
bool isOfProject(const Call &call, const Ledger::Account &account)
{
    if (call.project == nullptr)
        return false;
    const QString file = QFileInfo(*call.arguments.value("--project")).canonicalFilePath();
    if (account.count.by == CountedBy::place)
        return account.identity == EncoderIdentity{CountedBy::place, {}, {}, file, account.place}.key();
    const ProjectDevice *device = findDevice(*call.project, account.place);
    if (device == nullptr || device->participant.deviceKey != account.device)
        return false;
    const QString label = device->label.serialNumber;
    const QString number = account.identity.section(u'/', -1);
    return label.isEmpty() || label == number || label.toLongLong(nullptr, 16) == number.toLongLong();
}

QString noneText(const QString &file)
{
    return sentence(CommandLine::tr("No EEPROM writes are counted in %1."), {file}) + u'\n';
}

Checked<Answer> listAccounts(const Call &call)
{
    const QString file = ledgerMeant(call);
    const auto ledger = existingLedger(file);
    if (!ledger)
        return tl::unexpected(ledger.error());
    const auto accounts = *ledger ? (*ledger)->accounts() : std::vector<Ledger::Account>();
    using enum TextTable::Align;
    TextTable table({left, left, right, right});
    table.add({CommandLine::tr("since"), CommandLine::tr("last at"), CommandLine::tr("writes"),
               CommandLine::tr("perhaps"), CommandLine::tr("counted by"), CommandLine::tr("encoder")});
    std::set<Place> places;
    for (const Ledger::Account &account : accounts)
        places.insert(account.place);
    BusNames::tellApart(call, places);
    QJsonArray json;
    for (const Ledger::Account &account : accounts) {
        const QDateTime since = account.count.since.toLocalTime();
        table.add({QLocale().toString(since.date(), QLocale::ShortFormat),
                   BusNames::apart(call, account.place, isOfProject(call, account)),
                   QString::number(account.count.writes), QString::number(account.count.perhaps),
                   countedByName(account.count.by), account.identity});
        json.append(toJson(account));
    }
    Answer answer{.text = table.toString(), .json = {{QStringLiteral("accounts"), json}}};
    if (accounts.empty())
        answer.text = noneText(file);
    return answer;
}

QJsonObject toJson(const Ledger::Record &record)
{
    const Ledger::Entry &entry = record.entry;
    return {{QStringLiteral("at"), entry.at.toString(Qt::ISODateWithMs)},
            {QStringLiteral("identity"), entry.identity},
            {QStringLiteral("countedBy"), keyOf(countedByKeys, entry.by)},
            {QStringLiteral("bus"), entry.place.bus.number},
            {QStringLiteral("place"), entry.place.toString()},
            {QStringLiteral("device"), entry.device},
            {QStringLiteral("writes"), entry.writes},
            {QStringLiteral("perhaps"), entry.perhaps()},
            {QStringLiteral("computer"), entry.writer.computer},
            {QStringLiteral("user"), entry.writer.user}};
}

QString orUnknown(const QString &name)
{
    return name.isEmpty() ? QStringLiteral("-") : name;
}

// One by one, in the order in which they were made, whichever computer made them.
Checked<Answer> listEntries(const Call &call)
{
    const QString file = ledgerMeant(call);
    const auto ledger = existingLedger(file);
    if (!ledger)
        return tl::unexpected(ledger.error());
    auto records = *ledger ? (*ledger)->records() : std::vector<Ledger::Record>();
    if (!records)
        return tl::unexpected(aboutLedger(file, records.error()));
    std::erase_if(*records, [](const Ledger::Record &record) { return record.entry.isWithoutWrite(); });
    std::ranges::stable_sort(*records, {}, [](const Ledger::Record &record) { return record.entry.at; });
    std::set<Place> places;
    for (const Ledger::Record &record : *records)
        places.insert(record.entry.place);
    BusNames::tellApart(call, places);
    using enum TextTable::Align;
    TextTable table({left, left, right, right});
    table.add({CommandLine::tr("when"), CommandLine::tr("at"), CommandLine::tr("writes"),
               CommandLine::tr("perhaps"), CommandLine::tr("computer"), CommandLine::tr("name"),
               CommandLine::tr("encoder")});
    QJsonArray json;
    for (const Ledger::Record &record : *records) {
        const Ledger::Entry &entry = record.entry;
        table.add({recordedText(entry.at.toLocalTime()), BusNames::apart(call, entry.place, false),
                   QString::number(entry.writes), QString::number(entry.perhaps()),
                   orUnknown(entry.writer.computer), orUnknown(entry.writer.user), entry.identity});
        json.append(toJson(record));
    }
    return Answer{.text = records->empty() ? noneText(file) : table.toString(),
                  .json = {{QStringLiteral("entries"), json}}};
}

Checked<Answer> runLedger(const Call &call)
{
    const QStringList &words = call.arguments.rest;
    if (words.isEmpty())
        return listAccounts(call);
    const QString what = words.front();
    const QStringList names = words.sliced(1);
    if (what == QStringLiteral("entries") && names.isEmpty())
        return listEntries(call);
    if (what == QStringLiteral("export") && names.size() == 1)
        return exportLedger(call, names.front());
    if (what == QStringLiteral("import") && !names.isEmpty())
        return importLedgers(call, names);
    if (what == QStringLiteral("merge") && names.size() == 1)
        return mergeLedgerFolder(call, names.front());
    return badInput(
        "badLedgerCall",
        CommandLine::tr("\"%1\" is not understood. The ledger is listed, by encoder or with entries "
                        "one by one, or carried with export FILE, import FILE... and merge FOLDER."),
        {words.join(u' ')});
}

} // namespace

const Subcommand ledgerCommand{
    .name = "ledger",
    .usage = "[entries | export FILE [--yes] | import FILE... | merge FOLDER] [--ledger FILE]",
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine", "list how often this program wrote to EEPROMs"),
    .details = QT_TRANSLATE_NOOP(
        "codewheel::CommandLine",
        "Lists for each encoder how often this program, window or command line, has written to its EEPROM, "
        "and\n"
        "since when: by the serial number it told, else by the one typed from its label, else by its place "
        "in its\n"
        "project. \"perhaps\" are writes that were begun, and the program ended before it saw them carried "
        "out.\n"
        "\"entries\" lists them one by one, with computer and name of who wrote.\n"
        "\"export\" saves all entries in a file, and \"import\" on another computer takes them into its "
        "ledger: the\n"
        "same serial number is the same encoder there, and what was imported before is not counted twice. "
        "\"merge\"\n"
        "does both with a folder that several computers share: it takes in what the others left there, and "
        "leaves\n"
        "what is known here, in eeprom-writes-COMPUTER.json. Needs no bus."),
    .examples = ledgerExamples,
    .options = ledgerOptions,
    .arguments = {0, 1000},
    .run = runLedger,
};

} // namespace codewheel

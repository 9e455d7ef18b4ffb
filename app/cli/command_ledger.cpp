// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/consent.h"
#include "cli/json.h"
#include "cli/keys.h"
#include "cli/project_of_call.h"
#include "cli/text_table.h"
#include "cli/texts.h"
#include "encoder/sentence.h"
#include "journal/ledger_json.h"
#include "journal_files.h"
#include "project/file_access.h"

#include <QFileInfo>
#include <QLocale>

#include <array>

namespace codewheel {
namespace {

constexpr const char *ledgerExamples[] = {"ledger", "ledger --ledger eeprom-writes.sqlite --json",
                                          "ledger export counts.json", "ledger import counts.json"};

constexpr std::array ledgerOptions{
    Option{"--ledger", "FILE",
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "of this file, in place of the user's own")},
    Option{"--yes", nullptr,
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "export: replace the file if it is there")},
};

constexpr qint64 largestExport = 256'000'000; // bytes

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

QString fileMeant(const Call &call)
{
    return call.arguments.value("--ledger").value_or(ledgerFile(userJournalFolder()));
}

Complaint aboutLedger(const QString &file, const DatabaseError &error)
{
    return complaintAbout({RefusalKind::link, RefusalId::databaseFailed, {file, error.reason}});
}

// Looking creates no file: empty if there is none.
Checked<std::optional<Ledger>> existingLedger(const QString &file)
{
    if (!QFileInfo::exists(file))
        return std::nullopt;
    auto ledger = Ledger::open(DatabasePlace::file(file));
    if (!ledger)
        return tl::unexpected(aboutLedger(file, ledger.error()));
    return std::move(*ledger);
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

Checked<Answer> listAccounts(const Call &call)
{
    const QString file = fileMeant(call);
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
        answer.text = sentence(CommandLine::tr("No EEPROM writes are counted in %1."), {file}) + u'\n';
    return answer;
}

Checked<Answer> exportRecords(const Call &call, const QString &target)
{
    const QString file = fileMeant(call);
    if (const auto free = checkTargetFile(call.arguments, target); !free)
        return tl::unexpected(free.error());
    const auto ledger = existingLedger(file);
    if (!ledger)
        return tl::unexpected(ledger.error());
    const auto records = *ledger ? (*ledger)->records() : std::vector<Ledger::Record>();
    if (!records)
        return tl::unexpected(aboutLedger(file, records.error()));
    if (const auto saved = replaceFile(target, recordsToJson(*records, false), OldFile::goes); !saved)
        return tl::unexpected(complaintAbout(saved.error()));
    return Answer{.text = sentence(CommandLine::tr("Saved in %1: entries of the ledger: %2."),
                                   {target, QString::number(records->size())}) +
                          u'\n',
                  .json = {{QStringLiteral("saved"), target},
                           {QStringLiteral("entries"), static_cast<qint64>(records->size())}}};
}

Checked<Answer> importRecords(const Call &call, const QString &source)
{
    const auto bytes = readWholeFile(source, largestExport);
    if (!bytes)
        return tl::unexpected(complaintAbout(bytes.error()));
    const auto records = recordsFromJson(*bytes);
    if (!records)
        return tl::unexpected(
            complaintAbout({RefusalKind::badInput, RefusalId::fileNotReadable, {source, records.error()}}));
    const QString file = fileMeant(call);
    auto ledger = Ledger::open(DatabasePlace::file(file));
    if (!ledger)
        return tl::unexpected(aboutLedger(file, ledger.error()));
    const auto merged = ledger->merge(*records);
    if (!merged)
        return tl::unexpected(aboutLedger(file, merged.error()));
    return Answer{
        .text = sentence(CommandLine::tr("Imported into %1: new entries: %2; known already: %3."),
                         {file, QString::number(merged->added), QString::number(merged->known)}) +
                u'\n',
        .json = {{QStringLiteral("added"), merged->added}, {QStringLiteral("known"), merged->known}}};
}

Checked<Answer> runLedger(const Call &call)
{
    const QStringList &words = call.arguments.rest;
    if (words.isEmpty())
        return listAccounts(call);
    if (words.size() == 2 && words[0] == QStringLiteral("export"))
        return exportRecords(call, words[1]);
    if (words.size() == 2 && words[0] == QStringLiteral("import"))
        return importRecords(call, words[1]);
    return badInput(QStringLiteral("badLedgerCall"),
                    CommandLine::tr("\"%1\" is not understood. The ledger is listed, or carried with export "
                                    "FILE and import FILE."),
                    {words.join(u' ')});
}

} // namespace

const Subcommand ledgerCommand{
    .name = "ledger",
    .usage = "[export FILE [--yes] | import FILE] [--ledger FILE]",
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine", "list how often this program wrote to EEPROMs"),
    .details = QT_TRANSLATE_NOOP(
        "codewheel::CommandLine",
        "Lists for each encoder how often this program, window or command line, has written to its EEPROM, "
        "and\n"
        "since when: by the serial number it told, else by the one typed from its label, else by its place "
        "in its\n"
        "project. \"perhaps\" are writes that were begun, and the program ended before it saw them carried "
        "out.\n"
        "\"export\" saves all entries in a file, and \"import\" on another computer takes them into its "
        "ledger: the\n"
        "same serial number is the same encoder there, and what was imported before is not counted twice. "
        "Needs\n"
        "no bus."),
    .examples = ledgerExamples,
    .options = ledgerOptions,
    .minimumArguments = 0,
    .maximumArguments = 2,
    .needsBus = false,
    .run = runLedger,
};

} // namespace codewheel

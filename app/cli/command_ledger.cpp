// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/json.h"
#include "cli/text_table.h"
#include "cli/texts.h"
#include "encoder/sentence.h"
#include "journal/ledger.h"
#include "journal_files.h"

#include <QFileInfo>
#include <QLocale>

#include <array>

namespace codewheel {
namespace {

constexpr const char *ledgerExamples[] = {"ledger", "ledger --ledger eeprom-writes.sqlite --json"};

constexpr std::array ledgerOptions{
    Option{"--ledger", "FILE",
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "of this file, in place of the user's own")},
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

QString countedByKey(CountedBy by)
{
    switch (by) {
    case CountedBy::serialNumber:
        return QStringLiteral("serialNumber");
    case CountedBy::labelSerialNumber:
        return QStringLiteral("label");
    default:
        return QStringLiteral("place");
    }
}

QJsonObject toJson(const Ledger::Account &account)
{
    return {{QStringLiteral("identity"), account.identity},
            {QStringLiteral("countedBy"), countedByKey(account.count.by)},
            {QStringLiteral("place"), account.place.toString()},
            {QStringLiteral("device"), account.device},
            {QStringLiteral("writes"), account.count.writes},
            {QStringLiteral("perhaps"), account.count.perhaps},
            {QStringLiteral("since"), account.count.since.toString(Qt::ISODateWithMs)}};
}

Checked<std::vector<Ledger::Account>> accountsOf(const QString &file)
{
    if (!QFileInfo::exists(file)) // looking makes none
        return std::vector<Ledger::Account>();
    const auto ledger = Ledger::open(DatabasePlace::file(file));
    if (!ledger)
        return tl::unexpected(
            complaintAbout({RefusalKind::link, RefusalId::databaseFailed, {file, ledger.error().reason}}));
    return ledger->accounts();
}

Checked<Answer> runLedger(const Call &call)
{
    const QString file = call.arguments.value("--ledger").value_or(ledgerFile(userJournalFolder()));
    const auto accounts = accountsOf(file);
    if (!accounts)
        return tl::unexpected(accounts.error());
    using enum TextTable::Align;
    TextTable table({left, left, right, right});
    table.add({CommandLine::tr("since"), CommandLine::tr("last at"), CommandLine::tr("writes"),
               CommandLine::tr("perhaps"), CommandLine::tr("counted by"), CommandLine::tr("encoder")});
    QJsonArray json;
    for (const Ledger::Account &account : *accounts) {
        const QDateTime since = account.count.since.toLocalTime();
        table.add({QLocale().toString(since.date(), QLocale::ShortFormat), account.place.toString(),
                   QString::number(account.count.writes), QString::number(account.count.perhaps),
                   countedByName(account.count.by), account.identity});
        json.append(toJson(account));
    }
    Answer answer{.text = table.toString(), .json = {{QStringLiteral("accounts"), json}}};
    if (accounts->empty())
        answer.text = sentence(CommandLine::tr("No EEPROM writes are counted in %1."), {file}) + u'\n';
    return answer;
}

} // namespace

const Subcommand ledgerCommand{
    .name = "ledger",
    .usage = "[--ledger FILE]",
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine", "list how often this program wrote to EEPROMs"),
    .details = QT_TRANSLATE_NOOP(
        "codewheel::CommandLine",
        "Lists for each encoder how often this program, window or command line, has written to its EEPROM, "
        "and\n"
        "since when: by the serial number it told, else by the one typed from its label, else by its place "
        "in its\n"
        "project. \"perhaps\" are writes that were begun, and the program ended before it saw them carried "
        "out.\n"
        "Needs no bus."),
    .examples = ledgerExamples,
    .options = ledgerOptions,
    .minimumArguments = 0,
    .maximumArguments = 0,
    .needsBus = false,
    .run = runLedger,
};

} // namespace codewheel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/cli_run.h"

#include "cli/call/command_line.h"
#include "cli/commands.h"
#include "cli/kinds/interbus/ring_access.h"
#include "cli/project/project_of_call.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <gtest/gtest.h>
#include <sstream>

namespace codewheel {

CliRun runWith(const Person &person, const std::function<int(const Terminal &)> &call)
{
    std::istringstream in(person.types);
    std::ostringstream out;
    std::ostringstream err;
    const int exit = call(Terminal{in, out, err, person.isThere});
    return {exit, out.str(), err.str()};
}

QJsonObject CliRun::json() const
{
    QJsonParseError error;
    const auto document = QJsonDocument::fromJson(QByteArray::fromStdString(out), &error);
    EXPECT_EQ(error.error, QJsonParseError::NoError) << out;
    return document.object();
}

QJsonObject CliRun::lastJson() const
{
    return QJsonDocument::fromJson(QByteArray::fromStdString(out).trimmed().split('\n').last()).object();
}

int runOn(const Subcommand &command, const Arguments &arguments, const Catalog &catalog,
          const std::vector<BusAccess *> &links, const Terminal &terminal)
{
    const auto project = projectOf(command, arguments);
    if (!project) {
        ADD_FAILURE() << project.error().text.toStdString();
        return -1;
    }
    return runCommand(command, arguments, *project ? &**project : nullptr, catalog, links, terminal);
}

CliRun runLine(const QString &line, const Person &person)
{
    const QStringList words = line.split(u' ', Qt::SkipEmptyParts);
    return runWith(person, [&](const Terminal &terminal) { return runCommandLine(words, terminal); });
}

SharedBus::SharedBus()
    : m_training(openTrainingSession(m_catalog, QDateTime(QDate(2026, 3, 1), QTime(14, 2), Qt::UTC)))
{}

CliRun SharedBus::runLine(const QString &line, const Person &person)
{
    QStringList words = line.split(u' ', Qt::SkipEmptyParts);
    const Subcommand *command = commandNamed(words.takeFirst());
    if (!command)
        return {};
    const auto arguments = parseArguments(words, optionsOf(*command), {});
    if (!arguments)
        return {};
    return runWith(person, [&](const Terminal &terminal) {
        RingAccess ring(*m_training.bus);
        return runOn(*command, *arguments, m_catalog, {&ring}, terminal);
    });
}

int SharedBus::eepromWrites() const
{
    int writes = 0;
    for (const TrainingControls::Shaft &shaft : m_training.controls->shafts())
        writes += shaft.eepromWrites;
    return writes;
}

std::vector<std::string> rowsOf(const QJsonObject &json, const char *key)
{
    std::vector<std::string> rows;
    for (const QJsonValue row : json.value(QString::fromLatin1(key)).toArray())
        rows.push_back((row[u"out"].toString() + u' ' + row[u"in"].toString()).toStdString());
    return rows;
}

std::string errorKey(const CliRun &run)
{
    return run.json()[u"error"][u"key"].toString().toStdString();
}

} // namespace codewheel

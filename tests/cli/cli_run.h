// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/catalog.h"
#include "kinds/interbus/training_session.h"

#include <QJsonObject>
#include <QString>

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace codewheel {

class BusAccess;
struct Arguments;
struct Subcommand;
struct Terminal;

inline constexpr int patience = 60'000; // ms, for programs that tests start

// The result of a command line call.
struct CliRun
{
    int exit = -1;
    std::string out;
    std::string err;

    QJsonObject json() const;     // of `out`
    QJsonObject lastJson() const; // of its last line
};

// Who is at the terminal: nobody, or somebody who types this.
struct Person
{
    bool isThere = false;
    std::string types{};
};

// Runs `call` for this person.
CliRun runWith(const Person &person, const std::function<int(const Terminal &)> &call);

// A command on these buses, with the project given in its arguments.
int runOn(const Subcommand &command, const Arguments &arguments, const Catalog &catalog,
          const std::vector<BusAccess *> &links, const Terminal &terminal);

// A whole call, within this process. `line`: everything after codewheel-cli, split at spaces.
CliRun runLine(const QString &line, const Person &person = {});

// Calls that share one training bus.
class SharedBus
{
public:
    SharedBus();
    CliRun runLine(const QString &line, const Person &person = {});
    RingSession &bus() { return *m_training.bus; }
    TrainingControls &controls() { return *m_training.controls; }
    // Writes to the EEPROMs of all encoders, as counted by the simulated encoders.
    int eepromWrites() const;

private:
    Catalog m_catalog = Catalog::builtIn();
    TrainingSession m_training;
};

// "OUT IN" of each row of a trace in JSON.
std::vector<std::string> rowsOf(const QJsonObject &json, const char *key = "trace");
std::string errorKey(const CliRun &run);

} // namespace codewheel

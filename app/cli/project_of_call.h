// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/subcommand.h"
#include "project/project.h"

#include <set>

namespace codewheel {

// Of the first argument, else of --project; nothing without either. One call has one project, and reads it
// once.
Checked<std::optional<Project>> projectOf(const Subcommand &command, const Arguments &arguments);

// Buses are called as the project has them.
void nameBuses(const Call &call, const Project &project);
// Buses and encoders are called as the project has them. Told where a bus differs from it.
void useProject(const Call &call, const Project &project, const QString &file);

// Over the file, unless it was changed since it had this mark.
Checked<void> saveUnlessChanged(const Project &project, const QString &file, const QByteArray &mark);

// Places of kinds of which the call has several buses are told with the names of their buses, as long as it
// lives.
class BusNames
{
public:
    explicit BusNames(const Call &call);
    ~BusNames();
    Q_DISABLE_COPY_MOVE(BusNames)

    static void tell(const Call &call);
    // Of a list: each place with its bus, where those of the same form are on several, and each bus itself;
    // a bus that nobody has named has its number.
    static void tellApart(const Call &call, const std::set<Place> &places);
    // Such a place; by the number of its bus where the project has another kind of bus by this number, or
    // where the place is one of another project.
    static QString apart(const Call &call, Place place, bool isOfProject = true);
};

} // namespace codewheel

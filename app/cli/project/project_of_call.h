// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/subcommand.h"
#include "project/project.h"

#include <set>

namespace codewheel {

// From the first argument, otherwise from --project; empty without either. A call has one project, and reads
// it once.
Checked<std::optional<Project>> projectOf(const Subcommand &command, const Arguments &arguments);

// Buses get the names they have in the project.
void nameBuses(const Call &call, const Project &project);
// Buses and encoders get the names they have in the project. Reports where a bus differs from it.
void useProject(const Call &call, const Project &project, const QString &file);

// Over the file, unless it has changed since it had this mark.
Checked<void> saveUnlessChanged(const Project &project, const QString &file, const QByteArray &mark);

// As long as it lives, places of kinds of which the call has several buses are shown with the names of their
// buses.
class BusNames
{
public:
    explicit BusNames(const Call &call);
    ~BusNames();
    Q_DISABLE_COPY_MOVE(BusNames)

    static void tell(const Call &call);
    // For a list: each place with its bus if those of the same form are on several, and each bus itself; a
    // bus that nobody has named has its number.
    static void tellApart(const Call &call, const std::set<Place> &places);
    // Such a place; with the number of its bus if the project has another kind of bus with this number, or if
    // the place belongs to another project.
    static QString apart(const Call &call, Place place, bool isOfProject = true);
};

} // namespace codewheel

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/subcommand.h"
#include "project/project.h"

namespace codewheel {

// Of --project; nothing without it.
Checked<std::optional<Project>> projectNamed(const Arguments &arguments);

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
};

} // namespace codewheel

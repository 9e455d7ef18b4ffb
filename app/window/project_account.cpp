// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/project_account.h"

#include "journal/ledger_keeper.h"
#include "widgets/project/project_document.h"

namespace codewheel {

void keepAccountOf(ProjectDocument &project, LedgerKeeper &ledger)
{
    const auto tell = [&project, &ledger] {
        ledger.setProject(project.file());
        project.forEachDevice([&ledger](Place place, const ProjectDevice &device) {
            ledger.setLabel(place, device.label.serialNumber);
        });
    };
    QObject::connect(&project, &ProjectDocument::changed, &ledger, tell);
    // Another project has told its file with changed() before.
    QObject::connect(&project, &ProjectDocument::fileChanged, &ledger,
                     [&project, &ledger] { ledger.projectSavedAs(project.file()); });
    tell();
}

} // namespace codewheel

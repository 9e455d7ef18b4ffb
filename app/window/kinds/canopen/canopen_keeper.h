// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/plan/canopen_plan.h"

#include <QObject>

namespace codewheel {

class CanopenAtWork;
class ProjectDocument;

// Keeps in the project what happens to its CAN bus, each change as an undo step. The simulated bus is not the
// project's: nothing is kept of its encoders, which do not exist. Used by CanopenViews.
class CanopenKeeper : public QObject
{
    Q_OBJECT

public:
    // Both must outlive it.
    CanopenKeeper(const CanopenAtWork &bus, ProjectDocument &project, QObject *parent = nullptr);

    void keepLink(const CanopenSettings &settings);
    // Encoders already in the project stay as they are.
    void keepEncoders(const std::vector<Place> &places);
    void removeEncoder(Place place);

private:
    void edit(std::vector<ProjectDevice> after, const QString &what);
    std::vector<ProjectDevice> encoders() const; // of the project

    const CanopenAtWork &m_bus;
    ProjectDocument &m_project;
};

} // namespace codewheel

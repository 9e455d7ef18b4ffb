// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/parameter.h"
#include "vocabulary/place.h"

#include <QObject>

#include <map>
#include <optional>

namespace codewheel {

class ProjectDocument;

// Replaces the wanted value of the parameter; nothing: unchanged.
void putWanted(ParameterValues &values, Parameter parameter, const std::optional<Value> &value);

// What the user wants each encoder to have: entered, not sent. A facade of the project, shared by parameter
// panel and wizard; each change is an undo step.
class WantedValues : public QObject
{
    Q_OBJECT

public:
    explicit WantedValues(ProjectDocument &project, QObject *parent = nullptr);

    std::optional<Value> value(Place number, Parameter parameter) const;
    ParameterValues values(Place number) const; // in the order of the parameters
    // Nothing: leave it as it is.
    void set(Place number, Parameter parameter, const std::optional<Value> &value);
    // All at once, as an undo step named `what`.
    void replace(Place number, ParameterValues values, const QString &what);
    void clear(Place number);

Q_SIGNALS:
    void changed(codewheel::Place number);

private:
    void tellChanges();

    ProjectDocument &m_project;
    std::map<Place, ParameterValues> m_told; // last reported, for places that have any
};

} // namespace codewheel

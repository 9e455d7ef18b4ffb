// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/place.h"
#include "widgets/look/roles.h"

#include <QCoreApplication>
#include <QPointer>

#include <vector>

namespace codewheel {

class LineSession;
class ProjectDocument;

// What is shown of a state: the same for master, line and devices.
struct StateWord
{
    Role role = Role::inactive;
    QString word;

    friend bool operator==(const StateWord &, const StateWord &) = default;
};

// The branch of the bus structure with the serial line and, below it, its encoders in the order of their
// addresses. Used by StructureModel, which tells the views.
class LineBranch
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::LineBranch)

public:
    struct Row
    {
        Place number;
        QString name;    // of the kind of encoder
        QString station; // as the project has it; empty: none
        StateWord shown{};
        std::optional<std::int64_t> position{};
        bool isOld = false; // the position

        friend bool operator==(const Row &, const Row &) = default;
    };

    void setLine(LineSession *line);
    LineSession *line() const; // null: none, and nothing below it
    // As it is now. The rows that are shown may be others, until the model has told so.
    StateWord state() const;
    std::vector<Row> rows(const ProjectDocument *project) const;

    QString name() const;
    QString toolTip() const;
    QString toolTip(const Row &row) const;

private:
    StateWord stateOf(Place number) const;

    QPointer<LineSession> m_line;
};

// "hoist: Kübler 5882", or only the latter: its station comes first, that is how people at the plant call it.
QString calledText(const QString &station, const QString &name);

} // namespace codewheel

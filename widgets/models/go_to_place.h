// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/place.h"

#include <QAction>

#include <optional>

namespace codewheel {

// Takes the user from a row about a device or a bus to its row in the bus structure. For the menus of
// messages, handshake trace and terminal.
class GoToPlace : public QAction
{
    Q_OBJECT

public:
    explicit GoToPlace(QWidget *view); // where its key works

    void setPlace(std::optional<codewheel::Place> place); // of the chosen row; nothing: it is about none

Q_SIGNALS:
    void wanted(codewheel::Place place);

private:
    std::optional<Place> m_place;
};

} // namespace codewheel

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/look/typed_texts.h"
#include "vocabulary/place.h"
#include "widgets/models/traffic_model.h"
#include "widgets/parameters/parameter_table.h"
#include "widgets/trace/trace_view.h"
#include "widgets/wizard/parameter_wizard.h"

#include <QByteArray>

#include <any>
#include <map>
#include <optional>

namespace codewheel {

// What is under way in a window, for the one in another language that replaces it.
struct WorkInWindow
{
    std::optional<Place> row; // that is chosen in the bus structure
    int page = 0;             // in the middle, with its class
    QByteArray kindOfPage{};
    TraceView::Traces traces{};
    bool hasCams = false; // their page was made
    ParameterWizard::UnderWay wizard{};
    std::optional<ParameterTable::Typed> wanted{}; // that is being typed
    std::map<BusId, std::any> ofBuses{};
    TypedTexts typed{};
};

} // namespace codewheel

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/buses/plant.h"
#include "app/window/kinds/esc/esc_line_at_work.h"
#include "app/window/kinds/interbus/ring_at_work.h"
#include "app/window/main_window.h"
#include "catalog/catalog.h"
#include "widgets/messages/message_model.h"
#include "widgets/project/project_document.h"

namespace codewheel {

// The main window on a training bus and a training line in virtual time: nothing moves except by advance().
// For tests, and for the pictures of the manual, which match because each starts at the same date and time.
class TrainingWindow
{
public:
    // With an ini file of its own for the window's settings. `size`: at the first start, if not the usual
    // one.
    explicit TrainingWindow(const QString &settingsFile, QSize size = {});
    ~TrainingWindow();

    MainWindow &window() { return *m_window; }
    RingSession &bus() { return *m_plant.first<RingAtWork>()->bus(); }
    EscLineAtWork &line() { return *m_plant.first<EscLineAtWork>(); }
    Plant &plant() { return m_plant; }
    const Catalog &catalog() const { return m_catalog; }
    Buses &buses() { return m_plant.buses(); }
    TrainingControls &controls() { return m_plant.first<RingAtWork>()->controls(); }
    MessageModel &messages() { return m_messages; }
    ProjectDocument &project() { return m_project; } // initially the training plant
    // This many milliseconds pass on the bus; a frame is taken every 33.
    void advance(int milliseconds);

    static QDateTime begin();

private:
    Catalog m_catalog = Catalog::builtIn();
    WindowSettings m_settings;
    MessageStore m_store{{}}; // in memory
    MessageModel m_messages{m_store};
    ProjectDocument m_project;
    Plant m_plant;
    std::unique_ptr<MainWindow> m_window;
};

} // namespace codewheel

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/bus_views.h"

namespace codewheel {

class ComparisonPage;
class MasterPanel;
class RingAtWork;
class RingConnection;
class TrainingPanel;

// The views of a ring in the window: its master, its training panel, and the comparison with the project.
class RingViews final : public BusViews
{
    Q_OBJECT

public:
    RingViews(RingAtWork &ring, const WindowParts &parts, QObject *parent);
    ~RingViews() override;

    RingConnection &connection() const { return *m_connection; }
    TrainingPanel &training() const { return *m_training; }

    std::vector<Panel> panels() const override;
    void setCurrent(bool isCurrent) override;
    void setChosen(std::optional<Place> place) override;
    void open() override;
    void showPicture() override;

private:
    void tellTraining(Place place, MessageId what, const QString &text);
    void showState();
    void showActions();
    void showComparison();

    RingAtWork &m_ring;
    const WindowParts m_parts;
    RingConnection *m_connection;
    MasterPanel *m_master;
    TrainingPanel *m_training;
    ComparisonPage *m_comparison;
    std::optional<Place> m_chosen;
    bool m_isCurrent = false;
};

} // namespace codewheel

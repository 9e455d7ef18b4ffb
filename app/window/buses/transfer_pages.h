// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/look/late_page.h"
#include "transfer/values_before.h"
#include "vocabulary/message.h"
#include "widgets/transfer/replace_step.h"

#include <QObject>

namespace codewheel {

class Buses;
class Catalog;
class LastPositions;
class ProjectDocument;
class ReplacePage;
class ShownEncoder;
class TransferPage;
class WindowActions;

// The pages of the window for parameter transfer, and the actions that open them: Transfer, Replace encoder,
// Restore values of 14:02.
class TransferPages : public QObject
{
    Q_OBJECT

public:
    // All must outlive it; the pages are put into `pages`.
    TransferPages(const Buses &buses, const Catalog &catalog, ProjectDocument &project,
                  FindValuesBefore findBefore, LastPositions &positions, const WindowActions &actions,
                  QStackedWidget &pages, QObject *parent = nullptr);

    // What the kind of a bus adds to a replacement on it; before a page is shown.
    void setReplaceSteps(MakeReplaceSteps make) { m_makeReplaceSteps = std::move(make); }
    // The encoder chosen in the window.
    void setEncoder(const ShownEncoder &shown);
    bool isBusy() const; // encoders are being written

Q_SIGNALS:
    void told(const codewheel::Message &message);

private:
    void showTransfer();
    void showRestore();
    void showReplace();
    void showActions();

    const Buses &m_buses;
    FindValuesBefore m_findBefore;
    MakeReplaceSteps m_makeReplaceSteps;
    const WindowActions &m_actions;
    QStackedWidget &m_pages;
    LatePage<TransferPage> m_transfer;
    LatePage<ReplacePage> m_replace;
    std::optional<Place> m_number; // only if it is connected
    bool m_isOnlyPlanned = false;
};

} // namespace codewheel

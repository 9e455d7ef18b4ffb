// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/files/file_look.h"
#include "vocabulary/place.h"

#include <QObject>

class QStackedWidget;
class QVBoxLayout;

namespace codewheel {

class BusAtWork;
class InlineMessage;
class Plant;
class ProjectDocument;
class ProjectFiles;
class StartPage;
class WindowActions;
class WindowSettings;

// The start page in the window: shown instead of the monitors while no bus is connected, and what its entries
// do. Connects nothing by itself.
class Start : public QObject
{
    Q_OBJECT

public:
    // All must outlive it; the page is put into `pages`.
    struct Parts
    {
        Plant &plant;
        ProjectDocument &project;
        ProjectFiles &files;
        const WindowSettings &settings;
        const WindowActions &actions;
        QStackedWidget &pages;
        QVBoxLayout &notices; // above the pages
    };
    explicit Start(const Parts &parts, QObject *parent = nullptr);

    // The project that was open in the last session; empty: none.
    void offer(const QString &lastFile);
    // What the middle shows when no other page is open.
    QWidget *pageInsteadOf(QWidget *monitors) const;
    QWidget *page() const;

    // First closes the project, unless it is that of the training plant itself, changed or not.
    void openTraining();

Q_SIGNALS:
    void connectRequested(codewheel::BusId bus);
    void trainingRequested(codewheel::BusId bus); // connect its simulated link

private:
    bool isAnyOpen() const;
    bool isTrainingPlan() const;
    void showProject();
    void showFiles();
    void lookAtFiles();
    void chooseBus();
    std::vector<BusAtWork *> closedBuses() const; // the planned ones; if no device is planned, all
    void beginReplacing();
    void showReplacing();

    const Parts m_parts;
    StartPage *m_page;
    InlineMessage *m_replacing; // says how to go on
    FileLook m_look;
    QString m_last;
    bool m_replaces = false;
};

} // namespace codewheel

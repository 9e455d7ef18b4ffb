// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/language.h"
#include "app/window/look/frame_clock.h"
#include "app/window/settings_at_work.h"
#include "app/window/window_settings.h"
#include "catalog/catalog.h"
#include "widgets/project/project_document.h"

#include <QObject>

#include <memory>

class QApplication;

namespace codewheel {

class MainWindow;
class MessageModel;
class MessageStore;
class Plant;
class ProjectRecovery;
class UnseenFaults;

// The program with a window, from start to end: language, appearance, the window, and after its first paint
// the buses, each with its own thread once connected. The language can be changed at any time: the window is
// rebuilt, the bus goes on.
class Program : public QObject
{
    Q_OBJECT

public:
    // With an ini file of its own, the window's settings go there, and messages, EEPROM counts and unsaved
    // changes beside it; empty: the user's own.
    explicit Program(QApplication &application, const QString &settingsFile = {});
    ~Program() override;

    // A project, or another file of the program, to open as soon as the window is there; nothing is connected
    // then. Without one, the very first start begins with the training plant, later ones with the start page.
    void openAtStart(const QString &file) { m_file = file; }
    int run();
    void openWindow();
    MainWindow *window() const { return m_window.get(); }
    Plant *plant() const { return m_plant.get(); } // null before the first paint

private:
    void startBus();
    void watchFaults();
    void keepLastFile();
    void openProject();
    void attach();
    void showFrame();
    void useSettings();
    void useLanguage();
    void makeWindowAnew();
    void raiseWindow();

    QApplication &m_application;
    const QString m_dataFolder;     // of messages and EEPROM counts
    const QString m_recoveryFolder; // for unsaved changes
    WindowSettings m_settings;
    SettingsAtWork m_choices;
    Language m_language;
    std::unique_ptr<Catalog> m_catalog;
    std::unique_ptr<MessageStore> m_store;
    std::unique_ptr<MessageModel> m_messages;
    std::unique_ptr<UnseenFaults> m_unseenFaults;
    ProjectDocument m_project;
    std::unique_ptr<Plant> m_plant;
    std::unique_ptr<ProjectRecovery> m_recovery;
    QString m_file;     // to be opened once the bus is there
    QString m_lastFile; // of the last session, until another is opened
    std::unique_ptr<MainWindow> m_window;
    FrameClock m_frames;
};

} // namespace codewheel

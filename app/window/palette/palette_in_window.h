// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "other_language.h"
#include "vocabulary/parameter.h"
#include "vocabulary/place.h"

#include <QObject>

#include <functional>

class QMainWindow;
class QStackedWidget;

namespace codewheel {

class ContextHelp;
class DeviceChoice;
class MessageModel;
class MessagesView;
class ParameterPanel;
class Panels;
class Plant;
class ProjectDocument;
class StructureView;
class WindowActions;
class WindowSettings;

// The command palette of the main window (Ctrl+K): what it finds, and where each leads.
class PaletteInWindow : public QObject
{
    Q_OBJECT

public:
    // All outlive it.
    struct Parts
    {
        QMainWindow &window;
        const WindowActions &actions;
        Plant &plant;
        const ProjectDocument &project;
        const DeviceChoice &choice;
        StructureView &structure;
        ParameterPanel &parameters;
        const MessageModel &messageModel;
        MessagesView &messages;
        Panels &panels;
        const QStackedWidget &pages;
        ContextHelp &help;
        WindowSettings &settings;
        std::function<void()> showMonitors;
    };
    explicit PaletteInWindow(const Parts &parts);

private:
    void showDevice(Place place) const;
    void showParameter(Parameter parameter) const;
    void showMessage(qint64 id) const;
    void noteUsed(const QString &id) const;

    const Parts m_parts;
    OtherLanguage m_otherLanguage;
};

} // namespace codewheel

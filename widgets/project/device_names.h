// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace codewheel {

class EncoderBus;
class ProjectDocument;
struct Place;

// What the bus does not tell, the project does: it names the devices of a connected bus that fit for certain.
// Among neighbours of the same code that differ in the plan nobody can say which is which, so none takes the
// name of another. A device named in the window is named in the project, which can be undone.
class DeviceNames : public QObject
{
    Q_OBJECT

public:
    // Both must outlive it.
    DeviceNames(ProjectDocument &document, EncoderBus &bus, QObject *parent = nullptr);

private:
    void nameDevices(); // all that fit
    void takeName(Place number);

    ProjectDocument &m_document;
    EncoderBus &m_bus;
    bool m_isNaming = false;
};

} // namespace codewheel

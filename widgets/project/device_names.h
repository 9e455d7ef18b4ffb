// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace codewheel {

class EncoderBus;
class ProjectDocument;
struct Place;

// The project supplies what the bus does not tell: it names those devices of a connected bus that match for
// certain. Neighbours with the same code but different plans cannot be told apart, so none takes the name of
// another. A device named in the window is also named in the project, which can be undone.
class DeviceNames : public QObject
{
    Q_OBJECT

public:
    // Both must outlive it.
    DeviceNames(ProjectDocument &document, EncoderBus &bus, QObject *parent = nullptr);

private:
    void nameDevices(); // all that match
    void takeName(Place number);

    ProjectDocument &m_document;
    EncoderBus &m_bus;
    bool m_isNaming = false;
};

} // namespace codewheel

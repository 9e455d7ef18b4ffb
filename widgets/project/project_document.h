// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "project/project.h"

#include <QObject>
#include <QUndoStack>

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace codewheel {

class ProjectStep;

// The open project, and everything that can be undone in it. What views show and change of it goes through
// here: structure editor, wanted values, cams, sequences. Outlives the window, which is rebuilt when the
// language changes.
//
// A device has an id besides its number: the number follows from its place, the id stays.
class ProjectDocument : public QObject
{
    Q_OBJECT

public:
    using DeviceId = unsigned;
    // Changes within one gesture, such as typing in one field or a mouse drag, are one undo step.
    using Gesture = int;
    static constexpr Gesture noGesture = 0;
    // Where each device of a bus was before an edit, as an index on the bus; nothing: it is new.
    using Origins = std::vector<std::optional<std::size_t>>;

    explicit ProjectDocument(QObject *parent = nullptr);
    ~ProjectDocument() override;

    const Project &project() const { return m_project; }
    // The devices of a bus, in its order.
    std::span<const DeviceId> ids(BusId bus) const;
    std::optional<DeviceId> idAt(Place place) const; // nothing: it is not planned
    const ProjectDevice *device(DeviceId id) const;  // null: it no longer exists
    // Its index on its bus.
    std::optional<std::size_t> indexOf(DeviceId id) const;
    // What is planned for the device at this place. Values can also be given to one that is not in the
    // project (a connected ring may have others): they enter the project once it is planned at this place.
    // Until then they are in no file, and the project counts as unsaved.
    const ProjectDevice &device(Place number) const;
    // The places of planned buses that have values but are not in the project.
    std::vector<Place> notPlanned() const;
    // For which something is wanted that goes into no file, as they are on a training line that is not
    // planned; that does not make the project unsaved.
    std::vector<Place> notKept() const;
    void forEachDevice(const std::function<void(Place, const ProjectDevice &)> &visit) const;

    // Another project, or the same one read from its file again. Clears the undo stack. fileMark:
    // projectMark() of the content of the file.
    void setProject(Project project, const QString &file, const QByteArray &fileMark = {});
    QString file() const { return m_file; }                             // empty: not saved yet
    void setFile(const QString &file, const QByteArray &fileMark = {}); // saved there as it is now
    // What was added to the file when it was saved: no step, and not undone.
    void takeLastPositions(const Project &saved);
    // Of the file's content when it was read, or saved here; empty: not known.
    const QByteArray &fileMark() const { return m_fileMark; }
    bool isSaved() const { return m_undo.isClean() && !m_isRecovered && notPlanned().empty(); }
    // It was recovered after a crash: its file has other content.
    void setRecovered();

    // One undo step; none if nothing changes. what: its name, "Move 3.0". Without origins, each device is
    // where it was; if their number changes, those between the unchanged ones at both ends are new.
    void edit(Project after, const QString &what, Gesture gesture = noGesture);
    void edit(Project after, BusId bus, const Origins &origins, const QString &what);
    void editDevice(Place number, const QString &what, const std::function<void(ProjectDevice &)> &edit,
                    Gesture gesture = noGesture);
    // The encoder has a new address: all that is planned and known of it goes along, and replaces anything
    // planned for `to`. edit: what else changes of it in the same step.
    void renumber(
        Place from, Place to, const QString &what,
        const std::function<void(ProjectDevice &)> &edit = [](ProjectDevice &) {});
    Gesture newGesture() { return ++m_lastGesture; }

    static constexpr int mostSteps = 1'000; // to be undone; older ones are dropped
    QUndoStack &undoStack() { return m_undo; }
    // The language has changed: they were named in the one before.
    void nameStepsAnew();

Q_SIGNALS:
    void changed();     // anything of the project or of its devices
    void replaced();    // by another project; changed() is emitted as well
    void fileChanged(); // its name
    // Undone or redone: devices and buses whose plans have changed, devices first.
    void wentBackOrForth(const std::vector<codewheel::Place> &places);
    void savedChanged(bool isSaved);

private:
    bool isOfTrainingLine(Place place) const;
    std::vector<Place> others(bool areOfTrainingLine) const;
    friend class ProjectStep;
    struct Content; // everything a step changes except the devices
    Content content() const;
    void keepNewerPosition(ProjectDevice &device, DeviceId id) const;
    void apply(const Content &content, std::size_t first, std::size_t count,
               const std::vector<ProjectDevice> &devices, const std::vector<DeviceId> &ids);
    void push(Project after, std::vector<DeviceId> ids, std::map<Place, ProjectDevice> others,
              const QString &what, Gesture gesture);
    void pushPlanned(Project after, std::vector<DeviceId> ids, const QString &what, Gesture gesture);
    std::vector<DeviceId> keptIds(const Project &after);

    Project m_project;
    std::vector<DeviceId> m_ids;
    std::map<Place, ProjectDevice> m_others; // of devices that are not in the project
    QString m_file;
    QByteArray m_fileMark;
    QUndoStack m_undo;
    bool m_isRecovered = false;
    DeviceId m_lastId = 0;
    Gesture m_lastGesture = noGesture;
};

} // namespace codewheel
